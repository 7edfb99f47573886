// Tangential spring with dashpot under Coulomb's cap; the spring is the contact's history, the dashpot is not.
//   Ft_el ← rotated(Ft_el) · shrink + kt Δs          (9.21), (9.16)
//   Ft = Ft_el + ct ds/dt; when |Ft| > μ F:  Ft ← μ F Ft/|Ft|, Ft_el = Ft     (9.25), read as in the project's equation
//   sheet
// `shrink` = a/a_old when the contact radius has shrunk and rescaling is on, else 1: without it, unloading at fixed
// slip and loading again creates energy (Agnolin & Roux, Phys. Rev. E 76 (2007) 061302). Rotation of the history:
// minimal rotation of the old normal to the new one, then the mean spin about the normal; both keep the length to
// rounding. First contact within a step: only the part of the step spent in contact slips. Tests:
// tests/libcontact/laws_tangential.cpp
#pragma once

#include "libcontact/laws/state.h"

namespace contact {

// f turned as the contact frame turned: n_old → n, then the angle about n. f ⟂ n_old. n_old = 0 needs f = 0.
template <class T>
shapes::Vec3<T> carried(const shapes::Vec3<T>& f, const shapes::Vec3<T>& n_old, const shapes::Vec3<T>& n,
                        const T& angle) {
  const T c = dot(n_old, n);
  const shapes::Vec3<T> v = cross(n_old, n);
  const T t = T(0.5) * angle, turned = T(1) + t * t, stays = T(1) + c, both = T(1) / (turned * stays);
  shapes::Vec3<T> g = f * c + cross(v, f) + v * (dot(v, f) * (turned * both));
  const T s = stays * both;
  return g * ((T(1) - t * t) * s) + cross(n, g) * ((t + t) * s);
}

struct CoulombSpring {
  static constexpr const char* name = "coulomb_spring";
  static constexpr const char* parameters = "friction";
  static constexpr const char* remark =
      "spring and dashpot under Coulomb's cap, no micro-slip; rescale = false may create 2.6 % of what was stored";
  static constexpr const char* source =
      "Mindlin 1949, no slip; rescaling on unloading: Agnolin & Roux 2007, Thornton et al. 2013";
  static constexpr int vectors = 1;
  template <class T>
  struct State {
    Vec3<T> force{};  // elastic, on b, N
  };

  template <class T>
  static TangentialForce<T> update(const PairOf<T>& p, const Kinematics<T>& k, const NormalForce<T>& f,
                                   const LawOptions&, State<T>& s) {
    const T cap = capped(p.friction, f.holding);
    s.force = s.force * f.shrink + k.slip * (f.stiffness_t * k.dt_contact);
    const Vec3<T> trial = s.force + k.slip * f.damping_t;
    const T square = dot(trial, trial);
    const auto slides = square > cap * cap;
    TangentialForce<T> out;
    out.force = shortened(trial, slides, square, cap);
    s.force = select(slides, out.force, s.force);
    const auto holds = f.stiffness_t > T(0);
    out.energy = select(holds, T(0.5) * dot(s.force, s.force) / select(holds, f.stiffness_t, T(1)), T(0));
    return out;
  }
};

}  // namespace contact
