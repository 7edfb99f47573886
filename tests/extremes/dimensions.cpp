#include "tests/extremes/dimensions.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/extremes/bodies.h"
#include "tests/reference/core.h"

namespace extremes {
namespace {

using reference::half_space;
using reference::Source;

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

bool gap_of_size(double level, Kind a, Kind b, Source& draw, Case& c) {
  c = samples(a, b, draw);
  touch(c, level * std::min(least_size(c.a), least_size(c.b)), draw);
  return true;
}

bool ulps_off(double level, Kind a, Kind b, Source& draw, Case& c) {
  c = samples(a, b, draw);
  touch(c, 0, draw);
  for (int i = 0; i < shapes::dimension_of(a); ++i)
    if (level != 0) c.offset[i] = std::nextafter(c.offset[i], level * HUGE_VAL);
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
  if (!(int(make_thin(c.a, level, draw)) | int(make_thin(c.b, level, draw)))) return false;
  constexpr double gaps[] = {0.3, 1e-6, 0, -0.1, -0.5};
  const double gap = gaps[static_cast<int>(draw.uniform(0, 5))];
  touch(c, gap > 0 ? gap : gap / level, draw);
  return true;
}

bool size_ratio(double level, Kind a, Kind b, Source& draw, Case& c) {
  c = samples(a, b, draw);
  if (half_space(b)) {  // along it, as if it were that large
    touch(c, draw.uniform(-0.2, 0.5), draw);
    c.offset += level * c.b.placed().rotation.column(0);
    return true;
  }
  multiply(draw.uniform(0, 1) < 0.5 ? c.a : c.b, 1 / level);
  touch(c, draw.uniform(-0.2, 0.5) / level, draw);
  return true;
}

// Both bodies as far from the world's origin as 2^level: the difference of their positions is on the grid there.
bool world(double level, Kind a, Kind b, Source& draw, Case& c) {
  c = samples(a, b, draw);
  touch(c, draw.uniform(-0.2, 0.1), draw);
  for (int i = 0; i < shapes::dimension_of(a); ++i) {
    const double position = std::ldexp(draw.uniform(-1, 1), static_cast<int>(level));
    c.offset[i] = (position + c.offset[i]) - position;
  }
  return true;
}

bool far(double level, Kind a, Kind b, Source& draw, Case& c) {
  c = samples(a, b, draw);
  touch(c, level, draw);
  return true;
}

// Nearly the same pose, pushed against each other along a face normal or an axis; every other case of plates.
bool tilt(double level, Kind a, Kind b, Source& draw, Case& c) {
  c = samples(a, b, draw);
  if (draw.uniform(0, 1) < 0.5) make_thin(c.a, 100, draw), make_thin(c.b, 100, draw);
  const Vec3d axis = shapes::dimension_of(a) == 2 ? Vec3d{0, 0, 1} : draw.direction();
  if (half_space(b)) {
    c.a.orientation = turn_about(axis, level) * c.b.orientation;
    touch(c, -1e-3, draw);
    return true;
  }
  if (a == b) c.b.geometry = c.a.geometry;
  c.b.orientation = turn_about(axis, level) * c.a.orientation;
  const reference::Core<double> core(c.a, 1);
  const Vec3d n = core.normals.empty() ? c.a.placed().rotation.column(1) : draw.one_of(core.normals);
  c.offset = dot(n, farthest(c.a, n) - farthest(c.b, -n)) * n + draw.uniform(-1e-3, 1e-3) * n +
             0.1 * draw.uniform(0, 1) * draw.direction(shapes::dimension_of(a));
  return true;
}

// Edge on edge, or edge on plane: parallel but for a turn about the normal, or out of the plane of contact.
bool edge_tilt(double level, Kind a, Kind b, Source& draw, Case& c) {
  if (shapes::dimension_of(a) == 2) return false;
  c = samples(a, b, draw);
  const Ridge of_b = ridge(c.b, draw);
  Ridge of_a = ridge(c.a, draw);
  c.a.orientation = normalized(aligning(of_a.out, -of_b.out) * c.a.orientation);
  // The same ridge again, as the body lies now.
  const shapes::Mat3d moved = rotation_matrix(aligning(of_a.out, -of_b.out));
  of_a = {moved * of_a.along, -of_b.out};
  const Vec3d across = cross(of_b.out, of_b.along);
  const double angle = std::atan2(dot(of_a.along, across), dot(of_a.along, of_b.along));
  const Vec3d axis = half_space(b) || draw.uniform(0, 1) < 0.5 ? across : of_b.out;
  c.a.orientation = normalized(turn_about(axis, level) * (turn_about(of_b.out, -angle) * c.a.orientation));
  const double gap = draw.uniform(0, 1) < 0.5 ? 1e-3 : -1e-3;
  if (half_space(b)) {
    touch(c, gap, draw);
  } else {
    c.offset = farthest(c.a, -of_b.out) - farthest(c.b, of_b.out) - gap * of_b.out;
  }
  return true;
}

bool angles(double level, Kind a, Kind b, Source& draw, Case& c) {
  c = samples(a, b, draw);
  const Vec3d axis = shapes::dimension_of(a) == 2 ? Vec3d{0, 0, 1} : draw.direction();
  c.a.orientation = turn_about(axis, level);
  c.b.orientation = {1, 0, 0, 0};
  touch(c, draw.uniform(-0.1, 0.1), draw);
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
  c = samples(a, b, draw);
  const bool of_a = draw.uniform(0, 1) < 0.7 && make_sliver(c.a, level, draw);
  const bool of_b = (!of_a || draw.uniform(0, 1) < 0.5) && make_sliver(c.b, level, draw);
  if (!of_a && !of_b && !make_sliver(c.a, level, draw)) return false;
  touch(c, draw.uniform(-0.2, 0.2) * level, draw);
  return true;
}

bool many_faces(double level, Kind a, Kind b, Source& draw, Case& c) {
  const int count = static_cast<int>(level);
  c = samples(a, b, draw);
  const bool of_a = draw.uniform(0, 1) < 0.7 && give_faces(c.a, count);
  const bool of_b = (!of_a || draw.uniform(0, 1) < 0.5) && give_faces(c.b, count);
  if (!of_a && !of_b && !give_faces(c.a, count)) return false;
  touch(c, draw.uniform(-0.05, 0.05), draw);
  return true;
}

bool same_pose(double level, Kind a, Kind b, Source& draw, Case& c) {
  c = samples(a, b, draw);
  c.b.orientation = c.a.orientation;
  if (a == b) c.b = c.a;
  c.offset = level * draw.direction(shapes::dimension_of(a));
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

// Of bodies that are not the same however they are turned.
bool bad_orientation(double level, Kind a, Kind b, Source& draw, Case& c) {
  const auto turns = [](Kind kind) { return kind != Kind::sphere && kind != Kind::disc; };
  if (!turns(a) && !turns(b)) return false;
  gap_of_size(0, a, b, draw, c);
  Body& body = turns(a) && (!turns(b) || draw.uniform(0, 1) < 0.5) ? c.a : c.b;
  body.orientation = {level, 0, 0, 0};
  return true;
}

bool bad_size(double level, Kind a, Kind b, Source& draw, Case& c) {
  gap_of_size(0, a, b, draw, c);
  c.a.size.x = level;
  return true;
}

}  // namespace

const std::vector<Dimension>& dimensions() {
  constexpr double pi = 3.141592653589793;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  static const std::vector<Dimension> list{{"overlap", {-1e-16, -1e-12, -1e-9, -1e-6, -1e-3, -0.1}, gap_of_size},
                                           {"gap", {0, 1e-16, 1e-12, 1e-9, 1e-6, 1e-3, 0.1}, gap_of_size},
                                           {"ulps", {0, 1, -1}, ulps_off},
                                           {"containment", {0.5, 0.1, 1e-6, 0}, contained},
                                           {"same_pose", {0, 5e-324, 1e-300, 1e-16, 1e-8}, same_pose},
                                           {"aspect", {1e1, 1e2, 1e3, 1e4, 1e6}, aspect},
                                           {"size_ratio", {1e1, 1e3, 1e6, 1e9}, size_ratio},
                                           {"far", {1e3, 1e6, 1e8}, far},
                                           {"world", {10, 20, 30, 48}, world},
                                           {"tilt", {0, 3e-16, 1e-12, 1e-8, 1e-5, 1e-3}, tilt},
                                           {"edge_tilt", {0, 3e-16, 1e-12, 1e-8, 1e-5, 1e-3}, edge_tilt},
                                           {"angle", {0, 1e-300, pi / 2, pi, 20 * pi, 1e6}, angles},
                                           {"sliver", {1e-3, 1e-6, 1e-9, 1e-12}, sliver},
                                           {"many_faces", {1e2, 1e3, 1e4}, many_faces},
                                           {"scale", {-300, -100, -10, 10, 100, 300}, power_of_two},
                                           {"quaternion", {1 + 0x1p-52, 1 + 1e-8, 1 - 1e-3, 1e-100, 1e100}, not_unit},
                                           {"denormal", {-1060}, power_of_two, false},
                                           {"huge", {970, 1022}, power_of_two, false},
                                           {"bad_offset", {nan, HUGE_VAL, -HUGE_VAL}, bad_number, false},
                                           {"bad_turn", {nan, HUGE_VAL, 0}, bad_orientation, false},
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
