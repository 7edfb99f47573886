// Work over closed paths in the pose of one body against another one or a wall, through the loop's own force pass.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "libcontact/laws/mix.h"
#include "libdem/broad_phase/candidates.h"
#include "libdem/forces.h"
#include "libdem/law_map.h"
#include "libdem/laws_of_scene.h"
#include "libdem/scene/where.h"
#include "tests/libdem/scenes_in_code.h"

namespace dem::loops {

// A few waves of u in [0, 1).
constexpr std::size_t modes = 8;
struct Waves {
  std::array<double, modes> sine, cosine;
  explicit Waves(double u) {
    for (std::size_t k = 0; k < modes; ++k) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(k + 1) * u;
      sine[k] = std::sin(angle);
      cosine[k] = std::cos(angle);
    }
  }
};
struct Series {
  double mean = 0;
  std::array<double, modes> sine{}, cosine{};

  double value(const Waves& w) const {
    double sum = mean;
    for (std::size_t k = 0; k < modes; ++k) sum += sine[k] * w.sine[k] + cosine[k] * w.cosine[k];
    return sum;
  }
  double rate(const Waves& w) const {  // by u
    double sum = 0;
    for (std::size_t k = 0; k < modes; ++k)
      sum += 2 * std::numbers::pi * static_cast<double>(k + 1) * (sine[k] * w.cosine[k] - cosine[k] * w.sine[k]);
    return sum;
  }
  Series operator*(double s) const {
    Series out = *this;
    out.mean *= s;
    for (std::size_t k = 0; k < modes; ++k) out.sine[k] *= s, out.cosine[k] *= s;
    return out;
  }
};
// Three waves with random phases, between −1 and 1 or nearly.
inline Series random_series(shapes::Random& random) {
  Series s;
  for (std::size_t k = 0; k < 3; ++k) {
    const double amplitude = random.uniform(0.2, 0.6) / static_cast<double>(k + 1);
    const double phase = 2 * std::numbers::pi * random.uniform();
    s.sine[k] = amplitude * std::cos(phase);
    s.cosine[k] = amplitude * std::sin(phase);
  }
  return s;
}
// Through values at u = j/n, least squares.
inline Series series_through(const std::vector<double>& values) {
  Series s;
  const double n = static_cast<double>(values.size());
  for (std::size_t j = 0; j < values.size(); ++j) {
    const Waves w(static_cast<double>(j) / n);
    s.mean += values[j] / n;
    for (std::size_t k = 0; k < modes; ++k) {
      s.sine[k] += 2 / n * values[j] * w.sine[k];
      s.cosine[k] += 2 / n * values[j] * w.cosine[k];
    }
  }
  return s;
}

struct Pose {
  Vec3d position, velocity;  // m; m by u
  Quatd orientation;
  Vec3d spin;  // rad by u
};

// Turned and shifted as these series say, held `height` away along a direction: rolling, sliding, twisting, pressing.
struct PosePath {
  Vec3d along, side, across;  // orthonormal, right-handed as side, across, along
  Quatd start;
  std::array<Series, 2> shift;  // m, along side and across
  std::array<Series, 3> turn;   // rad, about side, across, along
  Series height;                // m

  Pose operator()(double u) const {
    const Waves w(u);
    Pose p;
    p.position = along * height.value(w) + side * shift[0].value(w) + across * shift[1].value(w);
    p.velocity = along * height.rate(w) + side * shift[0].rate(w) + across * shift[1].rate(w);
    const Quatd first = scenes::turn(side, turn[0].value(w)), second = first * scenes::turn(across, turn[1].value(w));
    p.orientation = second * scenes::turn(along, turn[2].value(w)) * start;
    p.spin = side * turn[0].rate(w) + shapes::rotate(first, across) * turn[1].rate(w) +
             shapes::rotate(second, along) * turn[2].rate(w);
    return p;
  }
};

// A world of one body that is led about, and one other body or wall at rest.
class Arena {
 public:
  explicit Arena(const Scene& scene) : world_(build_world(scene)) {}

  // The same shapes under another law: shapes take longer to build than loops to go round. False: refused.
  bool put_under(const LawSpec& law, const MaterialSpec& material) {
    world_.scene.law = law;
    world_.law = law_model_of(law);
    world_.law_options = law_options_of(law);
    world_.materials = {material_of(material, law)};
    world_.pairs = {contact::mix(world_.materials[0], world_.materials[0], law.clip)};
    world_.contacts = {};
    try {
      check_map(world_);
    } catch (const InputError&) {
      return false;
    }
    const auto regions = [](const auto& s) { return s.meets_in_regions(); };
    return !world_.law.lingers || !(std::any_of(world_.shapes.begin(), world_.shapes.end(), regions) ||
                                    std::any_of(world_.walls.begin(), world_.walls.end(), regions));
  }

  World& world() { return world_; }
  const Vec3d& force() const { return world_.particles.force[moving_]; }
  const Vec3d& torque() const { return world_.particles.torque[moving_]; }
  bool touching() const { return std::count(touched().begin(), touched().end(), 0) != count(touched()); }
  void rest(const Quatd& orientation) {
    if (world_.particles.count() > 1) world_.particles.orientation[scenes::place(world_, 1)] = orientation;
  }

  // Away, so that every contact ends; then this is where the next path begins.
  void begin(const Pose& pose, double dt) {
    for (const bool away : {true, false}) {
      moving_ = scenes::place(world_, 0);
      Pose p = pose;
      if (away) p.position = p.position * (50e-3 / scenes::length(p.position)), p.velocity = p.spin = {};
      set(p);
      rebuild_candidates(world_, 1);
      moving_ = scenes::place(world_, 0);
      if (away) compute_forces(world_, 1, dt);
    }
  }
  // The forces there, the laws advanced by dt.
  void look(const Pose& pose, double dt) {
    set(pose);
    // Bodies that are led do not tell how far they went.
    std::fill(world_.contacts.apart_until.begin(), world_.contacts.apart_until.end(), 0.0);
    world_.contacts.way_allowed = -1;
    compute_forces(world_, 1, dt);
  }

 private:
  const std::vector<std::uint8_t>& touched() const { return world_.contacts.touching; }
  static std::ptrdiff_t count(const std::vector<std::uint8_t>& v) { return static_cast<std::ptrdiff_t>(v.size()); }
  void set(const Pose& pose) {
    Motion& m = world_.particles.motion[moving_];
    m.position = pose.position;
    m.velocity = pose.velocity;
    m.spin = pose.spin;
    world_.particles.orientation[moving_] = pose.orientation;
  }

  World world_;
  std::size_t moving_ = 0;
};

// From which side a body is met, and how it is turned; a wall lies as it is, met along its normal.
struct RandomMeeting {
  Vec3d along;
  Quatd rest;
};
inline RandomMeeting random_meeting(bool planar, bool wall, shapes::Random& random) {
  if (wall) return {planar ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1}, {}};
  const Quatd rest = planar ? random.turn() : random.rotation();
  return {planar ? shapes::rotate(random.turn(), Vec3d{1, 0, 0}) : random.direction(), rest};
}

// How a loop is made: what moves, and by how much.
struct Style {
  bool shifts, turns, rolls;  // rolls: shift as the turn of a ball would
  bool parts;                 // comes apart and back
  double reach;               // rad of turn; of the body's size, of shift
};

// A path that touches: overlaps along `along` of 0.2 to 3 % of the size, by heights at which the bodies just touch.
// `arena`: of a law without cohesion, the other one at rest as it will be.
inline PosePath random_path(Arena& arena, const Vec3d& along, bool planar, const Style& style, double size,
                            shapes::Random& random) {
  PosePath path;
  path.along = along;
  path.side =
      planar ? Vec3d{0, 0, 1} : normalized(cross(std::abs(along.x) < 0.7 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}, along));
  path.across = cross(along, path.side);
  path.start = planar ? random.turn() : random.rotation();
  if (style.turns)
    for (std::size_t k = 0; k < (planar ? 1 : 3); ++k) path.turn[k] = random_series(random) * style.reach;
  if (style.shifts)
    for (std::size_t k = planar ? 1 : 0; k < 2; ++k) path.shift[k] = random_series(random) * (style.reach * size);
  if (style.rolls) {
    path.shift[1] = path.turn[0] * -size;
    path.shift[0] = path.turn[1] * (planar ? 0 : size);
  }
  const Series wave = random_series(random);
  constexpr std::size_t nodes = 48;
  std::vector<double> height(nodes);
  for (std::size_t j = 0; j < nodes; ++j) {
    const double u = static_cast<double>(j) / nodes;
    Pose p = path(u);
    const Vec3d at = p.position;
    const auto touches = [&](double h) {
      p.position = at + along * h;
      arena.look(p, 0);
      return arena.touching();
    };
    double apart = j > 0 ? height[j - 1] + 0.5 * size : 4 * size, deep = apart;
    p.position = at + along * apart;
    if (j == 0) arena.begin(p, 0);
    while (touches(deep) && deep < 6 * size) deep += 0.5 * size;
    while (!touches(deep) && deep > -4 * size) apart = deep, deep -= 0.1 * size;
    for (int i = 0; i < 36; ++i) (touches(0.5 * (apart + deep)) ? deep : apart) = 0.5 * (apart + deep);
    height[j] = deep;
  }
  for (std::size_t j = 0; j < nodes; ++j) {
    const double w = wave.value(Waves(static_cast<double>(j) / nodes));
    height[j] -= (style.parts ? 0.004 + 0.02 * w : 0.014 + 0.010 * std::clamp(w, -1.0, 1.0)) * size;
  }
  path.height = series_through(height);
  return path;
}

// The poses of a path at u = i/(2 · most), so that paths are made once.
struct Loop {
  std::vector<Pose> poses;
  Quatd rest;  // of the other body
  bool parts;

  Loop(const PosePath& path, const Quatd& resting, bool comes_apart, int most) : rest(resting), parts(comes_apart) {
    for (int i = 0; i < 2 * most; ++i) poses.push_back(path(0.5 * i / most));
  }
};

struct Lap {
  double created = -1e300;  // work on the body, and the gain of stored energy, of the worst lap, J
  double stored = 0;        // largest, J
  int apart = 0;            // looks at which the bodies did not touch
};

// `laps` times round in `steps` each, a lap `duration` long (s): velocities are those of half a step before, as the
// loop has them; work is power at the poses by the rule of trapezoids, whose error on a smooth closed path falls faster
// than any power.
inline Lap go_round(Arena& arena, const Loop& loop, int steps, int laps, double duration) {
  const std::size_t stride = loop.poses.size() / static_cast<std::size_t>(2 * steps), all = loop.poses.size();
  const double dt = duration / steps;
  arena.rest(loop.rest);
  const auto at = [&](int i) {
    const std::size_t place = 2 * stride * static_cast<std::size_t>(i) % all;
    const Pose &before = loop.poses[(place + all - stride) % all], &here = loop.poses[place];
    return Pose{here.position, before.velocity * (1 / duration), here.orientation, before.spin * (1 / duration)};
  };
  const auto power = [&](int i) {
    const Pose& here = loop.poses[2 * stride * static_cast<std::size_t>(i) % all];
    return dot(arena.force(), here.velocity) + dot(arena.torque(), here.spin);
  };
  arena.begin(at(0), dt);
  arena.look(at(0), dt);
  Lap out;
  double last = power(0), kept = energies(arena.world()).elastic;
  for (int lap = 0; lap < laps; ++lap) {
    const double at_start = kept;
    double work = 0;
    for (int i = 1; i <= steps; ++i) {
      arena.look(at(i), dt);
      const double now = power(i);
      work += 0.5 * (last + now) / steps;
      last = now;
      kept = energies(arena.world()).elastic;
      out.stored = std::max(out.stored, std::abs(kept));
      out.apart += arena.touching() ? 0 : 1;
    }
    out.created = std::max(out.created, work + kept - at_start);
  }
  return out;
}

}  // namespace dem::loops
