#include "shapes/geometry.h"

#include <cmath>
#include <numbers>

namespace shapes {

MassProperties mass_properties(const Sphere& s) { return mass_properties(Ellipsoid{{s.radius, s.radius, s.radius}}); }

MassProperties mass_properties(const Ellipsoid& e) {
  const Vec3d& s = e.semi_axes;
  const double volume = (4.0 / 3.0 * std::numbers::pi) * (s.x * s.y * s.z);
  const double fifth = volume / 5;
  return {volume,
          {},
          Mat3d::diagonal(
              {fifth * (s.y * s.y + s.z * s.z), fifth * (s.z * s.z + s.x * s.x), fifth * (s.x * s.x + s.y * s.y)})};
}

MassProperties mass_properties(const Polyhedron& p) { return p.mass; }

double circumradius(const Sphere& s) { return s.radius; }
double circumradius(const Ellipsoid& e) { return max_abs(e.semi_axes); }
double circumradius(const Polyhedron& p) { return p.circumradius; }

double inscribed_radius(const Sphere& s) { return s.radius; }
double inscribed_radius(const Ellipsoid& e) {
  return std::fmin(e.semi_axes.x, std::fmin(e.semi_axes.y, e.semi_axes.z));
}
double inscribed_radius(const Polyhedron& p) { return p.inscribed_radius; }

double equivalent_radius(double volume) {
  int exponent = 0;
  const double mantissa = std::frexp(volume, &exponent);
  const int whole =
      exponent >= 0 ? exponent / 3 : -((2 - exponent) / 3);  // floor: the root is taken of a number in [1/2, 4)
  return std::ldexp(std::cbrt(std::ldexp(mantissa, exponent - 3 * whole) * (3.0 / (4.0 * std::numbers::pi))), whole);
}

}  // namespace shapes
