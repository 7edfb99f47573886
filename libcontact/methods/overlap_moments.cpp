#include "libcontact/methods/overlap_moments.h"

#include <cmath>
#include <span>

#include "libcontact/methods/depth_spread.h"
#include "libcontact/methods/overlap_forms.h"

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

// What a body is summed over: a fan of triangles in each face, spread from the first of its corners. `cones`: those of
// faces without corner 0, `of_other`: those of other's faces, `rim`: sides with self's face to the left, other's to the
// right. And scratch for its corners.
struct Sums {
  std::size_t corners = 0;
  std::span<const Triangle> cones, of_other;
  std::span<const Side> rim;
  ScratchList<Vec3d> arms, places;
  ScratchList<double> residuals, volumes;

  void gather(const OverlapBody& body) {
    const auto faces = body.faces();
    const auto sides = body.sides();
    corners = body.corners().size();
    arms.make_room(corners);
    places.make_room(corners);
    residuals.make_room(corners);
    volumes.make_room(corners);
    fans_.make_room(faces.size());
    cones_.make_room(2 * sides.size() + 1);
    of_other_.make_room(2 * sides.size() + 1);
    rim_.make_room(sides.size() + 1);
    std::uint32_t* const fans = fans_.data();
    for (std::size_t i = 0; i < faces.size(); ++i) fans[i] = OverlapBody::none;
    for (const Side& s : sides) {
      const std::uint32_t first = std::min(s.from, s.to);
      fans[s.left] = std::min(fans[s.left], first);
      fans[s.right] = std::min(fans[s.right], first);
    }
    // No branch on what cannot be guessed.
    Triangle *cone = cones_.data(), *other = of_other_.data();
    Side* between = rim_.data();
    for (const Side& s : sides) {
      const std::size_t left = faces[s.left].of_other, right = faces[s.right].of_other;
      const std::uint32_t f = fans[s.left], g = fans[s.right];
      const std::size_t in_left = static_cast<std::size_t>(f != s.from) & static_cast<std::size_t>(f != s.to),
                        in_right = static_cast<std::size_t>(g != s.from) & static_cast<std::size_t>(g != s.to);
      *cone = {f, s.from, s.to};
      cone += in_left & static_cast<std::size_t>(f != 0);
      *other = {f, s.from, s.to};
      other += in_left & left;
      *cone = {g, s.to, s.from};
      cone += in_right & static_cast<std::size_t>(g != 0);
      *other = {g, s.to, s.from};
      other += in_right & right;
      *between = left != 0 ? Side{s.to, s.from, s.right, s.left} : s;
      between += left ^ right;
    }
    cones = {cones_.data(), cone};
    of_other = {of_other_.data(), other};
    rim = {rim_.data(), between};
  }

 private:
  ScratchList<std::uint32_t> fans_;  // of faces: the corner
  ScratchList<Triangle> cones_, of_other_;
  ScratchList<Side> rim_;
};

bool general_slope(const OverlapBody& body, double size, DepthSlope& out) {
  static thread_local Sums sums;
  sums.gather(body);
  const Vec3d* const corners = body.corners().data();
  const OverlapBody::Face* const faces = body.faces().data();
  const Vec3d apex = corners[0];
  Vec3d surface{};  // vector area of what lies of self's surface in other
  for (const Side& s : sums.rim) surface += cross(corners[s.from] - apex, corners[s.to] - apex);
  surface *= 0.5;
  const double section = norm(surface);
  if (!(section > least_depth * least_depth * size * size)) return false;
  const Axes axes(surface * (1 / section));

  const std::size_t count = sums.corners;
  // Along the axes, from corner 0 and from the middle of the corners: about that an even body has no moment at all, not
  // one of rounding.
  Vec3d *const arms = sums.arms.data(), *const places = sums.places.data();
  double *const residuals = sums.residuals.data(), *const volumes = sums.volumes.data();
  Vec3d middle{};
  for (std::size_t i = 0; i < count; ++i) {
    arms[i] = axes(corners[i] - apex);
    middle += arms[i];
  }
  middle *= 1 / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    places[i] = arms[i] - middle;
    volumes[i] = 0;
  }
  const Vec3d top = places[0];
  // Of a cone of volume v over a triangle: ∫x = v/4 Σ, ∫xxᵀ = v/20 (ΣΣᵀ + Σ xxᵀ), Σ the sum of its four corners.
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
  for (const auto& [f, p, q] : sums.cones) {
    const double v = dot(arms[f], cross(arms[p], arms[q]));
    const Vec3d sum = top + places[f] + places[p] + places[q];
    volume += v;
    volumes[f] += v;
    volumes[p] += v;
    volumes[q] += v;
    c += v * sum;
    add(v, sum);
  }
  if (!(volume > 0)) return false;
  volumes[0] = volume;
  for (std::size_t i = 0; i < count; ++i) add(volumes[i], places[i]);
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
  const double level = c.z - tilt.u * c.x - tilt.v * c.y;
  for (std::size_t i = 0; i < count; ++i) {
    residuals[i] = (places[i].z - level) - (tilt.u * places[i].x + tilt.v * places[i].y);
  }

  Vec3d force{}, moment{};                       // along the axes
  for (const auto& [f, p, q] : sums.of_other) {  // (4)
    const CornerWeights at(0.5, residuals[f], residuals[p], residuals[q], variance);
    const Vec3d twice = cross(places[p] - places[f], places[q] - places[f]);
    force += at.sum() * twice;
    moment += cross(at.a * places[f] + at.b * places[p] + at.c * places[q], twice);
  }
  const double scale = -out.depth / (2 * variance * volume);
  const auto back = [&](const Vec3d& x) { return axes.t * x.x + axes.s * x.y + axes.n * x.z; };
  out.force = back(scale * force);
  out.moment = back(scale * moment);
  out.volume = volume;
  out.tt = xx, out.uu = yy, out.tu = xy;
  out.t = axes.t, out.u = axes.s;
  // The rim, along the body's axes.
  const Vec3d about = apex + back(middle);
  const Vec3d slope = (out.depth / section) * (tilt.u * axes.t + tilt.v * axes.s);
  for (const Side& s : sums.rim) {
    const Vec3d &normal = faces[s.left].normal, &across = faces[s.right].normal;
    const Vec3d &from = corners[s.from], &to = corners[s.to], along = to - from, sine = cross(normal, across);
    const double square = dot(sine, sine);
    if (!(square > 0x1p-60)) continue;  // in one plane to rounding: nowhere in particular
    const double weight = dot(slope, normal) * (dot(along, sine) / square);  // n_a × n_b runs along the side
    out.force -= weight * across;
    out.moment -= weight * cross(0.5 * (from + to) - about, across);
  }
  const Vec3d shift = back(c);
  out.centroid = about + shift;
  out.moment -= cross(shift, out.force);
  return true;
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
  if (body.form() == OverlapBody::Form::corner) return corner_slope(body, size, out);
  if (body.form() == OverlapBody::Form::edges) return edges_slope(body, size, out);
  return general_slope(body, size, out);
}

}  // namespace contact
