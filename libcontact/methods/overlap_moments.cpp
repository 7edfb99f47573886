#include "libcontact/methods/overlap_moments.h"

#include <cmath>

#include "libcontact/methods/depth_spread.h"

namespace contact {

namespace {

using Side = OverlapBody::Side;

// Axes with n last.
struct Axes {
  Vec3d t, s, n;
  explicit Axes(const Vec3d& normal) : n(normal) { tangent_frame(n, t, s); }
  Vec3d operator()(const Vec3d& x) const { return {dot(t, x), dot(s, x), dot(n, x)}; }
};

struct Triangle {
  std::uint32_t a, b, c;
};
// What a body is summed over: a fan of triangles in each face, spread from the first of its corners.
struct Work {
  ScratchList<Vec3d> places;                // of corners along the axes, from corner 0
  ScratchList<double> residuals, volumes;   // of corners
  ScratchList<std::uint32_t> fans;          // of faces: the corner
  ScratchList<Triangle> cones, of_other;    // those not at corner 0; those of other's faces
  ScratchList<Side> rim;                    // turned: self's face to the left
  std::size_t cone_count = 0, of_other_count = 0, rim_count = 0;

  void gather(const OverlapBody& body) {
    const auto faces = body.faces();
    const auto sides = body.sides();
    const std::size_t corners = body.corners().size();
    places.make_room(corners);
    residuals.make_room(corners);
    volumes.make_room(corners);
    fans.make_room(faces.size());
    cones.make_room(2 * sides.size() + 1);
    of_other.make_room(2 * sides.size() + 1);
    rim.make_room(sides.size() + 1);
    std::fill_n(fans.data(), faces.size(), OverlapBody::none);
    for (const Side& s : sides) {
      const std::uint32_t first = std::min(s.from, s.to);
      fans[s.left] = std::min(fans[s.left], first);
      fans[s.right] = std::min(fans[s.right], first);
    }
    // No branch on what cannot be guessed.
    std::size_t cone = 0, other = 0, between = 0;
    for (const Side& s : sides) {
      const bool left = faces[s.left].of_other, right = faces[s.right].of_other;
      const std::uint32_t f = fans[s.left], g = fans[s.right];
      const bool in_left = f != s.from && f != s.to, in_right = g != s.from && g != s.to;
      cones[cone] = {f, s.from, s.to};
      cone += in_left && f != 0 ? 1 : 0;
      of_other[other] = {f, s.from, s.to};
      other += in_left && left ? 1 : 0;
      cones[cone] = {g, s.to, s.from};
      cone += in_right && g != 0 ? 1 : 0;
      of_other[other] = {g, s.to, s.from};
      other += in_right && right ? 1 : 0;
      rim[between] = left ? Side{s.to, s.from, s.right, s.left} : s;
      between += left != right ? 1 : 0;
    }
    cone_count = cone, of_other_count = other, rim_count = between;
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
  if (body.empty()) return false;
  static thread_local Work work;
  work.gather(body);
  const auto corners = body.corners();
  const auto faces = body.faces();
  const std::span<const Side> rim(work.rim.data(), work.rim_count);
  const Vec3d apex = corners[0];
  Vec3d surface{};  // vector area of what lies of self's surface in other
  for (const Side& s : rim) surface += cross(corners[s.from] - apex, corners[s.to] - apex);
  surface *= 0.5;
  const double section = norm(surface);
  if (!(section > least_depth * least_depth * size * size)) return false;
  const Axes axes(surface * (1 / section));

  const std::size_t count = corners.size();
  Vec3d* const places = work.places.data();
  double *const residuals = work.residuals.data(), *const volumes = work.volumes.data();
  for (std::size_t i = 0; i < count; ++i) {
    places[i] = axes(corners[i] - apex);
    volumes[i] = 0;
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
  for (const auto& [f, p, q] : std::span<const Triangle>(work.cones.data(), work.cone_count)) {
    const double v = dot(places[f], cross(places[p], places[q]));
    const Vec3d sum = places[f] + places[p] + places[q];
    volume += v;
    volumes[f] += v;
    volumes[p] += v;
    volumes[q] += v;
    c += v * sum;
    add(v, sum);
  }
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
  for (const auto& [f, p, q] : std::span<const Triangle>(work.of_other.data(), work.of_other_count)) {  // (4)
    const CornerWeights at(0.5, residuals[f], residuals[p], residuals[q], variance);
    const Vec3d twice = cross(places[p] - places[f], places[q] - places[f]);
    force += at.sum() * twice;
    moment += cross(at.a * places[f] + at.b * places[p] + at.c * places[q], twice);
  }
  const double scale = -out.depth / (2 * variance * volume);
  const auto back = [&](const Vec3d& x) { return axes.t * x.x + axes.s * x.y + axes.n * x.z; };
  out.force = back(scale * force);
  out.moment = back(scale * moment);
  out.centroid = apex + back(c);
  out.volume = volume;
  out.tt = xx, out.uu = yy, out.tu = xy;
  out.t = axes.t, out.u = axes.s;
  // The rim, along the body's axes.
  const Vec3d slope = (out.depth / section) * (tilt.u * axes.t + tilt.v * axes.s);
  for (const Side& s : rim) {
    const Vec3d &normal = faces[s.left].normal, &across = faces[s.right].normal;
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
