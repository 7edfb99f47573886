#include "tests/extremes/dimensions.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "tests/reference/core.h"

namespace extremes {
namespace {

using reference::half_space;
using reference::Source;

double least_size(const Body& b) {
  switch (b.kind) {
    case Kind::ellipsoid:
      return std::min({b.size.x, b.size.y, b.size.z});
    case Kind::ellipse:
      return std::min(b.size.x, b.size.y);
    case Kind::plane:
    case Kind::line:
      return HUGE_VAL;
    default:
      return b.circumradius();
  }
}

Vec3d farthest(const Body& b, const Vec3d& n) {
  const reference::Core<double> core(b, 1);
  return core.support(n) + core.ball * n;
}

// B touches A along a random direction and is moved apart by `gap`.
void touch(Case& c, double gap, Source& draw) {
  const int dimension = shapes::dimension_of(c.a.kind);
  if (half_space(c.b.kind)) {
    const Vec3d out = c.b.placed().rotation.column(c.b.kind == Kind::line ? 1 : 2);
    c.offset = farthest(c.a, -out) - gap * out;
    return;
  }
  const Vec3d n = draw.direction(dimension);
  c.offset = farthest(c.a, n) - farthest(c.b, -n) + gap * n;
}

Case samples(Kind a, Kind b, Source& draw) { return {reference::sample(a, draw), reference::sample(b, draw), {}}; }

void multiply(Body& b, double s) { b.size *= s; }

bool thin(Body& b, double aspect, Source& draw) {
  static std::deque<std::pair<double, shapes::Polyhedron>> plates;
  static std::deque<std::pair<double, shapes::Polygon>> strips;
  const auto known = [&](auto& list, auto build) -> const void* {
    for (const auto& [key, shape] : list)
      if (key == aspect) return &shape;
    list.emplace_back(aspect, build());
    return &list.back().second;
  };
  switch (b.kind) {
    case Kind::ellipsoid:
      b.size = {1, draw.uniform(0, 1) < 0.5 ? 1 : 1 / aspect, 1 / aspect};
      return true;
    case Kind::ellipse:
      b.size = {1, 1 / aspect, 0};
      return true;
    case Kind::polyhedron:
    case Kind::rounded_polyhedron:
      b.geometry = known(plates, [&] { return shapes::make_box({1, 0.75, 1 / aspect}); });
      b.size = {1, b.kind == Kind::polyhedron ? 0 : 0.25 / aspect, 0};
      return true;
    case Kind::polygon:
      b.geometry = known(strips, [&] {
        const double h = 0.5 / aspect;
        return shapes::polygon_hull(std::vector<Vec3d>{{-1, -h, 0}, {1, -h, 0}, {1, h, 0}, {-1, h, 0}});
      });
      b.size = {1, 0, 0};
      return true;
    default:
      return false;
  }
}

bool gap_of_size(double level, Kind a, Kind b, Source& draw, Case& c) {
  c = samples(a, b, draw);
  touch(c, level * std::min(least_size(c.a), least_size(c.b)), draw);
  return true;
}

bool contained(double level, Kind a, Kind b, Source& draw, Case& c) {
  c = samples(a, b, draw);
  touch(c, 0, draw);
  c.offset *= level;
  return true;
}

bool aspect(double level, Kind a, Kind b, Source& draw, Case& c) {
  c = samples(a, b, draw);
  if (!(int(thin(c.a, level, draw)) | int(thin(c.b, level, draw)))) return false;
  constexpr double gaps[] = {0.3, 1e-6, 0, -0.1, -0.5};
  const double gap = gaps[static_cast<int>(draw.uniform(0, 5))];
  touch(c, gap > 0 ? gap : gap / level, draw);
  return true;
}

bool size_ratio(double level, Kind a, Kind b, Source& draw, Case& c) {
  if (half_space(b)) return false;
  c = samples(a, b, draw);
  multiply(draw.uniform(0, 1) < 0.5 ? c.a : c.b, 1 / level);
  touch(c, draw.uniform(-0.2, 0.5) / level, draw);
  return true;
}

bool far(double level, Kind a, Kind b, Source& draw, Case& c) {
  c = samples(a, b, draw);
  touch(c, level, draw);
  return true;
}

// Nearly the same pose, pushed against each other along a face normal or an axis.
bool tilt(double level, Kind a, Kind b, Source& draw, Case& c) {
  c = samples(a, b, draw);
  const Vec3d axis = shapes::dimension_of(a) == 2 ? Vec3d{0, 0, 1} : draw.direction();
  const double s = std::sin(level / 2);
  if (half_space(b)) {
    c.a.orientation = shapes::Quatd{std::cos(level / 2), s * axis.x, s * axis.y, s * axis.z} * c.b.orientation;
    touch(c, -1e-3, draw);
    return true;
  }
  if (a == b) c.b.geometry = c.a.geometry;
  c.b.orientation = shapes::Quatd{std::cos(level / 2), s * axis.x, s * axis.y, s * axis.z} * c.a.orientation;
  const reference::Core<double> core(c.a, 1);
  const Vec3d n = core.normals.empty() ? c.a.placed().rotation.column(1) : draw.one_of(core.normals);
  c.offset = dot(n, farthest(c.a, n) - farthest(c.b, -n)) * n + draw.uniform(-1e-3, 1e-3) * n +
             0.1 * draw.uniform(0, 1) * draw.direction(shapes::dimension_of(a));
  return true;
}

bool power_of_two(double level, Kind a, Kind b, Source& draw, Case& c) {
  c = samples(a, b, draw);
  touch(c, draw.uniform(-0.1, 0.1), draw);
  const double s = std::ldexp(1.0, static_cast<int>(level));
  multiply(c.a, s);
  multiply(c.b, s);
  c.offset *= s;
  return true;
}

bool sliver(double level, Kind a, Kind b, Source& draw, Case& c) {
  if (a != Kind::polyhedron && b != Kind::polyhedron) return false;
  static std::deque<shapes::Polyhedron> kept;
  std::vector<Vec3d> points;
  for (int k = 0; k < 7; ++k) points.push_back({draw.uniform(-1, 1), draw.uniform(-1, 1), level * draw.uniform(-1, 1)});
  kept.push_back(shapes::polyhedron_from_points(points, shapes::Frame::principal));
  c = samples(a, b, draw);
  Body& thin_one = a == Kind::polyhedron ? c.a : c.b;
  thin_one.geometry = &kept.back();
  touch(c, draw.uniform(-0.2, 0.2) * level, draw);
  return true;
}

bool many_faces(double level, Kind a, Kind b, Source& draw, Case& c) {
  static std::deque<std::pair<double, shapes::Polyhedron>> balls;
  if (a != Kind::polyhedron && b != Kind::polyhedron) return false;
  if (b == Kind::potential_particle) return false;  // the reference would climb about every edge for minutes
  auto found = std::find_if(balls.begin(), balls.end(), [&](const auto& x) { return x.first == level; });
  if (found == balls.end()) {
    std::vector<Vec3d> points;
    const int n = static_cast<int>(level / 2) + 2;
    for (int i = 0; i < n; ++i) {
      const double z = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - z * z), angle = 2.399963229728653 * i;
      points.push_back({r * std::cos(angle), r * std::sin(angle), z});
    }
    balls.emplace_back(level, shapes::polyhedron_from_points(points, shapes::Frame::principal));
    found = balls.end() - 1;
  }
  c = samples(a, b, draw);
  (a == Kind::polyhedron ? c.a : c.b).geometry = &found->second;
  touch(c, draw.uniform(-0.05, 0.05), draw);
  return true;
}

bool same_pose(double, Kind a, Kind b, Source& draw, Case& c) {
  c = samples(a, b, draw);
  c.b.orientation = c.a.orientation;
  if (a == b) c.b = c.a;
  c.offset = {};
  return true;
}

bool not_unit(double level, Kind a, Kind b, Source& draw, Case& c) {
  gap_of_size(draw.uniform(-0.1, 0.1), a, b, draw, c);
  for (Body* body : {&c.a, &c.b}) {
    shapes::Quatd& q = body->orientation;
    q = {q.w * level, q.x * level, q.y * level, q.z * level};
  }
  return true;
}

bool bad_number(double level, Kind a, Kind b, Source& draw, Case& c) {
  gap_of_size(0, a, b, draw, c);
  c.offset.x = level;
  return true;
}

bool bad_size(double level, Kind a, Kind b, Source& draw, Case& c) {
  gap_of_size(0, a, b, draw, c);
  c.a.size.x = level;
  return true;
}

}  // namespace

const std::vector<Dimension>& dimensions() {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  static const std::vector<Dimension> list{{"overlap", {-1e-16, -1e-12, -1e-9, -1e-6, -1e-3, -0.1}, gap_of_size},
                                           {"gap", {0, 1e-16, 1e-12, 1e-9, 1e-6, 1e-3, 0.1}, gap_of_size},
                                           {"containment", {0.5, 0.1, 1e-6, 0}, contained},
                                           {"same_pose", {0}, same_pose},
                                           {"aspect", {1e1, 1e2, 1e3, 1e4, 1e6}, aspect},
                                           {"size_ratio", {1e1, 1e3, 1e6, 1e9}, size_ratio},
                                           {"far", {1e3, 1e6, 1e8}, far},
                                           {"tilt", {0, 3e-16, 1e-12, 1e-8, 1e-5, 1e-3}, tilt},
                                           {"sliver", {1e-3, 1e-6, 1e-9, 1e-12}, sliver},
                                           {"many_faces", {1e2, 1e3, 1e4}, many_faces},
                                           {"scale", {-300, -100, -10, 10, 100, 300}, power_of_two},
                                           {"quaternion", {1 + 0x1p-52, 1 + 1e-8, 1 - 1e-3, 1e-100, 1e100}, not_unit},
                                           {"denormal", {-1060}, power_of_two, false},
                                           {"bad_offset", {nan, HUGE_VAL, -HUGE_VAL}, bad_number, false},
                                           {"bad_size", {nan, HUGE_VAL, -1, 0}, bad_size, false}};
  return list;
}

void each_case(const Dimension& dimension, Kind a, Kind b, int count,
               const std::function<void(const Case& made, double level)>& use) {
  for (std::size_t k = 0; k < dimension.levels.size(); ++k) {
    Source draw(1000 * k + 16 * static_cast<unsigned>(a) + static_cast<unsigned>(b));
    for (int i = 0; i < count; ++i)
      if (Case made; dimension.make(dimension.levels[k], a, b, draw, made)) use(made, dimension.levels[k]);
  }
}

double Case::extent() const { return norm(offset) + a.circumradius() + b.circumradius(); }

}  // namespace extremes
