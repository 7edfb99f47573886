// A vector of the plane, over any scalar: double, or lanes.
#pragma once

namespace contact {

template <class T>
struct Flat {
  T x, y;
  [[gnu::always_inline]] friend T dot(const Flat& u, const Flat& v) { return u.x * v.x + u.y * v.y; }
  [[gnu::always_inline]] friend Flat operator+(const Flat& u, const Flat& v) { return {u.x + v.x, u.y + v.y}; }
  [[gnu::always_inline]] friend Flat operator-(const Flat& u, const Flat& v) { return {u.x - v.x, u.y - v.y}; }
  [[gnu::always_inline]] friend Flat operator*(const T& s, const Flat& u) { return {s * u.x, s * u.y}; }
  [[gnu::always_inline]] Flat turned() const { return {-y, x}; }
};

}  // namespace contact
