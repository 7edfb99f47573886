#include "libdem/analysis/displacement.h"

#include <cmath>

#include "libdem/analysis/groups.h"
#include "libdem/analysis/near_bodies.h"

namespace dem::analysis {

namespace {

double range_of(const Snapshot& s, double asked) {
  if (asked > 0) return asked;
  double diameter = 0;
  for (const double r : s.bounding_radius) diameter += 2 * r / static_cast<double>(s.count());
  return 1.8 * diameter;
}

LocalGradient fitted(const AffineFit& fit, int dimension) {
  LocalGradient local;
  local.neighbours = static_cast<std::uint32_t>(fit.count());
  const std::optional<Mat3d> g = fit.gradient(dimension);
  if (!g) return local;
  local.fitted = true;
  local.gradient = *g;
  local.left_over = fit.left_over(*g);
  return local;
}

}  // namespace

Displacements displacements(const Snapshot& s, const Snapshot& reference) {
  Displacements u;
  u.reference = places_in(s, reference);
  u.of_body.resize(s.count());
  for (std::size_t i = 0; i < s.count(); ++i) {
    if (u.reference[i] == Groups::none) continue;
    ++u.known;
    const Vec3d& from = reference.position[u.reference[i]];
    Vec3d d = s.position[i] - from;
    for (int k = 0; k < s.dimension; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      if (!s.periodic[axis] || !reference.periodic[axis]) continue;
      const double now = (s.position[i][k] - s.lower[k]) / s.length[k],
                   then = (from[k] - reference.lower[k]) / reference.length[k];
      d[k] -= s.length[k] * std::nearbyint(now - then);  // (1)
    }
    u.of_body[i] = d;
  }
  return u;
}

std::vector<LocalGradient> displacement_gradients(const Snapshot& s, const Snapshot& reference, const Displacements& u,
                                                  double range) {
  const std::vector<std::uint32_t> now = places_in(reference, s);
  std::vector<LocalGradient> list(s.count());
  if (s.count() == 0 || reference.count() == 0) return list;
  const NearBodies near(reference, range_of(reference, range));
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < s.count(); ++i) {
    if (u.reference[i] == Groups::none) continue;
    AffineFit fit;
    const Vec3d& x = reference.position[u.reference[i]];
    near.each(u.reference[i], [&](std::uint32_t j, const Vec3d& d) {
      if (now[j] == Groups::none) return;
      Vec3d change = u.of_body[now[j]] - u.of_body[i];  // of an image also what the cell's faces have moved
      for (int k = 0; k < s.dimension; ++k) {
        if (!reference.periodic[static_cast<std::size_t>(k)]) continue;
        const double images = std::nearbyint((d[k] - (reference.position[j][k] - x[k])) / reference.length[k]);
        change[k] += images * (s.length[k] - reference.length[k]);
      }
      fit.add(d, change);
    });
    list[i] = fitted(fit, s.dimension);
  }
  return list;
}

std::vector<LocalGradient> velocity_gradients(const Snapshot& s, double range) {
  std::vector<LocalGradient> list(s.count());
  if (s.count() == 0) return list;
  const NearBodies near(s, range_of(s, range));
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < s.count(); ++i) {
    AffineFit fit;
    near.each(i, [&](std::uint32_t j, const Vec3d& d) { fit.add(d, s.velocity[j] - s.velocity[i]); });
    list[i] = fitted(fit, s.dimension);
  }
  return list;
}

std::vector<LocalGradient> box_gradients(const Snapshot& s, const Snapshot& reference, const Displacements& u,
                                         const Grid& grid) {
  std::vector<std::size_t> box(s.count(), Grid::none);
  std::vector<Vec3d> x(grid.size()), v(grid.size());
  std::vector<double> count(grid.size(), 0);
  const auto place = [&](std::size_t i) {  // relative to the middle of its box, by the image that is in it
    return reference.between(grid.centre(box[i]), reference.position[u.reference[i]]);
  };
  for (std::size_t i = 0; i < s.count(); ++i) {
    if (u.reference[i] == Groups::none) continue;
    box[i] = grid.index(reference.position[u.reference[i]]);
    if (box[i] == Grid::none) continue;
    count[box[i]] += 1;
    x[box[i]] += place(i);
    v[box[i]] += u.of_body[i];
  }
  std::vector<AffineFit> fit(grid.size());
  for (std::size_t i = 0; i < s.count(); ++i) {
    if (box[i] == Grid::none) continue;
    const double n = count[box[i]];
    fit[box[i]].add(place(i) - x[box[i]] * (1 / n), u.of_body[i] - v[box[i]] * (1 / n));
  }
  std::vector<LocalGradient> list;
  for (const AffineFit& f : fit) list.push_back(fitted(f, s.dimension));
  return list;
}

}  // namespace dem::analysis
