#include "libcontact/methods/gjk_epa.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "libcontact/methods/convex_view.h"
#include "libcontact/methods/expanding_surface.h"

namespace contact {

namespace {

using Corner = ConvexPair::Corner;

constexpr int step_limit = 200;
constexpr double stop_width = 1e-10, good_width = 1e-6;  // of the interval, over the size: to stop, and to be content

struct Simplex {
  Corner p[4];
  double weight[4] = {1, 0, 0, 0};
  int count = 0;

  Vec3d nearest() const {
    Vec3d v{};
    for (int i = 0; i < count; ++i) v += weight[i] * p[i].at;
    return v;
  }
  Vec3d on_a() const {
    Vec3d v{};
    for (int i = 0; i < count; ++i) v += weight[i] * p[i].on_a;
    return v;
  }
};

// Weights of the point of the plane, line or space through n points that is nearest to the origin. False when one is
// not positive, or the points are not independent.
bool weights(const Vec3d* const (&x)[4], int n, double (&w)[4]) {
  const Vec3d& p = *x[0];
  if (n == 1) {
    w[0] = 1;
  } else if (n == 2) {
    const Vec3d e = *x[1] - p;
    w[1] = -dot(p, e) / dot(e, e);
    w[0] = 1 - w[1];
  } else if (n == 3) {
    const Vec3d e = *x[1] - p, f = *x[2] - p;
    const double ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), pe = dot(p, e), pf = dot(p, f);
    const double inverse = 1 / (ee * ff - ef * ef);
    w[1] = (ef * pf - ff * pe) * inverse;
    w[2] = (ef * pe - ee * pf) * inverse;
    w[0] = 1 - w[1] - w[2];
  } else {
    const Vec3d e = *x[1] - p, f = *x[2] - p, g = *x[3] - p;
    const double inverse = -1 / dot(e, cross(f, g));
    w[1] = dot(p, cross(f, g)) * inverse;
    w[2] = dot(p, cross(g, e)) * inverse;
    w[3] = dot(p, cross(e, f)) * inverse;
    w[0] = 1 - w[1] - w[2] - w[3];
  }
  for (int i = 0; i < n; ++i)
    if (!(w[i] > 0 && w[i] <= 1)) return false;
  return true;
}

// Leaves of the simplex the part whose inside holds its nearest point: the best of all its faces, edges and corners.
void reduce(Simplex& s) {
  Simplex best;
  double least = std::numeric_limits<double>::infinity();
  for (int mask = (1 << s.count) - 1; mask > 0; --mask) {
    const Vec3d* x[4] = {};
    Simplex part;
    for (int i = 0; i < s.count; ++i)
      if (mask >> i & 1) {
        x[part.count] = &s.p[i].at;
        part.p[part.count++] = s.p[i];
      }
    if (!weights(x, part.count, part.weight)) continue;
    const Vec3d v = part.nearest();
    const double square = part.count == 4 ? 0 : dot(v, v);
    if (square < least) least = square, best = part;
  }
  s = best;
}

void overlap(const ConvexPair& pair, Simplex& s, ConvexMeasure& m) {
  if (dot(cross(s.p[2].at - s.p[1].at, s.p[3].at - s.p[1].at), s.p[1].at - s.p[0].at) < 0) std::swap(s.p[2], s.p[3]);
  ExpandingSurface<Corner> surface;
  m.found = surface.begin(s.p);
  if (!m.found) return;
  double inner = 0, outer = std::numeric_limits<double>::infinity();
  ExpandingSurface<Corner>::Face near{};
  Simplex face;
  for (bool growing = true; growing; ++m.iterations) {
    const int i = surface.nearest();
    near = surface.face(i);
    const Corner w = pair.support(near.normal);
    inner = surface.clearance();
    if (const double height = dot(near.normal, w.at); height < outer) {
      outer = height;
      m.normal = near.normal;
      face.count = 3;
      for (int k = 0; k < 3; ++k) face.p[k] = surface.corner(near, k);
    }
    growing = outer - inner > stop_width * pair.size && surface.push(w, i);
  }
  m.converged = outer - inner <= good_width * pair.size;
  m.upper = -inner - pair.margins();  // (2)
  m.overlap = outer + pair.margins();
  reduce(face);
  const Vec3d on_a = face.on_a(), on_b = on_a - face.nearest();
  m.point = 0.5 * (on_a + on_b + (pair.a.margin - pair.b.margin) * m.normal);
}

ConvexMeasure measure(const ConvexPair& pair) {
  ConvexMeasure m;
  Simplex s;
  s.p[0] = pair.support(norm(pair.inside()) > 0 ? -pair.inside() : Vec3d{0, 0, 1});
  s.count = 1;
  double lower = -std::numeric_limits<double>::infinity(), distance = norm(s.nearest());
  Vec3d on_a = s.p[0].on_a, v = s.nearest();
  for (; m.iterations < step_limit; ++m.iterations) {
    if (!(distance > 0x1p-44 * pair.size)) return m;  // the origin lies on the simplex
    const Corner w = pair.support(-v);
    if (const double along = dot(v, w.at) / distance; along > lower) {
      lower = along;
      m.normal = v * (-1 / distance);
    }
    if (distance - lower <= stop_width * pair.size) break;
    Simplex next = s;
    next.p[next.count++] = w;
    reduce(next);
    if (next.count == 4) {
      overlap(pair, next, m);
      return m;
    }
    const double closer = norm(next.nearest());
    if (!(closer < distance)) break;
    s = next;
    v = s.nearest();
    distance = closer;
    on_a = s.on_a();
  }
  m.found = true;
  m.converged = distance - lower <= good_width * pair.size;
  m.upper = distance - pair.margins();  // (1)
  m.overlap = pair.margins() - lower;
  m.point = 0.5 * (on_a + (on_a - v) + (pair.a.margin - pair.b.margin) * m.normal);
  return m;
}

}  // namespace

Contact GjkEpa::query(const Placed<shapes::Sphere>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset,
                      const Options&, Cache*) {
  return by_convex_method(a, b, offset, measure);
}
Contact GjkEpa::query(const Placed<shapes::Sphere>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                      const Options&, Cache*) {
  return by_convex_method(a, b, offset, measure);
}
Contact GjkEpa::query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Ellipsoid>& b, const Vec3d& offset,
                      const Options&, Cache*) {
  return by_convex_method(a, b, offset, measure);
}
Contact GjkEpa::query(const Placed<shapes::Ellipsoid>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                      const Options&, Cache*) {
  return by_convex_method(a, b, offset, measure);
}
Contact GjkEpa::query(const Placed<shapes::Polyhedron>& a, const Placed<shapes::Polyhedron>& b, const Vec3d& offset,
                      const Options&, Cache*) {
  return by_convex_method(a, b, offset, measure);
}

}  // namespace contact
