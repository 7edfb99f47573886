// Assemblies of equal balls that stick: the largest frequency of all their motions, against the bound that the monitor
// of a run takes, the largest sum of rows of two bodies that touch (Anderson & Morley).
//   λ = largest eigenvalue of M⁻¹K over translations and rotations;  bound = max over contacts of (row_a + row_b),
//   row = Σ over the contacts of a body of max(kn/m, (7/2) kt/m);  limit of the step = 2/sqrt(λ)               (1)
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/laws/contacts.h"
#include "bench/laws/report.h"
#include "shapes/math/random.h"

namespace laws {
namespace {

struct Touch {
  std::size_t a, b;
  Vec3d normal;
};
struct Assembly {
  const char* name;
  std::size_t count;
  std::vector<Touch> touches;
};

// n³ cells of a cubic lattice with a basis, periodic; diameter 1.
Assembly lattice(const char* name, int n, const std::vector<Vec3d>& basis, double cell) {
  Assembly out{name, static_cast<std::size_t>(n * n * n) * basis.size(), {}};
  std::vector<Vec3d> x;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k)
        for (const Vec3d& b : basis) x.push_back((Vec3d{double(i), double(j), double(k)} + b) * cell);
  const double box = n * cell;
  for (std::size_t a = 0; a < x.size(); ++a)
    for (std::size_t b = a + 1; b < x.size(); ++b) {
      Vec3d d = x[b] - x[a];
      for (int k = 0; k < 3; ++k) d[k] -= box * std::round(d[k] / box);
      if (norm(d) < 1 + 1e-9) out.touches.push_back({a, b, normalized(d)});
    }
  return out;
}

// A row of balls that touch.
Assembly chain(std::size_t n) {
  Assembly out{"a row of 20 balls", n, {}};
  for (std::size_t i = 0; i + 1 < n; ++i) out.touches.push_back({i, i + 1, {1, 0, 0}});
  return out;
}

// Balls dropped one by one on the deepest place among those that are there: every one touches three.
Assembly heap(std::size_t n) {
  Assembly out{"a heap, every ball on three", n, {}};
  std::vector<Vec3d> x{{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}};
  out.touches = {{0, 1, x[1] - x[0]}, {1, 2, x[2] - x[1]}, {0, 2, x[2] - x[0]}};
  shapes::Random random(3, 0, 0);
  while (x.size() < n) {
    const auto pick = [&] { return static_cast<std::size_t>(random.bits() % x.size()); };
    const std::size_t i = pick(), j = pick(), k = pick();
    const Vec3d a = x[j] - x[i], b = x[k] - x[i], up = cross(a, b);
    const double area2 = dot(up, up);
    if (!(area2 > 0.1)) continue;
    // The centre of the circle through the three, then up until all are one diameter away.
    const Vec3d centre = (cross(up, a) * dot(b, b) + cross(b, up) * dot(a, a)) * (0.5 / area2);
    const double rise2 = 1 - dot(centre, centre);
    if (!(rise2 > 0)) continue;
    const Vec3d place = x[i] + centre + up * ((random.uniform() < 0.5 ? -1 : 1) * std::sqrt(rise2 / area2));
    if (std::any_of(x.begin(), x.end(), [&](const Vec3d& y) { return norm(y - place) < 1 - 1e-9; })) continue;
    for (std::size_t m = 0; m < x.size(); ++m)
      if (norm(x[m] - place) < 1 + 1e-9) out.touches.push_back({m, x.size(), normalized(place - x[m])});
    x.push_back(place);
  }
  return out;
}

// Mass 1, radius ½.
double largest_eigenvalue(const Assembly& s, double kn, double kt) {
  const double radius = 0.5, inertia = 0.4 * radius * radius;
  std::vector<Vec3d> u(s.count), w(s.count), f(s.count), t(s.count);
  shapes::Random random(1, 0, 0);
  for (std::size_t i = 0; i < s.count; ++i)
    for (int k = 0; k < 3; ++k) u[i][k] = random.uniform(-1, 1), w[i][k] = random.uniform(-1, 1);
  double value = 0;
  for (int step = 0; step < 3000; ++step) {
    std::fill(f.begin(), f.end(), Vec3d{});
    std::fill(t.begin(), t.end(), Vec3d{});
    for (const Touch& c : s.touches) {
      const Vec3d lever = c.normal * radius;
      const Vec3d d = u[c.a] + cross(w[c.a], lever) - u[c.b] + cross(w[c.b], lever);
      const double along = dot(d, c.normal);
      const Vec3d force = c.normal * (kn * along) + (d - c.normal * along) * kt;
      f[c.a] += force;
      f[c.b] -= force;
      t[c.a] += cross(lever, force);
      t[c.b] += cross(lever, force);
    }
    // In the norm of M: turns count by their inertia.
    double square = 0, before = 0;
    for (std::size_t i = 0; i < s.count; ++i) {
      before += dot(u[i], u[i]) + inertia * dot(w[i], w[i]);
      u[i] = f[i];
      w[i] = t[i] * (1 / inertia);
      square += dot(u[i], u[i]) + inertia * dot(w[i], w[i]);
    }
    value = std::sqrt(square / before);
    const double scale = 1 / std::sqrt(square);
    for (std::size_t i = 0; i < s.count; ++i) {
      u[i] = u[i] * scale;
      w[i] = w[i] * scale;
    }
  }
  return value;
}

}  // namespace

void assemblies(Report& r) {
  r.heading("assemblies that stick, ν = 0.3: the step that is stable over the bound of the monitor, not below 1");
  const double kn = 1, kt = 2 * (1 - 0.3) / (2 - 0.3), h = 0.5, root = std::sqrt(2.0);
  const std::vector<Assembly> all{
      chain(20), lattice("simple cubic, 4³", 4, {{0, 0, 0}}, 1),
      lattice("face-centred cubic, 3³ cells", 3, {{0, 0, 0}, {h, h, 0}, {h, 0, h}, {0, h, h}}, root), heap(150)};
  for (const Assembly& s : all) {
    std::vector<double> row(s.count);
    const double mode = std::max(kn, 3.5 * kt);
    for (const Touch& c : s.touches) {
      row[c.a] += mode;
      row[c.b] += mode;
    }
    double bound = 0;
    for (const Touch& c : s.touches) bound = std::max(bound, row[c.a] + row[c.b]);
    r.at_least(fmt::format("{}, {:.2f} contacts a ball", s.name,
                           2.0 * static_cast<double>(s.touches.size()) / static_cast<double>(s.count)),
               1, std::sqrt(bound / largest_eigenvalue(s, kn, kt)));
  }
}

}  // namespace laws
