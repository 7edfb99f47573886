// Stability of one contact under leapfrog: bodies that are pressed together by a constant force and pushed a little, in
// each direction. The limit is contract 4's: ω² = largest eigenvalue of K^½ W K^½, W the inverse-mass matrix of
// the contact's point (off-centre levers, rods); limit (2/ω)(sqrt(1+β²) − β), β = c sqrt(w/k)/2 of the mode: of a ball
// that sticks to a plane 1.87 times that of the normal mode.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/laws/contacts.h"
#include "bench/laws/report.h"

namespace laws {
namespace {

struct Matrix {
  double m[3][3];
  Vec3d operator*(const Vec3d& v) const {
    return {m[0][0] * v.x + m[0][1] * v.y + m[0][2] * v.z, m[1][0] * v.x + m[1][1] * v.y + m[1][2] * v.z,
            m[2][0] * v.x + m[2][1] * v.y + m[2][2] * v.z};
  }
};

// 1/m + (r×)ᵀ I⁻¹ (r×) of a body whose principal axes are those of the world.
Matrix inverse_mass(double mass, const Vec3d& inertia, const Vec3d& lever) {
  Matrix w{};
  const Vec3d axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int j = 0; j < 3; ++j) {
    const Vec3d turn = cross(lever, axes[j]);
    const Vec3d spin{turn.x / inertia.x, turn.y / inertia.y, turn.z / inertia.z};
    const Vec3d v = axes[j] * (1 / mass) + cross(spin, lever);
    w.m[0][j] = v.x;
    w.m[1][j] = v.y;
    w.m[2][j] = v.z;
  }
  return w;
}

// ω² by power iteration.
double largest(const Matrix& w, double kn, double kt) {
  const Vec3d root{std::sqrt(kt), std::sqrt(kt), std::sqrt(kn)};
  Vec3d v{0.5, 0.3, 0.8};
  double value = 0;
  for (int i = 0; i < 2000; ++i) {
    v = scaled(root, w * scaled(root, v));
    value = norm(v);
    v = v * (1 / value);
  }
  return value;
}

struct Body {
  const char* name;
  Matrix w;
};

std::vector<Body> bodies() {
  const double m = 1e-5, r = 1e-3, i = 0.4 * m * r * r;
  // A rod of 20:2:2 mm that touches near its end, a plate near its edge, and a brick anywhere.
  const auto brick = [m](double a, double b, double c) {
    return Vec3d{m / 12 * (b * b + c * c), m / 12 * (a * a + c * c), m / 12 * (a * a + b * b)};
  };
  return {{"sphere", inverse_mass(m, {i, i, i}, {0, 0, r})},
          {"rod, near its end", inverse_mass(m, brick(20 * r, r, r), {9.5 * r, 0.3 * r, 0.5 * r})},
          {"plate, near its edge", inverse_mass(m, brick(10 * r, 10 * r, 0.5 * r), {4.7 * r, -3 * r, 0.25 * r})},
          {"brick, off-centre", inverse_mass(m, brick(3 * r, 2 * r, r), {0.9 * r, 0.6 * r, 0.5 * r})}};
}

// The contact as it stands before the push: pressed to `overlap`, and for laws that yield let go a little, so that
// small motions are elastic.
Drive pressed(LawContact c, const Body& body, double overlap) {
  c.radius_eff = 1e-3;
  c.mass_eff = 1 / body.w.m[2][2];
  Drive drive(c);
  drive.step({.overlap = overlap});
  if (c.model.loss == contact::Loss::plastic) drive.step({.overlap = 0.999 * overlap});
  return drive;
}

// After a push of 1e-9 of the overlap in a direction: whether it stays below a hundredth of it.
bool is_stable(const LawContact& c, const Body& body, double overlap, double dt, const Vec3d& direction) {
  Drive drive = pressed(c, body, overlap);
  const Vec3d load = -drive.answer().force;
  double depth = c.model.loss == contact::Loss::plastic ? 0.999 * overlap : overlap;
  const double push = 1e-9 * overlap;
  Vec3d x{}, u = direction * (push / dt);
  for (int i = 0; i < 1500; ++i) {
    x += u * dt;
    const auto& a = drive.step({.overlap = depth + x.z, .velocity = u, .dt = dt, .prescribed = false});
    u += body.w * (a.force + load) * dt;
    if (!(norm(x) < 0.01 * overlap)) return false;
  }
  return true;
}

// Largest stable step over the limit.
double actual_over(const LawContact& c, const Body& body, double overlap, double limit, const Vec3d& direction) {
  double low = 0.3, high = 4;
  if (!is_stable(c, body, overlap, low * limit, direction)) return 0;
  while (high - low > 1e-4) {
    const double middle = 0.5 * (low + high);
    (is_stable(c, body, overlap, middle * limit, direction) ? low : high) = middle;
  }
  return low;
}

}  // namespace

void stability(Report& r) {
  const double overlap = 1e-5;
  r.heading("undamped: the largest stable step over the limit is 1 within 1 %; overlap 1 % of R*");
  r.heading(
      "damped (e = 0.6): not below 0.99; above 1 where the law lessens its dashpot for its lag, and where modes mix");
  for (const LawNames& n : every_law()) {
    for (const bool damped : {false, true}) {
      Material m = stone();
      if (!damped) m.restitution = 1, m.viscous_time = 0, m.rolling_viscosity = 0;
      const LawContact c = contact_of(n, m, m, wet());
      if (damped && c.model.damping_factor == 0 && n.normal != "viscoelastic_hertz") continue;
      // What latches does so by its restitution: it needs one.
      LawContact used = c;
      if (!damped) used.pair.loading_ratio = 0.36;
      for (const Body& body : bodies()) {
        const Drive at = pressed(used, body, overlap);
        const double kn = at.answer().stiffness, kt = n.tangential == "none" ? 0 : at.answer().stiffness_t;
        // β of a mode: c w/(2 ω), ω² = k w; of several the largest.
        const double wt = std::max(largest(body.w, 0, 1), body.w.m[0][0]);
        double beta = 0.5 * at.answer().damping * std::sqrt(body.w.m[2][2] / kn);
        if (kt > 0) beta = std::max(beta, 0.5 * at.answer().damping_t * std::sqrt(wt / kt));
        const double limit = 2 / std::sqrt(largest(body.w, kn, kt)) * (std::sqrt(1 + beta * beta) - beta);
        double ratio = 1e9;
        for (const Vec3d& push : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}})
          ratio = std::min(ratio, actual_over(used, body, overlap, limit, push));
        const double all = actual_over(used, body, overlap, limit, {0.5, -0.3, 0.8});
        const std::string item = fmt::format("{}{}, {}", title(n), damped ? ", damped" : "", body.name);
        // JKR's stiffness of contact is stated from above.
        if (damped || n.normal == "jkr" || n.normal == "thornton_ning_adhesive")
          r.at_least(item, 0.99, ratio);
        else
          r.near(item, 1, ratio, 0.01);
        // Micro-slip is no linear spring to a motion along and across at once.
        if (all < 0.995 * ratio) r.note(item + ", pushed along and across at once", all);
        if (n.rolling != "none" || n.cohesion != "none") break;  // those add nothing to the springs
      }
    }
  }
}

}  // namespace laws
