// How two materials meet: effective moduli, friction and damping of a pair. Set-up only.
#pragma once

#include "libcontact/export.h"
#include "libcontact/laws/law.h"

namespace contact {

// Restitution of a spring with a dashpot of ratio β >= 0 whose contact ends at zero force:
//   e(β) = exp(−2β acos(β)/sqrt(1−β²)), β < 1;  exp(−2), β = 1;  exp(−2β acosh(β)/sqrt(β²−1)), β > 1.
// The same for the linear spring and for Hertz with Tsuji's dashpot. Relative error about 1e-15. It is positive for
// every β, about 1/(4β²) for large ones: however strong, a dashpot that may not pull lets the spring throw the bodies
// apart.
CONTACT_API double clipped_restitution(double beta);
// Its inverse for 0 < e <= 1 (bracketed root, relative error 1e-14 in β).
CONTACT_API double clipped_damping(double restitution);
// Least restitution that a clipped contact is asked for. Every one above 0 can be had, but the stable step shrinks as
// sqrt(e) and the contact's duration grows as 1/sqrt(e): here β = 4.81, a tenth of the step of an undamped contact.
inline constexpr double least_clipped_restitution = 0.01;
// β for 0 <= e <= 1 of a contact that ends at zero overlap: e = exp(−πβ/sqrt(1−β²)); e = 0 is critical damping, β = 1.
CONTACT_API double unclipped_damping(double restitution);
// The one of the two that the end of contact asks for.
inline double damping_of(double restitution, bool clip) {
  return clip ? clipped_damping(restitution) : unclipped_damping(restitution);
}

// E* (8.6), G* (8.25), stiffnesses in series, kt/kn = 1/κ with κ = E*/(4G*); friction, restitution, resistance to
// rolling and twisting, cohesion and yield pressure = the smaller one; W = sqrt(W₁ W₂); viscous time, plastic depth and
// contact angle = the mean. A rigid partner is left out of all that comes from deformation; two rigid materials never
// meet (refused by the caller).
CONTACT_API PairParameters mix(const Material& a, const Material& b, bool clip = true);
// What follows from the restitution.
CONTACT_API void set_restitution(PairParameters& p, double restitution, bool clip = true);

}  // namespace contact
