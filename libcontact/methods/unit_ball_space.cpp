#include "libcontact/methods/unit_ball_space.h"

#include <algorithm>
#include <cmath>

namespace contact {

UnitBallSpace unit_ball_space(const QuadricPair& pair) {
  constexpr int sweep_limit = 16;
  UnitBallSpace s{};
  const Vec3d& a = pair.axes_a;
  const Vec3d inverse{1 / a.x, 1 / a.y, 1 / a.z};
  Vec3d column[3];
  for (int j = 0; j < 3; ++j)
    column[j] = scaled(inverse, transposed_times(pair.rotation_a, pair.rotation_b.column(j))) * pair.axes_b[j];
  for (int sweep = 0; sweep < sweep_limit; ++sweep) {
    bool done = true;
    for (int p = 0; p < 2; ++p)
      for (int q = p + 1; q < 3; ++q) {
        const double pp = dot(column[p], column[p]), qq = dot(column[q], column[q]), pq = dot(column[p], column[q]);
        if (!(std::abs(pq) > 4 * epsilon * std::sqrt(pp) * std::sqrt(qq))) continue;
        done = false;
        const double zeta = 0.5 * (qq - pp) / pq;
        const double t = (zeta < 0 ? -1 : 1) / (std::abs(zeta) + std::sqrt(1 + zeta * zeta));
        const double cosine = 1 / std::sqrt(1 + t * t), sine = cosine * t;
        const Vec3d u = cosine * column[p] - sine * column[q];
        column[q] = sine * column[p] + cosine * column[q];
        column[p] = u;
      }
    if (done) break;
  }
  s.valid = true;
  for (int j = 0; j < 3; ++j) {
    s.sigma[j] = norm(column[j]);
    s.valid = s.valid && s.sigma[j] > 0x1p-400 && s.sigma[j] < 0x1p400;
    const Vec3d u = column[j] * (1 / s.sigma[j]);
    for (int i = 0; i < 3; ++i) s.turn.row[i][j] = u[i];
  }
  s.e = transposed_times(s.turn, scaled(inverse, transposed_times(pair.rotation_a, pair.d)));
  for (int i = 0; i < 3; ++i) {
    const Vec3d& r = pair.rotation_a.row[i];
    for (int j = 0; j < 3; ++j)
      s.to_world.row[i][j] = r.x * a.x * s.turn.row[0][j] + r.y * a.y * s.turn.row[1][j] + r.z * a.z * s.turn.row[2][j];
  }
  if (pair.flat) s.sigma.z = std::max(s.sigma.x, s.sigma.y);
  s.valid = s.valid && max_abs(s.e) < 0x1p400;
  return s;
}

}  // namespace contact
