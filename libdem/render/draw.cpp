// Light and colour. One sun with a soft edge, a sky that reaches a point as far as its neighbours let it (ambient
// occlusion), walls as thin glass where they stand before the grains. Every sample's random numbers are a function of
// its pixel alone: the picture does not depend on threads.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "libdem/render/color.h"
#include "libdem/render/legend.h"
#include "libdem/render/tracer.h"

namespace dem::render {

namespace {

constexpr int grid = 2;              // grid × grid samples per pixel
constexpr int sun_rays = 3;          // per sample
constexpr int sky_rays = 5;          // per sample
constexpr int max_layers = 8;        // of walls along a ray
constexpr double sun_radius = 0.09;  // rad
constexpr double lift = 3e-5;        // of a new ray's start above the surface, scene = 1
constexpr float sun_light = 0.66f, sky_light = 0.52f, fill_light = 0.14f, gloss = 0.10f;

// Points of a disc, spread evenly over all rays of a pixel (a spiral by the golden angle) and turned and shifted from
// pixel to pixel by a hash: what remains of noise is fine and even.
struct Spread {
  double turn, shift;  // 0 … 1
  int sample;          // of the pixel, 0 … grid² − 1

  struct Point {
    double square, angle;  // radius² in 0 … 1; rad
  };
  Point point(int ray, int rays) const {
    const int index = sample + grid * grid * ray;
    return {(index + shift) / (grid * grid * rays), 2 * std::numbers::pi * (turn + 0.618033988749895 * index)};
  }
};

// Bits of a counter, mixed: 0 … 1.
double hash(std::uint64_t z) {
  z = (z + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

struct Layer {
  Color color;
  float opacity;
};

class Painter {
 public:
  Painter(const Picture& picture, const Camera& camera, const View& view, const Range& range)
      : picture_(picture), camera_(camera), view_(view), range_(range), tracer_(picture.bodies, picture.walls) {
    const Vec3d up = picture.up;
    sun_ = normalized(up * 1.0 - camera.right * 0.55 - camera.forward * 0.65);
    fill_ = normalized(up * 0.2 + camera.right * 0.9 - camera.forward * 0.4);
    tangent_frame(sun_, sun_u_, sun_v_);
    double sum = 0;
    for (const Body& b : picture.bodies)
      sum += b.polyhedron != nullptr ? b.size.x * b.polyhedron->circumradius : max_abs(b.size);
    sky_reach_ = picture.bodies.empty() ? 1.0 : 4 * sum / static_cast<double>(picture.bodies.size());
  }

  Color pixel(int i, int j) const {
    const std::uint64_t index =
        static_cast<std::uint64_t>(j) * static_cast<std::uint64_t>(view_.width) + static_cast<std::uint64_t>(i);
    Spread spread{hash(2 * index), hash(2 * index + 1), 0};
    Color sum{};
    for (int s = 0; s < grid * grid; ++s) {
      const int column = s % grid, row = s / grid;
      const double u = i + (column + 0.5) / grid, v = j + (row + 0.5) / grid;
      spread.sample = s;
      sum += sample(camera_.ray(u, v, view_.width, view_.height), spread);
    }
    return sum * (1.0f / (grid * grid));
  }

 private:
  Color sample(const Ray& ray, const Spread& spread) const {
    const BodyHit hit = tracer_.body(ray);
    Color color{};
    float clear = 1;
    double near = 0;
    for (int n = 0; n < max_layers; ++n) {
      const WallHit wall = tracer_.wall(ray, near, hit.distance);
      if (wall.distance == no_hit) break;
      const Layer layer = glass(ray, wall, n == 0, spread);
      color += layer.color * (clear * layer.opacity);
      clear *= 1 - layer.opacity;
      if (clear < 0.01f) return color;
      near = wall.distance * (1 + 1e-5) + 1e-6;
    }
    const Color behind = hit.distance == no_hit ? Color{1, 1, 1} : body_color(ray, hit, spread);
    return color + behind * clear;
  }

  Layer glass(const Ray& ray, const WallHit& hit, bool first, const Spread& spread) const {
    const io::WallSurface& surface = picture_.walls[hit.surface];
    const double cosine = std::abs(dot(hit.normal, ray.direction));
    const double line = 0.7 * camera_.pixel(hit.distance, view_.width, view_.height);
    const auto ink = static_cast<float>(std::clamp(1.5 - hit.edge * std::max(cosine, 0.2) / line, 0.0, 1.0));
    const Color pencil = from_srgb(0.34, 0.38, 0.43);
    Layer layer{};
    if (surface.half_space && dot(hit.normal, ray.direction) > 0)
      return {pencil, 0.35f * ink};  // seen through its solid
    if (surface.half_space) {
      layer = {lit(from_srgb(0.93, 0.93, 0.94), ray, hit.distance, hit.normal, spread, 0), 1.0f};
    } else {
      const double rim = std::pow(1 - cosine, 3);
      const Color steel = from_srgb(0.60, 0.69, 0.78);
      layer = first
                  ? Layer{steel, static_cast<float>(0.07 + 0.14 * rim)}
                  : Layer{lit(steel, ray, hit.distance, hit.normal, spread, 0), static_cast<float>(0.28 + 0.20 * rim)};
    }
    const float strength = (first ? 0.75f : 0.45f) * ink;
    const float opacity = layer.opacity + strength * (1 - layer.opacity);
    const float share = opacity > 0 ? strength / opacity : 0;
    return {layer.color * (1 - share) + pencil * share, opacity};
  }

  Color body_color(const Ray& ray, const BodyHit& hit, const Spread& spread) const {
    const Body& body = picture_.bodies[hit.body];
    const double span = range_.upper - range_.lower;
    const bool known = std::isfinite(body.value);
    const Color base = !known                   ? from_srgb(0.6, 0.6, 0.6)
                       : picture_.names.empty() ? sequential(span > 0 ? (body.value - range_.lower) / span : 0.5)
                                                : categorical(static_cast<std::size_t>(body.value));
    const Vec3d normal = dot(hit.normal, ray.direction) > 0 ? -hit.normal : hit.normal;
    return lit(base, ray, hit.distance, normal, spread, body.polyhedron != nullptr ? 0.4f * gloss : gloss);
  }

  Color lit(const Color& base, const Ray& ray, double distance, const Vec3d& n, const Spread& spread,
            float shine) const {
    const Vec3d start = ray.origin + ray.direction * distance + n * (lift + 1e-6 * distance);
    const double facing = dot(n, sun_);
    const double sun = facing > 0 ? facing * sun_share(start, spread) : 0;
    const double sky = sky_share(start, n, spread) * (0.75 + 0.25 * dot(n, picture_.up));
    const double fill = std::max(dot(n, fill_), 0.0) * (0.4 + 0.6 * sky);
    const float light = sun_light * static_cast<float>(sun) + sky_light * static_cast<float>(sky) +
                        fill_light * static_cast<float>(fill);
    const Vec3d half = normalized(sun_ - ray.direction);
    const double highlight = sun > 0 ? std::pow(std::max(dot(n, half), 0.0), 40) * sun / facing : 0;
    const float h = shine * static_cast<float>(highlight);
    return base * light + Color{h, h, h};
  }

  // The part of the sun's disc that is seen.
  double sun_share(const Vec3d& start, const Spread& spread) const {
    int seen = 0;
    for (int k = 0; k < sun_rays; ++k) {
      const auto [square, angle] = spread.point(k, sun_rays);
      const double r = sun_radius * std::sqrt(square);
      const Vec3d to = normalized(sun_ + sun_u_ * (r * std::cos(angle)) + sun_v_ * (r * std::sin(angle)));
      seen += tracer_.blocked({start, to}, no_hit) ? 0 : 1;
    }
    return static_cast<double>(seen) / sun_rays;
  }

  // The part of the sky above the surface that is seen within the reach, weighted by the cosine.
  double sky_share(const Vec3d& start, const Vec3d& n, const Spread& spread) const {
    Vec3d t1, t2;
    tangent_frame(n, t1, t2);
    int seen = 0;
    for (int k = 0; k < sky_rays; ++k) {
      const auto [square, angle] = spread.point(k, sky_rays);
      const double r = std::sqrt(square);
      const Vec3d to = t1 * (r * std::cos(angle)) + t2 * (r * std::sin(angle)) + n * std::sqrt(1 - square);
      seen += tracer_.blocked({start, to}, sky_reach_) ? 0 : 1;
    }
    return static_cast<double>(seen) / sky_rays;
  }

  const Picture& picture_;
  const Camera& camera_;
  const View& view_;
  Range range_;
  Tracer tracer_;
  Vec3d sun_{}, sun_u_{}, sun_v_{}, fill_{};
  double sky_reach_ = 1;
};

// Range of the colours: from zero when the values come near it, and without the highest four percent, so that falling
// grains do not darken all the others.
Range range_of(const std::vector<Body>& bodies) {
  std::vector<double> values;
  for (const Body& b : bodies)
    if (std::isfinite(b.value)) values.push_back(b.value);
  if (values.empty()) return {0, 1};
  std::sort(values.begin(), values.end());
  const double first = values.front(), high = values[(values.size() - 1) * 96 / 100];
  const double upper = high > first ? high : values.back();
  return {first > 0 && first < 0.1 * upper ? 0 : first, upper};
}

// Everything in units of the box's radius about its centre.
void to_unit_size(Picture& picture, io::Box& box) {
  const Vec3d centre = box.centre();
  const double shrink = box.radius() > 0 ? 1 / box.radius() : 1.0;
  const auto move = [&](Vec3d& x) { x = (x - centre) * shrink; };
  for (Body& b : picture.bodies) {
    move(b.position);
    b.size *= shrink;
  }
  for (io::WallSurface& s : picture.walls)
    for (Vec3d& v : s.vertices) move(v);
  move(box.lower);
  move(box.upper);
}

}  // namespace

Image draw(const Picture& picture, const View& view) {
  if (!view.box || view.width < 1 || view.height < 1) throw RunError("a picture needs a size and a box to show");
  Picture unit = picture;
  io::Box box = *view.box;
  to_unit_size(unit, box);
  const Range range = view.range ? *view.range : range_of(unit.bodies);
  Image image{view.width, view.height, {}};
  const auto width = static_cast<std::size_t>(view.width);
  image.rgb.assign(3 * width * static_cast<std::size_t>(view.height), 255);
  const bool categories = !picture.names.empty();
  int margin = 0;  // of the legend, to the right of the scene; a narrow picture keeps its legend inside
  if (view.legend)
    margin =
        categories ? categories_width(image, picture.label, picture.names) : bar_width(image, picture.label, range);
  View scene = view;
  if (margin <= view.width * 2 / 5) scene.width -= margin;
  const Camera camera = make_camera(box, unit.up, scene);
  const Painter painter(unit, camera, scene, range);

#pragma omp parallel for schedule(dynamic, 8)
  for (int j = 0; j < scene.height; ++j)
    for (int i = 0; i < scene.width; ++i) {
      const Color c = painter.pixel(i, j);
      std::uint8_t* out = &image.rgb[3 * (static_cast<std::size_t>(j) * width + static_cast<std::size_t>(i))];
      for (int k = 0; k < 3; ++k) out[k] = to_srgb(c[k]);
    }
  if (!view.legend) return image;
  if (categories) {
    draw_categories(image, picture.label, picture.names);
  } else {
    const bool clipped =
        std::any_of(unit.bodies.begin(), unit.bodies.end(), [&](const Body& b) { return b.value > range.upper; });
    draw_bar(image, picture.label, range, clipped);
  }
  return image;
}

}  // namespace dem::render
