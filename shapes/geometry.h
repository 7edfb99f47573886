// What every kind of body can say about itself: mass properties, radii, support points.
//
// All exact to rounding unless stated, in the body frame, and scaled exactly by a change of units by a power of two.
// Tests: tests/shapes/geometry.cpp.
#pragma once

#include "shapes/ellipsoid.h"
#include "shapes/export.h"
#include "shapes/mass.h"
#include "shapes/polyhedron.h"
#include "shapes/potential_particle.h"
#include "shapes/rounded_polyhedron.h"
#include "shapes/sphere.h"

namespace shapes {

// V = 4/3 π abc;  I = V/5 diag(b² + c², c² + a², a² + b²)   [m³, m⁵]
SHAPES_API MassProperties mass_properties(const Sphere& s);
SHAPES_API MassProperties mass_properties(const Ellipsoid& e);
SHAPES_API MassProperties mass_properties(const Polyhedron& p);
SHAPES_API MassProperties mass_properties(const RoundedPolyhedron& body);
SHAPES_API MassProperties mass_properties(const PotentialParticle& p);  // to 1e-8, found when it was built

// Radius of the smallest sphere about the body's origin that holds the body, m.
SHAPES_API double circumradius(const Sphere& s);
SHAPES_API double circumradius(const Ellipsoid& e);
SHAPES_API double circumradius(const Polyhedron& p);
SHAPES_API double circumradius(const RoundedPolyhedron& body);
SHAPES_API double circumradius(const PotentialParticle& p);  // at most 0.1 % larger

// Radius of the largest sphere about the body's origin that the body holds, m (not positive when the origin is
// outside).
SHAPES_API double inscribed_radius(const Sphere& s);
SHAPES_API double inscribed_radius(const Ellipsoid& e);
SHAPES_API double inscribed_radius(const Polyhedron& p);
SHAPES_API double inscribed_radius(const RoundedPolyhedron& body);
SHAPES_API double inscribed_radius(const PotentialParticle& p);

// Radius of the sphere of the same volume, r = (3V/4π)^(1/3), m; volume >= 0. Error 2 ulp.
SHAPES_API double equivalent_radius(double volume);

// Vertex farthest along n, which need not be unit; the lowest index of those that tie. Cost: one product per vertex.
inline Vec3d support(const Polyhedron& p, const Vec3d& n) {
  std::size_t best = 0;
  double farthest = dot(n, p.vertices[0]);
  for (std::size_t i = 1; i < p.vertices.size(); ++i) {
    const double reach = dot(n, p.vertices[i]);
    if (reach > farthest) {
      farthest = reach;
      best = i;
    }
  }
  return p.vertices[best];
}
SHAPES_API Vec3d support(const RoundedPolyhedron& body, const Vec3d& n);
SHAPES_API Vec3d support(const PotentialParticle& p, const Vec3d& n);

}  // namespace shapes
