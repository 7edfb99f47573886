// Where the picture is taken from. Perspective from above the front, or parallel along a given direction; the box fills
// the picture up to a margin.
#pragma once

#include "libdem/io/surfaces.h"
#include "libdem/render/render.h"

namespace dem::render {

struct Ray {
  Vec3d origin, direction;  // unit
};

struct Camera {
  Vec3d eye{};                     // perspective: the pin hole; orthographic: centre of the picture plane
  Vec3d right{}, up{}, forward{};  // unit
  double scale = 0;  // perspective: tan of half the angle; orthographic: half the width, m (of the shorter side)
  bool orthographic = false;
  // Ray through the picture point (u, v), in pixels from the upper left corner.
  Ray ray(double u, double v, int width, int height) const;
  // Size of a pixel of a picture with this height at a distance from the eye, m.
  double pixel(double distance, int width, int height) const;
};

Camera make_camera(const io::Box& box, const Vec3d& up, const View& view);

}  // namespace dem::render
