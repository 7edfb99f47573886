// Oblique elastic impacts of a solid sphere computed apart from the library, in one dimension across: what the
// published tables were recomputed with.
//   m* δ'' = −Fn,  m* s' = −(7/2) Ft,  s the speed of the contact's point across                              (1)
// by 10000 steps of leapfrog a contact, second order: about 1e-6 of the speeds.
#pragma once

namespace laws {

enum class Across {
  hertz_rescaled,  // kt = 8 G* a, the spring shortened as a shrinks, cap μ Fn
  hertz_plain,     // the same without shortening
  exact,           // Mindlin & Deresiewicz: all segments kept
  linear           // kn by (9.22), kt = kn/κ
};

struct Oblique {
  double slip;         // s'/(μ vn) afterwards
  double spin;         // R ω'/(μ vn), in the sense of −
  double restitution;  // of the centre across
};

// Θ = 2 tan(angle)/((1 + e) μ) with e = 1; no spin before.
Oblique oblique_impact(Across law, double theta, double poisson, double friction);

}  // namespace laws
