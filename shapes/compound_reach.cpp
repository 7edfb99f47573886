#include "shapes/compound_reach.h"

#include <algorithm>
#include <cmath>

#include "shapes/cells.h"
#include "shapes/convex.h"
#include "shapes/geometry.h"
#include "shapes/polyhedron_build.h"

namespace shapes::compound {
namespace {

using Kind = Compound::PartKind;
using convex::Outline;

// A face is looked at from just outside: what covers it there hides it, what only ends in the same plane does not.
// Slanting sides of what covers it leave a rim of that width.
constexpr double outside = 1e-8, slack = 1e-9, left_over = 1e-6;

// What of a polygon lies outside a convex solid.
std::vector<Outline> uncovered(const std::vector<Outline>& polygons, const Polyhedron& solid) {
  std::vector<Outline> left;
  for (const Outline& polygon : polygons) {
    std::vector<Outline> pieces;
    Outline rest = polygon;
    for (const auto& f : solid.faces) {
      if (rest.empty()) break;
      Outline piece = convex::part_below(rest, -f.normal, -(f.offset + slack));
      if (!piece.empty()) pieces.push_back(std::move(piece));
      rest = convex::part_below(rest, f.normal, f.offset + slack);
    }
    if (rest.empty())
      left.push_back(polygon);  // nothing is covered: as it was
    else
      left.insert(left.end(), pieces.begin(), pieces.end());
  }
  return left;
}

bool is_hidden(const Polyhedron& solid, const Polyhedron::Face& face, const std::vector<const Polyhedron*>& others) {
  Outline polygon;
  for (std::uint32_t k = 0; k < face.count; ++k)
    polygon.push_back(solid.vertices[solid.face_vertices[face.first + k]] + outside * face.normal);
  const double area = convex::area_of(polygon);
  std::vector<Outline> left{polygon};
  for (const Polyhedron* other : others) left = uncovered(left, *other);
  double rest = 0;
  for (const Outline& piece : left) rest += convex::area_of(piece);
  return rest <= left_over * area;
}

// The solid grown through a hidden face into the parts behind it; false when that would not be convex.
bool grow_through(const Polyhedron& solid, std::size_t face, const std::vector<const Polyhedron*>& others,
                  Polyhedron& grown) {
  const auto& f = solid.faces[face];
  std::vector<convex::Cell> behind;
  std::vector<const Polyhedron*> before;
  for (const Polyhedron* other : others) {
    convex::Cell cell = convex::part_below(convex::cell_of(*other), -f.normal, -f.offset);
    for (std::size_t k = 0; k < solid.faces.size() && !cell.faces.empty(); ++k)
      if (k != face) cell = convex::part_below(cell, solid.faces[k].normal, solid.faces[k].offset);
    std::vector<convex::Cell> own{cell};
    for (const Polyhedron* b : before) {
      std::vector<convex::Cell> left;
      for (const convex::Cell& c : own)
        for (convex::Cell& piece : convex::difference(c, *b)) left.push_back(std::move(piece));
      own = std::move(left);
    }
    behind.insert(behind.end(), own.begin(), own.end());
    before.push_back(other);
  }
  double volume = solid.mass.volume;
  std::vector<Vec3d> points = solid.vertices;
  for (const convex::Cell& cell : behind) {
    const double v = convex::volume_of(cell);
    if (!(v > 0)) continue;
    volume += v;
    for (const Outline& polygon : cell.faces) points.insert(points.end(), polygon.begin(), polygon.end());
  }
  if (points.size() == solid.vertices.size()) return false;
  grown = polyhedron_from_points(points, Frame::as_given);
  return volume >= (1 - 1e-9) * grown.mass.volume && grown.mass.volume > (1 + 1e-9) * solid.mass.volume;
}

Polyhedron reach_of(const Polyhedron& solid, const std::vector<const Polyhedron*>& others) {
  Polyhedron reach = solid;
  for (bool again = true; again;) {
    again = false;
    for (std::size_t f = 0; f < reach.faces.size() && !again; ++f) {
      Polyhedron grown;
      if (!is_hidden(reach, reach.faces[f], others) || !grow_through(reach, f, others, grown)) continue;
      reach = std::move(grown);
      again = true;
    }
  }
  return reach;
}

// A round part as a polyhedron whose corners lie on its surface, in the frame of the body.
Polyhedron faceted(const Compound::Part& p) {
  static const Polyhedron ball = [] {
    std::vector<Vec3d> points = make_platonic(Platonic::icosahedron, 1).vertices;
    for (int level = 0; level < 3; ++level) {
      const Polyhedron coarse = polyhedron_from_points(points, Frame::as_given);
      points = coarse.vertices;
      for (const auto& e : coarse.edges)
        points.push_back(normalized(coarse.vertices[e.vertex[0]] + coarse.vertices[e.vertex[1]]));
    }
    return polyhedron_from_points(points, Frame::as_given);
  }();
  std::vector<Vec3d> points;
  for (const Vec3d& v : ball.vertices) points.push_back(p.centre + p.rotation * scaled(p.size, v));
  return polyhedron_from_points(points, Frame::as_given);
}

Polyhedron in_body(const Compound::Part& p) {
  if (p.kind != Kind::polyhedron) return faceted(p);
  std::vector<Vec3d> points;
  for (const Vec3d& v : p.solid->vertices) points.push_back(p.centre + v);
  return polyhedron_from_points(points, Frame::as_given);
}

// Corners of the intersection, which may be flat: of the faces of each within the other.
std::vector<Vec3d> common_points(const Polyhedron& a, const Polyhedron& b) {
  std::vector<Vec3d> points;
  const auto add = [&](const Polyhedron& p, const Polyhedron& q) {
    for (Outline face : convex::cell_of(p).faces) {
      for (const auto& f : q.faces) face = convex::part_below(face, f.normal, f.offset + slack);
      points.insert(points.end(), face.begin(), face.end());
    }
  };
  add(a, b);
  add(b, a);
  std::vector<Vec3d> kept;
  for (const std::uint32_t i : convex::distinct_points(points, slack)) kept.push_back(points[i]);
  return kept;
}

}  // namespace

void grow_through_inner_faces(std::vector<Part>& parts) {
  std::vector<Polyhedron> grown(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].kind != Kind::polyhedron) continue;
    std::vector<const Polyhedron*> others;
    for (std::size_t j = 0; j < parts.size(); ++j)
      if (j != i && parts[j].kind == Kind::polyhedron) others.push_back(&parts[j].solid);
    grown[i] = reach_of(parts[i].solid, others);
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].kind != Kind::polyhedron) continue;
    parts[i].solid = std::move(grown[i]);
    parts[i].centre = parts[i].solid.mass.centre;
  }
}

std::vector<Compound::Joint> joints_of(const std::vector<Compound::Part>& parts) {
  std::vector<Compound::Joint> joints;
  for (std::uint32_t i = 0; i < parts.size(); ++i)
    for (std::uint32_t j = i + 1; j < parts.size(); ++j) {
      const Compound::Part &a = parts[i], &b = parts[j];
      const Vec3d d = b.centre - a.centre;
      const double d2 = dot(d, d), sum = a.bounding_radius + b.bounding_radius;
      if (d2 > sum * sum * (1 + 1e-12)) continue;
      Compound::Joint joint{i, j, {}, {}, {}, 0};
      if (a.kind == Kind::sphere && b.kind == Kind::sphere) {
        const double r2 = a.size.x * a.size.x, t = 0.5 + 0.5 * (r2 - b.size.x * b.size.x) / d2;
        joint.axis = d * (1 / std::sqrt(d2));
        joint.middle = a.centre + t * d;
        joint.radius = std::sqrt(std::max(0.0, r2 - t * t * d2));
      } else {
        joint.points = common_points(in_body(a), in_body(b));
        if (joint.points.empty()) continue;
        for (const Vec3d& x : joint.points) joint.middle += x;
        joint.middle *= 1.0 / static_cast<double>(joint.points.size());
      }
      joints.push_back(std::move(joint));
    }
  return joints;
}

}  // namespace shapes::compound

namespace shapes {

const Compound::Joint* Compound::joint(std::uint32_t p, std::uint32_t q) const {
  const auto key = std::minmax(p, q);
  const auto found = std::lower_bound(joints.begin(), joints.end(), key, [](const Joint& j, const auto& k) {
    return std::pair(j.a, j.b) < std::pair(k.first, k.second);
  });
  return found != joints.end() && found->a == key.first && found->b == key.second ? &*found : nullptr;
}

double distance(const Compound::Part& part, const Vec3d& x) {
  const Vec3d local = x - part.centre;
  if (part.kind == Compound::PartKind::sphere) return norm(local) - part.size.x;
  if (part.kind == Compound::PartKind::polyhedron) {
    double highest = -part.bounding_radius;
    for (const auto& f : part.solid->faces) highest = std::max(highest, dot(f.normal, local) - f.offset);
    return highest;
  }
  const Vec3d b = transposed_times(part.rotation, local), &s = part.size;
  const Vec3d u{b.x / s.x, b.y / s.y, b.z / s.z}, g{u.x / s.x, u.y / s.y, u.z / s.z};
  const double level = norm(u), slope = norm(g);  // |∇ level| = slope / level
  return level > 0 ? (level - 1) * level / slope : -part.inscribed_radius;
}

double extent(const Compound& body, const Compound::Joint& joint, const Vec3d& n) {
  if (!joint.points.empty()) {
    double highest = dot(n, joint.points[0]);
    for (const Vec3d& x : joint.points) highest = std::max(highest, dot(n, x));
    return highest;
  }
  // Where the farthest point of one ball lies in the other, it is the answer; else it is on the circle.
  const Compound::Part &a = body.parts[joint.a], &b = body.parts[joint.b];
  for (const auto& [p, q] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const Vec3d tip = p->centre + p->size.x * n;
    if (norm(tip - q->centre) <= q->size.x) return dot(n, tip);
  }
  const double along = dot(n, joint.axis);
  return dot(n, joint.middle) + joint.radius * std::sqrt(std::max(0.0, 1 - along * along));
}

}  // namespace shapes
