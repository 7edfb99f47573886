#include "tests/reference/climb.h"

namespace reference {
namespace {

void local(const Piece& p, const Vector& n, Vector& point, Matrix& hessian) {
  hessian = Matrix{};
  if (p.corner != nullptr)
    point = *p.corner;
  else
    p.core->at(n, point, hessian);
}

struct Local {
  Vector w;
  Matrix hessian;
  Real f;
};

Local local(const Piece& a, const Piece& b, const Vector& d, const Vector& n) {
  Vector xa, xb;
  Matrix ha, hb;
  local(a, n, xa, ha);
  local(b, -n, xb, hb);
  Local at{d + xb - xa, ha, 0};
  for (int i = 0; i < 3; ++i) at.hessian.row[i] += hb.row[i];
  at.f = dot(n, at.w);
  return at;
}

}  // namespace

Vector climb(const Piece& a, const Piece& b, const Vector& d, Vector n, const Vector* axis) {
  const Real tiny("1e-36");
  Local at = local(a, b, d, n);
  for (int iteration = 0; iteration < 80; ++iteration) {
    Vector t1, t2;
    if (axis != nullptr)
      t1 = cross(*axis, n), t2 = {};
    else
      tangent_frame(n, t1, t2);
    const Real r1 = dot(t1, at.w), r2 = dot(t2, at.w);
    if (r1 * r1 + r2 * r2 < tiny * tiny) break;
    Real k11 = dot(t1, at.hessian * t1) + at.f, k12 = dot(t1, at.hessian * t2),
         k22 = axis != nullptr ? Real(1) : Real(dot(t2, at.hessian * t2) + at.f);
    // Not a maximum of the quadratic model: shifted until it is one.
    const Real trace = (k11 + k22) / 2;
    const Real spread = sqrt((k11 - k22) * (k11 - k22) / 4 + k12 * k12);
    if (axis != nullptr) {
      if (k11 <= 0) k11 = -k11 + norm(at.w) / 4;
    } else if (trace - spread <= 0) {
      const Real shift = 2 * (spread - trace) + norm(at.w) / 16;
      k11 += shift, k22 += shift;
    }
    const Real determinant = k11 * k22 - k12 * k12;
    Real s1 = (k22 * r1 - k12 * r2) / determinant, s2 = (k11 * r2 - k12 * r1) / determinant;
    const Real length = sqrt(s1 * s1 + s2 * s2);
    if (length > 1) s1 /= length, s2 /= length;
    bool moved = false;
    for (int halving = 0; halving < 60 && !moved; ++halving, s1 /= 2, s2 /= 2) {
      const Vector next = normalized(n + s1 * t1 + s2 * t2);
      const Local there = local(a, b, d, next);
      if (there.f < at.f) continue;
      moved = true;
      n = next;
      at = there;
    }
    if (!moved) break;
  }
  return n;
}

}  // namespace reference
