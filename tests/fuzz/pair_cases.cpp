#include "tests/fuzz/pair_cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "shapes/math/trig.h"
#include "shapes/mesh_build.h"
#include "shapes/polygon_build.h"
#include "shapes/polyhedron_build.h"
#include "tests/shapes/potential_samples.h"

namespace pair_fuzz {
namespace {

bool is_flat(Kind k) { return shapes::dimension_of(k) == 2; }
bool is_endless(Kind k) { return k == Kind::plane || k == Kind::line; }

// A bipyramid of two tips at ±1 and a ring of n corners.
shapes::Polyhedron bipyramid(int n, double ring) {
  std::vector<Vec3d> points{{0, 0, 1}, {0, 0, -1}};
  for (int k = 0; k < n; ++k) {
    const shapes::SineCosine t = shapes::sine_cosine(6.283185307179586 * k / n);
    points.push_back({ring * t.cosine, ring * t.sine, 0});
  }
  return shapes::polyhedron_from_points(points, shapes::Frame::principal);
}

const std::vector<shapes::Polyhedron>& solids() {
  static const std::vector<shapes::Polyhedron> list{shapes::make_box({1, 1, 1}),
                                                    shapes::make_box({1, 1.5, 2}),
                                                    shapes::make_box({2, 2, 0x1p-7}),
                                                    shapes::make_box({2, 0x1p-20, 1}),
                                                    shapes::make_box({2, 0x1p-10, 0x1p-10}),
                                                    shapes::make_platonic(shapes::Platonic::tetrahedron, 1),
                                                    shapes::make_platonic(shapes::Platonic::octahedron, 1),
                                                    shapes::make_platonic(shapes::Platonic::icosahedron, 1),
                                                    shapes::make_prism(24, 1, 0.5),
                                                    bipyramid(5, 1e-3),
                                                    bipyramid(12, 0.6)};
  return list;
}

const std::vector<shapes::Polygon>& outlines() {
  static const std::vector<shapes::Polygon> list{
      shapes::make_regular_polygon(3, 1),
      shapes::make_regular_polygon(4, 1),
      shapes::make_regular_polygon(8, 1),
      shapes::make_regular_polygon(100, 1),
      shapes::polygon_hull(std::vector<Vec3d>{{-1, -0x1p-8, 0}, {1, -0x1p-8, 0}, {1, 0x1p-8, 0}, {-1, 0x1p-8, 0}}),
      shapes::polygon_hull(std::vector<Vec3d>{{-1, 0, 0}, {1, 0, 0}, {0, 0x1p-20, 0}}),
      shapes::polygon_hull(std::vector<Vec3d>{{-0.5, -0.5, 0}, {1, -0.25, 0}, {0.25, 0.75, 0}, {-0.75, 0.5, 0}})};
  return list;
}

// Facets with inner edges, a ridge and open borders.
const shapes::Mesh& facets() {
  static const shapes::Mesh mesh = [] {
    const std::vector<Vec3d> v{{-2, -2, -0.5}, {0, -2, 0}, {2, -2, 0}, {-2, 2, -0.5}, {0, 2, 0}, {2, 2, 0}};
    return shapes::mesh_from_triangles(v, std::vector<std::uint32_t>{0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4});
  }();
  return mesh;
}

Vec3d direction(const MethodInfo& m, Source& s) {
  if (s.pick(4) == 0) {  // along an axis
    Vec3d v{};
    v[static_cast<int>(s.pick(is_flat(m.a) ? 2 : 3))] = s.pick(2) == 0 ? 1 : -1;
    return v;
  }
  Vec3d v = s.vector();
  if (is_flat(m.a)) v.z = 0;
  return dot(v, v) > 1e-6 ? normalized(v) : Vec3d{1, 0, 0};
}

// Semi-axes about 1, the largest 0.3 to 1.5.
Vec3d semi_axes(Source& s) {
  const std::array<double, 4> thinnest{0.2, 0.2, 1e-3, 1e-6};
  const double least = thinnest[s.pick(4)], size = s.uniform(0.3, 1.5);
  if (s.pick(8) == 0) return {size, size, size};
  Vec3d a{size * s.spread(least, 1), size * s.spread(least, 1), size * s.spread(least, 1)};
  a[static_cast<int>(s.pick(3))] = size;
  if (s.pick(4) == 0) a.y = a.x;
  return a;
}

void shape(Body& b, Kind kind, double scale, Source& s) {
  b.kind = kind;
  switch (kind) {
    case Kind::sphere:
    case Kind::disc:
      b.size = {scale * s.uniform(0.3, 1.5), 0, 0};
      return;
    case Kind::ellipsoid:
      b.size = scale * semi_axes(s);
      return;
    case Kind::ellipse: {
      const Vec3d a = semi_axes(s);
      b.size = {scale * a.x, scale * a.y, 0};
      return;
    }
    case Kind::polyhedron:
    case Kind::rounded_polyhedron: {
      b.geometry = &solids()[s.pick(solids().size())];
      b.size = {scale, kind == Kind::polyhedron ? 0 : scale * s.spread(1e-6, 0.5), 0};
      return;
    }
    case Kind::potential_particle: {
      const auto& list = shape_tests::potential_particles();
      b.geometry = &list[s.pick(list.size())];
      b.size = {scale, 0, 0};
      return;
    }
    case Kind::polygon: {
      b.geometry = &outlines()[s.pick(outlines().size())];
      b.size = {scale, 0, 0};
      return;
    }
    case Kind::mesh:
      b.geometry = &facets();
      b.size = {scale, 0, 0};
      b.part = static_cast<std::uint32_t>(s.pick(facets().facets.size()));
      return;
    case Kind::plane:
    case Kind::line:
      return;
    default:
      throw std::logic_error("no bodies of this kind to fuzz with");
  }
}

void turn(Posed& p) {
  if (is_flat(p.body.kind)) {
    const shapes::SineCosine t = shapes::sine_cosine(p.angle);
    p.body.rotation = {{{t.cosine, -t.sine, 0}, {t.sine, t.cosine, 0}, {0, 0, 1}}};
  } else {
    p.orientation = normalized(p.orientation);
    p.body.rotation = rotation_matrix(p.orientation);
  }
}

void orient(Posed& p, Source& s) {
  switch (s.pick(3)) {
    case 0:
      break;
    case 1:  // by a quarter, about one axis
      p.angle = 1.5707963267948966 * s.integer(-4, 4);
      p.orientation = s.pick(2) == 0 ? Quatd{1, 1, 0, 0} : Quatd{1, 0, 0, 1};
      break;
    default: {
      p.angle = s.uniform(-3, 3);
      const Vec3d v = s.vector();
      const double w = s.uniform(-1, 1);
      if (w * w + dot(v, v) > 0.01) p.orientation = {w, v.x, v.y, v.z};
    }
  }
  turn(p);
}

// As `like`, but for a tilt of 1e-16 to 0.1 rad.
void orient_nearly(Posed& p, const Posed& like, Source& s) {
  const double tilt = s.pick(3) == 0 ? 0 : std::pow(10.0, -s.uniform(1, 16));
  const Vec3d v = tilt * s.vector();
  p.angle = like.angle + tilt;
  p.orientation = like.orientation * Quatd{1, v.x, v.y, v.z};
  turn(p);
}

Vec3d wall_normal(const Body& b) { return b.rotation.column(b.kind == Kind::line ? 1 : 2); }

void place(PairCase& c, const MethodInfo& m, Source& s) {
  const double small = circumradius(c.a.body), reach = small + circumradius(c.b.body);
  const std::size_t how = s.pick(6);
  if (how == 0) {
    c.offset = {};
    return;
  }
  const Vec3d d = direction(m, s);
  if (is_endless(m.b))
    c.offset = s.uniform(-2, 2) * reach * d - s.uniform(-0.2, 1.2) * reach * wall_normal(c.b.body);
  else
    c.offset = s.uniform(0.05, 1.1) * reach * d;
  if (how == 1) c.offset *= std::pow(10.0, s.uniform(0, 8));
  if (how < 3) return;
  // To a gap that was chosen.
  const Contact now = contact::query(c.a.body, c.b.body, c.offset, {}, m.name);
  if (!std::isfinite(now.gap) || !(norm(now.normal) > 0.5)) return;
  const double gap = how == 3 ? 0 : (s.pick(3) == 0 ? 1 : -1) * small * std::pow(10.0, -s.uniform(0, 16));
  c.offset += (gap - now.gap) * now.normal;
}

std::string number(double v) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.17g", v);
  return text.data();
}
std::string numbers(const Vec3d& v, bool flat = false) {
  return "[" + number(v.x) + ", " + number(v.y) + (flat ? "" : ", " + number(v.z)) + "]";
}
std::string numbers(const std::vector<Vec3d>& list, double scale, bool flat) {
  std::string out = "[";
  for (const Vec3d& v : list) out += (out.size() > 1 ? ", " : "") + numbers(scale * v, flat);
  return out + "]";
}

std::string shape_text(const Body& b) {
  switch (b.kind) {
    case Kind::sphere:
    case Kind::disc:
      return std::string("{\"type\": \"") + shapes::name_of(b.kind) + "\", \"radius\": " + number(b.size.x) + "}";
    case Kind::ellipsoid:
      return "{\"type\": \"ellipsoid\", \"semi_axes\": " + numbers(b.size) + "}";
    case Kind::ellipse:
      return "{\"type\": \"ellipse\", \"semi_axes\": " + numbers(b.size, true) + "}";
    case Kind::polyhedron:
    case Kind::rounded_polyhedron: {
      const auto& solid = *static_cast<const shapes::Polyhedron*>(b.geometry);
      const std::string rounding = b.kind == Kind::polyhedron ? std::string() : ", \"rounding\": " + number(b.size.y);
      return std::string("{\"type\": \"") + shapes::name_of(b.kind) +
             "\", \"vertices\": " + numbers(solid.vertices, b.size.x, false) + rounding + "}";
    }
    case Kind::polygon:
      return "{\"type\": \"simple_polygon\", \"vertices\": " +
             numbers(static_cast<const shapes::Polygon*>(b.geometry)->vertices, b.size.x, true) + "}";
    case Kind::plane:
    case Kind::line:
      return std::string("{\"type\": \"") + shapes::name_of(b.kind) + "\"}";
    default:
      return "";
  }
}

std::string pose_text(const Posed& p, const Vec3d& position) {
  if (is_flat(p.body.kind))
    return "{\"position\": " + numbers(position, true) + ", \"angle\": " + number(p.angle) + "}";
  const Quatd& q = p.orientation;
  return "{\"position\": " + numbers(position) + ", \"quaternion\": [" + number(q.w) + ", " + number(q.x) + ", " +
         number(q.y) + ", " + number(q.z) + "]}";
}

}  // namespace

PairCase draw_pair(const MethodInfo& m, Source& s) {
  PairCase c;
  const double scale = s.pick(8) == 0 ? std::ldexp(1.0, s.integer(-300, 300)) : 1.0;
  const double ratio = s.pick(4) == 0 ? std::ldexp(1.0, s.integer(-30, 30)) : 1.0;
  shape(c.a.body, m.a, scale, s);
  if (m.a == m.b && s.pick(8) == 0) {
    c.b = c.a;  // twice the same body
  } else {
    shape(c.b.body, m.b, scale * ratio, s);
  }
  orient(c.a, s);
  if (s.pick(3) == 0)
    orient_nearly(c.b, c.a, s);
  else
    orient(c.b, s);
  place(c, m, s);
  if (is_flat(m.a)) c.offset.z = 0;
  return c;
}

std::string case_file(const PairCase& c, const std::string& id) {
  const std::string a = shape_text(c.a.body), b = shape_text(c.b.body);
  if (a.empty() || b.empty()) return "";
  return "{\"schema\": \"narrowphase-cases/1\", \"count\": 1, \"cases\": [\n {\"id\": \"" + id +
         "\", \"dim\": " + (is_flat(c.a.body.kind) ? "2" : "3") + ",\n  \"shape_a\": " + a + ",\n  \"shape_b\": " + b +
         ",\n  \"pose_a\": " + pose_text(c.a, {}) + ",\n  \"pose_b\": " + pose_text(c.b, c.offset) + "}\n]}\n";
}

}  // namespace pair_fuzz
