#include "tests/witness/compare.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace witness {

namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();

bool finite(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

// Distance of x from the body's surface is at most this, m.
bool on_body(const Body& body, const Vector& x, Real tolerance) {
  return norm(x - pulled_in(body, x)) <= tolerance && clearance(body, x) <= tolerance;
}

bool usable_points(const Answer& answer) {
  return answer.has_points && finite(answer.point_a) && finite(answer.point_b);
}

// The points of an answer, each from its body's origin, and whether both are on the bodies.
bool points_on_bodies(const Pair& pair, const Answer& answer) {
  const Real tolerance = 1e-6L * pair.size();
  return on_body(pair.a, widened(answer.point_a), tolerance) &&
         on_body(pair.b, widened(answer.point_b) - widened(pair.offset), tolerance);
}

// The gap is at most minus this when it is positive: a ball about x of each body's clearance.
Real common_ball(const Pair& pair, const Vector& x) {
  const Real in_a = clearance(pair.a, x), in_b = clearance(pair.b, x - widened(pair.offset));
  return std::min(in_a, in_b) < 0 ? Real(-1) : in_a + in_b;
}

}  // namespace

Proof proof(const Pair& pair, const Answer& answer) {
  Proof p{-infinity, infinity};
  const double length = max_abs(answer.direction);
  if (finite(answer.direction) && length > 0) {
    const Vector n = widened(answer.direction) * (1 / static_cast<Real>(length));
    p.below = separation(pair, n);
  }
  if (!usable_points(answer)) return p;
  const Vector a = widened(answer.point_a), b = widened(answer.point_b), d = widened(pair.offset);
  if (!answer.overlap) {
    if (points_on_bodies(pair, answer)) p.above = norm(d + pulled_in(pair.b, b - d) - pulled_in(pair.a, a));
    return p;
  }
  for (const Vector& x : {a, b, Real(0.5) * (a + b)})
    if (const Real ball = common_ball(pair, x); ball >= 0) p.above = std::min(p.above, -ball);
  return p;
}

std::string contradiction(const Pair& pair, const Proof& proof, double lower, double upper) {
  // The proofs' own rounding: long double throughout, but the faces of a polyhedron are flat to a few eps only.
  const Real size = pair.size(), along = 64 * std::numeric_limits<Real>::epsilon() * size,
             points = 16 * std::numeric_limits<double>::epsilon() * size;
  char text[200];
  if (upper < proof.below - along) {
    std::snprintf(text, sizeof text, "%s: gap_upper %.17g below a support separation of %.17Lg", pair.name.c_str(),
                  upper, proof.below);
    return text;
  }
  if (lower > proof.above + points) {
    std::snprintf(text, sizeof text, "%s: gap_lower %.17g above the bound %.17Lg by points", pair.name.c_str(), lower,
                  proof.above);
    return text;
  }
  return {};
}

bool proves_itself(const Pair& pair, const contact::Contact& contact) {
  if (contact.gap > 0) return separation(pair, widened(contact.normal)) > 0;
  return common_ball(pair, Real(0.5) * (widened(contact.point_a) + widened(contact.point_b))) > 0;
}

void Tally::add(const Pair& pair, const contact::Contact& contact, const Answer& answer) {
  ++pairs;
  threw += answer.end == Answer::End::threw;
  aborted += answer.end == Answer::End::aborted;
  hung += answer.end == Answer::End::hung;
  not_asked += answer.end == Answer::End::not_asked;
  if (answer.end != Answer::End::answered) return;
  const double size = pair.size();
  if (std::abs(contact.gap) > 1e-6 * size) {
    ++yes_no;
    if (answer.overlap != (contact.gap < 0)) {
      ++refuted;
      if (!proves_itself(pair, contact)) failures.push_back(pair.name + ": overlap or not, and nobody proves it");
      return;
    }
  }
  const std::string against = contradiction(pair, proof(pair, answer), contact.gap_lower, contact.gap_upper);
  if (!against.empty()) failures.push_back(against);
  if (!answer.overlap && answer.has_points) {
    ++points;
    points_off += !usable_points(answer) || !points_on_bodies(pair, answer);
  }
  if (!answer.overlap && !answer.has_points) return;
  ++gaps;
  const double difference = std::abs(answer.gap - contact.gap);
  within_3 += difference <= 1e-3 * size;
  within_6 += difference <= 1e-6 * size;
}

std::string Tally::line(const std::string& name) const {
  char text[300];
  std::snprintf(
      text, sizeof text,
      "%-32s %4d pairs: %d threw, %d aborted, %d hung, %d not asked; overlap or not: %d of %d refuted; points "
      "off the bodies: %d of %d; gap within 1e-3 L %d, 1e-6 L %d, of %d",
      name.c_str(), pairs, threw, aborted, hung, not_asked, refuted, yes_no, points_off, points, within_3, within_6,
      gaps);
  return text;
}

}  // namespace witness
