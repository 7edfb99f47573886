// Potential particle: a convex body with flat-looking faces, round edges and corners, the points with f(x) <= 0 of
//   f(x) = (1 − k)[Σ⟨aᵢ·y − dᵢ⟩²/r² − 1] + k[|y|²/R² − 1],  y = x − centre,  ⟨z⟩ = max(z, 0)                     (1)
// aᵢ: unit normals of planes, dᵢ > 0: their distances from the centre, m; r, R: lengths, m; 0 < k <= 1: no unit. A face
// bulges by up to r beyond its plane; k = 1 is the sphere of radius R. For k > 0 f is strictly convex and the body lies
// in the ball of radius R/√k about the centre: the planes need not close.
//
// Source: G. Houlsby, Comput. Geotech. 36 (2009) 953; C. Boon, G. Houlsby & S. Utili, Powder Technol. 248 (2013) 94.
// Accuracy, cost and the checks of the input: potential_build.h. Tests: tests/shapes/potential_particle.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "shapes/mass.h"
#include "shapes/math/quat.h"

namespace shapes {

struct PotentialParticle {
  static constexpr const char* name = "potential_particle";
  static constexpr std::size_t most_planes = 64;
  struct Plane {
    Vec3d normal;   // aᵢ, unit
    double offset;  // dᵢ, m, from `centre`
  };
  std::vector<Plane> planes;
  double k{}, r{}, R{};
  Vec3d centre{};         // of (1) in the body frame, m
  double plane_weight{};  // α = (1 − k)/r², m⁻²
  double sphere_weight{};  // β = k/R², m⁻²:  f + 1 = αΣ⟨aᵢ·y − dᵢ⟩² + β|y|² =: g                        (2)
  MassProperties mass;              // in this frame; centre is the origin when the frame is principal
  double circumradius{};            // m, of a ball about the origin that holds the body: at most 0.1 % too large
  double inscribed_radius{};        // m, of a ball about the origin inside the body
  double inner_radius{};            // m, of a ball about `centre` inside the body: min(dᵢ, R/√k)
  double least_curvature_radius{};  // m, a lower bound: the body is a convex body plus a ball of this radius
  Pose frame;                       // x_input = R(frame.orientation) x_body + frame.position
};

// g of (2) at y, its half gradient and half second derivative M, and the planes that y lies beyond.
template <class T>
struct PotentialLevel {
  T g{};
  Vec3<T> half_gradient{};
  Mat3<T> half_hessian{};
  std::uint64_t beyond = 0;
};

namespace potential {

template <class T>
Vec3<T> widened(const Vec3d& v) {
  return {T(v.x), T(v.y), T(v.z)};
}

template <class T>
void add_outer(Mat3<T>& m, const Vec3<T>& a) {
  for (int i = 0; i < 3; ++i) m.row[i] += a[i] * a;
}

// α·(sum of aᵢ aᵢᵀ) + β.
template <class T>
Mat3<T> weighted(const PotentialParticle& p, const Mat3<T>& sum) {
  Mat3<T> m;
  for (int i = 0; i < 3; ++i) {
    m.row[i] = T(p.plane_weight) * sum.row[i];
    m.row[i][i] += T(p.sphere_weight);
  }
  return m;
}

template <class T>
Mat3<T> half_hessian(const PotentialParticle& p, std::uint64_t beyond) {
  Mat3<T> sum;
  for (std::size_t i = 0; i < p.planes.size(); ++i)
    if (beyond >> i & 1) add_outer(sum, widened<T>(p.planes[i].normal));
  return weighted(p, sum);
}

// Inverse of a symmetric positive definite matrix by cofactors.
template <class T>
Mat3<T> inverse(const Mat3<T>& m) {
  const Vec3<T> c0 = cross(m.row[1], m.row[2]), c1 = cross(m.row[2], m.row[0]), c2 = cross(m.row[0], m.row[1]);
  const T s = T(1) / dot(m.row[0], c0);
  return {{s * c0, s * c1, s * c2}};
}

}  // namespace potential

template <class T>
PotentialLevel<T> level_at(const PotentialParticle& p, const Vec3<T>& y) {
  PotentialLevel<T> at;
  Mat3<T> sum;
  Vec3<T> pull{};
  T squares{};
  for (std::size_t i = 0; i < p.planes.size(); ++i) {
    const Vec3<T> a = potential::widened<T>(p.planes[i].normal);
    const T s = dot(a, y) - T(p.planes[i].offset);
    if (!(s > T(0))) continue;
    squares += s * s;
    pull += s * a;
    potential::add_outer(sum, a);
    at.beyond |= std::uint64_t{1} << i;
  }
  at.g = T(p.plane_weight) * squares + T(p.sphere_weight) * dot(y, y);
  at.half_gradient = T(p.plane_weight) * pull + T(p.sphere_weight) * y;
  at.half_hessian = potential::weighted(p, sum);
  return at;
}

// The farthest point along a unit n.
template <class T>
struct PotentialSupport {
  Vec3<T> from_centre;      // y of it, m
  T height;                 // n·y, m
  T excess;                 // m, >= 0: the exact height is at most height + excess, before rounding
  T half_slope;             // t with ½∇g = t n, 1/m
  Mat3<T> inverse_hessian;  // M⁻¹, m²
  bool found;
};

// With ½∇g = t n the piece of the surface that lies beyond the planes A is an ellipsoid, and its point is
//   y = y_A + t M_A⁻¹ n,   t² = (1 − min g_A)/(n·M_A⁻¹ n)                                                        (3)
// Two ways to the set A: from a point that is near (`start`), by (3) again and again; or along the path y(t), t >= 0,
// from the centre, which is a chain of straight pieces, one plane entering or leaving at each joint: it always ends.
// Whatever the way, strong convexity bounds the height at any y from above:
//   h <= n·y + (1 − g)/2t + |½∇g − t n|²/(2 t β),   t = ½∇g·n > 0                                               (4)
template <class T>
PotentialSupport<T> support_from_centre(const PotentialParticle& p, const Vec3<T>& n, const Vec3<T>* start = nullptr);

// Radii of curvature in the tangent plane of unit vectors t1, t2 at a support point, as a symmetric matrix:
//   K = t (M⁻¹ − M⁻¹n nᵀM⁻¹/(n·M⁻¹n))                                                                           (5)
template <class T>
struct TangentMatrix {
  T k11, k12, k22;
};
template <class T>
TangentMatrix<T> curvature_radii(const PotentialSupport<T>& s, const Vec3<T>& n, const Vec3<T>& t1, const Vec3<T>& t2) {
  const Vec3<T> mn = s.inverse_hessian * n, m1 = s.inverse_hessian * t1, m2 = s.inverse_hessian * t2;
  const T w = T(1) / dot(n, mn), c1 = dot(t1, mn), c2 = dot(t2, mn);
  return {s.half_slope * (dot(t1, m1) - c1 * c1 * w), s.half_slope * (dot(t1, m2) - c1 * c2 * w),
          s.half_slope * (dot(t2, m2) - c2 * c2 * w)};
}

}  // namespace shapes

#include "shapes/potential_support.h"
