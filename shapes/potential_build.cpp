#include "shapes/potential_build.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "shapes/convex.h"
#include "shapes/geometry.h"

namespace shapes {
namespace {

constexpr double flattest = 1e10;

std::string shown(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", x);
  return text;
}
[[noreturn]] void refuse(const std::string& what, double value, const char* allowed) {
  throw Error("potential particle: " + what + " = " + shown(value) + "; allowed: " + allowed);
}

// Calls visit(unit direction) for the middles of n² cells on each face of a cube; every direction is within an angle of
// √2/n of one of them.
template <class Visit>
void for_each_direction(int n, Visit visit) {
  for (int face = 0; face < 6; ++face)
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        Vec3d w{};
        w[face / 2] = face % 2 == 0 ? 1 : -1;
        w[(face / 2 + 1) % 3] = (2 * i + 1 - n) / static_cast<double>(n);
        w[(face / 2 + 2) % 3] = (2 * j + 1 - n) / static_cast<double>(n);
        visit(normalized(w));
      }
}

// Height of the body over the origin along a unit n.
double height(const PotentialParticle& p, const Vec3d& n) {
  const auto s = support_from_centre<double>(p, n);
  return s.height + dot(n, p.centre);
}

// A body point at distance ρ along u has ρ cos δ <= n·x <= h(n) for the nearest n of the grid, δ <= √2/n.
double outer_radius(const PotentialParticle& p) {
  constexpr int cells = 48;
  double highest = 0;
  for_each_direction(cells, [&](const Vec3d& n) { highest = std::fmax(highest, height(p, n)); });
  return std::fmin(highest / (1 - 1.0 / (cells * cells)), norm(p.centre) + 1 / std::sqrt(p.sphere_weight));
}

// Smallest height over all directions: from the lowest of a grid and of the planes' normals, by ever smaller steps.
double inner_radius(const PotentialParticle& p) {
  std::vector<std::pair<double, Vec3d>> starts;
  const auto add = [&](const Vec3d& n) { starts.push_back({height(p, n), n}); };
  for_each_direction(12, add);
  for (const auto& plane : p.planes) add(plane.normal);
  std::stable_sort(starts.begin(), starts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  double lowest = starts.front().first;
  for (std::size_t i = 0; i < std::min<std::size_t>(starts.size(), 8); ++i) {
    auto [h, n] = starts[i];
    for (double step = 0.1; step > 1e-9;) {
      Vec3d t1, t2;
      tangent_frame(n, t1, t2);
      bool lower = false;
      for (const Vec3d& t : {t1, -t1, t2, -t2}) {
        const Vec3d tried = normalized(n + step * t);
        const double value = height(p, tried);
        if (value < h) h = value, n = tried, lower = true;
      }
      if (!lower) step *= 0.5;
    }
    lowest = std::fmin(lowest, h);
  }
  return lowest * (1 - 1e-9);
}

// A ball of radius ρ = min|∇g|/2Λ rolls inside the body, Λ above the largest eigenvalue of M anywhere in it (the ball
// lies in g(x) + ∇g·(y − x) + Λ|y − x|² <= 1). Bounds: Λ by rows of |aᵢ·aⱼ| over planes that can act together; with S =
// Σ⟨⟩², αS + β|y|² = 1 and dᵢ > 0,
//   |∇g|² >= 4α²q S + 8αβS + 4β²|y|² = 4β + αS(4αq + 4β),   q = 1 − (largest row of negative aᵢ·aⱼ), >= 0
//   |∇g| >= ∇g·y/|y| = 2 (1 + αΣ⟨⟩dᵢ)/|y| >= 2 (1 + min(dᵢ) √(α·αS))/|y|
// and αS >= 1 − β|y|² by how far the body reaches from its centre.
double least_curvature_radius(const PotentialParticle& p) {
  const double alpha = p.plane_weight, beta = p.sphere_weight;
  if (p.planes.empty() || alpha == 0) return 1 / std::sqrt(beta);
  double reach = p.circumradius + norm(p.centre);
  reach = std::fmin(reach, 1 / std::sqrt(beta));
  const auto together = [&](std::size_t i, std::size_t j) {  // a point beyond both that is not too far away
    const double c = dot(p.planes[i].normal, p.planes[j].normal), di = p.planes[i].offset, dj = p.planes[j].offset;
    const double s = 1 - c * c;
    double square = std::fmax(di, dj) * std::fmax(di, dj);
    if (c < 0) square = s > 0x1p-40 ? (di * di + dj * dj - 2 * c * di * dj) / s : reach * reach * 4;
    return square <= reach * reach * (1 + 0x1p-20);
  };
  double row = 1, negative = 0;
  for (std::size_t i = 0; i < p.planes.size(); ++i) {
    double all = 0, minus = 0;
    for (std::size_t j = 0; j < p.planes.size(); ++j) {
      if (j != i && !together(i, j)) continue;
      const double c = dot(p.planes[i].normal, p.planes[j].normal);
      all += std::fabs(c);
      minus += std::fmax(0, -c);
    }
    row = std::fmax(row, all);
    negative = std::fmax(negative, minus);
  }
  const double q = std::fmax(0, 1 - negative), lambda = alpha * row + beta;
  const double share = std::fmax(0, 1 - beta * reach * reach);  // least αS
  const double gradient = std::fmax(std::sqrt(4 * beta + share * (4 * alpha * q + 4 * beta)),
                                    2 * (1 + p.inner_radius * std::sqrt(alpha * share)) / reach);
  return 0.999 * gradient / (2 * lambda);
}

void set_radii(PotentialParticle& p) {
  p.inner_radius = 1 / std::sqrt(p.sphere_weight);
  for (const auto& plane : p.planes) p.inner_radius = std::fmin(p.inner_radius, plane.offset);
  p.circumradius = outer_radius(p);
  p.inscribed_radius = p.plane_weight == 0 && max_abs(p.centre) == 0 ? p.inner_radius : inner_radius(p);
  p.least_curvature_radius = least_curvature_radius(p);
}

void to_principal(PotentialParticle& p) {
  const Pose frame = convex::principal_frame(p.mass, 1 / std::sqrt(p.sphere_weight));
  const Quatd& o = frame.orientation;
  const bool turned = !(o.x == 0 && o.y == 0 && o.z == 0);
  const Mat3d rotation = turned ? rotation_matrix(o) : Mat3d::identity();
  const Mat3d inertia = turned ? transposed(rotation) * p.mass.inertia * rotation : p.mass.inertia;
  if (turned)
    for (auto& plane : p.planes) plane.normal = convex::unit(transposed_times(rotation, plane.normal));
  p.centre = transposed_times(rotation, p.centre - frame.position);
  p.mass.centre = {};
  p.mass.inertia = Mat3d::diagonal({inertia.row[0].x, inertia.row[1].y, inertia.row[2].z});
  p.frame = frame;
}

}  // namespace

PotentialParticle scaled(const PotentialParticle& given, double s) {
  PotentialParticle p = given;
  for (auto& plane : p.planes) plane.offset *= s;
  for (double* length : {&p.r, &p.R, &p.circumradius, &p.inscribed_radius, &p.inner_radius, &p.least_curvature_radius})
    *length *= s;
  p.plane_weight = p.plane_weight / s / s;
  p.sphere_weight = p.sphere_weight / s / s;
  p.centre *= s;
  p.frame.position *= s;
  p.mass.volume *= s * s * s;
  p.mass.centre *= s;
  for (Vec3d& row : p.mass.inertia.row) row = row * s * s * s * s * s;
  return p;
}

PotentialParticle make_potential_particle(std::span<const HalfSpace> planes, double k, double r, double R, Frame frame,
                                          double tolerance) {
  if (planes.size() > PotentialParticle::most_planes)
    refuse("number of planes", static_cast<double>(planes.size()), "at most 64");
  if (!(k > 0 && k <= 1)) refuse("k", k, "0 < k <= 1");
  if (!(r > 0) || !std::isfinite(r)) refuse("r", r, "finite and > 0 (m)");
  if (!(R > 0) || !std::isfinite(R)) refuse("R", R, "finite and > 0 (m)");
  const double flatness = (1 - k) / k * (R / r) * (R / r);
  if (!(flatness <= flattest)) refuse("(1 - k) R^2 / (k r^2)", flatness, "at most 1e10 (a larger k or r)");
  if (!(R > 0x1p-200 && R < 0x1p200)) refuse("R", R, "2^-200 to 2^200 m");
  const int exponent = convex::exponent_above(R);
  PotentialParticle p;
  p.k = k;
  p.r = std::ldexp(r, -exponent);
  p.R = std::ldexp(R, -exponent);
  p.plane_weight = (1 - k) / (p.r * p.r);
  p.sphere_weight = k / (p.R * p.R);
  const double reach = 1 / std::sqrt(p.sphere_weight);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const std::string name = "planes[" + std::to_string(i) + "]";
    const double length = convex::finite(planes[i].normal) ? convex::safe_norm(planes[i].normal) : 0;
    if (!(length > 0)) refuse(name + ": length of the normal", length, "finite and > 0");
    const double distance = planes[i].offset / length;
    if (!(distance > 0) || !std::isfinite(distance))
      refuse(name + ": distance from the origin", distance, "finite and > 0 (m): the origin lies inside");
    const double offset = std::ldexp(distance, -exponent);
    if (offset < reach && k < 1) p.planes.push_back({convex::unit(planes[i].normal), offset});  // else it does nothing
  }
  double error = 0;
  p.mass = potential::mass_by_quadrature(p, 0.75 * tolerance, error);
  if (!(error < tolerance))
    refuse("estimated error of the mass properties", error, "below 1e-8 (less extreme k, r or planes)");
  if (frame == Frame::principal) to_principal(p);
  set_radii(p);
  return scaled(p, std::ldexp(1.0, exponent));
}

Polyhedron drawing_of(const PotentialParticle& body) {
  std::vector<Vec3d> points;
  const auto add = [&](const Vec3d& n) { points.push_back(support(body, n)); };
  for_each_direction(8, add);
  for (const auto& plane : body.planes) add(plane.normal);
  return polyhedron_from_points(points, Frame::as_given);
}

MassProperties mass_properties(const PotentialParticle& p) { return p.mass; }
double circumradius(const PotentialParticle& p) { return p.circumradius; }
double inscribed_radius(const PotentialParticle& p) { return p.inscribed_radius; }
Vec3d support(const PotentialParticle& p, const Vec3d& n) {
  return p.centre + support_from_centre<double>(p, convex::unit(n)).from_centre;
}

}  // namespace shapes
