#include "libcontact/methods/convex_overlap.h"

#include <utility>
#include <vector>

namespace contact {

namespace {

constexpr std::uint32_t none = 0xffffffffu;

class Clipped {
 public:
  void begin(const PolyhedronPair& pair) {
    const shapes::Polyhedron& p = *pair.self;
    corners_.clear();
    for (std::uint32_t i = 0; i < p.vertices.size(); ++i) corners_.push_back(pair.self_vertex(i));
    faces_.clear();
    loops_.clear();
    for (const auto& f : p.faces) {
      faces_.push_back({f.normal, static_cast<std::uint32_t>(loops_.size()), f.count, false});
      for (std::uint32_t k = 0; k < f.count; ++k) loops_.push_back(p.face_vertices[f.first + k]);
    }
  }

  // Keeps n·x <= level; false when nothing is left.
  bool cut(const Vec3d& n, double level) {
    bool outside = false, inside = false;
    height_.resize(corners_.size());
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      height_[i] = dot(n, corners_[i]) - level;
      if (!(used_[i] != 0)) continue;
      (height_[i] > 0 ? outside : inside) = true;
    }
    if (!inside) return false;
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

  void mark() {
    used_.assign(corners_.size(), 0);
    for (const std::uint32_t i : loops_) used_[i] = 1;
  }

  OverlapSums sums() const {
    OverlapSums s;
    if (faces_.empty()) return s;
    s.apex = corners_[loops_[0]];
    for (const Face& f : faces_) {
      const Vec3d first = corners_[loops_[f.first]] - s.apex;
      const double height = dot(f.normal, first);
      const std::size_t of = f.of_other ? 1 : 0;
      Vec3d p = corners_[loops_[f.first + 1]] - s.apex - first;
      for (std::uint32_t i = 2; i < f.count; ++i) {
        const Vec3d q = corners_[loops_[f.first + i]] - s.apex - first, middle = first + (1.0 / 3) * (p + q);
        const double area = 0.5 * dot(f.normal, cross(p, q)), cone = area * height / 3;
        s.surface[of] += area * f.normal;
        s.moment[of] += area * cross(middle, f.normal);
        s.volume += cone;
        s.first += cone * (0.75 * middle);  // a cone's centroid, from its apex
        p = q;
      }
    }
    return s;
  }

 private:
  struct Face {
    Vec3d normal;
    std::uint32_t first, count;
    bool of_other;
  };
  struct Crossing {
    std::uint32_t in, out, corner;
  };

  // A face of the corners from `first` on, if they are enough.
  void close(const Vec3d& normal, std::uint32_t first, bool of_other) {
    const auto count = static_cast<std::uint32_t>(next_loops_.size()) - first;
    if (count < 3)
      next_loops_.resize(first);
    else
      next_faces_.push_back({normal, first, count, of_other});
  }

  // Where the edge from a kept corner to one that goes crosses the plane: one corner for both faces at the edge.
  std::uint32_t crossing(std::uint32_t in, std::uint32_t out) {
    for (const Crossing& c : crossings_)
      if (c.in == in && c.out == out) return c.corner;
    const double t = height_[in] / (height_[in] - height_[out]);
    const auto corner = static_cast<std::uint32_t>(corners_.size());
    after_.push_back(none);
    corners_.push_back(corners_[in] + t * (corners_[out] - corners_[in]));
    crossings_.push_back({in, out, corner});
    return corner;
  }

  std::vector<Vec3d> corners_;
  std::vector<double> height_;
  std::vector<std::uint8_t> used_;
  std::vector<std::uint32_t> loops_, next_loops_, after_;
  std::vector<Face> faces_, next_faces_;
  std::vector<Crossing> crossings_;
};

}  // namespace

OverlapSums convex_overlap(const PolyhedronPair& pair) {
  static thread_local Clipped body;
  body.begin(pair);
  body.mark();
  for (const auto& plane : pair.other->faces) {
    const Vec3d n = pair.other_to_self * plane.normal;
    if (!body.cut(n, pair.other_scale * plane.offset + dot(n, pair.offset))) return {};
  }
  return body.sums();
}

}  // namespace contact
