#include "libdem/walls.h"

#include <algorithm>
#include <numbers>

#include "shapes/math/trig.h"

namespace dem {
namespace {

void place(Wall& w, double time) {
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
    case WallMotion::rotation: {
      const auto half = shapes::sine_cosine(0.5 * m.rate * elapsed);
      const Vec3d axis = shapes::normalized(m.axis * (1 / shapes::max_abs(m.axis)));
      const Quatd turn{half.cosine, axis.x * half.sine, axis.y * half.sine, axis.z * half.sine};
      const Vec3d arm = shapes::rotate(turn, w.reference - m.centre);
      w.position = m.centre + arm;
      w.orientation = shapes::normalized(turn * w.reference_orientation);
      if (moves) {
        w.spin = axis * m.rate;
        w.velocity = cross(w.spin, arm);
      }
      return;
    }
    case WallMotion::oscillation: {
      const double omega = 2 * std::numbers::pi * m.frequency;
      const auto s = shapes::sine_cosine(omega * elapsed + m.phase);
      w.position = w.reference + m.amplitude * s.sine;
      if (moves) w.velocity = m.amplitude * (omega * s.cosine);
      return;
    }
  }
}

}  // namespace

void move_walls(World& world) {
  for (Wall& w : world.walls) {
    place(w, world.time());
    if (w.present && world.time() >= w.motion.remove_at) {
      w.present = false;
      world.contacts.stale = true;
    }
  }
}

}  // namespace dem
