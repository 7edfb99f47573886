#include "libcontact/methods/overlap_moments.h"

#include <cmath>

#include "libcontact/methods/depth_spread.h"

namespace contact {

namespace {

using Face = OverlapBody::Face;
using Side = OverlapBody::Side;

// Axes with n last.
struct Axes {
  Vec3d t, s, n;
  explicit Axes(const Vec3d& normal) : n(normal) { tangent_frame(n, t, s); }
  Vec3d operator()(const Vec3d& x) const { return {dot(t, x), dot(s, x), dot(n, x)}; }
};

// Per corner and face of a body.
struct Work {
  ScratchList<Vec3d> places;
  ScratchList<double> residuals, volumes;
  ScratchList<std::uint32_t> fans;
};

// Calls visit(f, p, q) for the triangles of a fan in each face, f the corner that it spreads from.
template <class Visit>
void each_triangle(const OverlapBody& body, const std::uint32_t* fans, Visit&& visit) {
  for (const Side& s : body.sides()) {
    if (const std::uint32_t f = fans[s.left]; f != s.from && f != s.to) visit(s.left, f, s.from, s.to);
    if (const std::uint32_t f = fans[s.right]; f != s.from && f != s.to) visit(s.right, f, s.to, s.from);
  }
}

}  // namespace

OverlapDepth line_of_action(const DepthSlope& s) {
  OverlapDepth out{.depth = s.depth, .gain = norm(s.force)};
  out.normal = s.force * (1 / out.gain);
  out.point = s.centroid + cross(out.normal, s.moment) * (1 / out.gain);
  out.screw = dot(out.normal, s.moment) / out.gain;
  return out;
}

bool depth_slope(const OverlapBody& body, double size, DepthSlope& out) {
  if (body.empty()) return false;
  const auto corners = body.corners();
  const auto faces = body.faces();
  const Vec3d apex = corners[0];
  // Vector area of what lies of self's surface in other, from the rim between the two.
  Vec3d surface{};
  for (const Side& s : body.sides()) {
    const bool left = faces[s.left].of_other, right = faces[s.right].of_other;
    if (left == right) continue;
    const Vec3d twice = cross(corners[s.from] - apex, corners[s.to] - apex);
    surface += right ? 0.5 * twice : -0.5 * twice;
  }
  const double section = norm(surface);
  if (!(section > least_depth * least_depth * size * size)) return false;
  const Axes axes(surface * (1 / section));

  static thread_local Work work;
  const std::size_t count = corners.size();
  work.places.make_room(count);
  work.residuals.make_room(count);
  work.volumes.make_room(count);
  work.fans.make_room(faces.size());
  Vec3d* const places = work.places.data();  // along the axes, from the apex
  double *const residuals = work.residuals.data(), *const volumes = work.volumes.data();
  std::uint32_t* const fans = work.fans.data();
  for (std::size_t i = 0; i < count; ++i) {
    places[i] = axes(corners[i] - apex);
    volumes[i] = 0;
  }
  // Faces with the apex spread from there: they have no part in the volume.
  std::fill_n(fans, faces.size(), OverlapBody::none);
  for (const Side& s : body.sides()) {
    const bool at_apex = s.from == 0 || s.to == 0;
    for (const std::uint32_t f : {s.left, s.right})
      if (at_apex || fans[f] == OverlapBody::none) fans[f] = at_apex ? 0 : s.from;
  }
  // Of a cone of volume v with its apex in the origin over a triangle: ∫x = v/4 Σ, ∫xxᵀ = v/20 (ΣΣᵀ + Σ xxᵀ), Σ the sum
  // of its corners.
  double volume = 0, xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
  Vec3d c{};
  const auto add = [&](double v, const Vec3d& a) {
    xx += v * (a.x * a.x);
    yy += v * (a.y * a.y);
    zz += v * (a.z * a.z);
    xy += v * (a.x * a.y);
    xz += v * (a.x * a.z);
    yz += v * (a.y * a.z);
  };
  each_triangle(body, fans, [&](std::uint32_t, std::uint32_t f, std::uint32_t p, std::uint32_t q) {
    if (f == 0) return;
    const double v = dot(places[f], cross(places[p], places[q]));
    const Vec3d sum = places[f] + places[p] + places[q];
    volume += v;
    volumes[f] += v;
    volumes[p] += v;
    volumes[q] += v;
    c += v * sum;
    add(v, sum);
  });
  if (!(volume > 0)) return false;
  for (std::size_t i = 1; i < count; ++i) add(volumes[i], places[i]);
  const double w = 0.05 / volume;
  c *= 0.25 / volume;
  volume *= 1.0 / 6;
  xx = w * xx - c.x * c.x, yy = w * yy - c.y * c.y, zz = w * zz - c.z * c.z;
  xy = w * xy - c.x * c.y, xz = w * xz - c.x * c.z, yz = w * yz - c.y * c.z;
  Tilt tilt;
  if (!find_tilt(xx, yy, zz, xy, xz, yz, tilt)) return false;
  const double variance = tilt.variance;
  out.depth = std::sqrt(12 * variance);  // (1)
  if (!(out.depth > least_depth * size)) return false;
  for (std::size_t i = 0; i < count; ++i) {
    places[i] -= c;
    residuals[i] = places[i].z - tilt.u * places[i].x - tilt.v * places[i].y;
  }

  Vec3d force{}, moment{};  // along the axes
  each_triangle(body, fans, [&](std::uint32_t face, std::uint32_t f, std::uint32_t p, std::uint32_t q) {  // (4)
    if (!faces[face].of_other) return;
    const CornerWeights at(0.5, residuals[f], residuals[p], residuals[q], variance);
    const Vec3d twice = cross(places[p] - places[f], places[q] - places[f]);
    force += at.sum() * twice;
    moment += cross(at.a * places[f] + at.b * places[p] + at.c * places[q], twice);
  });
  const double scale = -out.depth / (2 * variance * volume);
  const auto back = [&](const Vec3d& x) { return axes.t * x.x + axes.s * x.y + axes.n * x.z; };
  out.force = back(scale * force);
  out.moment = back(scale * moment);
  out.centroid = apex + back(c);
  // The rim, along the body's axes.
  const Vec3d slope = (out.depth / section) * (tilt.u * axes.t + tilt.v * axes.s);
  for (const Side& s : body.sides()) {
    const Face &left = faces[s.left], &right = faces[s.right];
    if (left.of_other == right.of_other) continue;
    const Vec3d &normal = (left.of_other ? right : left).normal, &across = (left.of_other ? left : right).normal;
    const Vec3d &from = corners[s.from], &to = corners[s.to], along = to - from, sine = cross(normal, across);
    const double square = dot(sine, sine);
    if (!(square > 0)) continue;
    const double weight = dot(slope, normal) * std::sqrt(dot(along, along) / square);
    out.force -= weight * across;
    out.moment -= weight * cross(0.5 * (from + to) - out.centroid, across);
  }
  return true;
}

}  // namespace contact
