#include "libcontact/methods/expansion.h"

#include <cmath>
#include <cstdint>

namespace contact {
namespace {

class Surface {
 public:
  struct Face {
    Vec3d normal;  // unit
    double distance;
    std::uint8_t corner[3];  // counter-clockwise from outside
  };

  // The tetrahedron of p and a triangle about the ray from p through the origin.
  bool begin(const Vec3d& p, const Corner (&portal)[3]) {
    corners_[0] = {p, Corner::inner, Corner::inner};
    for (int i = 0; i < 3; ++i) corners_[i + 1] = portal[i];
    corner_count_ = 4;
    return add(1, 2, 3) && add(0, 2, 1) && add(0, 3, 2) && add(0, 1, 3);
  }

  int nearest() const {
    int best = 0;
    for (int i = 1; i < face_count_; ++i) best = faces_[i].distance < faces_[best].distance ? i : best;
    return best;
  }
  const Face& face(int i) const { return faces_[i]; }
  const Corner& corner(const Face& f, int k) const { return corners_[f.corner[k]]; }

  // Adds a corner of K outside face `seen`. False when it cannot be held, or a face would not see the origin behind it.
  bool push(const Corner& c, int seen) {
    if (corner_count_ == corner_cap) return false;
    struct Edge {
      std::uint8_t from, to;
    } rim[rim_cap];
    int rim_count = 0;
    const auto remove = [&](int i) {
      for (int k = 0; k < 3; ++k) {
        const Edge e{faces_[i].corner[k], faces_[i].corner[k == 2 ? 0 : k + 1]};
        int twin = 0;
        while (twin < rim_count && !(rim[twin].from == e.to && rim[twin].to == e.from)) ++twin;
        if (twin < rim_count) {
          rim[twin] = rim[--rim_count];
        } else {
          if (rim_count == rim_cap) return false;
          rim[rim_count++] = e;
        }
      }
      faces_[i] = faces_[--face_count_];
      return true;
    };
    for (int i = face_count_ - 1; i >= 0; --i)
      if ((i == seen || dot(faces_[i].normal, c.at) > faces_[i].distance) && !remove(i)) return false;
    const auto index = static_cast<std::uint8_t>(corner_count_);
    corners_[corner_count_++] = c;
    for (int i = 0; i < rim_count; ++i)
      if (!add(rim[i].from, rim[i].to, index)) return false;
    return true;
  }

  // No face is as near as `limit` but those with all corners at least `level` high along n.
  bool clear_of(double limit, const Vec3d& n, double level) const {
    for (int i = 0; i < face_count_; ++i) {
      const Face& f = faces_[i];
      if (f.distance > limit) continue;
      for (int k = 0; k < 3; ++k)
        if (!(dot(n, corner(f, k).at) > level)) return false;
    }
    return true;
  }

 private:
  static constexpr int corner_cap = 96, face_cap = 2 * corner_cap, rim_cap = 64;

  bool add(std::uint8_t i, std::uint8_t j, std::uint8_t k) {
    if (face_count_ == face_cap) return false;
    const Vec3d& u = corners_[i].at;
    const Vec3d n = cross(corners_[j].at - u, corners_[k].at - u);
    const double square = dot(n, n);
    Face& f = faces_[face_count_++];
    f = {n * (1 / std::sqrt(square)), 0, {i, j, k}};
    f.distance = dot(f.normal, u);
    return f.distance > 0;  // not of a face without area
  }

  Corner corners_[corner_cap];
  Face faces_[face_cap];
  int corner_count_ = 0, face_count_ = 0;
};

}  // namespace

bool expand(const DifferencePair& pair, const Vec3d& inside, const Corner (&portal)[3], DifferenceFacet& facet,
            FacetAxis& axis) {
  Surface surface;
  if (!surface.begin(inside, portal)) return false;
  const double rounding = 16 * epsilon * pair.size;
  for (;;) {
    const int i = surface.nearest();
    const Surface::Face f = surface.face(i);
    const Corner c = support(pair, f.normal);
    if (dot(f.normal, c.at) > f.distance + rounding) {
      if (!surface.push(c, i)) return false;
      continue;
    }
    facet = facet_of(pair, surface.corner(f, 0), surface.corner(f, 1), surface.corner(f, 2));
    if (prove_nearest(pair, facet, axis, true) != Nearest::proven) return false;
    // A corner as high as the facet belongs to it: the proof has found all others to be farther below than rounding.
    return surface.clear_of(-axis.value + 2 * proof_clearance * pair.size, axis.normal,
                            -axis.value - proof_clearance * pair.size);
  }
}

}  // namespace contact
