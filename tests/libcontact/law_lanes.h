// Random numbers for the lanes of a chunk of contacts, and vectors in and out of them.
#pragma once

#include <random>

#include "libcontact/kernels/chunk.h"

namespace contact::kernels {

class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  double in(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  shapes::Vec3d vector(double size) { return {in(-size, size), in(-size, size), in(-size, size)}; }
  shapes::Vec3d unit() { return shapes::normalized(vector(1) + shapes::Vec3d{0, 0, 2}); }

 private:
  std::mt19937_64 engine_;
};

inline void put(Lane3& lane, std::size_t i, const shapes::Vec3d& v) {
  lane.x[i] = v.x;
  lane.y[i] = v.y;
  lane.z[i] = v.z;
}
inline shapes::Vec3d get(const Lane3& lane, std::size_t i) { return {lane.x[i], lane.y[i], lane.z[i]}; }

}  // namespace contact::kernels
