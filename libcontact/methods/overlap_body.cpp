#include "libcontact/methods/overlap_body.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libcontact/kernels/chunk.h"

namespace contact {

namespace {

OverlapBody& scratch() {
  static thread_local OverlapBody of_thread;
  return of_thread;
}

Vec3d crossing(const Vec3d& in, const Vec3d& out, double height_in, double height_out) {
  return in + (height_in / (height_in - height_out)) * (out - in);
}

}  // namespace

HalfSpace face_of_other(const PolyhedronPair& pair, std::uint32_t i) {
  const auto& face = pair.other->faces[i];
  const Vec3d n = pair.other_to_self * face.normal;
  return {n, pair.other_scale * face.offset + dot(n, pair.offset)};
}

void OverlapBody::begin_walk(const shapes::Polyhedron& p) {
  clear();
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
  crossings_.make_room(edges);
  faces_.make_room(p.faces.size() + 1);
}

std::uint32_t OverlapBody::name_of_face(const shapes::Polyhedron& p, std::uint32_t face) {
  Mark& mark = faces_of_walk_[face];
  if (mark.stamp != stamp_) {
    mark = {stamp_, static_cast<std::uint32_t>(face_count_)};
    faces_[face_count_++] = {p.faces[face].normal, 0, false};
  }
  return mark.name;
}

// Adds the face that a cut makes; the corners of its crossings come after `kept` others. In every face a side of it
// runs from where the face leaves what is kept to where it enters it again.
void OverlapBody::close(std::uint32_t kept, std::uint32_t crossings, const Vec3d& normal, bool of_other) {
  const auto face = static_cast<std::uint32_t>(face_count_);
  faces_[face_count_++] = {normal, 0, of_other};
  Side* const sides = sides_.data() + side_count_;
  bool once = true;
  for (std::uint32_t c = 0; c < crossings; ++c) {
    const Crossing& here = crossings_[c];
    sides[c] = {kept + c, kept + faces_[here.leaves].enters, here.leaves, face};
    once &= faces_[here.enters].enters == c;
  }
  side_count_ += crossings;
  if (once) return;
  // Rounding crosses a face in the plane more than twice: then any two may be joined.
  for (std::uint32_t c = 0; c < crossings; ++c)
    for (std::uint32_t e = 0; e < crossings; ++e)
      if (crossings_[e].enters == crossings_[c].leaves) {
        sides[c].to = kept + e;
        crossings_[e].enters = none;
        break;
      }
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
        crossings_[c] = {left, before};
        faces_[before].enters = c;
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
  if (crossings > 0) close(found, crossings, keep.n, true);
  form_ = found == 1 ? Form::corner : Form::general;
  depth_ = -height(p.vertices[start]);
}

bool OverlapBody::cut(const HalfSpace& keep, bool of_other) {
  const std::size_t count = corner_count_;
  height_.make_room(count);
  kept_as_.make_room(count);
  double* const height = height_.data();
  std::uint32_t* const kept_as = kept_as_.data();  // the highest bit: lies outside
  std::uint32_t kept = 0;
  for (std::size_t i = 0; i < count; ++i) {
    height[i] = dot(keep.n, corners_[i]) - keep.level;
    const std::uint32_t out = height[i] > 0 ? 1 : 0;
    kept_as[i] = out << 31 | kept;
    kept += out ^ 1;
  }
  if (kept == count) return false;
  if (kept == 0) {
    clear();
    return true;
  }
  corners_.make_room(count + side_count_, count);
  sides_.make_room(2 * side_count_, side_count_);
  crossed_.make_room(side_count_ + 1);
  crossings_.make_room(side_count_);
  faces_.make_room(face_count_ + 1, face_count_);
  form_ = Form::general;
  Vec3d* const corners = corners_.data();
  Side *const sides = sides_.data(), *const crossed = crossed_.data();
  // No branch on what cannot be guessed.
  std::size_t left = 0, crossings = 0;
  for (std::size_t i = 0; i < side_count_; ++i) {
    const Side s = sides[i];
    const std::uint32_t from = kept_as[s.from], to = kept_as[s.to];
    crossed[crossings] = s;
    crossings += (from ^ to) >> 31;
    sides[left] = {from, to, s.left, s.right};
    left += ((from | to) >> 31) ^ 1;
  }
  for (std::uint32_t c = 0; c < crossings; ++c) {
    const Side& s = crossed[c];
    const bool from_out = kept_as[s.from] >> 31 != 0;
    const std::uint32_t in = from_out ? s.to : s.from, out = from_out ? s.from : s.to,
                        leaves = from_out ? s.right : s.left, enters = from_out ? s.left : s.right, here = kept + c;
    corners[count + c] = crossing(corners[in], corners[out], height[in], height[out]);
    crossings_[c] = {leaves, enters};
    faces_[enters].enters = c;
    sides[left++] = {from_out ? here : kept_as[in], from_out ? kept_as[in] : here, s.left, s.right};
  }
  for (std::size_t i = 0; i < count; ++i) corners[kept_as[i] & ~(1U << 31)] = corners[i];
  for (std::size_t c = 0; c < crossings; ++c) corners[kept + c] = corners[count + c];
  corner_count_ = kept + crossings;
  side_count_ = left;
  close(kept, static_cast<std::uint32_t>(crossings), keep.n, of_other);
  return true;
}

// Of the planes that corners lie over, those of p's geometry where `into` takes them from the body's frame; planes back
// by `face_of`. The one that cuts most comes first and leaves less for the others.
template <class Into, class FaceOf>
void OverlapBody::cut_by(const shapes::Polyhedron& p, double down, Except except, bool of_other, Into&& into,
                         FaceOf&& face_of) {
  if (empty()) return;
  const std::size_t filled = (corner_count_ + 3) / 4 * 4;
  seen_.make_room(filled);
  for (std::size_t i = 0; i < filled; ++i) {
    const Vec3d x = down * into(corners_[i < corner_count_ ? i : 0]);
    seen_[i] = {x.x, x.y, x.z, 0};
  }
  near_.make_room(p.nx.size() + 1);
  const kernels::OverlapKernels& kernels = *kernels::kernels().overlaps;
  const std::size_t found = kernels.cutting({p.nx.data(), p.ny.data(), p.nz.data(), p.nx.size()}, p.nd.data(),
                                            p.faces.size(), seen_.data(), filled, near_.data());
  const std::size_t room = found + 4;
  planes_.make_room(4 * room);
  const kernels::OverlapPlanes planes{planes_.data(), planes_.data() + room, planes_.data() + 2 * room,
                                      planes_.data() + 3 * room};
  const auto set = [&](std::size_t i, const Vec3d& n, double level) {
    planes.x[i] = n.x, planes.y[i] = n.y, planes.z[i] = n.z, planes.level[i] = level;
  };
  std::size_t count = 0;
  for (std::size_t i = 0; i < found; ++i) {
    if (near_[i] == except.face[0] || near_[i] == except.face[1]) continue;
    const HalfSpace face = face_of(near_[i]);
    set(count++, face.n, face.level);
  }
  for (std::size_t i = count; i % 4 != 0; ++i) set(i, {}, 0);
  for (;;) {
    std::size_t deepest = 0;
    count = kernels.deepest(planes, count, corners_.data(), corner_count_, deepest);
    if (count == 0) return;
    const HalfSpace face{{planes.x[deepest], planes.y[deepest], planes.z[deepest]}, planes.level[deepest]};
    --count;
    set(deepest, {planes.x[count], planes.y[count], planes.z[count]}, planes.level[count]);
    cut(face, of_other);
    if (empty()) return;
  }
}

void OverlapBody::cut_by_self(const PolyhedronPair& pair, Except except) {
  cut_by(
      *pair.self, 1 / pair.self_scale, except, false, [](const Vec3d& x) { return x; },
      [&](std::uint32_t i) {
        const auto& face = pair.self->faces[i];
        return HalfSpace{face.normal, pair.self_scale * face.offset};
      });
}

void OverlapBody::cut_by_other(const PolyhedronPair& pair, Except except) {
  cut_by(
      *pair.other, 1 / pair.other_scale, except, true,
      [&](const Vec3d& x) { return transposed_times(pair.other_to_self, x - pair.offset); },
      [&](std::uint32_t i) { return face_of_other(pair, i); });
}

EdgesMeeting::EdgesMeeting(const PolyhedronPair& pair, std::uint32_t edge_of_self, std::uint32_t edge_of_other)
    : found(false) {
  const auto &a = pair.self->edges[edge_of_self], &b = pair.other->edges[edge_of_other];
  p = pair.self_vertex(a.vertex[0]);
  e = pair.self_vertex(a.vertex[1]) - p;
  q = pair.other_vertex(b.vertex[0]);
  f = pair.other_vertex(b.vertex[1]) - q;
  w = q - p;
  for (int i = 0; i < 2; ++i) {
    of_a[i] = pair.self->faces[a.face[i]].normal;
    of_b[i] = pair.other_to_self * pair.other->faces[b.face[i]].normal;
  }
  const double rise_a[2] = {dot(of_b[0], e), dot(of_b[1], e)}, rise_b[2] = {dot(of_a[0], f), dot(of_a[1], f)};
  low = rise_a[0] < 0 ? 0 : 1;
  high = 1 - low;
  if (!(rise_a[low] < 0 && rise_a[high] > 0 && rise_b[low] < 0 && rise_b[high] > 0)) return;
  for (int i = 0; i < 2; ++i) {
    s[i] = dot(of_b[i], w) / rise_a[i];
    t[i] = -dot(of_a[i], w) / rise_b[i];
  }
  const auto near_edge = [](double x) { return std::abs(x) <= 2; };
  found =
      s[low] < s[high] && t[low] < t[high] && near_edge(s[0]) && near_edge(s[1]) && near_edge(t[0]) && near_edge(t[1]);
}

bool OverlapBody::begin(const EdgesMeeting& m) {
  if (!m.found) return false;
  clear();
  corners_.make_room(4);
  sides_.make_room(6);
  faces_.make_room(4);
  m.corners(corners_.data());
  faces_[0] = {m.of_a[0], 0, false};
  faces_[1] = {m.of_a[1], 0, false};
  faces_[2] = {m.of_b[m.low], 0, true};
  faces_[3] = {m.of_b[m.high], 0, true};
  constexpr Side sides[6] = {{0, 1, 0, 1}, {2, 3, 2, 3}, {1, 2, 0, 3}, {2, 0, 0, 2}, {0, 3, 1, 2}, {3, 1, 1, 3}};
  std::copy_n(sides, 6, sides_.data());
  form_ = Form::edges;
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

const OverlapBody& overlap_of_edges(const PolyhedronPair& pair, const EdgesMeeting& meeting, std::uint32_t edge_of_self,
                                    std::uint32_t edge_of_other, const Vec3d& n, double depth) {
  OverlapBody& body = scratch();
  const auto &a = pair.self->edges[edge_of_self], &b = pair.other->edges[edge_of_other];
  const OverlapBody::Except of_other{{b.face[0], b.face[1]}};
  if (body.begin(meeting)) {
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
