#include "libcontact/methods/overlap_body.h"

#include <utility>

namespace contact {

namespace {

constexpr std::uint32_t none = 0xffffffffu;

struct Scratch {
  OverlapBody body;
  std::vector<double> height;
};
Scratch& scratch() {
  static thread_local Scratch of_thread;
  return of_thread;
}
const OverlapBody& nothing() {
  static const OverlapBody body;
  return body;
}

}  // namespace

// Heights over the cut are in height_.
struct OverlapBody::Solid {
  const Vec3d* corners;
  double scale;
  const std::uint32_t* loops;
  const shapes::Polyhedron* geometry;  // null: faces
  const std::vector<Face>* faces;
  std::size_t face_count() const { return geometry ? geometry->faces.size() : faces->size(); }
  Face face(std::size_t i) const {
    if (!geometry) return (*faces)[i];
    const auto& f = geometry->faces[i];
    return {f.normal, f.first, f.count, false};
  }
};

void OverlapBody::begin(const shapes::Polyhedron& p, double scale) {
  corners_.clear();
  for (const Vec3d& x : p.vertices) corners_.push_back(scale * x);
  faces_.clear();
  loops_.assign(p.face_vertices.begin(), p.face_vertices.end());
  for (const auto& f : p.faces) faces_.push_back({f.normal, f.first, f.count, false});
}

bool OverlapBody::begin(const shapes::Polyhedron& p, double scale, const Vec3d& n, double level) {
  height_.resize(p.vertices.size());
  bool outside = false;
  for (std::size_t i = 0; i < p.vertices.size(); ++i) {
    height_[i] = dot(n, scale * p.vertices[i]) - level;
    outside |= height_[i] > 0;
  }
  if (outside) return clip({p.vertices.data(), scale, p.face_vertices.data(), &p, nullptr}, n);
  begin(p, scale);
  return true;
}

bool OverlapBody::cut(const Vec3d& n, double level) {
  height_.resize(corners_.size());
  bool outside = false;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    height_[i] = dot(n, corners_[i]) - level;
    outside |= height_[i] > 0;
  }
  return !outside || clip({corners_.data(), 1, loops_.data(), nullptr, &faces_}, n);
}

bool OverlapBody::clip(const Solid& solid, const Vec3d& n) {
  crossings_.clear();
  kept_as_.assign(height_.size(), none);
  next_corners_.clear();
  next_loops_.clear();
  next_faces_.clear();
  const auto keep = [&](std::uint32_t i) {
    if (kept_as_[i] == none) {
      kept_as_[i] = static_cast<std::uint32_t>(next_corners_.size());
      next_corners_.push_back(solid.scale * solid.corners[i]);
    }
    return kept_as_[i];
  };
  // Where the edge from a kept corner to one that goes crosses the plane: one corner for both faces at the edge.
  const auto crossing = [&](std::uint32_t in, std::uint32_t out) {
    for (std::uint32_t k = 0; k < crossings_.size(); ++k)
      if (crossings_[k].in == in && crossings_[k].out == out) return k;
    const double t = height_[in] / (height_[in] - height_[out]);
    const Vec3d from = solid.scale * solid.corners[in], to = solid.scale * solid.corners[out];
    crossings_.push_back({in, out, static_cast<std::uint32_t>(next_corners_.size()), none});
    next_corners_.push_back(from + t * (to - from));
    return static_cast<std::uint32_t>(crossings_.size() - 1);
  };
  for (std::size_t i = 0; i < solid.face_count(); ++i) {
    const Face f = solid.face(i);
    const std::uint32_t* loop = solid.loops + f.first;
    const auto first = static_cast<std::uint32_t>(next_loops_.size());
    std::uint32_t left = none, first_enter = none;
    for (std::uint32_t k = 0; k < f.count; ++k) {
      const std::uint32_t p = loop[k], q = loop[k + 1 == f.count ? 0 : k + 1];
      const bool p_out = height_[p] > 0, q_out = height_[q] > 0;
      if (!p_out) next_loops_.push_back(keep(p));
      if (p_out == q_out) continue;
      const std::uint32_t c = p_out ? crossing(q, p) : crossing(p, q);
      next_loops_.push_back(crossings_[c].corner);
      // The face goes from where it leaves to where it enters again; the cut's own face the other way.
      if (q_out)
        left = c;
      else if (left == none)
        first_enter = c;
      else
        crossings_[c].after = left;
    }
    if (first_enter != none) crossings_[first_enter].after = left;
    close(f.normal, first, f.of_other);
  }
  // One loop; several where rounding has crossed a face in the plane more than twice.
  for (std::uint32_t start = 0; start < crossings_.size(); ++start) {
    const auto first = static_cast<std::uint32_t>(next_loops_.size());
    for (std::uint32_t c = start; c != none;) {
      next_loops_.push_back(crossings_[c].corner);
      c = std::exchange(crossings_[c].after, none);
      if (c == start) break;
    }
    if (next_loops_.size() == first + 1) next_loops_.pop_back();
    close(n, first, true);
  }
  std::swap(corners_, next_corners_);
  std::swap(loops_, next_loops_);
  std::swap(faces_, next_faces_);
  return !faces_.empty();
}

const OverlapBody::Face* OverlapBody::face_of_other(std::uint32_t j, std::uint32_t i) const {
  for (const Face& f : faces_) {
    if (!f.of_other) continue;
    const std::uint32_t* loop = &loops_[f.first];
    for (std::uint32_t k = 0; k < f.count; ++k)
      if (loop[k] == j && loop[k + 1 == f.count ? 0 : k + 1] == i) return &f;
  }
  return nullptr;
}

// A face of the corners from `first` on, if they are enough.
void OverlapBody::close(const Vec3d& normal, std::uint32_t first, bool of_other) {
  const auto count = static_cast<std::uint32_t>(next_loops_.size()) - first;
  if (count < 3)
    next_loops_.resize(first);
  else
    next_faces_.push_back({normal, first, count, of_other});
}

const OverlapBody& overlap_body(const PolyhedronPair& pair) {
  OverlapBody& body = scratch().body;
  body.begin(*pair.self, pair.self_scale);
  for (const auto& plane : pair.other->faces) {
    const Vec3d n = pair.other_to_self * plane.normal;
    if (!body.cut(n, pair.other_scale * plane.offset + dot(n, pair.offset))) return nothing();
  }
  return body;
}

const OverlapBody& overlap_body(const PolyhedronPair& pair, const Vec3d& n) {
  OverlapBody& body = scratch().body;
  std::vector<double>& height = scratch().height;
  const shapes::Polyhedron& other = *pair.other;
  // Heights in other's geometry.
  const Vec3d m = transposed_times(pair.other_to_self, n);
  height.resize(other.vertices.size());
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < height.size(); ++i) {
    height[i] = dot(m, other.vertices[i]);
    least = height[i] < least ? height[i] : least;
  }
  const double base = dot(n, pair.offset), low = base + pair.other_scale * least, high = pair.highest_of_self(n).value;
  if (!(low < high)) return nothing();
  // A plane clear of other, whose own planes then cut its face away.
  if (!body.begin(*pair.self, pair.self_scale, -n, -(low - 0.5 * (high - low)))) return nothing();
  // A face with no corner below self's highest has no part in the overlap.
  const double reach = (high + 0x1p-40 * (high - low) - base) / pair.other_scale + 8 * epsilon * other.circumradius;
  for (const auto& face : other.faces) {
    const std::uint32_t* loop = other.face_vertices.data() + face.first;
    bool meets = false;
    for (std::uint32_t k = 0; k < face.count && !meets; ++k) meets = height[loop[k]] <= reach;
    if (!meets) continue;
    const Vec3d normal = pair.other_to_self * face.normal;
    if (!body.cut(normal, pair.other_scale * face.offset + dot(normal, pair.offset))) return nothing();
  }
  return body;
}

const OverlapBody& overlap_body(const shapes::Polyhedron& p, double scale, const Vec3d& n, double level) {
  OverlapBody& body = scratch().body;
  return body.begin(p, scale, n, level) ? body : nothing();
}

}  // namespace contact
