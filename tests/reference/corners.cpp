#include "tests/reference/corners.h"

#include <algorithm>

namespace reference {
namespace {

void keep_shorter(Vector& best, const Vector& v) {
  if (dot(v, v) < dot(best, best)) best = v;
}

Vector to_segment(const Vector& x, const Vector& p, const Vector& q) {
  const Vector e = q - p;
  Real t = dot(x - p, e) / dot(e, e);
  t = std::min(std::max(t, Real(0)), Real(1));
  return p + t * e - x;
}

// From x to its foot on a face, when it is over the face.
bool to_face(const Core<Real>& core, std::uint32_t loop, const Vector& x, Vector& foot) {
  const auto& l = core.loops[loop];
  if (l.size() < 3) return false;
  const Vector n = face_normals(core, loop).back();
  for (std::size_t k = 0; k < l.size(); ++k) {
    const Vector &p = core.corners[l[k]], &q = core.corners[l[(k + 1) % l.size()]];
    if (dot(cross(n, q - p), x - p) < 0) return false;
  }
  foot = -dot(n, x - core.corners[l[0]]) * n;
  return true;
}

}  // namespace

Active active(const Core<double>& core, const std::vector<Cell>& cells, double side) {
  std::vector<bool> in(core.corners.size());
  for (const Cell& cell : cells) {
    const shapes::Vec3d n = side * cell.centre, top = core.support(n);
    const double height = dot(n, top);
    for (std::size_t i = 0; i < in.size(); ++i)
      if (height - dot(n, core.corners[i]) <= 1.01 * cell.radius * norm(core.corners[i] - top) + 1e-13) in[i] = true;
  }
  Active f;
  const auto whole = [&](const auto& list) {
    return std::all_of(list.begin(), list.end(), [&](auto i) { return in[i]; });
  };
  for (std::uint32_t i = 0; i < in.size(); ++i)
    if (in[i]) f.corners.push_back(i);
  for (std::uint32_t i = 0; i < core.edges.size(); ++i)
    if (in[core.edges[i].first] && in[core.edges[i].second]) f.edges.push_back(i);
  for (std::uint32_t i = 0; i < core.loops.size(); ++i)
    if (whole(core.loops[i])) f.loops.push_back(i);
  return f;
}

std::vector<Vector> face_normals(const Core<Real>& core, std::uint32_t loop) {
  const auto& l = core.loops[loop];
  std::vector<Vector> normals{core.normals[loop]};
  if (l.size() == 2) {
    const Vector e = core.corners[l[1]] - core.corners[l[0]];
    normals.push_back(normalized(Vector{e.y, -e.x, 0}));
  }
  // A face of more corners is bent by rounding: a few of its triangles.
  const std::size_t stride = std::max<std::size_t>(1, l.size() / 4);
  for (std::size_t k = 1; k + 1 < l.size(); k += stride) {
    const Vector &p = core.corners[l[0]], n = cross(core.corners[l[k]] - p, core.corners[l[k + 1]] - p);
    if (dot(n, n) > 0) normals.push_back(normalized(n));
  }
  return normals;
}

std::vector<Vector> edge_axes(const Core<Real>& a, const Core<Real>& b, const Active& fa, const Active& fb) {
  std::vector<Vector> axes;
  if (a.planar) return axes;
  for (const auto i : fa.edges)
    for (const auto j : fb.edges) {
      const Vector n = cross(a.corners[a.edges[i].second] - a.corners[a.edges[i].first],
                             b.corners[b.edges[j].second] - b.corners[b.edges[j].first]);
      if (!(dot(n, n) > 0)) continue;
      axes.push_back(normalized(n));
      axes.push_back(-axes.back());
    }
  return axes;
}

Vector shortest(const Core<Real>& a, const Core<Real>& b, const Vector& d, const Active& fa, const Active& fb) {
  Vector best = d + b.corners[fb.corners[0]] - a.corners[fa.corners[0]], foot;
  for (const auto i : fa.corners)
    for (const auto j : fb.corners) keep_shorter(best, d + b.corners[j] - a.corners[i]);
  for (const auto i : fa.corners) {
    const Vector x = a.corners[i] - d;
    for (const auto e : fb.edges)
      keep_shorter(best, to_segment(x, b.corners[b.edges[e].first], b.corners[b.edges[e].second]));
    for (const auto f : fb.loops)
      if (to_face(b, f, x, foot)) keep_shorter(best, foot);
  }
  for (const auto j : fb.corners) {
    const Vector x = b.corners[j] + d;
    for (const auto e : fa.edges)
      keep_shorter(best, -to_segment(x, a.corners[a.edges[e].first], a.corners[a.edges[e].second]));
    for (const auto f : fa.loops)
      if (to_face(a, f, x, foot)) keep_shorter(best, -foot);
  }
  if (a.planar) return best;
  for (const auto i : fa.edges)
    for (const auto j : fb.edges) {
      const Vector &p = a.corners[a.edges[i].first], q = b.corners[b.edges[j].first] + d;
      const Vector e = a.corners[a.edges[i].second] - p, f = b.corners[b.edges[j].second] + d - q;
      const Vector n = cross(e, f), w = q - p;
      const Real square = dot(n, n);
      if (!(square > 0)) continue;
      const Real s = dot(cross(w, f), n) / square, t = dot(cross(w, e), n) / square;
      if (s >= 0 && s <= 1 && t >= 0 && t <= 1) keep_shorter(best, (dot(n, w) / square) * n);
    }
  return best;
}

Real to_support_set(const Core<Real>& core, const Active& features, const Vector& n, const Vector& q) {
  const Real height = dot(n, core.support(n)), near = Real("1e-24");
  const auto in = [&](std::uint32_t i) { return height - dot(n, core.corners[i]) <= near; };
  Vector best = core.support(n) - q, foot;
  for (const auto i : features.corners)
    if (in(i)) keep_shorter(best, core.corners[i] - q);
  for (const auto i : features.edges)
    if (in(core.edges[i].first) && in(core.edges[i].second))
      keep_shorter(best, to_segment(q, core.corners[core.edges[i].first], core.corners[core.edges[i].second]));
  for (const auto i : features.loops)
    if (std::all_of(core.loops[i].begin(), core.loops[i].end(), in) && to_face(core, i, q, foot))
      keep_shorter(best, foot);
  return norm(best);
}

}  // namespace reference
