// Rays against bodies and walls. The only header that stands between the pictures and the ray-tracing library; lengths
// are those of a scene scaled to about unit size, which single precision inside the library needs.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "libdem/render/camera.h"
#include "libdem/render/render.h"

namespace dem::render {

inline constexpr double no_hit = std::numeric_limits<double>::infinity();

struct BodyHit {
  double distance = no_hit;
  Vec3d normal{};  // unit, outward
  std::uint32_t body = 0;
};

struct WallHit {
  double distance = no_hit;
  Vec3d normal{};             // unit; of a plane: to its free side, of a mesh: towards the eye
  std::uint32_t surface = 0;  // index into the surfaces
  double edge = no_hit;       // distance to the nearest outline edge of its triangle
};

class Tracer {
 public:
  Tracer(const std::vector<Body>& bodies, const std::vector<io::WallSurface>& walls);
  ~Tracer();
  BodyHit body(const Ray& ray) const;
  bool blocked(const Ray& ray, double far) const;               // by a body
  WallHit wall(const Ray& ray, double near, double far) const;  // first one in between

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace dem::render
