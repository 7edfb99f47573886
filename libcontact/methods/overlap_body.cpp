#include "libcontact/methods/overlap_body.h"

#include <cmath>
#include <experimental/simd>
#include <utility>

namespace contact {

namespace {

using Lanes = std::experimental::native_simd<double>;
using std::experimental::element_aligned;

OverlapBody& scratch() {
  static thread_local OverlapBody of_thread;
  return of_thread;
}

Vec3d crossing(const Vec3d& in, const Vec3d& out, double height_in, double height_out) {
  return in + (height_in / (height_in - height_out)) * (out - in);
}

}  // namespace

void OverlapBody::begin_walk(const shapes::Polyhedron& p) {
  clear();
  closing_count_ = 0;
  if (vertices_.size() < p.vertices.size()) vertices_.resize(p.vertices.size());
  if (faces_of_walk_.size() < p.faces.size()) faces_of_walk_.resize(p.faces.size());
  if (++stamp_ == 0) {  // all stamps have been used
    for (Mark& m : vertices_) m.stamp = 0;
    for (Mark& m : faces_of_walk_) m.stamp = 0;
    stamp_ = 1;
  }
  const std::size_t edges = p.edges.size();
  queue_.make_room(p.vertices.size());
  corners_.make_room(p.vertices.size() + edges);
  sides_.make_room(2 * edges);
  closing_.make_room(edges);
  next_.make_room(2 * edges);
  faces_.make_room(p.faces.size() + 1);
}

std::uint32_t OverlapBody::name_of_face(const shapes::Polyhedron& p, std::uint32_t face) {
  Mark& mark = faces_of_walk_[face];
  if (mark.stamp != stamp_) {
    mark = {stamp_, static_cast<std::uint32_t>(face_count_)};
    faces_[face_count_++] = {p.faces[face].normal, none, false};
  }
  return mark.name;
}

// Round a face places where it leaves and where it enters what is kept take turns: each meets one of the other kind,
// and there a side of the cut's own face runs. Rounding may cross a face in the plane more than twice: then any two
// may meet.
void OverlapBody::meet(std::uint32_t face, std::uint32_t crossing, std::uint32_t enters) {
  std::uint32_t& waiting = faces_[face].waiting;
  const std::uint32_t mine = 2 * crossing + enters;
  if (waiting == none || (waiting & 1) == enters) {
    next_[mine] = waiting;
    waiting = mine;
    return;
  }
  const std::uint32_t other = waiting >> 1;
  waiting = next_[waiting];
  closing_[closing_count_++] = {enters != 0 ? other : crossing, enters != 0 ? crossing : other, face, none};
}

void OverlapBody::begin(const shapes::Polyhedron& p, double scale, const HalfSpace& keep, std::uint32_t start) {
  begin_walk(p);
  const auto height = [&](const Vec3d& x) { return dot(keep.n, scale * x) - keep.level; };
  if (!(height(p.vertices[start]) <= 0)) return;
  std::uint32_t found = 1, crossings = 0;
  queue_[0] = start;
  vertices_[start] = {stamp_, 0};
  Vec3d* const cut_corners = corners_.data() + p.vertices.size();  // for now
  Side* const sides = sides_.data();
  std::size_t side_count = 0;
  for (std::uint32_t i = 0; i < found; ++i) {
    const std::uint32_t v = queue_[i], first = p.first_spoke[v], end = p.first_spoke[v + 1];
    const Vec3d x = scale * p.vertices[v];
    const double here = height(p.vertices[v]);
    corners_[i] = x;
    std::uint32_t right = name_of_face(p, p.spokes[end - 1].face);
    for (std::uint32_t k = first; k < end; ++k) {
      const auto& spoke = p.spokes[k];
      const std::uint32_t left = name_of_face(p, spoke.face), before = std::exchange(right, left);
      const double there = height(spoke.to);
      if (there > 0) {
        const std::uint32_t c = crossings++;
        cut_corners[c] = crossing(x, scale * spoke.to, here, there);
        sides[side_count++] = {i, none - 1 - c, left, before};
        meet(left, c, 0);
        meet(before, c, 1);
        continue;
      }
      Mark& mark = vertices_[spoke.vertex];
      if (mark.stamp != stamp_) {
        mark = {stamp_, found};
        queue_[found++] = spoke.vertex;
      }
      if (i < mark.name) sides[side_count++] = {i, mark.name, left, before};
    }
  }
  for (std::uint32_t c = 0; c < crossings; ++c) corners_[found + c] = cut_corners[c];
  for (std::size_t i = 0; i < side_count; ++i)
    if (sides[i].to >= none - crossings) sides[i].to = found + (none - 1 - sides[i].to);
  corner_count_ = found + crossings;
  side_count_ = side_count;
  close(found, keep.n);
}

// Adds the sides of the face that a cut makes; the corners of its crossings come after `kept` others.
void OverlapBody::close(std::uint32_t kept, const Vec3d& normal) {
  if (closing_count_ == 0) return;
  const auto face = static_cast<std::uint32_t>(face_count_);
  faces_[face_count_++] = {normal, none, true};
  for (std::size_t i = 0; i < closing_count_; ++i) {
    const Side& s = closing_[i];
    sides_[side_count_++] = {kept + s.from, kept + s.to, s.left, face};
  }
  closing_count_ = 0;
}

void OverlapBody::cut(const HalfSpace& keep) {
  const std::size_t count = corner_count_;
  height_.make_room(count);
  kept_as_.make_room(count);
  double* const height = height_.data();
  std::uint32_t* const kept_as = kept_as_.data();
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    height[i] = dot(keep.n, corners_[i]) - keep.level;
    kept_as[i] = kept;
    kept += height[i] > 0 ? 0 : 1;
  }
  if (kept == count) return;
  if (kept == 0) return clear();
  corners_.make_room(count + side_count_, count);
  sides_.make_room(2 * side_count_, side_count_);
  closing_.make_room(side_count_);
  next_.make_room(2 * side_count_);
  faces_.make_room(face_count_ + 1, face_count_);
  Vec3d* const corners = corners_.data();
  Side* const sides = sides_.data();
  std::uint32_t crossings = 0;
  std::size_t left = 0;
  for (std::size_t i = 0; i < side_count_; ++i) {
    Side s = sides[i];
    const bool from_out = height[s.from] > 0, to_out = height[s.to] > 0;
    if (from_out && to_out) continue;
    if (from_out != to_out) {
      const std::uint32_t in = from_out ? s.to : s.from, out = from_out ? s.from : s.to, c = crossings++;
      corners[count + c] = crossing(corners[in], corners[out], height[in], height[out]);
      meet(s.left, c, from_out ? 1 : 0);
      meet(s.right, c, from_out ? 0 : 1);
      s.from = from_out ? kept + c : kept_as[s.from];
      s.to = from_out ? kept_as[s.to] : kept + c;
    } else {
      s.from = kept_as[s.from];
      s.to = kept_as[s.to];
    }
    sides[left++] = s;
  }
  for (std::size_t i = 0; i < count; ++i) corners[kept_as[i]] = corners[i];
  for (std::uint32_t c = 0; c < crossings; ++c) corners[kept + c] = corners[count + c];
  corner_count_ = kept + crossings;
  side_count_ = left;
  close(kept, keep.n);
}

void OverlapBody::cut_by_other(const PolyhedronPair& pair, std::uint32_t except) {
  if (empty()) return;
  const shapes::Polyhedron& other = *pair.other;
  // The ball about what is left, in other's geometry.
  Vec3d low = corners_[0], high = low;
  for (const Vec3d& x : corners()) {
    low = {std::min(low.x, x.x), std::min(low.y, x.y), std::min(low.z, x.z)};
    high = {std::max(high.x, x.x), std::max(high.y, x.y), std::max(high.z, x.z)};
  }
  const Vec3d middle = 0.5 * (low + high);
  double square = 0;
  for (const Vec3d& x : corners()) square = std::max(square, dot(x - middle, x - middle));
  const double down = 1 / pair.other_scale;
  const Vec3d m = down * transposed_times(pair.other_to_self, middle - pair.offset);
  const double reach = down * std::sqrt(square) + 32 * epsilon * (max_abs(m) + other.circumradius);
  const Lanes x = m.x, y = m.y, z = m.z;
  const auto count = static_cast<std::uint32_t>(other.faces.size());
  constexpr std::uint32_t block = shapes::polyhedron_padding;
  for (std::uint32_t first = 0; first < count; first += block) {
    double above[block];  // how far the ball reaches over each plane
    bool any = false;
    for (std::uint32_t i = 0; i < block; i += static_cast<std::uint32_t>(Lanes::size())) {
      const std::size_t k = first + i;
      const Lanes h = Lanes(&other.nx[k], element_aligned) * x + Lanes(&other.ny[k], element_aligned) * y +
                      Lanes(&other.nz[k], element_aligned) * z - Lanes(&other.nd[k], element_aligned) + reach;
      h.copy_to(above + i, element_aligned);
      any |= any_of(h > 0);
    }
    if (!any) continue;
    for (std::uint32_t i = 0; i < block && first + i < count; ++i) {
      if (!(above[i] > 0) || first + i == except) continue;
      cut(face_of_other(pair, first + i));
      if (empty()) return;
    }
  }
}

HalfSpace face_of_other(const PolyhedronPair& pair, std::uint32_t i) {
  const auto& face = pair.other->faces[i];
  const Vec3d n = pair.other_to_self * face.normal;
  return {n, pair.other_scale * face.offset + dot(n, pair.offset)};
}

const OverlapBody& overlap_body(const PolyhedronPair& pair) {
  OverlapBody& body = scratch();
  body.begin(*pair.self, pair.self_scale);
  body.cut_by_other(pair);
  return body;
}

const OverlapBody& overlap_under_face(const PolyhedronPair& pair, std::uint32_t face, std::uint32_t vertex) {
  OverlapBody& body = scratch();
  body.begin(*pair.self, pair.self_scale, face_of_other(pair, face), vertex);
  body.cut_by_other(pair, face);
  return body;
}

const OverlapBody& overlap_along(const PolyhedronPair& pair, const Vec3d& n, double depth, std::uint32_t vertex) {
  OverlapBody& body = scratch();
  // A plane clear of other, whose own planes then cut its face away.
  body.begin(*pair.self, pair.self_scale, {-n, 1.5 * depth - dot(n, pair.self_vertex(vertex))}, vertex);
  body.cut_by_other(pair);
  return body;
}

const OverlapBody& overlap_body(const shapes::Polyhedron& p, double scale, const HalfSpace& keep) {
  OverlapBody& body = scratch();
  body.begin(p, scale, keep, lowest_vertex(p, keep.n).index);
  return body;
}

}  // namespace contact
