#include "libdem/analysis/body_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dem::analysis {

namespace {

using shapes::Compound;
using shapes::Polyhedron;
using shapes::PotentialParticle;

void add(BodyPieces& body, BodyPiece piece) {
  piece.volume = piece.volume_of(piece.solid);
  if (!(piece.volume > 0)) return;
  Vec3d lower = piece.solid.corners()[0], upper = lower;
  for (const Vec3d& v : piece.solid.corners())
    for (int k = 0; k < 3; ++k) lower[k] = std::min(lower[k], v[k]), upper[k] = std::max(upper[k], v[k]);
  piece.middle = 0.5 * (lower + upper);
  for (const Vec3d& v : piece.solid.corners()) piece.reach = std::max(piece.reach, norm(v - piece.middle));
  piece.reach *= 1 + 1e-12;  // rounding
  body.volume += piece.volume;
  body.pieces.push_back(std::move(piece));
}

void add_solid(BodyPieces& body, CutSolid solid) {
  BodyPiece piece;
  piece.solid = std::move(solid);
  add(body, std::move(piece));
}

CutSolid cube_about(const Vec3d& centre, double half) {
  const Vec3d h{half, half, half};
  return CutSolid::box(centre - h, centre + h);
}

void add_ball(BodyPieces& body, CutSolid solid, const RoundFrame& frame) {
  BodyPiece piece;
  piece.kind = BodyPiece::Kind::ball;
  piece.solid = std::move(solid);
  piece.frame = frame;
  add(body, std::move(piece));
}

void add_rounded(BodyPieces& body, const Polyhedron& core, double radius) {
  add_solid(body, CutSolid::of(core));
  std::vector<Vec3d> loop;
  for (const auto& f : core.faces) {
    loop.clear();
    for (std::uint32_t i = 0; i < f.count; ++i) loop.push_back(core.vertices[core.face_vertices[f.first + i]]);
    add_solid(body, CutSolid::prism(loop, f.normal, radius));
  }
  std::vector<CutSolid> corner;
  for (const Vec3d& v : core.vertices) corner.push_back(cube_about(v, radius));
  for (const auto& e : core.edges) {
    const Vec3d &a = core.vertices[e.vertex[0]], &b = core.vertices[e.vertex[1]];
    const Vec3d along = normalized(b - a);
    BodyPiece piece;
    piece.kind = BodyPiece::Kind::cylinder;
    piece.point = a;
    piece.along = along;
    piece.radius = radius;
    Vec3d lower{}, upper{};
    for (int k = 0; k < 3; ++k) {
      lower[k] = std::min(a[k], b[k]) - radius;
      upper[k] = std::max(a[k], b[k]) + radius;
    }
    piece.solid = CutSolid::box(lower, upper);
    piece.solid.cut(along, dot(along, b));
    piece.solid.cut(-along, -dot(along, a));
    // Between the normals of its faces: on the outer side of both.
    for (const int side : {0, 1}) {
      const Vec3d into_face = (side == 0 ? 1.0 : -1.0) * cross(core.faces[e.face[side]].normal, along);
      piece.solid.cut(into_face, dot(into_face, a));
    }
    add(body, std::move(piece));
    corner[e.vertex[0]].cut(along, dot(along, a));
    corner[e.vertex[1]].cut(-along, -dot(along, b));
  }
  for (std::size_t i = 0; i < corner.size(); ++i)
    add_ball(body, std::move(corner[i]), round_frame(core.vertices[i], Mat3d::identity(), {radius, radius, radius}));
}

// The ellipsoid g_A <= 1 of the planes `beyond`, y = x − centre; false: no point.
//   g_A = (y − y_A)·M(y − y_A) + c − b·M⁻¹b,   M = β + αΣ a aᵀ,  b = αΣ d a,  c = αΣ d²,  y_A = M⁻¹b
bool frame_of(const PotentialParticle& p, std::uint64_t beyond, RoundFrame& frame) {
  const Mat3d m = shapes::potential::half_hessian<double>(p, beyond);
  Vec3d b{};
  double c = 0;
  for (std::size_t i = 0; i < p.planes.size(); ++i)
    if (beyond >> i & 1) {
      b += (p.plane_weight * p.planes[i].offset) * p.planes[i].normal;
      c += p.plane_weight * p.planes[i].offset * p.planes[i].offset;
    }
  const Vec3d y = shapes::potential::inverse(m) * b;
  const double square = 1 - (c - dot(b, y));
  if (!(square > 0)) return false;
  // M = L Lᵀ by Cholesky; u = Lᵀ(y − y_A)/√square.
  const double l00 = std::sqrt(m.row[0].x), l10 = m.row[1].x / l00, l20 = m.row[2].x / l00;
  const double l11 = std::sqrt(m.row[1].y - l10 * l10), l21 = (m.row[2].y - l20 * l10) / l11;
  const double l22 = std::sqrt(m.row[2].z - l20 * l20 - l21 * l21), root = std::sqrt(square);
  const Mat3d upper{{{l00, l10, l20}, {0, l11, l21}, {0, 0, l22}}};
  for (int i = 0; i < 3; ++i) frame.map.row[i] = (1 / root) * upper.row[i];
  const double i01 = -l10 / (l00 * l11), i12 = -l21 / (l11 * l22), i02 = (l10 * l21 - l20 * l11) / (l00 * l11 * l22);
  frame.inverse = {{root * Vec3d{1 / l00, i01, i02}, root * Vec3d{0, 1 / l11, i12}, root * Vec3d{0, 0, 1 / l22}}};
  frame.centre = p.centre + y;
  frame.volume_scale = l00 * l11 * l22 / (square * root);
  return true;
}

void add_cells(BodyPieces& body, const PotentialParticle& p, std::size_t plane, std::uint64_t beyond, CutSolid cell) {
  RoundFrame frame;
  if (cell.empty() || !frame_of(p, beyond, frame)) return;
  // With fewer planes the quadratic is smaller: where even this one leaves nothing there is no piece.
  if (!(volume_in_ball(cell, frame) > 1e-17 * p.mass.volume)) return;
  if (plane == p.planes.size()) return add_ball(body, std::move(cell), frame);
  const auto& [normal, distance] = p.planes[plane];
  const double offset = distance + dot(normal, p.centre);
  CutSolid outer = cell;
  outer.cut(-normal, -offset);
  add_cells(body, p, plane + 1, beyond | std::uint64_t{1} << plane, std::move(outer));
  cell.cut(normal, offset);
  add_cells(body, p, plane + 1, beyond, std::move(cell));
}

CutSolid placed(const Compound::Part& part) {
  CutSolid s = CutSolid::of(*part.solid);
  s.move(part.centre);
  return s;
}

// Cells less a polyhedron: what lies beyond its first face, then of the rest beyond the second, …
std::vector<CutSolid> without(const std::vector<CutSolid>& cells, const Compound::Part& part) {
  std::vector<CutSolid> left;
  for (const CutSolid& cell : cells) {
    CutSolid common = cell;
    for (const auto& f : part.solid->faces) common.cut(f.normal, f.offset + dot(f.normal, part.centre));
    if (!(common.volume() > 0)) {
      left.push_back(cell);
      continue;
    }
    CutSolid rest = cell;
    for (const auto& f : part.solid->faces) {
      const double offset = f.offset + dot(f.normal, part.centre);
      CutSolid beyond = rest;
      beyond.cut(-f.normal, -offset);
      if (beyond.volume() > 0) left.push_back(std::move(beyond));
      rest.cut(f.normal, offset);
    }
  }
  return left;
}

bool near(const Compound::Part& a, const Compound::Part& b) {
  return norm(a.centre - b.centre) < a.bounding_radius + b.bounding_radius;
}

void add_part(BodyPieces& body, const Compound& whole, std::size_t index) {
  const Compound::Part& part = whole.parts[index];
  const bool solid = part.kind == Compound::PartKind::polyhedron;
  const bool sphere = part.kind == Compound::PartKind::sphere;
  std::vector<CutSolid> cells{solid ? placed(part) : cube_about(part.centre, part.bounding_radius * (1 + 1e-12))};
  for (std::size_t j = 0; j < whole.parts.size(); ++j) {
    const Compound::Part& other = whole.parts[j];
    if (j == index || !near(part, other)) continue;
    if (other.kind == Compound::PartKind::polyhedron) {
      if (!solid || j < index) cells = without(cells, other);
    } else if (sphere && other.kind == Compound::PartKind::sphere) {
      const Vec3d between = other.centre - part.centre;
      const double distance = norm(between), r = part.size.x, q = other.size.x;
      const double height = 0.5 * (distance + (r - q) * (r + q) / distance);  // of the plane in which they meet
      const Vec3d n = between * (1 / distance);
      for (CutSolid& c : cells) c.cut(n, dot(n, part.centre) + height);
    } else if (!solid && std::find(part.neighbours.begin(), part.neighbours.end(), j) != part.neighbours.end()) {
      body.exact = false;
    }
  }
  const RoundFrame frame = solid ? RoundFrame{} : round_frame(part.centre, part.rotation, part.size);
  for (CutSolid& c : cells)
    if (!c.empty()) solid ? add_solid(body, std::move(c)) : add_ball(body, std::move(c), frame);
}

}  // namespace

double BodyPiece::volume_of(const CutSolid& cut) const {
  switch (kind) {
    case Kind::ball:
      return volume_in_ball(cut, frame);
    case Kind::cylinder:
      return volume_in_cylinder(cut, point, along, radius);
    default:
      return cut.volume();
  }
}

BodyPieces pieces_of(const ShapeEntry& shape) {
  BodyPieces body;
  if (shape.kind == shapes::Kind::polyhedron) add_solid(body, CutSolid::of(*shape.polyhedron));
  if (shape.kind == shapes::Kind::rounded_polyhedron) add_rounded(body, *shape.polyhedron, shape.size.y);
  if (shape.potential) {
    const PotentialParticle& p = *shape.potential;
    add_cells(body, p, 0, 0, cube_about({}, p.circumradius));
  }
  if (shape.compound)
    for (std::size_t i = 0; i < shape.compound->parts.size(); ++i) add_part(body, *shape.compound, i);
  if (shape.polygon)
    for (const auto& part : shape.polygon->parts) add_solid(body, CutSolid::prism(part.vertices, {0, 0, 1}, 1));
  return body;
}

}  // namespace dem::analysis
