// The servo. A wall without mass that pushes with target − force, against a resistance c: v = gain (target − F) / c,
// |v| <= speed_limit, F the push of the wall on the bodies in the step before. With
//   c = Σ (1 + 2β) sqrt(kn m)   over the bodies m that it touches, kn the stiffness of their contacts              (1)
// the wall is matched to the bed: sqrt(k m) is what a chain of bodies opposes to a slow push, so the wall absorbs what
// comes to it instead of throwing it back.
// The iteration v → F → v is stable: the contacts' own dashpots, 2β sqrt(kn m) at most, answer with less than c, and
// the springs with kn dt / c < sqrt(kn/m) dt, which the time step keeps below 1. A wall that touches nothing keeps its
// last c; before its first contact it comes at speed_limit.
#include "libdem/walls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "libdem/build.h"
#include "libdem/coherence.h"
#include "shapes/math/trig.h"

namespace dem {
namespace {

// Value and slope of a table of rows [time, …] at a time: straight between rows, at rest outside.
template <class Row>
struct Sample {
  Row value{}, slope{};
};
template <class Row>
Sample<Row> sample(const std::vector<Row>& rows, double time) {
  Sample<Row> s;
  if (rows.empty()) return s;
  const auto next = std::upper_bound(rows.begin(), rows.end(), time, [](double t, const Row& r) { return t < r[0]; });
  if (next == rows.begin() || next == rows.end()) {
    s.value = next == rows.begin() ? rows.front() : rows.back();
    return s;
  }
  const Row &a = *(next - 1), &b = *next;
  for (std::size_t k = 1; k < a.size(); ++k) {
    s.slope[k] = (b[k] - a[k]) / (b[0] - a[0]);
    s.value[k] = a[k] + s.slope[k] * (time - a[0]);
  }
  return s;
}

// Turned by an angle about the motion's axis, at a rate.
void turn(Wall& w, double angle, double rate) {
  const WallSpec& m = w.motion;
  const auto half = shapes::sine_cosine(0.5 * angle);
  const Vec3d axis = shapes::normalized(m.axis * (1 / shapes::max_abs(m.axis)));
  const Quatd q{half.cosine, axis.x * half.sine, axis.y * half.sine, axis.z * half.sine};
  const Vec3d arm = shapes::rotate(q, w.reference - m.centre);
  w.position = m.centre + arm;
  w.orientation = shapes::normalized(q * w.reference_orientation);
  w.spin = axis * rate;
  w.velocity = cross(w.spin, arm);
}

// At a time, after a step dt. Contacts compare the velocity with those that bodies have in the middle of the step, so
// that of an oscillation is taken there too: else a dashpot sees a body that rides on the plate move by half a step's
// acceleration, and the body rides on a wrong overlap.
void place(Wall& w, double time, double dt) {
  const WallSpec& m = w.motion;
  const bool moves = time >= m.start && time < m.stop;
  const double elapsed = std::max(0.0, std::min(time, m.stop) - m.start);
  w.velocity = w.spin = {};
  switch (m.motion) {
    case WallMotion::fixed:
      return;
    case WallMotion::translation:
      w.position = w.reference + m.velocity * elapsed;
      if (moves) w.velocity = m.velocity;
      return;
    case WallMotion::rotation:
      return turn(w, m.rate * elapsed, moves ? m.rate : 0);
    case WallMotion::oscillation: {
      const double omega = 2 * std::numbers::pi * m.frequency;
      w.position = w.reference + m.amplitude * shapes::sine_cosine(omega * elapsed + m.phase).sine;
      const double middle = std::max(0.0, elapsed - 0.5 * dt);
      if (moves) w.velocity = m.amplitude * (omega * shapes::sine_cosine(omega * middle + m.phase).cosine);
      return;
    }
    case WallMotion::table: {
      const auto way = sample(m.displacements, elapsed);
      const auto angle = sample(m.turns, elapsed);
      w.position = w.reference;
      if (!m.turns.empty()) turn(w, angle.value[1], moves ? angle.slope[1] : 0);
      w.position += Vec3d{way.value[1], way.value[2], way.value[3]};
      if (moves) w.velocity += Vec3d{way.slope[1], way.slope[2], way.slope[3]};
      return;
    }
    case WallMotion::servo:
      return;  // not a function of time: push()
  }
}

void push(Wall& w, double time, double dt) {
  const WallSpec& m = w.motion;
  w.velocity = {};
  if (!w.present || time < m.start || time >= m.stop) return;
  const double missing = w.target + dot(w.push, w.force);  // the force of the bodies is against the push
  const double limit = m.speed_limit, most = w.resistance * limit, wanted = m.gain * missing;
  const double speed = wanted >= most ? limit : wanted <= -most ? -limit : wanted / w.resistance;
  w.velocity = w.push * speed;
  w.position += w.velocity * dt;
}

// Returns by how much.
double add_travel(Wall& w) {
  const Quatd &q = w.orientation, &seen = w.seen_orientation;
  const bool turned = q.w != seen.w || q.x != seen.x || q.y != seen.y || q.z != seen.z;
  const double radius = is_half_space(w.kind) && turned ? std::numeric_limits<double>::infinity() : w.extent;
  const double way =
      turned || !(w.position == w.seen_position) ? travel_of(w.position - w.seen_position, seen, q, radius) : 0;
  w.travel += way;
  w.seen_position = w.position;
  w.seen_orientation = w.orientation;
  return way;
}

}  // namespace

void start_motion(Wall& w, double time) {
  const bool moved = std::isfinite(w.motion.start);
  w.motion.start = time;
  w.motion.stop = std::numeric_limits<double>::infinity();
  if (!moved || w.motion.motion == WallMotion::servo) return;
  const Vec3d here = w.reference = w.position;
  const Quatd turned = w.reference_orientation = w.orientation;
  place(w, time, 0);  // where the motion itself would begin
  const Quatd first = w.orientation * conjugate(turned);
  w.reference += shapes::rotate(conjugate(first), here - w.position);
  if (w.motion.motion == WallMotion::table && !w.motion.turns.empty())
    w.reference_orientation = shapes::normalized(conjugate(first) * turned);
  place(w, time, 0);
}

void stop_motion(Wall& w, double time) { w.motion.stop = time; }

void sum_resistance(World& world) {
  bool servo = false;
  for (const Wall& w : world.walls) servo = servo || w.motion.motion == WallMotion::servo;
  if (!servo) return;
  const Contacts& c = world.contacts;
  std::vector<double> sum(world.walls.size());
  for (const std::uint32_t k : c.wall_records)
    if (c.touching[k] != 0 && world.walls[c.index_b[k]].motion.motion == WallMotion::servo)
      sum[c.index_b[k]] += contact_resistance(world, k);
  for (std::size_t w = 0; w < sum.size(); ++w)
    if (sum[w] > 0) world.walls[w].resistance = sum[w];
}

void move_walls(World& world) {
  const double dt = world.step > 0 ? world.time_step.dt : 0;
  double farthest = 0;
  for (Wall& w : world.walls) {
    if (w.motion.motion == WallMotion::servo)
      push(w, world.time(), dt);
    else
      place(w, world.time(), dt);
    if (!world.contacts.travel.empty()) {
      const double way = add_travel(w);
      if (std::isfinite(way)) farthest = std::max(farthest, way);  // nothing sleeps near a half-space that turns
    }
    if (w.present && world.time() >= w.motion.remove_at) {
      w.present = false;
      world.contacts.stale = true;
    }
  }
  world.contacts.step_way += farthest;
}

}  // namespace dem
