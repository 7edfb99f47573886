#include "tests/fuzz/pair_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pair_fuzz {
namespace {

using Real = long double;
using Vector = shapes::Vec3<Real>;
using contact::epsilon;
using contact::Status;

Vector wide(const Vec3d& v) { return {v.x, v.y, v.z}; }
Vector unit(const Vector& v) { return v * (1 / std::sqrt(dot(v, v))); }
bool is_endless(Kind k) { return k == Kind::plane || k == Kind::line; }
Vector wall_normal(const Body& b) { return unit(wide(b.rotation.column(b.kind == Kind::line ? 1 : 2))); }

// Rᵀn
Vector to_body(const Body& b, const Vector& n) {
  const auto& r = b.rotation;
  return {dot(wide(r.column(0)), n), dot(wide(r.column(1)), n), dot(wide(r.column(2)), n)};
}

Real over_vertices(const std::vector<Vec3d>& vertices, Real scale, const Vector& m) {
  Real best = -std::numeric_limits<Real>::infinity();
  for (const Vec3d& v : vertices) best = std::max(best, dot(wide(v), m));
  return scale * best;
}

// max over the body of n·x, from its origin; an upper bound of it, within rounding, of potential particles.
Real support(const Body& b, const Vector& n) {
  const Vector m = to_body(b, n);
  const auto over = [&](Real x, Real y, Real z) { return std::sqrt(x * x + y * y + z * z); };
  switch (b.kind) {
    case Kind::sphere:
    case Kind::disc:
      return b.size.x;
    case Kind::ellipsoid:
    case Kind::ellipse:
      return over(b.size.x * m.x, b.size.y * m.y, b.kind == Kind::ellipse ? 0 : b.size.z * m.z);
    case Kind::polyhedron:
    case Kind::rounded_polyhedron:
      return over_vertices(static_cast<const shapes::Polyhedron*>(b.geometry)->vertices, b.size.x, m) + b.size.y;
    case Kind::polygon:
      return over_vertices(static_cast<const shapes::Polygon*>(b.geometry)->vertices, b.size.x, m);
    case Kind::potential_particle: {
      const auto& p = *static_cast<const shapes::PotentialParticle*>(b.geometry);
      const auto s = shapes::support_from_centre<Real>(p, unit(m));
      return b.size.x * (dot(m, wide(p.centre)) + s.height + s.excess);
    }
    default:
      return std::numeric_limits<Real>::quiet_NaN();
  }
}

Real separation(const PairCase& c, const Vector& n) {
  return dot(n, wide(c.offset)) - support(c.a.body, n) - support(c.b.body, -n);
}

// Outward normals of flat parts, along world axes.
template <class Use>
void each_face(const Body& b, Use&& use) {
  const auto out = [&](const Vec3d& n) {
    const auto& r = b.rotation;
    return unit(wide(r.column(0)) * Real(n.x) + wide(r.column(1)) * Real(n.y) + wide(r.column(2)) * Real(n.z));
  };
  if (b.kind == Kind::polyhedron || b.kind == Kind::rounded_polyhedron)
    for (const auto& face : static_cast<const shapes::Polyhedron*>(b.geometry)->faces) use(out(face.normal));
  if (b.kind == Kind::polygon)
    for (const Vec3d& n : static_cast<const shapes::Polygon*>(b.geometry)->normals) use(out(n));
}

// The directions of (2). Every one is unit.
template <class Use>
void each_direction(const PairCase& c, const Vector& normal, Source& s, Use&& use) {
  const bool flat = shapes::dimension_of(c.a.body.kind) == 2;
  use(normal);
  each_face(c.a.body, use);
  each_face(c.b.body, [&](const Vector& n) { use(-n); });
  if (max_abs(c.offset) > 0) use(unit(wide(c.offset * (1 / max_abs(c.offset)))));
  for (int i = 0; i < 12; ++i) {
    Vector v = wide(s.vector());
    if (flat) v.z = 0;
    if (i >= 3) v = normal + v * std::pow(Real(10), -Real(i - 2));
    if (dot(v, v) > 1e-6) use(unit(v));
  }
}

class Judge {
 public:
  Judge(const PairCase& pair, const Contact& answer) : c_(pair), r_(answer), unit_(epsilon * pair.extent()) {}

  Judgement run(Source& source) {
    out_.uncertified = !r_.certified;
    out_.refused = r_.status == Status::refused;
    out_.not_converged = r_.status == Status::not_converged;
    if (out_.refused) return out_;
    left_to_others_ = c_.b.body.kind == Kind::mesh && r_.status == Status::separated && std::isinf(r_.gap_upper);
    if (!numbers()) return out_;
    if (c_.b.body.kind == Kind::mesh) return out_;
    if (is_endless(c_.b.body.kind))
      against_wall();
    else
      along_directions(source);
    if (!out_.broken) witnesses();
    return out_;
  }

 private:
  void breaks(const char* rule, Real by = 0) {
    if (out_.broken) return;
    out_.broken = rule;
    out_.by = static_cast<double>(by / unit_);
  }
  // `excess` should not be positive.
  void at_most(Real excess, const char* rule) {
    if (!(excess <= 8 * unit_)) breaks(rule, excess);
  }

  bool numbers() {
    if (left_to_others_) return true;
    if (!std::isfinite(r_.gap) || !std::isfinite(r_.gap_lower) || !std::isfinite(r_.gap_upper) ||
        !is_finite(r_.normal) || !is_finite(r_.point_a) || !is_finite(r_.point_b) || !is_finite(r_.patch.centre))
      breaks("a number of the answer is not finite");
    else if (!(r_.gap_lower <= r_.gap && r_.gap <= r_.gap_upper))
      breaks("the bounds do not hold the gap");
    else if (!(std::abs(norm(r_.normal) - 1) <= 16 * epsilon))  // a unit vector turned by a rounded rotation
      breaks("the normal is not a unit vector");
    else if (!out_.not_converged && ((r_.status == Status::separated) != (r_.gap_lower > 0) ||
                                     (r_.status == Status::overlapping) != (r_.gap_upper < 0)))
      breaks("the status does not follow from the bounds");
    out_.width = static_cast<double>((r_.gap_upper - r_.gap_lower) / unit_);
    return !out_.broken;
  }

  void against_wall() {
    const Vector n = wall_normal(c_.b.body);
    const Real gap = -dot(n, wide(c_.offset)) - support(c_.a.body, -n);
    at_most(r_.gap_lower - gap, "gap_lower is above the support separation");
    at_most(gap - r_.gap_upper, "gap_upper is below the support separation");
  }

  void along_directions(Source& source) {
    const Vector normal = unit(wide(r_.normal));
    at_most(r_.gap_lower - separation(c_, normal), "gap_lower is above the support separation along the normal");
    if (!r_.certified) return;
    each_direction(c_, normal, source, [&](const Vector& n) {
      at_most(separation(c_, n) - r_.gap_upper, "gap_upper is below the support separation along another direction");
    });
  }

  // A point of a convex body is behind every supporting plane; tried are those along the normal and of the faces.
  void witnesses() {
    const Vector a = wide(r_.point_a), b = wide(r_.point_b) - wide(c_.offset);
    const Vector n = unit(wide(r_.normal)), ab = wide(r_.point_b) - wide(r_.point_a);
    Real off = 0;
    const auto behind = [&](const Body& body, const Vector& x, const Vector& m) {
      off = std::max(off, is_endless(body.kind) ? dot(x, wall_normal(body)) : dot(m, x) - support(body, m));
    };
    behind(c_.a.body, a, n);
    behind(c_.b.body, b, -n);
    each_face(c_.a.body, [&](const Vector& m) { behind(c_.a.body, a, m); });
    each_face(c_.b.body, [&](const Vector& m) { behind(c_.b.body, b, m); });
    off = std::max(off, std::abs(std::sqrt(dot(ab, ab)) - std::abs(Real(r_.gap))));
    out_.points = static_cast<double>(off / unit_);
  }

  const PairCase& c_;
  const Contact& r_;
  Real unit_;
  bool left_to_others_ = false;
  Judgement out_;
};

bool same_bits(const Vec3d& a, const Vec3d& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
bool same_answer(const Contact& a, const Contact& b) {
  return a.status == b.status && a.certified == b.certified && a.gap == b.gap && a.gap_lower == b.gap_lower &&
         a.gap_upper == b.gap_upper && same_bits(a.normal, b.normal);
}

// (4)
const char* doors(const PairCase& c, const MethodInfo& m, const Contact& answer, Source& source) {
  const contact::ChunkQuery chunk = contact::find(m.a, m.b, m.name);
  constexpr std::size_t n = 5;
  const Body a[n] = {c.a.body, c.a.body, c.a.body, c.a.body, c.a.body};
  const Body b[n] = {c.b.body, c.b.body, c.b.body, c.b.body, c.b.body};
  Vec3d offset[n] = {c.offset, 2.0 * c.offset, c.offset, 0.5 * c.offset, c.offset};
  Contact many[n];
  chunk(n, a, b, offset, {}, nullptr, many);
  for (const std::size_t i : {0u, 2u, 4u})
    if (!same_answer(many[i], answer) || !same_bits(many[i].point_a, answer.point_a) ||
        !same_bits(many[i].patch.centre, answer.patch.centre))
      return "a chunk gives another answer";
  // Bodies of one kind with one centre have no order of their own: one right answer of several is given.
  const Contact swapped = contact::query(c.b.body, c.a.body, -c.offset, {}, m.name);
  if (m.a == m.b && max_abs(c.offset) == 0
          ? (answer.certified && swapped.gap_lower > answer.gap_upper) ||
                (swapped.certified && answer.gap_lower > swapped.gap_upper)
          : swapped.status != answer.status || swapped.gap != answer.gap || swapped.gap_lower != answer.gap_lower ||
                swapped.gap_upper != answer.gap_upper || !same_bits(-swapped.normal, answer.normal))
    return "the other order gives another answer";
  contact::Options bare, quick;
  bare.patch = false;
  quick.overlap_only = true;
  Contact one;
  chunk(1, a, b, offset, bare, nullptr, &one);
  if (!same_answer(one, answer)) return "without a patch there is another answer";
  contact::Cache kept, wrong{source.vector()};
  chunk(1, a, b, offset, {}, &kept, &one);
  if (!same_answer(one, answer)) return "with a cache there is another answer";
  for (contact::Cache* cache : {&kept, &wrong}) {
    chunk(1, a, b, offset, quick, cache, &one);
    const bool apart = answer.status == Status::separated;
    if (apart ? one.status != Status::separated || one.gap_lower > answer.gap_upper : !same_answer(one, answer))
      return "with a stop at the first proof there is another answer";
  }
  return nullptr;
}

}  // namespace

Judgement judge(const PairCase& pair, const Contact& answer, Source& source) { return Judge(pair, answer).run(source); }

Judgement judge(const PairCase& pair, const MethodInfo& method, Source& source) {
  Contact answer;
  contact::find(method.a, method.b, method.name)(1, &pair.a.body, &pair.b.body, &pair.offset, {}, nullptr, &answer);
  Judgement out = judge(pair, answer, source);
  if (out.broken || out.refused) return out;
  out.broken = doors(pair, method, answer, source);
  return out;
}

}  // namespace pair_fuzz
