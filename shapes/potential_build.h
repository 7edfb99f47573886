// Building potential particles, and what they look like.
//
// Refused with the name, the value and what is allowed: more than 64 planes, a plane whose normal vanishes or whose
// distance from the origin is not > 0 (so the origin is inside), k outside 0 < k <= 1, r or R not > 0, and faces
// flatter than doubles can tell apart: (1 − k)R²/(k r²) above 10^10, or mass properties that cannot be found to their
// tolerance. Everything is found in units of a power of two near the size: the same input in other units gives the same
// bits, scaled. Mass properties: volume, centre and moments by adaptive quadrature over directions, each to 1e-8 of its
// kind (of the volume; of √(∫1 ∫x²); of √(∫x² ∫y²)); what it cannot tell from zero is zero, so that symmetric bodies
// keep their axes. Tests: tests/shapes/potential_particle.cpp.
#pragma once

#include <span>

#include "shapes/export.h"
#include "shapes/polyhedron_build.h"
#include "shapes/potential_particle.h"

namespace shapes {

// Planes normal·x <= offset about the origin, which is the centre of (1); normals need not be unit.
// `tolerance`: of the mass properties, relative, in place of 1e-8.
SHAPES_API PotentialParticle make_potential_particle(std::span<const HalfSpace> planes, double k, double r, double R,
                                                     Frame frame, double tolerance = 1e-8);
// The same body with every length multiplied by s > 0.
SHAPES_API PotentialParticle scaled(const PotentialParticle& p, double s);
// A polyhedron inscribed in the body, for drawings only: the hull of its support points along about 400 directions.
SHAPES_API Polyhedron drawing_of(const PotentialParticle& body);

namespace potential {
// Mass properties in the body frame by quadrature to `tolerance` (relative); `error`: its own estimate, relative.
MassProperties mass_by_quadrature(const PotentialParticle& p, double tolerance, double& error);
}  // namespace potential

}  // namespace shapes
