// The support point of a potential particle (potential_particle.h, (3) and (4)), over any scalar.
#pragma once

#include <limits>

#include "shapes/potential_particle.h"

namespace shapes::potential {

// One step (3) from y, and the bound (4) at y itself. False when y tells nothing: n·½∇g <= 0 there.
template <class T>
bool step_to_support(const PotentialParticle& p, const Vec3<T>& n, Vec3<T>& y, PotentialSupport<T>& s, T& misfit,
                     std::uint64_t& beyond) {
  using std::sqrt;
  const PotentialLevel<T> at = level_at(p, y);
  beyond = at.beyond;
  s.half_slope = dot(at.half_gradient, n);
  if (!(s.half_slope > T(0))) return false;
  s.inverse_hessian = inverse(at.half_hessian);
  const Vec3<T> tangential = at.half_gradient - s.half_slope * n;
  misfit = T(1) - at.g;
  s.height = dot(n, y) + misfit / (T(2) * s.half_slope);
  s.excess = dot(tangential, tangential) / (T(2) * s.half_slope * T(p.sphere_weight));
  const Vec3<T> back = s.inverse_hessian * at.half_gradient, along = s.inverse_hessian * n;
  const T square = (misfit + dot(at.half_gradient, back)) / dot(n, along);
  if (!(square > T(0))) return false;
  y += sqrt(square) * along - back;
  s.from_centre = y;
  return true;
}

template <class T>
bool settle(const PotentialParticle& p, const Vec3<T>& n, Vec3<T> y, int limit, PotentialSupport<T>& s) {
  const T unit = T(std::numeric_limits<T>::epsilon());
  std::uint64_t last = 0;
  for (int i = 0; i < limit; ++i) {
    T misfit{};
    std::uint64_t beyond = 0;
    if (!step_to_support(p, n, y, s, misfit, beyond)) return false;
    // On one set of planes the step is exact but for rounding, which (4) and the misfit then show.
    const T error = s.excess + (misfit < T(0) ? -misfit : misfit) / (T(2) * s.half_slope);
    if (i > 0 && (beyond == last || error <= unit * s.height) && error <= T(0x1p-26) * s.height &&
        s.excess <= T(4) * unit * s.height)
      return s.found = true;
    last = beyond;
  }
  return false;
}

// Along the path of points with ½∇g = t n from t = 0 at the centre to g = 1.
template <class T>
Vec3<T> along_path(const PotentialParticle& p, const Vec3<T>& n) {
  using std::sqrt;
  Vec3<T> y{};
  T t{}, g{};
  std::uint64_t beyond = 0;
  const std::size_t limit = 8 * p.planes.size() + 8;
  for (std::size_t k = 0; k < limit; ++k) {
    const Vec3<T> v = inverse(half_hessian<T>(p, beyond)) * n;
    const T rate = dot(n, v), rest = (T(1) - g) / rate;
    const T to_end = rest / (t + sqrt(t * t + rest));  // g + (2 t τ + τ²) n·v = 1
    T next = to_end;
    std::size_t plane = p.planes.size();
    for (std::size_t i = 0; i < p.planes.size(); ++i) {
      const Vec3<T> a = widened<T>(p.planes[i].normal);
      const T speed = dot(a, v);
      const bool inside = !(beyond >> i & 1);
      if (inside ? !(speed > T(0)) : !(speed < T(0))) continue;
      T tau = (T(p.planes[i].offset) - dot(a, y)) / speed;
      if (tau < T(0)) tau = T(0);
      if (tau < next) next = tau, plane = i;
    }
    y += next * v;
    if (plane == p.planes.size()) return y;
    g += (T(2) * t + next) * next * rate;
    if (!(g < T(1))) return y;
    t += next;
    beyond ^= std::uint64_t{1} << plane;
  }
  return y;
}

}  // namespace shapes::potential

namespace shapes {

template <class T>
PotentialSupport<T> support_from_centre(const PotentialParticle& p, const Vec3<T>& n, const Vec3<T>* start) {
  PotentialSupport<T> s{};
  if (start != nullptr && potential::settle(p, n, *start, 6, s)) return s;
  potential::settle(p, n, potential::along_path(p, n), 16, s);
  return s;
}

}  // namespace shapes
