#include "bench/pairs/sets.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "shapes/math/random.h"
#include "shapes/math/trig.h"
#include "shapes/polygon_build.h"
#include "shapes/polyhedron_build.h"
#include "shapes/potential_build.h"

namespace pairs {

namespace {

using shapes::Kind;
using shapes::Random;

bool is_flat(Kind k) { return shapes::dimension_of(k) == 2; }

Vec3d direction(Kind k, Random& draw) {
  if (!is_flat(k)) return draw.direction();
  const shapes::SineCosine t = shapes::sine_cosine(draw.uniform(0, 6.283185307179586));
  return {t.cosine, t.sine, 0};
}

struct Family {
  const char* name;
  Kind kind;
  Vec3d size;
  int points;  // of polyhedra
};

constexpr int coarse = -1, fine = -2;  // convex hulls of grains seen by tomography, in shapes/data

constexpr Family families[] = {{"sphere", Kind::sphere, {1, 0, 0}, 0},
                               {"ellipsoid_1_1_2", Kind::ellipsoid, {1, 1, 2}, 0},
                               {"ellipsoid_1_1_10", Kind::ellipsoid, {1, 1, 10}, 0},
                               {"ellipsoid_1_.5_.25", Kind::ellipsoid, {1, 0.5, 0.25}, 0},
                               {"cube", Kind::polyhedron, {1, 0, 0}, 8},
                               {"poly12", Kind::polyhedron, {1, 0, 0}, 12},
                               {"poly50", Kind::polyhedron, {1, 0, 0}, 50},
                               {"poly200", Kind::polyhedron, {1, 0, 0}, 200},
                               {"poly1000", Kind::polyhedron, {1, 0, 0}, 1000},
                               {"rounded50", Kind::rounded_polyhedron, {1, 0.1, 0}, 50},
                               {"potential", Kind::potential_particle, {1, 0, 0}, 0},
                               {"disc", Kind::disc, {1, 0, 0}, 0},
                               {"ellipse_1_.5", Kind::ellipse, {1, 0.5, 0}, 0},
                               {"octagon", Kind::polygon, {1, 0, 0}, 8},
                               {"ellipsoid_1_1_1.5", Kind::ellipsoid, {1, 1, 1.5}, 0},
                               {"ellipsoid_1_1_3", Kind::ellipsoid, {1, 1, 3}, 0},
                               {"ellipsoid_1_1_100", Kind::ellipsoid, {1, 1, 100}, 0},
                               {"ellipsoid_1_10_10", Kind::ellipsoid, {1, 10, 10}, 0},
                               {"ellipse_1_1.5", Kind::ellipse, {1, 1.5, 0}, 0},
                               {"ellipse_1_3", Kind::ellipse, {1, 3, 0}, 0},
                               {"ellipse_1_10", Kind::ellipse, {1, 10, 0}, 0},
                               {"ellipse_1_100", Kind::ellipse, {1, 100, 0}, 0},
                               {"grain_coarse", Kind::polyhedron, {1, 0, 0}, coarse},
                               {"grain_fine", Kind::polyhedron, {1, 0, 0}, fine}};
// Of these, bench_pairs times the pairs of a family with itself.
constexpr std::size_t own_pairs = 14;
// What stands for its kind in mixed pairs.
constexpr const char* members[] = {"sphere", "ellipsoid_1_.5_.25", "poly50", "rounded50", "potential",
                                   "disc",   "ellipse_1_.5",       "octagon"};

const Family& family(const std::string& name) {
  return *std::find_if(std::begin(families), std::end(families), [&](const Family& f) { return name == f.name; });
}

// Geometries live as long as the program.
const shapes::Polyhedron* random_polyhedron(int points, std::uint64_t index) {
  static std::deque<shapes::Polyhedron> pool;
  if (points == 8) return &pool.emplace_back(shapes::make_box({1, 1, 1}));
  if (points < 0) {
    const std::string file = std::string(PROJECT_ROOT "/shapes/data/") +
                             (points == coarse ? "ct_hull_coarse" : "ct_hull_fine") + "/cement140_" +
                             (index < 9 ? "0" : "") + std::to_string(index + 1) + ".off";
    return &pool.emplace_back(shapes::polyhedron_from_file(file, shapes::Frame::principal));
  }
  Random draw(11, static_cast<std::uint64_t>(points), index);
  const Vec3d axes{draw.uniform(0.7, 1.3), draw.uniform(0.7, 1.3), draw.uniform(0.7, 1.3)};
  std::vector<Vec3d> cloud;
  for (int i = 0; i < points; ++i) cloud.push_back(scaled(axes, draw.direction()));
  return &pool.emplace_back(shapes::polyhedron_from_points(cloud, shapes::Frame::as_given));
}
const shapes::Polygon* random_octagon(std::uint64_t index) {
  static std::deque<shapes::Polygon> pool;
  Random draw(12, 8, index);
  const Vec3d axes{draw.uniform(0.7, 1.3), draw.uniform(0.7, 1.3), 0};
  std::vector<Vec3d> outline;
  for (int i = 0; i < 8; ++i) {
    const shapes::SineCosine t = shapes::sine_cosine((i + draw.uniform(-0.3, 0.3)) * 0.7853981633974483);
    outline.push_back({axes.x * t.cosine, axes.y * t.sine, 0});
  }
  return &pool.emplace_back(shapes::polygon_hull(outline));
}
const shapes::PotentialParticle* potential_particle() {
  static const shapes::PotentialParticle body = [] {
    std::vector<shapes::HalfSpace> planes;
    for (const double sign : {1.0, -1.0})
      for (const Vec3d& n : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}) planes.push_back({sign * n, 1});
    return shapes::make_potential_particle(planes, 0.3, 0.6, 1.2, shapes::Frame::principal, 1e-5);
  }();
  return &body;
}

Body make_body(const Family& f, std::uint64_t index, Random& draw, shapes::Quatd& orientation) {
  Body b;
  b.kind = f.kind;
  b.size = f.size;
  orientation = is_flat(f.kind) ? draw.turn() : draw.rotation();
  b.rotation = rotation_matrix(orientation);
  constexpr std::uint64_t different = 24;  // geometries of a family
  if (f.kind == Kind::polyhedron || f.kind == Kind::rounded_polyhedron) {
    static std::deque<std::pair<std::pair<int, std::uint64_t>, const shapes::Polyhedron*>> known;
    const std::pair key{f.points, f.points == 8 ? 0 : index % different};
    const auto at = std::find_if(known.begin(), known.end(), [&](const auto& k) { return k.first == key; });
    b.geometry =
        at != known.end() ? at->second : known.emplace_back(key, random_polyhedron(key.first, key.second)).second;
  }
  if (f.kind == Kind::polygon) b.geometry = random_octagon(index);
  if (f.kind == Kind::potential_particle) b.geometry = potential_particle();
  return b;
}

// Support point along n of the bodies that are placed about a normal.
bool has_support(Kind k) { return k == Kind::sphere || k == Kind::ellipsoid || k == Kind::disc || k == Kind::ellipse; }
Vec3d support(const Body& b, const Vec3d& n) {
  if (b.kind == Kind::sphere || b.kind == Kind::disc) return b.size.x * n;
  return b.rotation * shapes::support(shapes::Ellipsoid{b.size}, transposed_times(b.rotation, n));
}

Vec3d place(const Body& a, const Body& b, double gap, Random& draw) {
  const Vec3d n = direction(a.kind, draw);
  if (has_support(a.kind) && has_support(b.kind)) return support(a, n) + support(b, n) + gap * n;
  double near = 0, far = 2 * (circumradius(a) + circumradius(b));
  for (int k = 0; k < 40; ++k) {
    const double middle = 0.5 * (near + far);
    (contact::query(a, b, middle * n).gap < gap ? near : far) = middle;
  }
  return near * n;
}

std::unique_ptr<Set> make_set(const Family& fa, const Family& fb, const Config& config, std::size_t count) {
  auto set = std::make_unique<Set>();
  const bool mixed = &fa != &fb;
  set->family = mixed ? std::string(fa.name) + "-" + fb.name : fa.name;
  set->member_a = fa.name;
  set->member_b = fb.name;
  set->config = config.name;
  set->a = fa.kind;
  set->b = fb.kind;
  for (std::size_t i = 0; i < count; ++i) {
    Random draw(1, static_cast<std::uint64_t>(&fa - families) * 64 + static_cast<std::uint64_t>(&fb - families), i);
    shapes::Quatd turn_a, turn_b;
    Body a = make_body(fa, 2 * i, draw, turn_a), b = make_body(fb, 2 * i + 1, draw, turn_b);
    if (mixed) {  // of one size
      b.size *= circumradius(a) / circumradius(b);
    }
    const double size = 0.5 * (circumradius(a) + circumradius(b));
    Pair p;
    p.offset = place(a, b, config.part * size, draw);
    p.size = size;
    p.next_offset = p.offset + 1e-3 * size * direction(a.kind, draw);
    Body next = b;
    const Vec3d axis = is_flat(b.kind) ? Vec3d{0, 0, 1} : draw.direction();
    const shapes::Quatd turn = normalized(shapes::Quatd{1, 5e-4 * axis.x, 5e-4 * axis.y, 5e-4 * axis.z});
    next.rotation = rotation_matrix(turn) * b.rotation;
    p.a = static_cast<std::uint32_t>(set->bodies.size());
    p.b = p.a + 1;
    p.next_b = p.a + 2;
    set->bodies.insert(set->bodies.end(), {a, b, next});
    set->orientation.insert(set->orientation.end(), {turn_a, turn_b, turn * turn_b});
    set->list.push_back(p);
  }
  return set;
}

}  // namespace

std::unique_ptr<Set> make_set(const std::string& family_a, const std::string& family_b, const Config& config,
                              std::size_t count) {
  return make_set(family(family_a), family(family_b), config, count);
}

std::vector<std::unique_ptr<Set>> all_sets(const std::string& filter, std::size_t count) {
  constexpr Config configs[] = {{"touch", -1e-3}, {"apart", 0.05}, {"deep", -0.2}};
  std::vector<std::unique_ptr<Set>> sets;
  const auto add = [&](const Family& a, const Family& b) {
    for (const Config& c : configs) {
      const bool dear = a.points >= 1000 || a.kind == Kind::potential_particle || b.kind == Kind::potential_particle;
      const std::string name = (&a == &b ? std::string(a.name) : std::string(a.name) + "-" + b.name) + "/" + c.name;
      // What the bars of others are measured against is there whatever the filter says.
      const bool yardstick = name == "sphere/touch";
      if (!yardstick && name.find(filter) == std::string::npos) continue;
      sets.push_back(make_set(a, b, c, dear ? count / 4 : count));
    }
  };
  for (std::size_t i = 0; i < own_pairs; ++i) add(families[i], families[i]);
  for (std::size_t i = 0; i < std::size(members); ++i)
    for (std::size_t j = i + 1; j < std::size(members); ++j) {
      const Family &a = family(members[i]), &b = family(members[j]);
      if (contact::find(a.kind, b.kind) != nullptr) add(a, b);
    }
  return sets;
}

}  // namespace pairs
