// A closed surface of triangles about the origin, pushed outwards one corner at a time: what is left of an expanding
// polytope once the body that it grows in is taken away.
//
// Every face sees the origin on its inner side, or at most `slack` in front of it, which is checked as it is added, and
// a corner is outside a face from `slack` above it on:
// hence the least distance of the faces is a lower bound of that of the body's surface, whatever rounding did to
// convexity. Without allocation. Corner: any type with a member `at`, its place.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "shapes/math/vec.h"

namespace contact {

template <class Corner, int corner_cap = 96>
class ExpandingSurface {
  static_assert(corner_cap <= 255);

 public:
  explicit ExpandingSurface(double slack = 0) : slack_(slack) {}

  struct Face {
    shapes::Vec3d normal;  // unit
    double distance;
    std::uint8_t corner[3];  // counter-clockwise from outside
  };

  // A tetrahedron about the origin; 1, 2, 3 counter-clockwise seen from outside, away from 0.
  bool begin(const Corner (&tetrahedron)[4]) {
    for (int i = 0; i < 4; ++i) corners_[i] = tetrahedron[i];
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

  // Adds a corner of the body outside face `seen`. False when it cannot be held, or a face would not see the origin
  // behind it; the surface is then as it was.
  bool push(const Corner& c, int seen) {
    // Where a corner in the plane of a face makes one without area of its edge, that face goes too.
    return push_above(c, seen, slack_) || (slack_ > 0 && push_above(c, seen, -slack_));
  }

  // A lower bound of the distance of the surface, to rounding, even where the normal of a sliver is not: along any unit
  // vector no point of a triangle lies lower than its lowest corner.
  double clearance() const {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < face_count_; ++i)
      for (int k = 0; k < 3; ++k) least = std::fmin(least, dot(faces_[i].normal, corner(faces_[i], k).at));
    return least;
  }

  // No face is as near as `limit` but those with all corners at least `level` high along n.
  bool clear_of(double limit, const shapes::Vec3d& n, double level) const {
    for (int i = 0; i < face_count_; ++i) {
      const Face& f = faces_[i];
      if (f.distance > limit) continue;
      for (int k = 0; k < 3; ++k)
        if (!(dot(n, corner(f, k).at) > level)) return false;
    }
    return true;
  }

 private:
  static constexpr int rim_cap = 64, face_cap = 2 * corner_cap + rim_cap;

  // Faces go that the corner is more than `margin` above.
  bool push_above(const Corner& c, int seen, double margin) {
    if (corner_count_ == corner_cap) return false;
    struct Edge {
      std::uint8_t from, to;
    } rim[rim_cap];
    int rim_count = 0, hidden[face_cap], hidden_count = 0;
    const auto hide = [&](int i) {
      hidden[hidden_count++] = i;
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
      return true;
    };
    for (int i = face_count_ - 1; i >= 0; --i)
      if ((i == seen || dot(faces_[i].normal, c.at) > faces_[i].distance + margin) && !hide(i)) return false;
    if (rim_count < 3) return false;
    const int faces = face_count_;
    const auto index = static_cast<std::uint8_t>(corner_count_);
    corners_[corner_count_++] = c;
    for (int i = 0; i < rim_count; ++i)
      if (!add(rim[i].from, rim[i].to, index)) {
        face_count_ = faces;
        --corner_count_;
        return false;
      }
    for (int i = 0; i < hidden_count; ++i) faces_[hidden[i]] = faces_[--face_count_];  // the last ones first
    return true;
  }

  bool add(std::uint8_t i, std::uint8_t j, std::uint8_t k) {
    if (face_count_ == face_cap) return false;
    const shapes::Vec3d& u = corners_[i].at;
    const shapes::Vec3d n = cross(corners_[j].at - u, corners_[k].at - u);
    const double square = dot(n, n);
    Face& f = faces_[face_count_++];
    f = {n * (1 / std::sqrt(square)), 0, {i, j, k}};
    f.distance = dot(f.normal, u);
    return f.distance > -slack_;  // not of a face without area
  }

  double slack_;
  union {  // not cleared
    Corner corners_[corner_cap];
  };
  Face faces_[face_cap];
  int corner_count_ = 0, face_count_ = 0;
};

}  // namespace contact
