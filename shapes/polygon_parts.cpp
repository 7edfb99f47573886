#include "shapes/polygon_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "shapes/convex.h"
#include "shapes/polyhedron_build.h"

namespace shapes {

namespace {

constexpr std::uint32_t none = Polygon::none;

struct Side {
  std::uint32_t edge = none, cut = none;  // one of the two
  bool second = false;                    // of the two sides of a cut
};

struct Loop {
  std::vector<Vec3d> vertices;
  std::vector<std::uint32_t> corner;  // of the outline, or none
  std::vector<Side> sides;            // from vertex k to vertex k + 1
  std::size_t size() const { return vertices.size(); }
  std::size_t next(std::size_t i) const { return i + 1 == size() ? 0 : i + 1; }
  std::size_t before(std::size_t i) const { return i == 0 ? size() - 1 : i - 1; }
  void add(const Vec3d& v, std::uint32_t c, const Side& s) {
    vertices.push_back(v);
    corner.push_back(c);
    sides.push_back(s);
  }
};

struct Cut {
  Vec3d from, to;
  std::uint32_t corner[2];
  Vec3d normal;  // out of the part on its first side
  double offset;
};

double turn(const Vec3d& a, const Vec3d& b) { return convex::accurate_cross(a, b).z; }

bool is_reflex(const Loop& l, std::size_t i) {
  const Vec3d &a = l.vertices[l.before(i)], &b = l.vertices[i], &c = l.vertices[l.next(i)];
  return l.corner[i] != none && turn(b - a, c - b) < 0;
}

// Into the polygon, at the reflex corner i; unit.
Vec3d bisector(const Loop& l, std::size_t i) {
  const Vec3d in = convex::unit(l.vertices[i] - l.vertices[l.before(i)]);
  const Vec3d out = convex::unit(l.vertices[l.next(i)] - l.vertices[i]);
  return convex::unit(dot(in, out) < 0 ? in - out : Vec3d{-in.y - out.y, in.x + out.x, 0});
}

struct Hit {
  std::size_t side = 0, vertex = 0;
  bool at_vertex = false;
  Vec3d point;
};

// Where the ray from vertex i first leaves the loop; throws Error when rounding hides that.
Hit first_hit(const Loop& l, std::size_t i, const Vec3d& ray) {
  const Vec3d& from = l.vertices[i];
  Hit hit;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t j = l.next(i); j != l.before(i); j = l.next(j)) {
    const Vec3d p = l.vertices[j] - from, q = l.vertices[l.next(j)] - from;
    const double right = turn(ray, p), left = turn(ray, q);
    if (!(right <= 0 && left >= 0 && left > right)) continue;
    const double along = turn(p, q - p) / (left - right);
    if (!(along > 0 && along < nearest)) continue;
    nearest = along;
    hit.side = j;
    hit.point = from + along * ray;
  }
  if (!(nearest < std::numeric_limits<double>::infinity()))
    throw Error("polygon: corner " + std::to_string(l.corner[i]) + " is too narrow to be cut into convex parts");
  for (const std::size_t end : {hit.side, l.next(hit.side)})
    if (max_abs(hit.point - l.vertices[end]) <= convex::rounding && end != l.next(i) && end != l.before(i)) {
      hit.at_vertex = true;
      hit.vertex = end;
      hit.point = l.vertices[end];
    }
  return hit;
}

// The loop as two, with a side on the cut each.
void split(const Loop& l, std::size_t i, const Hit& hit, std::uint32_t cut, Loop& first, Loop& second) {
  const std::size_t last = hit.at_vertex ? hit.vertex : hit.side;
  for (std::size_t k = i; k != last; k = l.next(k)) first.add(l.vertices[k], l.corner[k], l.sides[k]);
  if (!hit.at_vertex) first.add(l.vertices[last], l.corner[last], l.sides[last]);
  first.add(hit.point, hit.at_vertex ? l.corner[last] : none, {none, cut, false});
  second.add(hit.point, hit.at_vertex ? l.corner[last] : none, l.sides[last]);
  for (std::size_t k = l.next(last); k != i; k = l.next(k)) second.add(l.vertices[k], l.corner[k], l.sides[k]);
  second.add(l.vertices[i], l.corner[i], {none, cut, true});
}

Polygon::Part part_of(const Polygon& p, const Loop& l, const std::vector<Cut>& cuts) {
  Polygon::Part part;
  for (std::size_t k = 0; k < l.size(); ++k) {
    const Side& side = l.sides[k];
    const bool outer = side.edge != none;
    part.vertices.push_back(l.vertices[k]);
    part.edge.push_back(side.edge);
    const double sign = side.second ? -1 : 1;
    part.normals.push_back(outer ? p.normals[side.edge] : sign * cuts[side.cut].normal);
    part.offsets.push_back(outer ? p.offsets[side.edge] : sign * cuts[side.cut].offset);
  }
  add_circle(part);
  return part;
}

// Parts on either side of a cut that share a piece of it.
void add_seams(Polygon& p, const std::vector<Loop>& loops, const std::vector<Cut>& cuts) {
  struct Reach {
    std::uint32_t part;
    double low, high;  // share of the cut
  };
  for (std::uint32_t c = 0; c < cuts.size(); ++c) {
    const Vec3d along = cuts[c].to - cuts[c].from;
    std::vector<Reach> sides[2];
    for (std::uint32_t i = 0; i < loops.size(); ++i)
      for (std::size_t k = 0; k < loops[i].size(); ++k) {
        const Side& side = loops[i].sides[k];
        if (side.cut != c) continue;
        const auto share = [&](const Vec3d& v) { return dot(v - cuts[c].from, along) / dot(along, along); };
        const double a = share(loops[i].vertices[k]), b = share(loops[i].vertices[loops[i].next(k)]);
        sides[side.second ? 1 : 0].push_back({i, std::min(a, b), std::max(a, b)});
      }
    for (const Reach& a : sides[0])
      for (const Reach& b : sides[1]) {
        const double low = std::max(a.low, b.low), high = std::min(a.high, b.high);
        if (!(high - low > convex::rounding)) continue;
        const auto at = [&](double share) {
          return share == 0 ? cuts[c].from : share == 1 ? cuts[c].to : cuts[c].from + share * along;
        };
        p.seams.push_back({{a.part, b.part}, {at(low), at(high)}, {cuts[c].corner[0], cuts[c].corner[1]}});
      }
  }
}

}  // namespace

void add_circle(Polygon::Part& part) {
  Vec3d low = part.vertices[0], high = low;
  for (const Vec3d& v : part.vertices)
    for (int d = 0; d < 2; ++d) {
      low[d] = std::min(low[d], v[d]);
      high[d] = std::max(high[d], v[d]);
    }
  part.centre = 0.5 * (low + high);
  for (const Vec3d& v : part.vertices) part.radius = std::max(part.radius, norm(v - part.centre));
}

void to_units(Polygon& p, int exponent) {
  const auto points = [&](std::vector<Vec3d>& list) {
    for (Vec3d& x : list) x = convex::times_two_to(x, exponent);
  };
  const auto lengths = [&](std::vector<double>& list) {
    for (double& x : list) x = std::ldexp(x, exponent);
  };
  points(p.vertices);
  lengths(p.offsets);
  for (Polygon::Part& part : p.parts) {
    points(part.vertices);
    lengths(part.offsets);
    part.centre = convex::times_two_to(part.centre, exponent);
    part.radius = std::ldexp(part.radius, exponent);
  }
  for (Polygon::Seam& seam : p.seams)
    for (Vec3d& x : seam.end) x = convex::times_two_to(x, exponent);
  p.area = std::ldexp(p.area, 2 * exponent);
  p.centroid = convex::times_two_to(p.centroid, exponent);
  p.second_moment = std::ldexp(p.second_moment, 4 * exponent);
  p.circumradius = std::ldexp(p.circumradius, exponent);
  p.inscribed_radius = std::ldexp(p.inscribed_radius, exponent);
}

void cut_into_parts(Polygon& p) {
  Loop whole;
  for (std::uint32_t i = 0; i < p.vertices.size(); ++i) whole.add(p.vertices[i], i, {i, none, false});
  std::vector<Loop> open{std::move(whole)}, loops;
  std::vector<Cut> cuts;
  while (!open.empty()) {
    const Loop l = std::move(open.back());
    open.pop_back();
    std::size_t i = 0;
    while (i < l.size() && !is_reflex(l, i)) ++i;
    if (i == l.size() || p.convex) {
      loops.push_back(l);
      continue;
    }
    if (cuts.size() > 2 * p.vertices.size()) throw Error("polygon: too narrow to be cut into convex parts");
    const Hit hit = first_hit(l, i, bisector(l, i));
    const Vec3d along = l.vertices[i] - hit.point, normal = convex::unit({along.y, -along.x, 0});
    const std::uint32_t end = hit.at_vertex && is_reflex(l, hit.vertex) ? l.corner[hit.vertex] : none;
    Loop first, second;
    split(l, i, hit, static_cast<std::uint32_t>(cuts.size()), first, second);
    cuts.push_back({l.vertices[i],
                    hit.point,
                    {l.corner[i], end},
                    normal,
                    0.5 * (dot(normal, hit.point) + dot(normal, l.vertices[i]))});
    open.push_back(std::move(second));
    open.push_back(std::move(first));
  }
  for (const Loop& l : loops) p.parts.push_back(part_of(p, l, cuts));
  add_seams(p, loops, cuts);
}

}  // namespace shapes
