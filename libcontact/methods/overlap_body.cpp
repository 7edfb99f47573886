#include "libcontact/methods/overlap_body.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace contact {

namespace {

OverlapBody& scratch() {
  static thread_local OverlapBody of_thread;
  return of_thread;
}

Vec3d crossing(const Vec3d& in, const Vec3d& out, double height_in, double height_out) {
  return in + (height_in / (height_in - height_out)) * (out - in);
}

HalfSpace face_of_other(const PolyhedronPair& pair, std::uint32_t i) {
  const auto& face = pair.other->faces[i];
  const Vec3d n = pair.other_to_self * face.normal;
  return {n, pair.other_scale * face.offset + dot(n, pair.offset)};
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
  close(found, keep.n, true);
}

// Adds the sides of the face that a cut makes; the corners of its crossings come after `kept` others.
void OverlapBody::close(std::uint32_t kept, const Vec3d& normal, bool of_other) {
  if (closing_count_ == 0) return;
  const auto face = static_cast<std::uint32_t>(face_count_);
  faces_[face_count_++] = {normal, none, of_other};
  for (std::size_t i = 0; i < closing_count_; ++i) {
    const Side& s = closing_[i];
    sides_[side_count_++] = {kept + s.from, kept + s.to, s.left, face};
  }
  closing_count_ = 0;
}

void OverlapBody::cut(const HalfSpace& keep, bool of_other) {
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
  close(kept, keep.n, of_other);
}

// The ball about what is left tells which planes may cut; in p's geometry.
template <class FaceOf>
void OverlapBody::cut_by(const shapes::Polyhedron& p, const Vec3d& middle, double radius, Except except, bool of_other,
                         FaceOf&& face_of) {
  near_.make_room(p.nx.size() + 1);
  const double reach = radius + 32 * epsilon * (max_abs(middle) + p.circumradius);
  const std::size_t count = kernels::search_kernels().reaching(
      {p.nx.data(), p.ny.data(), p.nz.data(), p.nx.size()}, p.nd.data(), p.faces.size(), middle, reach, near_.data());
  for (std::size_t i = 0; i < count && !empty(); ++i)
    if (const std::uint32_t face = near_[i]; face != except.face[0] && face != except.face[1])
      cut(face_of(face), of_other);
}

OverlapBody::Ball OverlapBody::ball() const {
  Vec3d sum{};
  for (const Vec3d& x : corners()) sum += x;
  Ball ball{sum * (1 / static_cast<double>(corner_count_)), 0};
  double square = 0;
  for (const Vec3d& x : corners()) square = std::max(square, dot(x - ball.middle, x - ball.middle));
  ball.radius = std::sqrt(square);
  return ball;
}

void OverlapBody::cut_by_self(const PolyhedronPair& pair, Except except) {
  if (empty()) return;
  const Ball b = ball();
  const double down = 1 / pair.self_scale;
  cut_by(*pair.self, down * b.middle, down * b.radius, except, false, [&](std::uint32_t i) {
    const auto& face = pair.self->faces[i];
    return HalfSpace{face.normal, pair.self_scale * face.offset};
  });
}

void OverlapBody::cut_by_other(const PolyhedronPair& pair, Except except) {
  if (empty()) return;
  const Ball b = ball();
  const double down = 1 / pair.other_scale;
  cut_by(*pair.other, down * transposed_times(pair.other_to_self, b.middle - pair.offset), down * b.radius, except,
         true, [&](std::uint32_t i) { return face_of_other(pair, i); });
}

bool OverlapBody::begin(const PolyhedronPair& pair, std::uint32_t edge_of_self, std::uint32_t edge_of_other) {
  const auto &a = pair.self->edges[edge_of_self], &b = pair.other->edges[edge_of_other];
  const Vec3d p = pair.self_vertex(a.vertex[0]), e = pair.self_vertex(a.vertex[1]) - p;
  const Vec3d q = pair.other_vertex(b.vertex[0]), f = pair.other_vertex(b.vertex[1]) - q, w = q - p;
  const Vec3d of_a[2] = {pair.self->faces[a.face[0]].normal, pair.self->faces[a.face[1]].normal};
  const Vec3d of_b[2] = {pair.other_to_self * pair.other->faces[b.face[0]].normal,
                         pair.other_to_self * pair.other->faces[b.face[1]].normal};
  // Where the line of each edge meets the faces at the other one: corners 0 and 1 on self's, 2 and 3 on other's, in the
  // order of other's faces and self's.
  const double rise_a[2] = {dot(of_b[0], e), dot(of_b[1], e)}, rise_b[2] = {dot(of_a[0], f), dot(of_a[1], f)};
  // Along self's edge from other's face `low` to its face `high`; then other's edge runs from self's face 0 to 1 with
  // `low` on its left.
  const std::uint32_t low = rise_a[0] < 0 ? 0 : 1, high = 1 - low;
  if (!(rise_a[low] < 0 && rise_a[high] > 0 && rise_b[low] < 0 && rise_b[high] > 0)) return false;
  double s[2], t[2];
  for (int i = 0; i < 2; ++i) {
    s[i] = dot(of_b[i], w) / rise_a[i];
    t[i] = -dot(of_a[i], w) / rise_b[i];
  }
  const auto near_edge = [](double x) { return std::abs(x) <= 2; };
  if (!(s[low] < s[high] && t[low] < t[high] && near_edge(s[0]) && near_edge(s[1]) && near_edge(t[0]) &&
        near_edge(t[1])))
    return false;
  clear();
  closing_count_ = 0;
  corners_.make_room(4);
  sides_.make_room(6);
  faces_.make_room(4);
  for (std::size_t i = 0; i < 2; ++i) {
    corners_[i] = p + s[i] * e;
    corners_[2 + i] = q + t[i] * f;
    faces_[i] = {of_a[i], none, false};
    faces_[2 + i] = {of_b[i], none, true};
  }
  const std::uint32_t left = 2 + low, right = 2 + high;
  const Side sides[6] = {{low, high, 0, 1}, {2, 3, left, right}, {high, 2, 0, right},
                         {2, low, 0, left}, {low, 3, 1, left},   {3, high, 1, right}};
  std::copy_n(sides, 6, sides_.data());
  corner_count_ = face_count_ = 4;
  side_count_ = 6;
  return true;
}

const OverlapBody& overlap_body(const PolyhedronPair& pair) {
  OverlapBody& body = scratch();
  body.begin(*pair.self, pair.self_scale);
  body.cut_by_other(pair, {});
  return body;
}

const OverlapBody& overlap_under_face(const PolyhedronPair& pair, std::uint32_t face, std::uint32_t vertex) {
  OverlapBody& body = scratch();
  body.begin(*pair.self, pair.self_scale, face_of_other(pair, face), vertex);
  body.cut_by_other(pair, {{face, OverlapBody::none}});
  return body;
}

const OverlapBody& overlap_of_edges(const PolyhedronPair& pair, std::uint32_t edge_of_self, std::uint32_t edge_of_other,
                                    const Vec3d& n, double depth) {
  OverlapBody& body = scratch();
  const auto &a = pair.self->edges[edge_of_self], &b = pair.other->edges[edge_of_other];
  const OverlapBody::Except of_other{{b.face[0], b.face[1]}};
  if (body.begin(pair, edge_of_self, edge_of_other)) {
    body.cut_by_self(pair, {{a.face[0], a.face[1]}});
    body.cut_by_other(pair, of_other);
    return body;
  }
  // What self has under a plane clear of other, whose own planes then cut its face away.
  body.begin(*pair.self, pair.self_scale, {-n, 1.25 * depth - dot(n, pair.self_vertex(a.vertex[0]))}, a.vertex[0]);
  for (const std::uint32_t face : of_other.face)
    if (!body.empty()) body.cut(face_of_other(pair, face));
  body.cut_by_other(pair, of_other);
  return body;
}

const OverlapBody& overlap_body(const shapes::Polyhedron& p, double scale, const HalfSpace& keep) {
  OverlapBody& body = scratch();
  body.begin(p, scale, keep, lowest_vertex(p, keep.n).index);
  return body;
}

}  // namespace contact
