// The constrained minimisations of Boon, Houlsby & Utili as NLopt is asked to solve them. Inner header; the library
// that was built without NLopt has none of it.
//
//   max t   subject to   a_i·x + t <= b_i   for every plane of both bodies, a_i unit                           (1)
//   min f_A + f_B   subject to   f_A = f_B,   f = |D⁻¹Rᵀ(x − c)|² − 1 of an ellipsoid                           (2)
//
// (1) begins midway between the centres, with the t that is feasible there, within a box of the extent.
#pragma once

#include <string>
#include <vector>

#include "libcontact/contact.h"

namespace contact::nlopt_program {

struct HalfSpaces {
  std::vector<Vec3d> normal;   // unit, those of a first
  std::vector<double> offset;  // units
  std::size_t of_a = 0;
};

enum class Algorithm { cobyla, slsqp, mma, ccsa_quadratic, augmented_lbfgs, augmented_mma, augmented_cobyla };
inline constexpr Algorithm algorithms[] = {
    Algorithm::cobyla,          Algorithm::slsqp,           Algorithm::mma,
    Algorithm::ccsa_quadratic,  Algorithm::augmented_lbfgs, Algorithm::augmented_mma,
    Algorithm::augmented_cobyla};
std::string name_of(Algorithm algorithm);

struct Optimum {
  bool converged = false;
  int evaluations = 0;
  Vec3d x{};
  double t = 0;  // of (2): f_A = f_B
};

// (1), to `tolerance` in x and t, lengths as those of the half-spaces; `size`: the extent.
Optimum largest_ball(const HalfSpaces& planes, const Vec3d& start, double size, double tolerance, Algorithm algorithm);

struct Ellipsoid {
  Vec3d centre, axes;
  Mat3d rotation;
};
// (2) by SLSQP.
Optimum least_equal_potential(const Ellipsoid& a, const Ellipsoid& b, double size, double tolerance);

// D⁻¹Rᵀ(x − c), and the gradient of f at x.
Vec3d in_unit_ball(const Ellipsoid& e, const Vec3d& from_centre);
Vec3d gradient(const Ellipsoid& e, const Vec3d& x);

}  // namespace contact::nlopt_program
