#include <algorithm>
#include <cmath>

#include "tests/extremes/dimensions.h"
#include "tests/reference/answer.h"

namespace extremes {

contact::Contact ask(const Case& c, std::string_view method) {
  const contact::Body a = c.a.placed(), b = c.b.placed();
  contact::Contact got;
  contact::find(c.a.kind, c.b.kind, method)(1, &a, &b, &c.offset, {}, nullptr, &got);
  return got;
}

Outcome judge(const Case& c, const contact::Contact& got) {
  if (got.status == contact::Status::refused) return {Verdict::refused, 0, 0, false};
  const reference::Real size = reference::Real(std::max({max_abs(c.offset), c.a.circumradius(), c.b.circumradius()}));
  if (!is_finite(got.normal) || !is_finite(got.point_a) || !is_finite(got.point_b) || !is_finite(got.patch.centre) ||
      !std::isfinite(got.gap) || !(got.gap_lower <= got.gap) || !(got.gap <= got.gap_upper) || !(size > 0))
    return {Verdict::wrong, 0, 0, got.certified};
  reference::Answer truth = reference::answer(c.a, c.b, c.offset);
  // Deep smooth bodies: the reference has the best of all directions but no close upper bound. A method may know a
  // better direction, and must show it.
  if (!truth.matched) {
    truth.lower = std::max(truth.lower, reference::separation(c.a, c.b, c.offset, got.normal));
    truth.upper = truth.lower;
  }
  const reference::Real step =
      reference::Real(contact::epsilon) *
      (norm(reference::Vector{c.offset.x, c.offset.y, c.offset.z}) + c.a.circumradius() + c.b.circumradius());
  Outcome o{Verdict::wider, static_cast<double>((reference::Real(got.gap_upper) - got.gap_lower) / step),
            static_cast<double>(abs(reference::Real(got.gap) - truth.lower) / step), got.certified};
  if (truth.upper < got.gap_lower || (got.certified && truth.lower > got.gap_upper))
    o.verdict = Verdict::wrong;
  else if (o.error <= 64)
    o.verdict = Verdict::holds;
  return o;
}

bool scales(const Case& c, std::string_view method, const contact::Contact& got) {
  if (got.status == contact::Status::refused) return true;
  for (const double unit : {0x1p300, 0x1p-300}) {
    Case other = c;
    other.a.size *= unit;
    other.b.size *= unit;
    other.offset *= unit;
    if (other.offset * (1 / unit) != c.offset) continue;  // bits were lost below the smallest double
    const contact::Contact x = ask(other, method);
    if (x.status != got.status || x.gap != unit * got.gap || x.gap_lower != unit * got.gap_lower ||
        x.gap_upper != unit * got.gap_upper || x.normal != got.normal || x.point_a != unit * got.point_a ||
        x.point_b != unit * got.point_b || x.patch.centre != unit * got.patch.centre)
      return false;
  }
  return true;
}

}  // namespace extremes
