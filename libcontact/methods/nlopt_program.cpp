#include "libcontact/methods/nlopt_program.h"

#include <nlopt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

namespace contact::nlopt_program {

namespace {

constexpr int evaluation_limit = 2000;

struct Destroy {
  void operator()(nlopt_opt o) const { nlopt_destroy(o); }
};
using Problem = std::unique_ptr<std::remove_pointer_t<nlopt_opt>, Destroy>;

nlopt_algorithm code_of(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::cobyla:
      return NLOPT_LN_COBYLA;
    case Algorithm::slsqp:
      return NLOPT_LD_SLSQP;
    case Algorithm::mma:
      return NLOPT_LD_MMA;
    case Algorithm::ccsa_quadratic:
      return NLOPT_LD_CCSAQ;
    default:
      return NLOPT_AUGLAG;
  }
}
// The search within an augmented Lagrangian.
nlopt_algorithm inner_code_of(Algorithm algorithm) {
  if (algorithm == Algorithm::augmented_mma) return NLOPT_LD_MMA;
  return algorithm == Algorithm::augmented_cobyla ? NLOPT_LN_COBYLA : NLOPT_LD_LBFGS;
}
bool is_augmented(Algorithm algorithm) { return code_of(algorithm) == NLOPT_AUGLAG; }

// What NLopt calls back.
struct Linear {
  const HalfSpaces& planes;
  static double objective(unsigned, const double* x, double* slope, void*) {
    if (slope != nullptr) std::fill_n(slope, 4, 0.0), slope[3] = 1;
    return x[3];
  }
  static void constraints(unsigned m, double* value, unsigned, const double* x, double* slope, void* self) {
    const HalfSpaces& p = static_cast<const Linear*>(self)->planes;
    for (unsigned i = 0; i < m; ++i) {
      value[i] = dot(p.normal[i], Vec3d{x[0], x[1], x[2]}) + x[3] - p.offset[i];
      if (slope == nullptr) continue;
      for (int k = 0; k < 3; ++k) slope[4 * i + static_cast<unsigned>(k)] = p.normal[i][k];
      slope[4 * i + 3] = 1;
    }
  }
};

struct Potentials {
  const Ellipsoid &a, &b;
  double value(const Ellipsoid& e, const Vec3d& x) const {
    const Vec3d u = in_unit_ball(e, x - e.centre);
    return dot(u, u) - 1;
  }
  // f_A + sign f_B
  double combined(const double* at, double* slope, double sign) const {
    const Vec3d x{at[0], at[1], at[2]};
    if (slope != nullptr) {
      const Vec3d g = gradient(a, x) + sign * gradient(b, x);
      for (int k = 0; k < 3; ++k) slope[k] = g[k];
    }
    return value(a, x) + sign * value(b, x);
  }
  static double sum(unsigned, const double* x, double* slope, void* self) {
    return static_cast<const Potentials*>(self)->combined(x, slope, 1);
  }
  static double difference(unsigned, const double* x, double* slope, void* self) {
    return static_cast<const Potentials*>(self)->combined(x, slope, -1);
  }
};

// Stops, bounds, and the run; x is where it began and ends.
template <std::size_t n>
Optimum solve(nlopt_opt o, std::array<double, n>& x, double size, double tolerance) {
  nlopt_set_lower_bounds1(o, -4 * size);
  nlopt_set_upper_bounds1(o, 4 * size);
  nlopt_set_xtol_abs1(o, tolerance);
  nlopt_set_maxeval(o, evaluation_limit);
  double value = 0;
  const nlopt_result result = nlopt_optimize(o, x.data(), &value);
  Optimum best;
  best.evaluations = nlopt_get_numevals(o);
  // Limits of rounding end a search that has arrived; what it found is judged by the caller.
  best.converged = (result > 0 && result != NLOPT_MAXEVAL_REACHED) || result == NLOPT_ROUNDOFF_LIMITED;
  best.x = {x[0], x[1], x[2]};
  for (const double v : x) best.converged = best.converged && std::isfinite(v);
  return best;
}

}  // namespace

std::string name_of(Algorithm algorithm) {
  const std::string name = nlopt_algorithm_to_string(code_of(algorithm));
  return is_augmented(algorithm) ? name + " with " + nlopt_algorithm_to_string(inner_code_of(algorithm)) : name;
}

Optimum largest_ball(const HalfSpaces& planes, const Vec3d& start, double size, double tolerance, Algorithm algorithm) {
  const Problem o(nlopt_create(code_of(algorithm), 4));
  if (!o) return {};
  Linear linear{planes};
  const std::vector<double> slack(planes.normal.size(), 1e-2 * tolerance);
  nlopt_set_max_objective(o.get(), Linear::objective, nullptr);
  nlopt_add_inequality_mconstraint(o.get(), static_cast<unsigned>(planes.normal.size()), Linear::constraints, &linear,
                                   slack.data());
  if (is_augmented(algorithm)) {
    const Problem inner(nlopt_create(inner_code_of(algorithm), 4));
    if (!inner) return {};
    nlopt_set_xtol_abs1(inner.get(), tolerance);
    nlopt_set_maxeval(inner.get(), evaluation_limit);
    nlopt_set_local_optimizer(o.get(), inner.get());  // keeps a copy
  }
  nlopt_set_initial_step1(o.get(), 0.125 * size);
  std::array<double, 4> x{start.x, start.y, start.z, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < planes.normal.size(); ++i)
    x[3] = std::min(x[3], planes.offset[i] - dot(planes.normal[i], start));
  Optimum best = solve(o.get(), x, size, tolerance);
  // The t that is feasible where it ended.
  best.t = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < planes.normal.size(); ++i)
    best.t = std::min(best.t, planes.offset[i] - dot(planes.normal[i], best.x));
  return best;
}

Vec3d in_unit_ball(const Ellipsoid& e, const Vec3d& from_centre) {
  const Vec3d y = transposed_times(e.rotation, from_centre);
  return {y.x / e.axes.x, y.y / e.axes.y, y.z / e.axes.z};
}

Vec3d gradient(const Ellipsoid& e, const Vec3d& x) {
  const Vec3d u = in_unit_ball(e, x - e.centre);
  return e.rotation * Vec3d{2 * u.x / e.axes.x, 2 * u.y / e.axes.y, 2 * u.z / e.axes.z};
}

Optimum least_equal_potential(const Ellipsoid& a, const Ellipsoid& b, double size, double tolerance) {
  const Problem o(nlopt_create(NLOPT_LD_SLSQP, 3));
  if (!o) return {};
  Potentials potentials{a, b};
  nlopt_set_min_objective(o.get(), Potentials::sum, &potentials);
  nlopt_add_equality_constraint(o.get(), Potentials::difference, &potentials, tolerance);
  const Vec3d start = 0.5 * (a.centre + b.centre);
  std::array<double, 3> x{start.x, start.y, start.z};
  Optimum best = solve(o.get(), x, size, tolerance);
  best.t = 0.5 * potentials.combined(x.data(), nullptr, 1);
  return best;
}

}  // namespace contact::nlopt_program
