// Mass properties of a potential particle. On each of six faces of a cube about the centre, w = (1, p, q) turned to
// that face, the body is 0 <= λ <= λ(p, q), y = λ w, dV = λ² dλ dp dq:
//   ∫1 = ∫∫λ³/3,   ∫y = ∫∫λ⁴/4 w,   ∫y yᵀ = ∫∫λ⁵/5 w wᵀ                                                          (1)
// λ solves g(λ w) = 1: along a line g is convex, and Newton's method from outside falls to the root. The integrands
// have jumps in their second derivatives where a plane begins to act, which is what the adaptive rule spends its points
// on.
#include <algorithm>
#include <cmath>
#include <vector>

#include "shapes/geometry.h"
#include "shapes/potential_build.h"
#include "shapes/quadrature.h"

namespace shapes::potential {
namespace {

using Values = std::array<double, 10>;  // 1; x, y, z; xx, yy, zz, xy, yz, zx

// λ(w), and the planes that the surface lies beyond there.
double reach(const PotentialParticle& p, const Vec3d& w, std::uint64_t& beyond) {
  double slope[PotentialParticle::most_planes], offset[PotentialParticle::most_planes];
  std::size_t index[PotentialParticle::most_planes], count = 0;
  for (std::size_t i = 0; i < p.planes.size(); ++i) {
    const double c = dot(p.planes[i].normal, w);
    if (c > 0) slope[count] = c, offset[count] = p.planes[i].offset, index[count++] = i;
  }
  const double square = dot(w, w);
  double lambda = 1 / std::sqrt(p.sphere_weight * square);
  for (int i = 0; i < 100; ++i) {
    double squares = 0, pull = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const double s = lambda * slope[k] - offset[k];
      if (s > 0) squares += s * s, pull += s * slope[k];
    }
    const double g = p.plane_weight * squares + p.sphere_weight * square * lambda * lambda;
    const double half_slope = p.plane_weight * pull + p.sphere_weight * square * lambda;
    const double next = lambda - (g - 1) / (2 * half_slope);
    const bool last = !(next < lambda * (1 - 0x1p-52));
    lambda = next;
    if (last) break;
  }
  beyond = 0;
  for (std::size_t k = 0; k < count; ++k)
    if (lambda * slope[k] > offset[k]) beyond |= std::uint64_t{1} << index[k];
  return lambda;
}

Vec3d on_cube(int face, double u, double v) {
  Vec3d w{};
  w[face / 2] = face % 2 == 0 ? 1 : -1;
  w[(face / 2 + 1) % 3] = u;
  w[(face / 2 + 2) % 3] = v;
  return w;
}

Values moments_at(const PotentialParticle& p, const Vec3d& w) {
  std::uint64_t beyond = 0;
  const double l = reach(p, w, beyond), l3 = l * l * l;
  const Vec3d first = (0.25 * l3 * l) * w;
  const double second = 0.2 * l3 * l * l;
  return {l3 / 3,
          first.x,
          first.y,
          first.z,
          second * w.x * w.x,
          second * w.y * w.y,
          second * w.z * w.z,
          second * w.x * w.y,
          second * w.y * w.z,
          second * w.z * w.x};
}

// Where along the line (u, ·) of a face of the cube planes begin or cease to act, as far as a grid shows it; from −1 to
// 1. By bisection: a kink that is missed by δ costs δ³.
std::vector<double> pieces_of_line(const PotentialParticle& p, int face, double u) {
  constexpr int cells = 16;
  std::vector<double> at{-1};
  std::uint64_t last = 0;
  for (int i = 0; i <= cells; ++i) {
    const double v = -1 + 2.0 * i / cells;
    std::uint64_t beyond = 0;
    reach(p, on_cube(face, u, v), beyond);
    for (std::uint64_t changed = i == 0 ? 0 : beyond ^ last; changed != 0; changed &= changed - 1) {
      const std::uint64_t bit = changed & ~(changed - 1);
      double low = v - 2.0 / cells, high = v;
      for (int k = 0; k < 20; ++k) {
        const double middle = 0.5 * (low + high);
        std::uint64_t there = 0;
        reach(p, on_cube(face, u, middle), there);
        ((there ^ last) & bit ? high : low) = middle;
      }
      at.push_back(0.5 * (low + high));
    }
    last = beyond;
  }
  at.push_back(1);
  std::sort(at.begin(), at.end());
  return at;
}

// Over all faces, outer and inner rule both to `tolerance`.
Values integral(const PotentialParticle& p, const Values& tolerance, int depth, double& worst) {
  Values sum{}, outer = tolerance, inner = tolerance;
  for (double& t : outer) t /= 6;
  for (double& t : inner) t /= 6 * 2 * 4;  // per unit of u, a quarter of what the outer rule may miss
  worst = 0;
  for (int face = 0; face < 6; ++face) {
    const auto line = [&](double u) {
      Values of_line{};
      const auto point = [&](double v) { return moments_at(p, on_cube(face, u, v)); };
      const std::vector<double> at = pieces_of_line(p, face, u);
      for (std::size_t i = 0; i + 1 < at.size(); ++i)
        if (at[i + 1] > at[i]) integrate<10>(point, at[i], at[i + 1], 2, inner, depth, of_line);
      return of_line;
    };
    worst += integrate<10>(line, -1, 1, 2, outer, depth, sum) / 6;
  }
  return sum;
}

}  // namespace

MassProperties mass_by_quadrature(const PotentialParticle& p, double tolerance, double& error) {
  Values large;
  large.fill(0x1p500);
  double worst = 0;
  const Values rough = integral(p, large, 0, worst);
  Values allowed{};
  for (std::size_t i = 0; i < 10; ++i) {
    const double kind = i == 0  ? rough[0]
                        : i < 4 ? std::sqrt(rough[0] * rough[i + 3])
                        : i < 7 ? rough[i]
                                : std::sqrt(rough[4 + (i - 7)] * rough[4 + (i - 6) % 3]);
    allowed[i] = tolerance * kind;
  }
  const Values m = integral(p, allowed, 16, worst);
  error = tolerance * (worst + 0.25);  // and what the inner rule may miss
  MassProperties out;
  const double volume = m[0];
  const Vec3d c{m[1] / volume, m[2] / volume, m[3] / volume};
  const Vec3d square{m[4] - volume * c.x * c.x, m[5] - volume * c.y * c.y, m[6] - volume * c.z * c.z};
  const double xy = m[7] - volume * c.x * c.y, yz = m[8] - volume * c.y * c.z, zx = m[9] - volume * c.z * c.x;
  const auto told = [&](double value, double kind) { return std::fabs(value) > 4 * tolerance * kind ? value : 0.0; };
  out.volume = volume;
  for (int i = 0; i < 3; ++i) out.centre[i] = told(c[i], std::sqrt(square[i] / volume));
  const double ixy = -told(xy, std::sqrt(square.x * square.y)), iyz = -told(yz, std::sqrt(square.y * square.z));
  const double izx = -told(zx, std::sqrt(square.z * square.x));
  out.inertia = {{{square.y + square.z, ixy, izx}, {ixy, square.z + square.x, iyz}, {izx, iyz, square.x + square.y}}};
  out.centre += p.centre;
  return out;
}

}  // namespace shapes::potential
