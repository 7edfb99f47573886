#include "shapes/compound_build.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "shapes/cells.h"
#include "shapes/compound_parts.h"
#include "shapes/compound_reach.h"
#include "shapes/convex.h"
#include "shapes/geometry.h"
#include "shapes/polyhedron_build.h"

namespace shapes {
namespace {

using compound::Part;
using Kind = Compound::PartKind;

double largest_coordinate(const CompoundPart& p) {
  const double size = std::visit([](const auto& s) { return circumradius(s); }, p.solid);
  return max_abs(p.pose.position) + size;
}

Polyhedron moved(const Polyhedron& p, const Mat3d& rotation, const Vec3d& position) {
  std::vector<Vec3d> points;
  for (const Vec3d& v : p.vertices) points.push_back(rotation * v + position);
  return polyhedron_from_points(points, Frame::as_given);
}

// The part in the frame of the input, times 2^-exponent.
Part placed(const CompoundPart& input, int exponent) {
  Part part;
  const Quatd& q = input.pose.orientation;
  const bool turned = !(q.x == 0 && q.y == 0 && q.z == 0);
  const Mat3d rotation = turned ? rotation_matrix(normalized(q)) : Mat3d::identity();
  part.centre = convex::times_two_to(input.pose.position, -exponent);
  if (const auto* sphere = std::get_if<Sphere>(&input.solid)) {
    const double r = std::ldexp(sphere->radius, -exponent);
    part.size = {r, r, r};
  } else if (const auto* ellipsoid = std::get_if<Ellipsoid>(&input.solid)) {
    part.kind = Kind::ellipsoid;
    part.rotation = rotation;
    if (turned) part.orientation = normalized(q);
    part.size = convex::times_two_to(ellipsoid->semi_axes, -exponent);
  } else {
    part.kind = Kind::polyhedron;
    part.size = {1, 1, 1};
    part.solid = moved(scaled(std::get<Polyhedron>(input.solid), std::ldexp(1.0, -exponent)), rotation, part.centre);
    part.centre = part.solid.mass.centre;
  }
  return part;
}

// Every point of a lies in b, as far as is easily seen.
bool inside(const Part& a, const Part& b) {
  constexpr double rounding = convex::rounding;
  if (b.kind == Kind::polyhedron)
    return std::all_of(b.solid.faces.begin(), b.solid.faces.end(),
                       [&](const auto& f) { return compound::highest(a, f.normal) <= f.offset + rounding; });
  const double least = std::min({b.size.x, b.size.y, b.size.z});
  if (a.kind == Kind::polyhedron)
    return std::all_of(a.solid.vertices.begin(), a.solid.vertices.end(), [&](const Vec3d& v) {
      const Vec3d x = transposed_times(b.rotation, v - b.centre);
      return norm(Vec3d{x.x / b.size.x, x.y / b.size.y, x.z / b.size.z}) <= 1 + rounding;
    });
  const Vec3d offset = a.centre - b.centre;
  if (b.kind == a.kind && max_abs(offset) == 0 && a.size == b.size) {
    const Mat3d turn = transposed(a.rotation) * b.rotation;
    if (turn.row[0].x == 1 && turn.row[1].y == 1 && turn.row[2].z == 1) return true;
  }
  return norm(offset) + max_abs(a.size) <= least + rounding;
}

void drop_inner(std::vector<Part>& parts) {
  for (std::size_t i = parts.size(); i-- > 0;)
    for (std::size_t j = 0; j < parts.size(); ++j)
      if (i != j && inside(parts[i], parts[j])) {
        parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(i));
        break;
      }
}

constexpr double convex_tolerance = 1e-9;  // of the volume: decimals that were typed may leave cracks

// The hull of polyhedra when it is their union.
bool convex_union(const std::vector<const Part*>& parts, Polyhedron& hull) {
  std::vector<Vec3d> points;
  std::vector<const Polyhedron*> solids;
  for (const Part* p : parts) {
    points.insert(points.end(), p->solid.vertices.begin(), p->solid.vertices.end());
    solids.push_back(&p->solid);
  }
  hull = polyhedron_from_points(points, Frame::as_given);
  double sum = 0;
  for (const Polyhedron* s : solids) sum += s->mass.volume;
  if (sum < (1 - convex_tolerance) * hull.mass.volume) return false;  // overlaps would only lessen it
  double volume = 0;
  for (const convex::Cell& cell : convex::disjoint_cells(solids)) volume += convex::volume_of(cell);
  return volume >= (1 - convex_tolerance) * hull.mass.volume;
}

Part part_of(Polyhedron solid) {
  Part p;
  p.kind = Kind::polyhedron;
  p.size = {1, 1, 1};
  p.centre = solid.mass.centre;
  p.solid = std::move(solid);
  return p;
}

// All polyhedra at once, then pairs.
void merge_convex(std::vector<Part>& parts) {
  const bool all = std::all_of(parts.begin(), parts.end(), [](const Part& p) { return p.kind == Kind::polyhedron; });
  Polyhedron hull;
  if (all && parts.size() > 1) {
    std::vector<const Part*> list;
    for (const Part& p : parts) list.push_back(&p);
    if (convex_union(list, hull)) {
      parts = {part_of(std::move(hull))};
      return;
    }
  }
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = i + 1; j < parts.size(); ++j) {
      if (parts[i].kind != Kind::polyhedron || parts[j].kind != Kind::polyhedron) continue;
      if (!convex_union({&parts[i], &parts[j]}, hull)) continue;
      parts[i] = part_of(std::move(hull));
      parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(j));
      i = static_cast<std::size_t>(-1);  // from the start again
      break;
    }
}

void check(std::span<const CompoundPart> parts) {
  if (parts.empty()) throw Error("no parts; allowed: at least one");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Quatd& q = parts[i].pose.orientation;
    const double size = largest_coordinate(parts[i]), square = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    const double volume = std::visit([](const auto& s) { return mass_properties(s).volume; }, parts[i].solid);
    if (!(volume > 0) || !std::isfinite(size) || !(square > 0.25 && square < 4))
      throw Error("part " + std::to_string(i) + ": size, position and orientation must be finite, the size positive");
  }
}

Compound::Part finished(const Part& p, const Pose& frame, const Mat3d& rotation) {
  Compound::Part out;
  out.kind = p.kind;
  const auto to_body = [&](const Vec3d& x) { return transposed_times(rotation, x - frame.position); };
  out.centre = to_body(p.centre);
  out.size = p.size;
  if (p.kind != Kind::polyhedron) {
    if (p.kind == Kind::ellipsoid) {
      out.orientation = normalized(conjugate(frame.orientation) * p.orientation);
      out.rotation = rotation_matrix(out.orientation);
    }
    out.bounding_radius = max_abs(p.size);
    out.inscribed_radius = std::min({p.size.x, p.size.y, p.size.z});
    out.equivalent_radius =
        p.kind == Kind::sphere ? p.size.x : equivalent_radius(mass_properties(Ellipsoid{p.size}).volume);
    return out;
  }
  std::vector<Vec3d> points;
  for (const Vec3d& v : p.solid.vertices) points.push_back(to_body(v) - out.centre);
  out.solid = std::make_shared<const Polyhedron>(polyhedron_from_points(points, Frame::as_given));
  out.bounding_radius = out.solid->circumradius;
  out.inscribed_radius = out.solid->inscribed_radius;
  out.equivalent_radius = equivalent_radius(out.solid->mass.volume);
  return out;
}

double farthest(const Compound::Part& p) {
  if (p.kind != Kind::polyhedron) return norm(p.centre) + p.bounding_radius;
  double r = 0;
  for (const Vec3d& v : p.solid->vertices) r = std::max(r, norm(v + p.centre));
  return r;
}

// One sphere or ellipsoid stands in its own frame, one polyhedron in the frame that polyhedra make for themselves.
void finish_single(const Part& part, Compound& body) {
  if (part.kind != Kind::polyhedron) {
    body.frame = {part.centre, part.orientation};
    body.mass = mass_properties(Ellipsoid{part.size});
    Part own = part;
    own.centre = {};
    own.rotation = Mat3d::identity();
    own.orientation = {};
    body.parts.push_back(finished(own, {}, Mat3d::identity()));
    return;
  }
  Polyhedron whole = polyhedron_from_points(part.solid.vertices, Frame::principal);
  body.frame = whole.frame;
  body.mass = whole.mass;
  Compound::Part p;
  p.kind = Kind::polyhedron;
  p.size = {1, 1, 1};
  p.bounding_radius = whole.circumradius;
  p.inscribed_radius = whole.inscribed_radius;
  p.equivalent_radius = equivalent_radius(whole.mass.volume);
  p.solid = std::make_shared<const Polyhedron>(std::move(whole));
  body.parts.push_back(std::move(p));
}

void finish(std::vector<Part>& parts, Compound& body) {
  const compound::Moments moments = compound::moments_of_union(parts);
  body.mass = compound::mass_of(moments);
  body.mass_error = moments.error / moments.zeroth;
  body.frame = convex::principal_frame(body.mass, 1);
  const Quatd& q = body.frame.orientation;
  const Mat3d rotation = q.x == 0 && q.y == 0 && q.z == 0 ? Mat3d::identity() : rotation_matrix(q);
  compound::grow_through_inner_faces(parts);
  drop_inner(parts);
  for (const Part& p : parts) body.parts.push_back(finished(p, body.frame, rotation));
  body.joints = compound::joints_of(body.parts);
  for (const Compound::Joint& j : body.joints) {
    body.parts[j.a].neighbours.push_back(j.b);
    body.parts[j.b].neighbours.push_back(j.a);
  }
  const Mat3d turned = transposed(rotation) * body.mass.inertia * rotation;
  body.mass.inertia = Mat3d::diagonal({turned.row[0].x, turned.row[1].y, turned.row[2].z});
  body.mass.centre = {};
}

// Every length times 2^exponent.
void rescale(Compound& body, int exponent) {
  const double unit = std::ldexp(1.0, exponent);
  for (Compound::Part& p : body.parts) {
    p.centre *= unit;
    if (p.kind != Kind::polyhedron) p.size *= unit;
    for (double* r : {&p.bounding_radius, &p.inscribed_radius, &p.equivalent_radius}) *r *= unit;
    if (p.solid) p.solid = std::make_shared<const Polyhedron>(scaled(*p.solid, unit));
  }
  for (Compound::Joint& j : body.joints) {
    for (Vec3d& x : j.points) x *= unit;
    j.middle *= unit;
    j.radius *= unit;
  }
  body.circumradius *= unit;
  body.frame.position *= unit;
  body.mass.volume = std::ldexp(body.mass.volume, 3 * exponent);
  for (Vec3d& row : body.mass.inertia.row) row = convex::times_two_to(row, 5 * exponent);
}

}  // namespace

Compound make_compound(std::span<const CompoundPart> input) {
  check(input);
  double largest = 0;
  for (const CompoundPart& p : input) largest = std::max(largest, largest_coordinate(p));
  const int exponent = convex::exponent_above(largest);
  std::vector<Part> parts;
  for (const CompoundPart& p : input) parts.push_back(placed(p, exponent));
  drop_inner(parts);
  merge_convex(parts);
  Compound body;
  if (parts.size() == 1)
    finish_single(parts[0], body);
  else
    finish(parts, body);
  for (const Compound::Part& p : body.parts) body.circumradius = std::max(body.circumradius, farthest(p));
  rescale(body, exponent);
  return body;
}

}  // namespace shapes
