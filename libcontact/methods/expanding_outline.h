// A closed polygon about the origin of the plane z = 0, pushed outwards one corner at a time: expanding_surface.h in
// two dimensions. Without allocation. Corner: any type with a member `at`, its place.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "shapes/math/vec.h"

namespace contact {

template <class Corner>
class ExpandingOutline {
 public:
  struct Face {            // a side
    shapes::Vec3d normal;  // unit
    double distance;       // of its lower end along the normal
    std::uint8_t corner[2];
  };

  // A side may leave the origin at most `slack` outside, and a corner is outside a side from `slack` above it on.
  explicit ExpandingOutline(double slack) : slack_(slack) {}

  // A triangle about the origin, counter-clockwise.
  bool begin(const Corner (&triangle)[4]) {
    for (int i = 0; i < 3; ++i) corners_[i] = triangle[i];
    corner_count_ = count_ = 3;
    return set(sides_[0], 0, 1) && set(sides_[1], 1, 2) && set(sides_[2], 2, 0);
  }

  int nearest() const {
    int best = 0;
    for (int i = 1; i < count_; ++i) best = sides_[i].distance < sides_[best].distance ? i : best;
    return best;
  }
  const Face& face(int i) const { return sides_[i]; }
  const Corner& corner(const Face& f, int k) const { return corners_[f.corner[k]]; }
  double clearance() const { return sides_[nearest()].distance; }

  // Adds a corner outside side `seen`. False when it cannot be held, or a side would not see the origin behind it; the
  // outline is then as it was.
  bool push(const Corner& c, int seen) {
    int first = 0, last = 0;  // sides that go, from `seen`
    const auto hidden = [&](int i) { return dot(at(seen + i).normal, c.at) > at(seen + i).distance + slack_; };
    while (last < count_ - 2 && hidden(last + 1)) ++last;
    while (last - first < count_ - 2 && hidden(first - 1)) --first;
    if (corner_count_ == corner_cap) return false;
    const auto index = static_cast<std::uint8_t>(corner_count_);
    corners_[index] = c;
    Face to, from;
    if (!set(to, at(seen + first).corner[0], index) || !set(from, index, at(seen + last).corner[1])) return false;
    ++corner_count_;
    // The sides that stay come first, in their order.
    std::rotate(sides_, sides_ + (seen + last + 1) % count_, sides_ + count_);
    count_ -= last - first + 1;
    sides_[count_++] = to;
    sides_[count_++] = from;
    return true;
  }

 private:
  static constexpr int corner_cap = 255;

  Face& at(int i) { return sides_[(i + count_) % count_]; }

  bool set(Face& f, std::uint8_t from, std::uint8_t to) {
    const shapes::Vec3d &p = corners_[from].at, &q = corners_[to].at;
    const double x = q.y - p.y, y = p.x - q.x, inverse = 1 / std::sqrt(x * x + y * y);
    f = {{x * inverse, y * inverse, 0}, 0, {from, to}};
    f.distance = std::fmin(dot(f.normal, p), dot(f.normal, q));
    return f.distance > -slack_;  // not of a side without length
  }

  double slack_;
  union {  // not cleared
    Corner corners_[corner_cap];
  };
  union {
    Face sides_[corner_cap];
  };
  int corner_count_ = 0, count_ = 0;
};

}  // namespace contact
