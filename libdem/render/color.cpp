#include "libdem/render/color.h"

#include <array>
#include <numbers>

namespace dem::render {

namespace {

double to_linear(double s) { return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4); }

struct Lch {
  double lightness, chroma, hue;  // hue in degrees
};

// Oklab lightness, chroma and hue to linear red, green, blue. Source: B. Ottosson, "A perceptual color space
// for image processing" (2020): l, m, s = (L + matrix · (a, b))³, rgb = matrix · (l, m, s).
Color from_oklch(const Lch& c) {
  const double angle = c.hue * std::numbers::pi / 180, a = c.chroma * std::cos(angle), b = c.chroma * std::sin(angle);
  const auto cube = [](double v) { return v * v * v; };
  const double l = cube(c.lightness + 0.3963377774 * a + 0.2158037573 * b);
  const double m = cube(c.lightness - 0.1055613458 * a - 0.0638541728 * b);
  const double s = cube(c.lightness - 0.0894841775 * a - 1.2914855480 * b);
  const auto unit = [](double v) { return static_cast<float>(std::clamp(v, 0.0, 1.0)); };
  return {unit(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          unit(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          unit(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

}  // namespace

Color from_srgb(double r, double g, double b) {
  return {static_cast<float>(to_linear(r)), static_cast<float>(to_linear(g)), static_cast<float>(to_linear(b))};
}

std::uint8_t to_srgb(float linear) {
  const double v = std::clamp(static_cast<double>(linear), 0.0, 1.0);
  const double s = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * s));
}

Color sequential(double t) {
  // Blue violet, blue, teal, green, lime, yellow; chroma stays inside what screens show, so nothing is clipped to a
  // band.
  static constexpr std::array<Lch, 6> points{{{0.49, 0.125, 280},
                                              {0.57, 0.115, 248},
                                              {0.66, 0.098, 208},
                                              {0.75, 0.125, 165},
                                              {0.82, 0.160, 130},
                                              {0.91, 0.165, 101}}};
  const double x = std::clamp(std::isfinite(t) ? t : 0.0, 0.0, 1.0) * (points.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(x), points.size() - 2);
  const double f = x - static_cast<double>(k);
  const auto mix = [f](double a, double b) { return a + (b - a) * f; };
  const Lch &a = points[k], &b = points[k + 1];
  return from_oklch({mix(a.lightness, b.lightness), mix(a.chroma, b.chroma), mix(a.hue, b.hue)});
}

Color categorical(std::size_t index) {
  static constexpr std::array<Lch, 10> table{{{0.62, 0.13, 250},
                                              {0.76, 0.15, 70},
                                              {0.66, 0.13, 155},
                                              {0.62, 0.18, 25},
                                              {0.60, 0.15, 310},
                                              {0.80, 0.10, 200},
                                              {0.52, 0.08, 60},
                                              {0.75, 0.12, 350},
                                              {0.82, 0.15, 110},
                                              {0.60, 0.01, 250}}};
  return from_oklch(table[index % table.size()]);
}

}  // namespace dem::render
