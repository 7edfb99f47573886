// The search of support_newton.h, (1) to (5), with every safeguard: what it falls back to from ellipsoid_search.h.
//
// Cuts of the step as often as needed, a shifted matrix where (3) is not positive definite, the tangent plane in a
// frame that keeps its digits at any aspect ratio, and the ten starts of a pair that overlaps by more than m.
#pragma once

#include "libcontact/contact.h"
#include "libcontact/kernels/ellipsoid_search.h"

namespace contact {

enum class Certainty { none, proven, best_known, not_converged };  // of the upper bound; none: a pair that is no pair

// `start`: unit, or zero for a cold one. Lengths in a power of two near the pair's extent. When it stops at a proof the
// outcome says so and only `lower` and `normal` are answers.
EllipsoidAnswer<double> climb_ellipsoids(const EllipsoidPair<double>& bodies, const Vec3d& start, bool stop_at_proof,
                                         Certainty& certainty);

}  // namespace contact
