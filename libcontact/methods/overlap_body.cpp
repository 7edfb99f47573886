#include "libcontact/methods/overlap_body.h"

#include <utility>

namespace contact {

namespace {

constexpr std::uint32_t none = 0xffffffffu;

OverlapBody& scratch() {
  static thread_local OverlapBody body;
  return body;
}
const OverlapBody& nothing() {
  static const OverlapBody body;
  return body;
}

}  // namespace

void OverlapBody::begin(const shapes::Polyhedron& p, double scale) {
  corners_.clear();
  for (const Vec3d& x : p.vertices) corners_.push_back(scale * x);
  faces_.clear();
  loops_.assign(p.face_vertices.begin(), p.face_vertices.end());
  for (const auto& f : p.faces) faces_.push_back({f.normal, f.first, f.count, false});
  used_.assign(corners_.size(), 1);
}

bool OverlapBody::cut(const Vec3d& n, double level) {
  bool outside = false, inside = false;
  height_.resize(corners_.size());
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    height_[i] = dot(n, corners_[i]) - level;
    if (used_[i] == 0) continue;
    (height_[i] > 0 ? outside : inside) = true;
  }
  if (!inside) {
    faces_.clear();
    return false;
  }
  if (!outside) return true;
  crossings_.clear();
  after_.assign(corners_.size(), none);
  next_loops_.clear();
  next_faces_.clear();
  for (const Face& f : faces_) {
    const auto first = static_cast<std::uint32_t>(next_loops_.size());
    std::uint32_t left = none, first_enter = none;
    for (std::uint32_t k = 0; k < f.count; ++k) {
      const std::uint32_t p = loops_[f.first + k], q = loops_[f.first + (k + 1 == f.count ? 0 : k + 1)];
      const bool p_out = height_[p] > 0, q_out = height_[q] > 0;
      if (!p_out) next_loops_.push_back(p);
      if (p_out == q_out) continue;
      const std::uint32_t c = p_out ? crossing(q, p) : crossing(p, q);
      next_loops_.push_back(c);
      // The face goes from where it leaves to where it enters again; the cut's own face the other way.
      if (q_out)
        left = c;
      else if (left == none)
        first_enter = c;
      else
        after_[c] = left;
    }
    if (first_enter != none) after_[first_enter] = left;
    close(f.normal, first, f.of_other);
  }
  // One loop; several where rounding has crossed a face in the plane more than twice.
  for (const Crossing& start : crossings_) {
    const auto first = static_cast<std::uint32_t>(next_loops_.size());
    for (std::uint32_t c = start.corner; c != none;) {
      next_loops_.push_back(c);
      c = std::exchange(after_[c], none);
      if (c == start.corner) break;
    }
    if (next_loops_.size() == first + 1) next_loops_.pop_back();
    close(n, first, true);
  }
  std::swap(loops_, next_loops_);
  std::swap(faces_, next_faces_);
  mark();
  return !faces_.empty();
}

const OverlapBody::Face* OverlapBody::across(std::uint32_t i, std::uint32_t j) const {
  for (const Face& f : faces_) {
    const std::uint32_t* loop = &loops_[f.first];
    for (std::uint32_t k = 0; k < f.count; ++k)
      if (loop[k] == j && loop[k + 1 == f.count ? 0 : k + 1] == i) return &f;
  }
  return nullptr;
}

void OverlapBody::mark() {
  used_.assign(corners_.size(), 0);
  for (const std::uint32_t i : loops_) used_[i] = 1;
}

// A face of the corners from `first` on, if they are enough.
void OverlapBody::close(const Vec3d& normal, std::uint32_t first, bool of_other) {
  const auto count = static_cast<std::uint32_t>(next_loops_.size()) - first;
  if (count < 3)
    next_loops_.resize(first);
  else
    next_faces_.push_back({normal, first, count, of_other});
}

// Where the edge from a kept corner to one that goes crosses the plane: one corner for both faces at the edge.
std::uint32_t OverlapBody::crossing(std::uint32_t in, std::uint32_t out) {
  for (const Crossing& c : crossings_)
    if (c.in == in && c.out == out) return c.corner;
  const double t = height_[in] / (height_[in] - height_[out]);
  const auto corner = static_cast<std::uint32_t>(corners_.size());
  after_.push_back(none);
  corners_.push_back(corners_[in] + t * (corners_[out] - corners_[in]));
  crossings_.push_back({in, out, corner});
  return corner;
}

const OverlapBody& overlap_body(const PolyhedronPair& pair) {
  OverlapBody& body = scratch();
  body.begin(*pair.self, pair.self_scale);
  for (const auto& plane : pair.other->faces) {
    const Vec3d n = pair.other_to_self * plane.normal;
    if (!body.cut(n, pair.other_scale * plane.offset + dot(n, pair.offset))) return nothing();
  }
  return body;
}

const OverlapBody& overlap_body(const PolyhedronPair& pair, const Vec3d& n) {
  OverlapBody& body = scratch();
  const double low = pair.lowest_of_other(n).value, high = pair.highest_of_self(n).value;
  if (!(low < high)) return nothing();
  body.begin(*pair.self, pair.self_scale);
  // A plane clear of other, whose own planes then cut its face away.
  if (!body.cut(-n, -(low - 0.5 * (high - low)))) return nothing();
  const shapes::Polyhedron& other = *pair.other;
  const Vec3d m = transposed_times(pair.other_to_self, n);
  // Heights in other's geometry: a face with no corner below self's highest has no part in the overlap.
  const double reach =
      (high + 0x1p-40 * (high - low) - dot(n, pair.offset)) / pair.other_scale + 8 * epsilon * other.circumradius;
  for (const auto& face : other.faces) {
    bool meets = false;
    for (std::uint32_t k = 0; k < face.count && !meets; ++k)
      meets = dot(m, other.vertices[other.face_vertices[face.first + k]]) <= reach;
    if (!meets) continue;
    const Vec3d normal = pair.other_to_self * face.normal;
    if (!body.cut(normal, pair.other_scale * face.offset + dot(normal, pair.offset))) return nothing();
  }
  return body;
}

const OverlapBody& overlap_body(const shapes::Polyhedron& p, double scale, const Vec3d& n, double level) {
  OverlapBody& body = scratch();
  body.begin(p, scale);
  return body.cut(n, level) ? body : nothing();
}

}  // namespace contact
