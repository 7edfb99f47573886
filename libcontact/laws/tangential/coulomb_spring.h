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

#include "libcontact/laws/kinematics.h"

namespace contact {

// f turned as the contact frame turned: n_old → n, then the angle about n. f ⟂ n_old. n_old = 0 needs f = 0.
template <class T>
shapes::Vec3<T> carried(const shapes::Vec3<T>& f, const shapes::Vec3<T>& n_old, const shapes::Vec3<T>& n,
                        const T& angle) {
  const T c = dot(n_old, n);
  const shapes::Vec3<T> v = cross(n_old, n);
  shapes::Vec3<T> g = f * c + cross(v, f) + v * (dot(v, f) / (T(1) + c));
  g -= n * dot(n, g);  // rounding only
  const T t = T(0.5) * angle, s = T(1) / (T(1) + t * t);
  return g * ((T(1) - t * t) * s) + cross(n, g) * ((t + t) * s);
}

struct CoulombSpring {
  static constexpr const char* name = "coulomb_spring";
  // elastic: in: the carried history, out: the new one. Returns the tangential force (on b, along the slip of a).
  template <class T>
  static shapes::Vec3<T> update(const T& kt, const T& ct, const T& cap, const shapes::Vec3<T>& slip,
                                const T& dt_contact, shapes::Vec3<T>& elastic) {
    using std::sqrt;
    elastic += slip * (kt * dt_contact);
    const shapes::Vec3<T> trial = elastic + slip * ct;
    const T square = dot(trial, trial);
    const auto slides = square > cap * cap;
    const T shorten = select(slides, cap / sqrt(select(slides, square, T(1))), T(1));
    const shapes::Vec3<T> force = trial * shorten;
    elastic = {select(slides, force.x, elastic.x), select(slides, force.y, elastic.y),
               select(slides, force.z, elastic.z)};
    return force;
  }
};

}  // namespace contact
