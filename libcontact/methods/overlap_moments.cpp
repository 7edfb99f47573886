#include "libcontact/methods/overlap_moments.h"

#include <cmath>
#include <vector>

#include "libcontact/methods/depth_spread.h"

namespace contact {

namespace {

using Face = OverlapBody::Face;

// Axes with n last.
struct Axes {
  Vec3d t, s, n;
  explicit Axes(const Vec3d& normal) : n(normal) { tangent_frame(n, t, s); }
  Vec3d operator()(const Vec3d& x) const { return {dot(t, x), dot(s, x), dot(n, x)}; }
};

// Vector area of the surface of one of the two.
void add_surface(const OverlapBody& body, const Face& f, Vec3d& sum) {
  const Vec3d& first = body.corner(f, 0);
  double area = 0;
  for (std::uint32_t k = 2; k < f.count; ++k)
    area += dot(f.normal, cross(body.corner(f, k - 1) - first, body.corner(f, k) - first));
  sum += (0.5 * area) * f.normal;
}

// ∫1, ∫x, ∫xxᵀ about a corner of the body, along Axes.
struct Moments {
  double volume = 0;
  Vec3d first{};
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
  // The cone over a triangle, apex in the origin.
  void add(double v, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const Vec3d sum = a + b + c;
    volume += v;
    first += (0.25 * v) * sum;
    const double w = 0.05 * v;
    xx += w * (sum.x * sum.x + a.x * a.x + b.x * b.x + c.x * c.x);
    yy += w * (sum.y * sum.y + a.y * a.y + b.y * b.y + c.y * c.y);
    zz += w * (sum.z * sum.z + a.z * a.z + b.z * b.z + c.z * c.z);
    xy += w * (sum.x * sum.y + a.x * a.y + b.x * b.y + c.x * c.y);
    xz += w * (sum.x * sum.z + a.x * a.z + b.x * b.z + c.x * c.z);
    yz += w * (sum.y * sum.z + a.y * a.z + b.y * b.z + c.y * c.z);
  }
};

}  // namespace

OverlapDepth line_of_action(const DepthSlope& s) {
  OverlapDepth out{.depth = s.depth, .gain = norm(s.force)};
  out.normal = s.force * (1 / out.gain);
  out.point = s.centroid + cross(out.normal, s.moment) * (1 / out.gain);
  out.screw = dot(out.normal, s.moment) / out.gain;
  return out;
}

bool depth_slope(const OverlapBody& body, double size, DepthSlope& out) {
  if (body.faces().empty()) return false;
  Vec3d of_self{}, of_other{};
  for (const Face& f : body.faces()) add_surface(body, f, f.of_other ? of_other : of_self);
  const Vec3d surface = 0.5 * (of_self - of_other);
  const double section = norm(surface);
  if (!(section > least_depth * least_depth * size * size)) return false;
  const Axes axes(surface * (1 / section));

  // Corners along the axes from one of them, and what they are to r.
  static thread_local std::vector<Vec3d> places;
  static thread_local std::vector<double> residuals;
  const std::size_t count = body.corners().size();
  const Vec3d apex = body.corner(body.faces()[0], 0);
  places.resize(count);
  residuals.resize(count);
  for (std::size_t i = 0; i < count; ++i) places[i] = axes(body.corners()[i] - apex);
  Moments m;
  for (const Face& f : body.faces()) {
    const Vec3d normal = axes(f.normal), &first = places[body.name(f, 0)];
    const double height = dot(normal, first) / 6;
    const Vec3d* p = &places[body.name(f, 1)];
    for (std::uint32_t k = 2; k < f.count; ++k) {
      const Vec3d* q = &places[body.name(f, k)];
      m.add(dot(normal, cross(*p - first, *q - first)) * height, first, *p, *q);
      p = q;
    }
  }
  if (!(m.volume > 0)) return false;
  const double w = 1 / m.volume;
  const Vec3d c = w * m.first;
  const double xx = w * m.xx - c.x * c.x, yy = w * m.yy - c.y * c.y, xy = w * m.xy - c.x * c.y;
  const double xz = w * m.xz - c.x * c.z, yz = w * m.yz - c.y * c.z, zz = w * m.zz - c.z * c.z;
  Tilt tilt;
  if (!find_tilt(xx, yy, zz, xy, xz, yz, tilt)) return false;
  const double variance = tilt.variance;
  for (std::size_t i = 0; i < count; ++i) {
    places[i] -= c;
    residuals[i] = places[i].z - tilt.u * places[i].x - tilt.v * places[i].y;
  }

  out.depth = std::sqrt(12 * variance);  // (1)
  if (!(out.depth > least_depth * size)) return false;
  const double scale = out.depth / (2 * variance * m.volume), turn = out.depth / section;
  Vec3d force{}, moment{};              // along the axes
  for (const Face& f : body.faces()) {  // (4)
    if (!f.of_other) continue;
    const Vec3d normal = axes(f.normal);
    const std::uint32_t i = body.name(f, 0);
    std::uint32_t j = body.name(f, 1);
    Vec3d at{};
    double sum = 0;
    for (std::uint32_t k = 2; k < f.count; ++k) {
      const std::uint32_t l = body.name(f, k);
      const double area = 0.5 * dot(normal, cross(places[j] - places[i], places[l] - places[i]));
      const CornerWeights at_corner(area, residuals[i], residuals[j], residuals[l], variance);
      sum += at_corner.sum();
      at += at_corner.a * places[i] + at_corner.b * places[j] + at_corner.c * places[l];
      j = l;
    }
    force -= (scale * sum) * normal;
    moment -= scale * cross(at, normal);
  }
  for (const Face& f : body.faces()) {  // the rim: sides that a face of self has in common with one of other
    if (f.of_other) continue;
    const Vec3d normal = axes(f.normal);
    const double slope = turn * (tilt.u * normal.x + tilt.v * normal.y);
    if (slope == 0) continue;
    for (std::uint32_t k = 0; k < f.count; ++k) {
      const std::uint32_t i = body.name(f, k), j = body.name(f, k + 1 == f.count ? 0 : k + 1);
      const Face* g = body.face_of_other(j, i);
      if (g == nullptr) continue;
      const Vec3d across = axes(g->normal);
      const double sine = norm(cross(normal, across));
      if (!(sine > 0)) continue;
      const double weight = slope / sine * norm(places[j] - places[i]);
      force -= weight * across;
      moment -= weight * cross(0.5 * (places[i] + places[j]), across);
    }
  }
  const auto back = [&](const Vec3d& x) { return axes.t * x.x + axes.s * x.y + axes.n * x.z; };
  out.force = back(force);
  out.moment = back(moment);
  out.centroid = apex + back(c);
  return true;
}

}  // namespace contact
