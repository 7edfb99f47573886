// One contact of every law is stable just below the limit of the step that goes with its springs and unstable just
// above, in the middle of a body and off its centre; contact_limit never says more than that limit.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cstdio>
#include <limits>

#include "libdem/build.h"
#include "libdem/forces.h"
#include "tests/libdem/laws_in_loop.h"

namespace dem {
namespace {

// What rests, and how: a ball, a rod that lies, and one that stands askew on its tip, held by friction.
struct Resting {
  const char* name;
  ShapeSpec shape;
  Quatd orientation;
};
std::vector<Resting> resting() {
  const double r = law_loop::radius;
  return {{"ball", scenes::sphere("body", r), {}},
          {"lying_rod", scenes::ellipsoid("body", {r, r, 5 * r}), scenes::turn({0, 1, 0}, std::numbers::pi / 2)},
          {"rod_on_its_tip", scenes::ellipsoid("body", {r, r, 2 * r}), scenes::turn({0, 1, 0}, 0.1)}};
}

// Shallow, so that the weight's own slow modes do not show, and past the first yield of what yields.
constexpr double depth = 1e-6 * law_loop::radius;

MaterialSpec material(double restitution) {
  MaterialSpec m = law_loop::material();
  m.restitution = restitution;
  m.friction = 4;
  m.yield_pressure = 2e3;
  m.plastic_depth = 1e-6;
  m.viscous_time = 0;
  m.cohesion = 1e-9;
  m.work_of_adhesion = 1e-6;
  m.rolling_damping = 0;
  m.rolling_viscosity = 0;
  return m;
}

// At rest on a plane, unloaded a little from its greatest depth; gravity points from its centre to the contact (without
// friction to the plane: it turns, slowly).
World at_rest(const LawSpec& law, const MaterialSpec& m, const Resting& body) {
  Scene s;
  s.law = law;
  s.law.bridge_volume = 1e-18;
  s.law.surface_tension = 1e-6;
  s.materials = {m};
  s.shapes = {body.shape};
  s.walls = {scenes::plane("floor", "m", {0, 0, 0}, {0, 0, 1})};
  s.run.dt_auto = false;
  s.run.dt = 1e-12;
  s.run.steps = 1;
  s.run.max_initial_overlap = 10;
  s.bodies = {scenes::body("body", "m", {0, 0, 1}, {}, {}, body.orientation)};
  const Vec3d axes = body.shape.kind == "sphere" ? Vec3d{1, 1, 1} * body.shape.radius : body.shape.semi_axes;
  const Vec3d up = rotate(shapes::conjugate(body.orientation), Vec3d{0, 0, 1});
  s.bodies[0].position.z = shapes::norm(scaled(axes, up)) - depth;
  World w = build_world(s);
  w.particles.motion[0].position.z += 0.02 * depth;
  compute_forces(w, 1, 0.0);
  EXPECT_EQ(touching_contacts(w).size(), 1u);
  const Vec3d arm = contact_point(w, 0) - w.particles.motion[0].position;
  const double n = w.contacts.slot[0].force.z;
  const Vec3d whole = arm * (n / arm.z);  // a force along the arm does not turn the body
  const bool held = law_names(law).tangential != "none";
  if (held && std::abs(arm.x) > 1e-9 * std::abs(arm.z)) w.contacts.history[0].force_t = {-whole.x, -whole.y, 0};
  compute_forces(w, 1, 0.0);
  w.scene.gravity = (held ? whole : Vec3d{0, 0, n}) * (-1 / w.particles.mass[0]);
  return w;
}

// The step at which the springs of the contact make its body unstable: dt² K + 2 dt C, the eigenvalues over its mass,
// may reach 4. K: along and across the normal, rolling, twisting. C: dry friction of rolling, which within a step is a
// dashpot that takes a quarter of a turn (laws/rolling/resistance.h).
double stable_step(const World& w) {
  using Matrix = Eigen::Matrix<double, 6, 6>;
  const Particles& p = w.particles;
  const Vec3d arm = contact_point(w, 0) - p.motion[0].position;
  const contact::PairParameters& q = w.pairs[0];
  const double radius = p.motion[0].equivalent_radius;
  const contact::Stiffness k = w.law.stiffness(q, w.law_options, radius, w.contacts.history[0].overlap,
                                               w.contacts.memory.empty() ? nullptr : &w.contacts.memory[0]);
  const auto r = shapes::rotation_matrix(p.orientation[0]);
  Eigen::Matrix3d turn, skew;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) turn(i, j) = r.row[i][j];
  skew << 0, -arm.z, arm.y, arm.z, 0, -arm.x, -arm.y, arm.x, 0;
  const Eigen::Vector3d inertia(p.inertia[0].x, p.inertia[0].y, p.inertia[0].z);
  Matrix inverse_mass = Matrix::Zero(), damping = Matrix::Zero();
  inverse_mass.topLeftCorner<3, 3>() = Eigen::Matrix3d::Identity() * p.motion[0].inverse_mass;
  inverse_mass.bottomRightCorner<3, 3>() = turn * inertia.cwiseInverse().asDiagonal() * turn.transpose();
  Eigen::Matrix<double, 3, 6> point;  // u − skew θ
  point << Eigen::Matrix3d::Identity(), -skew;
  const double t = law_names(w.scene.law).tangential == "none" ? 0 : k.t;
  Matrix stiffness = point.transpose() * Eigen::Vector3d(t, t, k.n).asDiagonal() * point;
  stiffness.bottomRightCorner<3, 3>() += Eigen::Vector3d(k.rolling, k.rolling, k.twist).asDiagonal();
  const std::string rolling = law_names(w.scene.law).rolling;
  if (rolling == "constant" || rolling == "viscous") {
    const double along = (point * inverse_mass * point.transpose())(2, 2), dry = 0.25 * 0.4 * radius * radius / along;
    const double rolled = rolling == "constant" ? dry : 0;  // this material's rolling viscosity is 0
    damping.bottomRightCorner<3, 3>() = Eigen::Vector3d(rolled, rolled, dry).asDiagonal();
  }
  const Matrix root = inverse_mass.llt().matrixL();
  const auto largest = [&](double dt) {
    const Matrix m = root.transpose() * (stiffness * (dt * dt) + damping * 2) * root;
    return Eigen::SelfAdjointEigenSolver<Matrix>(m).eigenvalues().maxCoeff();
  };
  double low = 0, high = 1;
  while (high - low > 1e-9 * high) (largest(0.5 * (low + high)) < 4 ? low : high) = 0.5 * (low + high);
  return low;
}

// The part of its motion that changes sign from step to step, late over early: what is unstable does so and grows.
double growth(World w, double dt) {
  w.time_step.dt = dt;
  constexpr double push = 1e-7 * depth;
  Motion& m = w.particles.motion[0];
  m.position.z += push;
  m.velocity = Vec3d{0.6, 0.5, 0.7} * (push / dt);
  double early = 0, late = 0;
  std::vector<Vec3d> way, turned;
  for (int i = 0; i < 60; ++i) {
    try {
      advance(w, 1);
    } catch (const RunError&) {  // it jumped off and came down again
      return std::numeric_limits<double>::infinity();
    }
    if (touching_contacts(w).empty()) return std::numeric_limits<double>::infinity();
    way.push_back(w.particles.motion[0].position);
    turned.push_back(w.particles.rotation[0] * law_loop::radius);
    const std::size_t n = way.size();
    if (n < 5) continue;
    const auto changes = [n](const std::vector<Vec3d>& x) {  // fourth differences: what is slow has next to none
      return shapes::norm(x[n - 1] - (x[n - 2] + x[n - 4]) * 4.0 + x[n - 3] * 6.0 + x[n - 5]);
    };
    const double size = changes(way) + changes(turned);
    if (i >= 8 && i < 20) early = std::max(early, size);
    if (i >= 48) late = std::max(late, size);
  }
  return late / early;
}

class OneContact : public testing::TestWithParam<std::tuple<std::size_t, std::size_t>> {};

TEST_P(OneContact, IsStableJustBelowTheLimitAndUnstableJustAbove) {
  const LawSpec law = law_loop::every_law()[std::get<0>(GetParam())];
  const Resting body = resting()[std::get<1>(GetParam())];
  const World w = at_rest(law, material(1), body);
  const double limit = stable_step(w), used = contact_limit(w, 0, w.contacts.history[0].overlap);
  const double below = growth(w, 0.99 * limit), above = growth(w, 1.01 * limit);
  std::printf("  limit %.4e s, used %.3f of it; growth %.2g just below, %.2g just above\n", limit, used / limit, below,
              above);
  EXPECT_LE(used, limit * (1 + 1e-9));
  EXPECT_LT(below, 2);
  EXPECT_GT(above, 10);
}

// Dashpots of every kind shorten the limit and contact_limit knows it. The ratio of the actual limit to it is printed:
// it is more than 1.2 only where a strong dashpot is made less by its lag (kinematics.h).
TEST(LawStability, DampedContactsAreStableBelowContactLimit) {
  for (const LawSpec& law : law_loop::every_law())
    for (const double strength : {0.2, 1.0}) {
      MaterialSpec m = material(strength < 1 ? 0.7 : 0.1);
      m.viscous_time = 2e-3 * strength;
      m.rolling_damping = m.rolling_viscosity = strength;
      const World w = at_rest(law, m, resting()[0]);
      const double used = contact_limit(w, 0, w.contacts.history[0].overlap);
      EXPECT_LT(growth(w, 0.99 * used), 2) << law_title(law);
      double ratio = 1;
      while (ratio < 2 && growth(w, ratio * used) < 2) ratio *= 1.01;
      std::printf("  %-70s %.3f\n", law_title(law).c_str(), ratio);
      if (law_names(law).normal != "latching_spring") {  // what grows there latches
        EXPECT_LT(ratio, 1.6) << law_title(law);
      }
    }
}

std::string name_of(const testing::TestParamInfo<std::tuple<std::size_t, std::size_t>>& p) {
  return law_loop::test_name(law_loop::every_law()[std::get<0>(p.param)]) + "_" + resting()[std::get<1>(p.param)].name;
}

// Off the centre only those that are at rest: what remembers more than its tangential force is not set up by hand.
std::vector<std::tuple<std::size_t, std::size_t>> cases() {
  std::vector<std::tuple<std::size_t, std::size_t>> all;
  for (std::size_t l = 0; l < law_loop::every_law().size(); ++l)
    for (std::size_t b = 0; b < resting().size(); ++b) {
      const World w = at_rest(law_loop::every_law()[l], material(1), resting()[b]);
      const double most = 1e-6 * scenes::length(w.particles.force[0]) * law_loop::radius;
      if (scenes::length(w.particles.torque[0]) < most) all.emplace_back(l, b);
    }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Every, OneContact, testing::ValuesIn(cases()), name_of);

}  // namespace
}  // namespace dem
