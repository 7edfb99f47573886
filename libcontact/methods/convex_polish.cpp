// The end of gjk_epa on round bodies: Newton's method for the normal, its derivative by differences of support points.
//
//   h_K(m)/|m| is least where ρ_i = t_i·w − (n·w) s_i/|m| = 0,   m = n₀ + s₁ t₁ + s₂ t₂,  n = m/|m|,  w = w(n)    (1)
//
// Against a polyhedron or polygon, (1) with one vertex in its place, or across an edge: where the whole body's support
// is the same, no other direction separates more, since that of any one vertex is never less                     (2)
#include <cmath>

#include "libcontact/methods/convex_search.h"
#include "libcontact/methods/segments.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

using Corner = ConvexPair::Corner;

constexpr double tilt = 0x1p-14;  // of the differences: of the order of the normal's error when a search ends
constexpr int step_limit = 6;

struct Tangents {
  Vec3d n0, t[2];
  int count;
};

// Across an edge, or in the plane, there is one.
Tangents tangents(const Vec3d& n, const Vec3d& edge, bool flat) {
  Tangents s{n, {}, flat ? 1 : 2};
  if (flat) {
    s.t[0] = {-n.y, n.x, 0};
  } else if (length_and_direction(edge, s.t[1]) > 0) {
    s.count = 1;
    length_and_direction(perpendicular(n, edge), s.n0);
    s.t[0] = cross(s.t[1], s.n0);
  } else {
    tangent_frame(n, s.t[0], s.t[1]);
  }
  return s;
}

// (1). `support` gives w(n); `use` sees every n that a step leads to, and its w.
template <class Support, class Use>
void newton(const Tangents& s, double rounding, Support&& support, Use&& use) {
  struct Residual {
    double rho[2] = {};
    Vec3d n;
    Corner w;
  };
  const auto at = [&](double s0, double s1) {
    Residual r;
    const double length =
        length_and_direction(s.count == 1 ? s.n0 + s0 * s.t[0] : s.n0 + s0 * s.t[0] + s1 * s.t[1], r.n);
    r.w = support(r.n);
    const double height = dot(r.n, r.w.at) / length;
    r.rho[0] = dot(s.t[0], r.w.at) - height * s0;
    if (s.count == 2) r.rho[1] = dot(s.t[1], r.w.at) - height * s1;
    return r;
  };
  Residual here = at(0, 0);
  const Residual a = at(tilt, 0);
  const double j00 = a.rho[0] - here.rho[0], j10 = a.rho[1] - here.rho[1];
  double j01 = 0, j11 = tilt;
  if (s.count == 2) {
    const Residual b = at(0, tilt);
    j01 = b.rho[0] - here.rho[0];
    j11 = b.rho[1] - here.rho[1];
  }
  const double inverse = tilt / (j00 * j11 - j01 * j10);
  double s0 = 0, s1 = 0;
  for (int i = 0; i < step_limit; ++i) {
    const double u0 = (j11 * here.rho[0] - j01 * here.rho[1]) * inverse;
    const double u1 = (j00 * here.rho[1] - j10 * here.rho[0]) * inverse;
    if (!(u0 * u0 + u1 * u1 <= 0x1p-8)) return;  // no small error: not where the search has ended
    s0 -= u0, s1 -= u1;
    const double gain = here.rho[0] * u0 + here.rho[1] * u1;
    here = at(s0, s1);
    use(here.n, here.w);
    if (!(gain > rounding)) return;
  }
}

void between_round_bodies(ConvexSearch& search) {
  newton(
      tangents(search.normal, {}, search.pair.a.is_flat()), 0x1p-52 * search.pair.size,
      [&](const Vec3d& n) { return search.probe(n); },
      [&](const Vec3d&, const Corner& w) {
        const double distance = norm(w.at);
        if (search.upper <= 0 || distance < search.upper) search.set_near(w.at, w.on_a);
        if (search.upper > 0) search.upper = std::fmin(search.upper, distance);  // apart: the nearest points
      });
}

// A vertex, or an edge from there, in place of a body of `faces`. True when (2) shows that it is the one.
bool against(ConvexSearch& search, bool of_a, const Vec3d& vertex, const Vec3d& edge) {
  const ConvexPair& pair = search.pair;
  Vec3d best;
  double value = 0;
  bool found = false;
  newton(
      tangents(search.normal, edge, pair.a.is_flat()), 0x1p-52 * pair.size,
      [&](const Vec3d& n) {
        ++search.steps;
        const Vec3d on_a = of_a ? vertex : pair.a.support(n).at;
        return Corner{on_a - (of_a ? pair.d + pair.b.support(-n).at : vertex), on_a};
      },
      [&](const Vec3d& n, const Corner& w) {
        best = n;
        value = dot(n, w.at);
        found = true;
        if (search.upper <= 0) return;
        const Vec3d x = of_a ? w.on_a - w.at : w.on_a;  // of the round body
        const Vec3d foot = point_segment(x, vertex, edge).b;
        if (const double distance = norm(foot - x); distance < search.upper) {
          search.upper = distance;
          search.set_near(of_a ? foot - x : x - foot, of_a ? foot : x);
        }
      });
  if (!found) return false;
  return dot(best, search.probe(best).at) <= value + 0.25 * search.rounding();
}

}  // namespace

void finish_on_curvature(ConvexSearch& search) {
  const ConvexPair& pair = search.pair;
  const bool of_a = pair.a.has_faces();
  if (!of_a && !pair.b.has_faces()) return between_round_bodies(search);
  // The vertices that the search has ended on, the farthest along the normal first.
  Corner named[5] = {search.probe(search.normal)};
  int count = 1;
  for (int i = 0; i < search.near.count; ++i) {
    const Corner& c = search.near.p[i];
    bool known = (of_a ? c.vertex_a : c.vertex_b) == ConvexBody::no_vertex;
    for (int k = 0; k < count; ++k)
      known = known || (of_a ? c.vertex_a == named[k].vertex_a : c.vertex_b == named[k].vertex_b);
    if (!known) named[count++] = c;
  }
  const auto place = [&](const Corner& c) { return of_a ? c.on_a : c.on_a - c.at; };
  for (int i = 0; i < count; ++i)
    if (against(search, of_a, place(named[i]), {})) return;
  if (pair.a.is_flat()) return;  // the side's normal has been tried
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < i; ++k)
      if (against(search, of_a, place(named[i]), place(named[k]) - place(named[i]))) return;
}

}  // namespace contact
