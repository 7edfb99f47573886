// Mass properties of the solid that closed polygons bound, by signed tetrahedra.
//   V       = Σ det(a, b, c) / 6                                   (1)
//   ∫x      = Σ det(a, b, c) / 24 · (a + b + c)                     (2)
//   ∫x xᵀ   = Σ det(a, b, c) / 120 · (aaᵀ + bbᵀ + ccᵀ + ssᵀ),  s = a + b + c   (3)
// with a, b, c relative to a point in the body, so that no term is much larger than the sum. Faces are cut into fans.
#include "shapes/convex.h"

namespace shapes::convex {

Vec3d accurate_cross(const Vec3d& a, const Vec3d& b) {
  const auto difference_of_products = [](double p, double q, double r, double s) {  // p q − r s
    const double rs = r * s;
    const double error = std::fma(-r, s, rs);
    return std::fma(p, q, -rs) + error;
  };
  return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
          difference_of_products(a.x, b.y, a.y, b.x)};
}

Vec3d area_vector(std::span<const Vec3d> vertices, std::span<const std::uint32_t> loop) {
  Vec3d sum{};
  const Vec3d& base = vertices[loop[0]];
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    sum += accurate_cross(vertices[loop[i]] - base, vertices[loop[i + 1]] - base);
  return 0.5 * sum;
}

MassProperties mass_of(std::span<const Vec3d> vertices, std::span<const Loop> loops) {
  Vec3d reference{};
  for (const Vec3d& v : vertices) reference += v;
  reference *= 1.0 / static_cast<double>(vertices.size());

  double six_volumes = 0, second[3][3] = {};
  Vec3d first{};
  for (const Loop& loop : loops) {
    const Vec3d a = vertices[loop[0]] - reference;
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      const Vec3d b = vertices[loop[i]] - reference, c = vertices[loop[i + 1]] - reference, s = a + b + c;
      const double det = dot(a, accurate_cross(b - a, c - a));
      six_volumes += det;  // (1)
      first += det * s;    // (2)
      for (int j = 0; j < 3; ++j)
        for (int k = 0; k < 3; ++k)
          second[j][k] += det * (a[j] * a[k] + b[j] * b[k] + c[j] * c[k] + s[j] * s[k]);  // (3)
    }
  }
  MassProperties m;
  m.volume = six_volumes / 6;
  const Vec3d shift{first.x / (4 * six_volumes), first.y / (4 * six_volumes), first.z / (4 * six_volumes)};
  m.centre = reference + shift;
  double moment[3][3];
  for (int j = 0; j < 3; ++j)
    for (int k = 0; k < 3; ++k) moment[j][k] = second[j][k] / 120 - m.volume * shift[j] * shift[k];
  for (int j = 0; j < 3; ++j)
    for (int k = 0; k < 3; ++k)
      m.inertia.row[j][k] = j == k ? moment[(j + 1) % 3][(j + 1) % 3] + moment[(j + 2) % 3][(j + 2) % 3]
                                   : -0.5 * (moment[j][k] + moment[k][j]);
  return m;
}

}  // namespace shapes::convex
