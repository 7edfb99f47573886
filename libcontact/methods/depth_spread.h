// What (2) and (4) of overlap_depth.h take of second moments, u and v across the normal and z along it.
#pragma once

namespace contact {

struct Tilt {
  double u = 0, v = 0;  // β: of the overlap's middle
  double variance = 0;  // σ², what the tilt leaves along the normal
};
// False where the overlap has no extent across or along the normal.
inline bool find_tilt(double uu, double vv, double zz, double uv, double uz, double vz, Tilt& out) {
  const double determinant = uu * vv - uv * uv;
  if (!(determinant > 0x1p-100 * (uu * vv))) return false;
  const double inverse = 1 / determinant;
  out.u = (vv * uz - uv * vz) * inverse;
  out.v = (uu * vz - uv * uz) * inverse;
  out.variance = zz - out.u * uz - out.v * vz;  // (2)
  return out.variance > 0;
}

// ∫λ (r² − σ²) over a triangle, λ = 1 in one corner and 0 in the others; r linear, of these values in the corners.
struct CornerWeights {
  double a, b, c;
  CornerWeights(double area, double ra, double rb, double rc, double variance) {
    const double squares = ra * ra + rb * rb + rc * rc, total = ra + rb + rc;
    const double thirtieth = area * (1.0 / 30), level = area * (1.0 / 3) * variance;
    const auto of = [&](double own, double others) { return thirtieth * (squares + 2 * own * total + others) - level; };
    a = of(ra, rb * rc);
    b = of(rb, ra * rc);
    c = of(rc, ra * rb);
  }
  double sum() const { return a + b + c; }
};

}  // namespace contact
