#include "libdem/render/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dem::render {

namespace {

constexpr double margin = 1.06;                             // of the box, in the picture
constexpr double half_angle = 14 * std::numbers::pi / 180;  // of view: long lens, little distortion
constexpr double azimuth = 28 * std::numbers::pi / 180, elevation = 18 * std::numbers::pi / 180;

// Distances of the box's corners from its centre, along the camera's axes.
struct Corner {
  double x, y, z;
};

std::vector<Corner> corners_of(const io::Box& box, const Camera& c) {
  std::vector<Corner> corners;
  for (int k = 0; k < 8; ++k) {
    const Vec3d p{k & 1 ? box.upper.x : box.lower.x, k & 2 ? box.upper.y : box.lower.y,
                  k & 4 ? box.upper.z : box.lower.z};
    const Vec3d d = p - box.centre();
    corners.push_back({dot(d, c.right), dot(d, c.up), dot(d, c.forward)});
  }
  return corners;
}

// Half extents of the picture plane in units of its shorter half.
double half_width(int width, int height) { return static_cast<double>(width) / std::min(width, height); }
double half_height(int width, int height) { return static_cast<double>(height) / std::min(width, height); }

// Smallest distance, and the sideways shift that goes with it, at which all |x − shift| <= slope (distance + z).
struct Fit {
  double distance, shift;
};
template <class Get>
Fit fit(const std::vector<Corner>& corners, double slope, Get get) {
  double positive = -INFINITY, negative = -INFINITY;  // of ±x − slope z
  for (const Corner& c : corners) {
    positive = std::max(positive, get(c) - slope * c.z);
    negative = std::max(negative, -get(c) - slope * c.z);
  }
  return {(positive + negative) / (2 * slope), (positive - negative) / 2};
}

}  // namespace

Ray Camera::ray(double u, double v, int width, int height) const {
  const double x = (2 * u / width - 1) * half_width(width, height) * scale;
  const double y = (1 - 2 * v / height) * half_height(width, height) * scale;
  if (orthographic) return {eye + right * x + up * y, forward};
  return {eye, normalized(forward + right * x + up * y)};
}

double Camera::pixel(double distance, int width, int height) const {
  return 2 * scale * (orthographic ? 1.0 : distance) / std::min(width, height);
}

Camera make_camera(const io::Box& box, const Vec3d& up, const View& view) {
  const double w = half_width(view.width, view.height), h = half_height(view.width, view.height);
  Camera c;
  c.orthographic = view.orthographic.has_value();
  if (c.orthographic) {
    c.forward = normalized(*view.orthographic);
  } else {
    // The front is the side of −y (of −z when y is up).
    const Vec3d ahead = std::abs(up.y) > 0.9 ? Vec3d{0, 0, -up.y} : Vec3d{0, 1, 0};
    const Vec3d level = normalized(ahead - up * dot(up, ahead)), side = cross(level, up);
    const Vec3d turned = level * std::cos(azimuth) - side * std::sin(azimuth);
    c.forward = turned * std::cos(elevation) - up * std::sin(elevation);
  }
  Vec3d right = cross(c.forward, up);
  if (norm(right) < 1e-3) right = Vec3d{1, 0, 0} - c.forward * c.forward.x;  // straight down or up
  c.right = normalized(right);
  c.up = cross(c.right, c.forward);

  const auto corners = corners_of(box, c);
  if (c.orthographic) {
    for (const Corner& p : corners) c.scale = std::max({c.scale, std::abs(p.x) / w, std::abs(p.y) / h});
    c.scale *= margin;
    c.eye = box.centre() - c.forward * (4 * box.radius());
    return c;
  }
  c.scale = std::tan(half_angle);
  const Fit x = fit(corners, c.scale * w / margin, [](const Corner& p) { return p.x; });
  const Fit y = fit(corners, c.scale * h / margin, [](const Corner& p) { return p.y; });
  c.eye = box.centre() - c.forward * std::max(x.distance, y.distance) + c.right * x.shift + c.up * y.shift;
  return c;
}

}  // namespace dem::render
