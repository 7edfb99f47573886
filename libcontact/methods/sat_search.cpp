#include "libcontact/methods/sat_search.h"

#include <algorithm>
#include <cmath>
#include <experimental/simd>
#include <limits>

#include "libcontact/methods/edge_arcs.h"

namespace contact {
namespace {

constexpr std::uint32_t unset = 0xffffffffu;
constexpr double infinity = std::numeric_limits<double>::infinity();

using Lanes = std::experimental::native_simd<double>;
using std::experimental::element_aligned;

// Heights of x over all (padded) faces of p, and what to do with them.
template <class Use>
void for_each_height(const shapes::Polyhedron& p, double scale, const Vec3d& x, Use&& use) {
  const Lanes vx = x.x, vy = x.y, vz = x.z, s = scale;
  for (std::size_t i = 0; i < p.nx.size(); i += Lanes::size())
    use(i, Lanes(&p.nx[i], element_aligned) * vx + Lanes(&p.ny[i], element_aligned) * vy +
               Lanes(&p.nz[i], element_aligned) * vz - s * Lanes(&p.nd[i], element_aligned));
}

}  // namespace

FaceSearch::FaceSearch(const PolyhedronPair& pair) : pair_(pair), deepest_{-infinity, 0} {
  const CoreBall core = core_ball(*pair.other);
  centre_ = pair.other_to_self * (pair.other_scale * core.centre) + pair.offset;
  ball_ = pair.other_scale * core.radius;
  const shapes::Polyhedron& self = *pair.self;
  known_ = self.nx.size() <= cap ? static_cast<std::uint32_t>(self.faces.size()) : 0;
  std::fill_n(vertex_, known_, unset);
}

double FaceSearch::height(std::uint32_t i, const Vec3d& x) const {
  const auto& face = pair_.self->faces[i];
  return dot(face.normal, x) - pair_.self_scale * face.offset;
}

FaceSearch::Face FaceSearch::separation(std::uint32_t i) {
  if (i < known_ && vertex_[i] != unset) return {value_[i], vertex_[i]};
  const auto& face = pair_.self->faces[i];
  const Extreme other = pair_.lowest_of_other(face.normal);
  const Face found{other.value - pair_.self_scale * face.offset, other.index};
  if (i < known_) value_[i] = found.value, vertex_[i] = found.on_other;
  if (found.value > deepest_.value) deepest_ = found, has_witness_ = false;
  return found;
}

bool FaceSearch::search(double& bar, double enough, std::uint32_t& best, Face& held) {
  const shapes::Polyhedron& self = *pair_.self;
  const auto count = static_cast<std::uint32_t>(self.faces.size());
  bool found = false;
  const auto evaluate = [&](std::uint32_t i) {
    const Face face = separation(i);
    if (face.value > bar) bar = face.value, best = i, held = face, found = true;
    return face.on_other;
  };
  if (known_ == 0) {  // more faces than are remembered: one pass, bounded by the ball and the best vertex so far
    for (std::uint32_t i = 0; i < count && !(bar > enough); ++i)
      if (height(i, centre_) - ball_ > bar && (deepest_.value == -infinity || height(i, witness_) > bar)) {
        evaluate(i);
        witness_ = pair_.other_vertex(deepest_.on_other);
      }
    return found;
  }
  const std::size_t padded = self.nx.size();
  for_each_height(self, pair_.self_scale, centre_,
                  [&](std::size_t i, const Lanes& h) { (h - ball_).copy_to(bound_ + i, element_aligned); });
  std::fill(bound_ + count, bound_ + padded, -infinity);
  std::uint32_t last = unset;
  for (;;) {
    std::uint32_t top = 0;
    for (std::uint32_t i = 1; i < count; ++i) top = bound_[i] > bound_[top] ? i : top;
    if (!(bound_[top] > bar)) return found;
    bound_[top] = -infinity;
    const std::uint32_t vertex = evaluate(top);
    if (bar > enough) return found;
    if (vertex == last) continue;
    last = vertex;
    for_each_height(self, pair_.self_scale, pair_.other_vertex(vertex), [&](std::size_t i, const Lanes& h) {
      min(h, Lanes(bound_ + i, element_aligned)).copy_to(bound_ + i, element_aligned);
    });
  }
}

void FaceSearch::set_witness() {
  if (deepest_.value == -infinity) separation(0);
  witness_ = pair_.other_vertex(deepest_.on_other);
  if (known_ > 0)
    for_each_height(*pair_.self, pair_.self_scale, witness_,
                    [&](std::size_t i, const Lanes& h) { h.copy_to(witness_height_ + i, element_aligned); });
  has_witness_ = true;
}

std::size_t FaceSearch::edges_above(double bar, std::uint32_t first, std::size_t count, std::uint32_t* out) {
  if (!has_witness_) set_witness();
  // With both heights of one point of the other body negative, the highest point of the arc is an end of it.
  const double least = std::min(bar, 0.0);
  std::size_t passed = 0;
  const auto end = first + static_cast<std::uint32_t>(count);
  for (std::uint32_t i = first; i < end; ++i) {
    const auto& edge = pair_.self->edges[i];
    const double top = std::max(witness_height(edge.face[0]), witness_height(edge.face[1]));
    out[passed] = i;
    passed += top > least ? 1 : 0;
  }
  std::size_t kept = 0;
  for (std::size_t k = 0; k < passed; ++k)
    if (may_exceed(pair_.self->edges[out[k]], bar)) out[kept++] = out[k];
  return kept;
}

bool FaceSearch::may_exceed(const shapes::Polyhedron::Edge& edge, double bar) {
  const std::uint32_t f0 = edge.face[0], f1 = edge.face[1];
  const Vec3d& n0 = pair_.self->faces[f0].normal;
  const Vec3d& n1 = pair_.self->faces[f1].normal;
  const Vec3d p = pair_.self_vertex(edge.vertex[0]);
  const Vec3d e = pair_.self_vertex(edge.vertex[1]) - p;
  // (i) By the ball inside the other body: at most the distance of its centre to the line of the edge, less its radius,
  // when the direction to it lies in the arc; else the value at an end.
  const Vec3d w = centre_ - p;
  const Vec3d moment = cross(e, w);  // |e| times the line distance, its direction turned a quarter about e
  const double reach = bar + ball_;
  if (reach >= 0 && dot(moment, moment) <= reach * reach * dot(e, e)) return false;
  const bool ends_fail = std::max(dot(n0, w), dot(n1, w)) <= reach;
  if (ends_fail && !(dot(moment, n0) <= 0 && dot(moment, n1) >= 0)) return false;
  // (ii) By the deepest vertices for the two faces: over a n0 + b n1 with a + b = 1 the lower of two linear functions,
  // highest where they cross; when that is negative, making the direction a unit vector only lowers it.
  const Face s0 = separation(f0), s1 = separation(f1);
  const double y0 = dot(n1, pair_.other_vertex(s0.on_other) - p), y1 = dot(n0, pair_.other_vertex(s1.on_other) - p);
  const double slope = (y0 - s1.value) + (y1 - s0.value);
  double bound = std::max(s0.value, s1.value);
  if (slope > 0) bound = std::max(bound, (y0 * y1 - s0.value * s1.value) / slope);
  return bound > 0 || bound > bar;
}

namespace {

// The best edge–edge axis whose separation exceeds `bar`, which it raises. Stops at the first one above `enough`.
bool search_edges(FaceSearch& a, FaceSearch& b, double& bar, double enough, DifferenceFacet& best) {
  const PolyhedronPair& pair = a.pair();
  std::uint32_t edges_a[FaceSearch::edge_block], edges_b[FaceSearch::edge_block];
  Arc arcs_b[FaceSearch::edge_block];
  bool found = false;
  const auto count_a = static_cast<std::uint32_t>(pair.self->edges.size());
  const auto count_b = static_cast<std::uint32_t>(pair.other->edges.size());

  const auto try_pair = [&](const Arc& ea, const Arc& eb) {
    Vec3d along, n;
    double weight = 0;
    if (!arcs_cross(ea, eb, along, weight)) return;
    const double rise = dot(along, eb.point - ea.point);
    if (rise <= 0 && rise <= bar * weight) return;  // |along| <= weight
    if (!arc_axis(ea, eb, along, weight, n)) return;
    const double value = dot(n, eb.point - ea.point);
    if (!(value > bar)) return;
    const double proven = std::min(value, pair.separation(n).value);
    if (proven > bar) {
      bar = proven;
      best = {DifferenceFacet::edges, ea.edge, eb.edge};
      found = true;
    }
  };

  constexpr auto block = static_cast<std::uint32_t>(FaceSearch::edge_block);
  for (std::uint32_t i = 0; i < count_a; i += block) {
    const std::size_t held_a = a.edges_above(bar, i, std::min(block, count_a - i), edges_a);
    for (std::uint32_t j = 0; j < count_b && held_a > 0; j += block) {
      const std::size_t held_b = b.edges_above(bar, j, std::min(block, count_b - j), edges_b);
      for (std::size_t l = 0; l < held_b; ++l) arcs_b[l] = arc_of_other(pair, edges_b[l]);
      for (std::size_t k = 0; k < held_a; ++k) {
        const Arc arc_a = arc_of_self(pair, edges_a[k]);
        for (std::size_t l = 0; l < held_b; ++l) {
          try_pair(arc_a, arcs_b[l]);
          if (bar > enough) return found;
        }
      }
    }
  }
  return found;
}

}  // namespace

DifferenceFacet search_all(const DifferencePair& pair, double enough) {
  const PolyhedronPair swapped = pair.swapped();
  FaceSearch faces_a(pair), faces_b(swapped);
  DifferenceFacet best;
  double bar = -infinity;
  FaceSearch::Face found{};
  std::uint32_t face = 0;
  if (faces_a.search(bar, enough, face, found)) best = {DifferenceFacet::face_of_a, face, found.on_other};
  if (bar > enough) return best;
  double better = bar + face_preference * pair.size;
  if (faces_b.search(better, enough, face, found)) {
    best = {DifferenceFacet::face_of_b, found.on_other, face};
    bar = better;
  }
  if (!(bar > 0)) {
    better = bar + face_preference * pair.size;
    search_edges(faces_a, faces_b, better, enough, best);
  }
  return best;
}

}  // namespace contact
