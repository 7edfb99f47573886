// A program with a shape, a method and a force law of its own, beside those of the library: a capsule, its pairs with
// spheres, ellipsoids and planes, and a spring that hardens. Prints nothing when every answer is that of the formulas.
#include <cmath>
#include <cstdio>

#include "libcontact/extend.h"
#include "libcontact/kernels/law_kernel.h"
#include "libcontact/methods/list.h"

namespace host {

struct Capsule {  // a segment along the body's x, and all within a radius of it
  static constexpr const char* name = "capsule";
};

}  // namespace host

template <>
struct contact::Placed<host::Capsule> {
  Vec3d half;  // from the middle to one end of the segment, world axes, m
  double radius;
  static Placed of(const Body& b) { return {b.rotation.column(0) * b.size.x, b.size.y}; }
  double circumradius() const { return norm(half) + radius; }
};

namespace host {

using contact::Body;
using contact::Cache;
using contact::Contact;
using contact::Options;
using contact::Placed;
using contact::Vec3d;

struct CapsulePair {
  static constexpr const char *name = "capsule", *remark = "a segment and a radius";
  static constexpr int cost_rank = 0;
  static Contact query(const Placed<shapes::Sphere>& a, const Placed<Capsule>& b, const Vec3d& offset, const Options&,
                       Cache*) {
    const double at = dot(b.half, -offset) / dot(b.half, b.half);
    const Vec3d nearest = offset + b.half * std::fmin(1, std::fmax(-1, at));
    const double distance = norm(nearest), gap = distance - a.radius - b.radius;
    const double extent = norm(offset) + a.radius + b.circumradius(), slack = contact::rounding(extent);
    const Vec3d n = nearest * (1 / distance);
    return contact::smooth_contact(gap, gap - slack, gap + slack, n, n * a.radius, nearest - n * b.radius);
  }
  static Contact query(const Placed<shapes::Plane>& a, const Placed<Capsule>& b, const Vec3d& offset, const Options&,
                       Cache*) {
    const Vec3d lowest = offset - b.half * (dot(a.normal, b.half) < 0 ? -1.0 : 1.0);
    const double height = dot(a.normal, lowest), gap = height - b.radius;
    const double slack = contact::rounding(norm(offset) + b.circumradius());
    return contact::smooth_contact(gap, gap - slack, gap + slack, a.normal, lowest - a.normal * height,
                                   lowest - a.normal * b.radius);
  }
};

using Shapes = contact::Joined<shapes::List, std::tuple<Capsule>>;
using Methods = contact::Joined<contact::Methods, std::tuple<CapsulePair>>;
using Table = contact::Dispatch<Shapes, Methods>;

struct Hardening {  // F = kn δ (1 + δ/R*)
  template <class T>
  using State = contact::NoState<T>;
  template <class T>
  static contact::NormalForce<T> update(const contact::PairOf<T>& p, const contact::Kinematics<T>& k,
                                        const contact::LawOptions&, State<T>&) {
    const T ratio = k.overlap / k.radius_eff;
    contact::NormalForce<T> f;
    f.force = f.elastic = f.holding = p.stiffness_n * k.overlap * (T(1) + ratio);
    f.stiffness = p.stiffness_n * (T(1) + T(2) * ratio);
    f.stiffness_t = p.stiffness_t;
    f.shrink = T(1);
    return f;
  }
};

}  // namespace host

static int faults = 0;
static void expect(const char* what, double got, double expected, double within) {
  if (std::fabs(got - expected) <= within) return;
  std::printf("%s: %.17g, not %.17g\n", what, got, expected);
  ++faults;
}

int main() {
  contact::Body ball, rod, floor, egg;
  ball.size = {0.5, 0, 0};
  rod.kind = host::Table::kind_of<host::Capsule>();
  rod.size = {2, 0.25, 0};
  rod.rotation = {{{0.6, -0.8, 0}, {0.8, 0.6, 0}, {0, 0, 1}}};  // along (0.6, 0.8, 0)
  floor.kind = shapes::Kind::plane;
  egg.kind = shapes::Kind::ellipsoid;
  egg.size = {0.5, 0.5, 0.5};

  // Beside the segment, beyond its end, and exchanged.
  expect("beside", host::Table::query(ball, rod, {-0.8 * 0.7, 0.6 * 0.7, 0}).gap, 0.7 - 0.75, 1e-15);
  expect("beyond", host::Table::query(ball, rod, {0.6 * 2.7, 0.8 * 2.7, 0}).gap, 0.7 - 0.75, 1e-14);
  const contact::Contact back = host::Table::query(rod, ball, {0.8 * 0.7, -0.6 * 0.7, 0});
  expect("exchanged", back.gap, 0.7 - 0.75, 1e-15);
  expect("normal", back.normal.x, 0.8, 1e-14);
  expect("on the floor", host::Table::query(floor, rod, {0, 2, 0}).gap, -0.25, 1e-15);  // it lies in the floor's plane
  // The library's own pairs are in the same table, in the library's bits; what nobody answers is refused.
  const host::Vec3d offset{0.7, 0.2, 0.1};
  expect("the library's", host::Table::query(ball, egg, offset).gap, contact::query(ball, egg, offset).gap, 0);
  if (host::Table::query(egg, rod, offset).status != contact::Status::refused) ++faults;
  contact::Options wanted;
  wanted.tolerance = 1e-6;
  expect("to a tolerance", host::Table::query(ball, rod, {0.7, 0, 0.1}, wanted).gap,
         host::Table::query(ball, rod, {0.7, 0, 0.1}).gap, 0);

  contact::kernels::LawChunk lanes;
  for (std::size_t i = 0; i < 3; ++i) {
    lanes.overlap[i] = 0.01 * static_cast<double>(i + 1);
    lanes.normal.x[i] = 1;
    lanes.pair.stiffness_n[i] = 1e4;
    lanes.radius_eff[i] = 0.1;
    lanes.mass_eff[i] = 1;
  }
  contact::kernels::law_kernel<host::Hardening, false>(lanes, 3, 1e-5, {});
  for (std::size_t i = 0; i < 3; ++i) {
    const double d = 0.01 * static_cast<double>(i + 1);
    expect("force", lanes.force.x[i], -1e4 * d * (1 + d / 0.1), 1e-11);
  }
  return faults == 0 ? 0 : 1;
}
