#include <algorithm>
#include <cmath>
#include <numeric>

#include "shapes/form.h"
#include "shapes/generate.h"
#include "shapes/geometry.h"
#include "shapes/math/random.h"
#include "shapes/polyhedron_build.h"

namespace shapes {
namespace {

double measure(const FormTarget& t, int k) { return k == 0 ? t.elongation : k == 1 ? t.flatness : t.sphericity_cubed; }

// Orders rows as the leaves of a tree that halves them along each measure in turn; which half comes first is random, so
// that a place among the leaves says nothing about the finer ones.
struct Tree {
  std::span<const FormTarget> sample;
  std::uint64_t seed, stream;

  void halve(std::span<std::size_t> rows, int k, std::uint64_t node) const {
    if (rows.size() < 2) return;
    std::sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
      const double x = measure(sample[a], k), y = measure(sample[b], k);
      return x < y || (x == y && a < b);
    });
    if ((Random(seed, stream, node).bits() & 1) != 0) std::reverse(rows.begin(), rows.end());
    const std::size_t half = rows.size() / 2;
    halve(rows.first(half), (k + 1) % 3, 2 * node);
    halve(rows.subspan(half), (k + 1) % 3, 2 * node + 1);
  }
};

double van_der_corput(std::uint64_t i) {
  double x = 0;
  for (double digit = 0.5; i != 0; i >>= 1, digit *= 0.5) x += (i & 1) != 0 ? digit : 0;
  return x;
}

// Each point is the farthest of three random ones from those that are there.
std::vector<Vec3d> points_on_sphere(std::size_t count, Random& random) {
  std::vector<Vec3d> points;
  while (points.size() < count) {
    Vec3d best{};
    double farthest = -1;
    for (int k = 0; k < 3; ++k) {
      const Vec3d x = random.direction();
      double nearest = 5;
      for (const Vec3d& p : points) nearest = std::min(nearest, dot(x - p, x - p));
      if (nearest > farthest) {
        farthest = nearest;
        best = x;
      }
    }
    points.push_back(best);
  }
  return points;
}

// A stretch along the axes of its form keeps faces, edges and what is convex.
void stretch(Polyhedron& p, const Form& f, double across, double through) {
  for (Vec3d& v : p.vertices)
    v += ((across - 1) * dot(v, f.across)) * f.across + ((through - 1) * dot(v, f.through)) * f.through;
  for (auto& face : p.faces) {
    Vec3d& n = face.normal;
    n += ((1 / across - 1) * dot(n, f.across)) * f.across + ((1 / through - 1) * dot(n, f.through)) * f.through;
    n *= 1 / norm(n);
    face.offset = dot(n, p.vertices[p.face_vertices[face.first]]);
  }
}

constexpr double close = 1e-2;

// Stretched until its ratios are those wanted, as nearly as that settles; what they are off by.
double fit(Polyhedron& p, const FormTarget& target) {
  Polyhedron best;
  double off = 2;
  for (int i = 0; i < 40; ++i) {
    const Form f = form_of(p);
    const double across = target.elongation / (f.width / f.length), through = target.flatness / (f.thickness / f.width);
    const double error = std::max(std::abs(across - 1), std::abs(through - 1));
    if (i == 0 || error < off) {
      off = error;
      best = p;
    }
    if (off < 2e-3 || (off < close && i >= 20)) break;
    const double gently = i < 10 ? 1 : 0.5;  // near W = L the longest line and the one across it change places
    stretch(p, f, 1 + gently * (across - 1), 1 + gently * (across * through - 1));
  }
  p = std::move(best);
  return off;
}

}  // namespace

std::vector<std::size_t> spread(std::span<const FormTarget> sample, std::size_t count, std::uint64_t seed,
                                std::uint64_t stream) {
  std::vector<std::size_t> rows(sample.size()), chosen;
  std::iota(rows.begin(), rows.end(), std::size_t(0));
  Tree{sample, seed, stream}.halve(rows, 0, 1);
  const double start = Random(seed, stream, 0).uniform();
  for (std::size_t i = 0; i < count; ++i) {
    const double x = start + van_der_corput(i);
    chosen.push_back(rows[static_cast<std::size_t>((x - std::floor(x)) * static_cast<double>(rows.size()))]);
  }
  return chosen;
}

Polyhedron grain_of_form(const FormTarget& target, std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
  constexpr std::uint64_t trials = 32;
  constexpr std::size_t fewest = 5, most = 64;
  constexpr double near = 0.015;  // of the cube: 0.5 % of the sphericity
  if (!(target.elongation > 0 && target.elongation <= 1 && target.flatness > 0 && target.flatness <= 1))
    throw Error("grain of W/L = " + std::to_string(target.elongation) + ", T/W = " + std::to_string(target.flatness) +
                ": allowed 0 < W/L, T/W <= 1");
  Polyhedron best;
  double off = -1;
  std::size_t points = 10;
  for (std::uint64_t k = 0; k < trials; ++k) {
    Random random(seed, stream, index * trials + k);
    std::vector<Vec3d> x = points_on_sphere(points, random);
    for (Vec3d& v : x) v = {v.x, v.y * target.elongation, v.z * (target.elongation * target.flatness)};
    Polyhedron p = polyhedron_from_points(x, Frame::as_given);
    const double misfit = fit(p, target);
    p = polyhedron_from_points(p.vertices, Frame::principal);
    const double sphericity = form_of(p).sphericity_cubed(), wanted = target.sphericity_cubed;
    double error = wanted > 0 ? std::abs(sphericity / wanted - 1) : 0;
    if (misfit > close) error = 1e3 * misfit;  // only where nothing else is found
    if (off < 0 || error < off) {
      off = error;
      best = std::move(p);
    }
    if (off < near) break;
    points = sphericity < wanted ? points + std::max<std::size_t>(1, points / 4) : points - points / 5 - 1;
    points = std::clamp(points, fewest, most);
  }
  return scaled(best, 0.5 / equivalent_radius(best.mass.volume));
}

}  // namespace shapes
