#include "libdem/law_driver/impact.h"

#include <algorithm>
#include <cmath>

namespace dem::law_driver {
namespace {

struct Moving {
  Ball ball;
  Vec3d position{}, velocity{}, spin{}, force{}, torque{};

  double inverse_mass() const { return 1 / ball.mass; }
  double inverse_inertia() const { return 1 / ball.inertia; }
  // Returns the work of force and torque: with the mean of the velocities before and after.
  double kick(double h) {
    const Vec3d v = velocity, w = spin;
    velocity += force * (h * inverse_mass());
    spin += torque * (h * inverse_inertia());
    return 0.5 * h * (dot(force, v + velocity) + dot(torque, w + spin));
  }
  double kinetic() const {
    return (std::isfinite(ball.mass) ? 0.5 * ball.mass * dot(velocity, velocity) : 0) +
           (std::isfinite(ball.inertia) ? 0.5 * ball.inertia * dot(spin, spin) : 0);
  }
};

struct Geometry {
  double overlap;
  Vec3d normal, arm_a, arm_b;
};

// As the kernels of sphere pairs and of planes place the contact: midway through the overlap.
Geometry geometry(const Moving& a, const Moving& b) {
  Geometry g;
  const Vec3d offset = b.position - a.position;
  if (b.ball.radius > 0) {
    const double distance = norm(offset);
    g.normal = offset * (1 / distance);
    g.overlap = a.ball.radius + b.ball.radius - distance;
    g.arm_a = g.normal * (a.ball.radius - 0.5 * g.overlap);
  } else {
    g.normal = {0, 0, 1};
    g.overlap = a.ball.radius - offset.z;
    g.arm_a = g.normal * (a.ball.radius - 0.5 * g.overlap);
  }
  g.arm_b = g.arm_a - offset;
  if (!(b.ball.radius > 0)) g.arm_b = {};  // a plane does not turn
  return g;
}

class Impact {
 public:
  Impact(const LawContact& contact, const Ball& a, const Ball& b, const Approach& how)
      : drive_(contact), a_{a}, b_{b}, how_(how), dt_(how.dt) {
    // In the frame of the common centre of mass.
    const double share_b = std::isfinite(b.mass) ? a.mass / (a.mass + b.mass) : 0;
    const Vec3d v{how.tangential_speed, 0, how.normal_speed};
    a_.velocity = v * (1 - share_b);
    b_.velocity = v * -share_b;
    a_.spin = {0, how.spin_a, 0};
    b_.spin = {0, how.spin_b, 0};
    // They touch after the part `phase` of the first step.
    a_.position = {};
    b_.position = Vec3d{0, 0, a.radius + b.radius} + v * (how.phase * dt_);
    move_.prescribed = false;
    energy_ = result_.kinetic_before = result_.largest_kinetic = a_.kinetic() + b_.kinetic();
  }

  Rebound run(const std::function<void(const Look&)>& look, std::size_t most_steps) {
    bool met = false;
    for (std::size_t n = 0; n < most_steps; ++n) {
      step();
      const Answer& answer = drive_.answer();
      if (answer.touching) {
        met = true;
        ++result_.steps;
        watch(answer);
        if (look) look({time_, move_.overlap, slip_.x, slip_.y, move_, drive_});
      } else if (met) {
        result_.ended = true;
        break;
      } else if (n > 2) {
        break;  // passed by: nothing to meet
      }
      if (stays()) break;
    }
    finish();
    return result_;
  }

 private:
  void step() {
    const double before = a_.kinetic() + b_.kinetic();
    work_ += a_.kick(0.5 * dt_) + b_.kick(0.5 * dt_);
    a_.position += a_.velocity * dt_;
    b_.position += b_.velocity * dt_;
    const Geometry g = geometry(a_, b_);
    move_.normal = g.normal;
    move_.velocity = a_.velocity + cross(a_.spin, g.arm_a) - b_.velocity - cross(b_.spin, g.arm_b);
    move_.turned = cross(a_.spin, arm_a_ - g.arm_a) - cross(b_.spin, arm_b_ - g.arm_b);
    arm_a_ = g.arm_a;
    arm_b_ = g.arm_b;
    move_.turn = 0.5 * dot(a_.spin + b_.spin, g.normal);
    move_.relative_spin = a_.spin - b_.spin;
    const double was = move_.overlap;
    move_.overlap = g.overlap;
    move_.dt = dt_;
    const bool touched = drive_.answer().touching;
    const Answer& answer = drive_.step(move_);
    a_.force = answer.force;
    b_.force = -answer.force;
    a_.torque = cross(g.arm_a, answer.force) + answer.moment;
    b_.torque = -cross(g.arm_b, answer.force) - answer.moment;
    const double closing = dot(move_.velocity, g.normal);
    double part = 0;  // of the step, in contact
    if (answer.touching)
      part = touched ? 1 : std::min(1.0, g.overlap / (closing * dt_));
    else if (touched && closing < 0)
      part = std::min(1.0, std::max(0.0, was) / (-closing * dt_));
    time_ += part * dt_;
    const Vec3d slip = (move_.velocity - g.normal * closing) * (part * dt_);
    slip_ += Vec3d{slip.x * g.normal.z - slip.z * g.normal.x, slip.y, 0};
    work_ += a_.kick(0.5 * dt_) + b_.kick(0.5 * dt_);
    const double now = a_.kinetic() + b_.kinetic();
    result_.largest_kinetic = std::max({result_.largest_kinetic, before, now});
    gained_ = now - result_.kinetic_before;
    result_.work_error = std::max(result_.work_error, std::abs(gained_ - work_));
    result_.energy_error = std::max(result_.energy_error, std::abs(now + answer.energy + drive_.lost() - energy_));
  }

  void watch(const Answer& answer) {
    result_.peak_force = std::max(result_.peak_force, answer.normal);
    if (move_.overlap > result_.peak_overlap) {
      result_.peak_overlap = move_.overlap;
      result_.peak_time = time_;
      peak_steps_ = result_.steps;
    }
  }

  // A contact that lasts long beyond its first push: stuck, or creeping out.
  bool stays() const { return peak_steps_ > 0 && result_.steps > 1000 + 60 * peak_steps_; }

  void finish() {
    const Vec3d v = a_.velocity - b_.velocity;
    const Geometry g = geometry(a_, b_);
    const Vec3d point = v + cross(a_.spin, g.arm_a) - cross(b_.spin, g.arm_b);
    // Along the normal of the moment at which they meet: they part before it has turned by much.
    result_.normal_speed = v.z;
    result_.tangential_speed = v.x;
    result_.restitution = result_.ended ? -v.z / how_.normal_speed : 0;
    result_.tangential_restitution = how_.tangential_speed != 0 ? v.x / how_.tangential_speed : 0;
    result_.contact_slip = point.x;
    result_.spin_a = a_.spin.y;
    result_.spin_b = b_.spin.y;
    result_.duration = time_;
    result_.kinetic_after = a_.kinetic() + b_.kinetic();
    for (std::size_t m = 0; m < contact::mechanism_count; ++m)
      result_.lost[m] = drive_.lost(static_cast<contact::Mechanism>(m));
  }

  Drive drive_;
  Moving a_, b_;
  Approach how_;
  double dt_, time_ = 0, work_ = 0, gained_ = 0, energy_ = 0;
  std::size_t peak_steps_ = 0;
  Vec3d slip_{}, arm_a_{}, arm_b_{};
  Move move_;
  Rebound result_;
};

}  // namespace

Ball solid_ball(double radius, double mass) { return {radius, mass, 0.4 * mass * radius * radius}; }

void set_bodies(LawContact& contact, const Ball& a, const Ball& b) {
  contact.radius_eff = b.radius > 0 ? a.radius * b.radius / (a.radius + b.radius) : a.radius;
  contact.mass_eff = 1 / (1 / a.mass + 1 / b.mass);
}

Rebound impact(LawContact contact, const Ball& a, const Ball& b, const Approach& approach,
               const std::function<void(const Look&)>& look, std::size_t most_steps) {
  set_bodies(contact, a, b);
  return Impact(contact, a, b, approach).run(look, most_steps);
}

double automatic_step(LawContact contact, const Ball& a, const Ball& b, double fraction, double overlap_share,
                      int contacts) {
  set_bodies(contact, a, b);
  const double rows = std::max(1.0, 0.5 * contacts), smaller = b.radius > 0 ? std::min(a.radius, b.radius) : a.radius;
  double n = 1 / a.mass, t = 1 / a.mass + a.radius * a.radius / a.inertia;
  if (std::isfinite(b.mass)) {
    n += 1 / b.mass;
    t += 1 / b.mass + b.radius * b.radius / b.inertia;
  }
  return fraction * stable_step(contact, overlap_share * smaller, n, t) / std::sqrt(rows);
}

}  // namespace dem::law_driver
