#include "libcontact/methods/patch.h"

#include <cmath>

namespace contact {

void DepthMoments::add(const DepthPoint* polygon, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    if (polygon[i].h > deepest.h) deepest = polygon[i];
  const DepthPoint a = polygon[0];
  for (std::size_t i = 1; i + 1 < count; ++i) {
    const DepthPoint b = polygon[i], c = polygon[i + 1];
    // Over a triangle of area T with linear coordinates λ: ∫λi = T/3, ∫λiλj = T/12 (1 + [i=j]), ∫λiλjλk = T/60 × (1, 2,
    // 6).
    const double area = 0.5 * std::abs((b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u));
    const double sum_h = a.h + b.h + c.h, sum_u = a.u + b.u + c.u, sum_v = a.v + b.v + c.v;
    const double sum_hu = a.h * a.u + b.h * b.u + c.h * c.u, sum_hv = a.h * a.v + b.h * b.v + c.h * c.v;
    const double sum_uu = a.u * a.u + b.u * b.u + c.u * c.u, sum_vv = a.v * a.v + b.v * b.v + c.v * c.v;
    const double sum_uv = a.u * a.v + b.u * b.v + c.u * c.v;
    const double sum_huu = a.h * a.u * a.u + b.h * b.u * b.u + c.h * c.u * c.u;
    const double sum_hvv = a.h * a.v * a.v + b.h * b.v * b.v + c.h * c.v * c.v;
    const double sum_huv = a.h * a.u * a.v + b.h * b.u * b.v + c.h * c.u * c.v;
    const double t12 = area / 12, t60 = area / 60;
    h += area / 3 * sum_h;
    hh += t12 * (sum_h * sum_h + a.h * a.h + b.h * b.h + c.h * c.h);
    hu += t12 * (sum_u * sum_h + sum_hu);
    hv += t12 * (sum_v * sum_h + sum_hv);
    huu += t60 * (sum_h * (sum_u * sum_u + sum_uu) + 2 * (sum_u * sum_hu + sum_huu));
    hvv += t60 * (sum_h * (sum_v * sum_v + sum_vv) + 2 * (sum_v * sum_hv + sum_hvv));
    huv += t60 * (sum_h * (sum_u * sum_v + sum_uv) + sum_u * sum_hv + sum_v * sum_hu + 2 * sum_huv);
  }
}

std::size_t clip(const DepthPoint* in, std::size_t count, double cu, double cv, double ch, double c, DepthPoint* out) {
  const auto side = [&](const DepthPoint& p) { return cu * p.u + cv * p.v + ch * p.h + c; };
  std::size_t kept = 0;
  DepthPoint previous = in[count - 1];
  double d_previous = side(previous);
  for (std::size_t i = 0; i < count; ++i) {
    const DepthPoint here = in[i];
    const double d = side(here);
    if ((d < 0) != (d_previous < 0)) {
      const double t = d_previous / (d_previous - d);
      out[kept++] = {previous.u + t * (here.u - previous.u), previous.v + t * (here.v - previous.v),
                     previous.h + t * (here.h - previous.h)};
    }
    if (!(d < 0)) out[kept++] = here;
    previous = here;
    d_previous = d;
  }
  return kept;
}

bool make_patch(const DepthMoments& m, const PlaneFrame& plane, Patch& patch) {
  if (!(m.h > 0)) return false;
  const double u = m.hu / m.h, v = m.hv / m.h;
  const double uu = std::fmax(m.huu / m.h - u * u, 0.0), vv = std::fmax(m.hvv / m.h - v * v, 0.0);
  const double uv = m.huv / m.h - u * v;
  patch.centre = plane(u, v, -0.5 * (m.hh / m.h));  // (2)
  patch.weight = m.h;
  const Vec3d& a = plane.u;
  const Vec3d& b = plane.v;
  const auto moment = [&](int i, int j) {
    return uu * a[i] * a[j] + vv * b[i] * b[j] + uv * (a[i] * b[j] + b[i] * a[j]);
  };
  patch.spread[0] = moment(0, 0);
  patch.spread[1] = moment(1, 1);
  patch.spread[2] = moment(2, 2);
  patch.spread[3] = moment(0, 1);
  patch.spread[4] = moment(0, 2);
  patch.spread[5] = moment(1, 2);
  return true;
}

Patch rotated(const Patch& patch, const Mat3d& rotation) {
  const double* s = patch.spread;
  const Mat3d half = rotation * Mat3d{{{s[0], s[3], s[4]}, {s[3], s[1], s[5]}, {s[4], s[5], s[2]}}};
  const auto entry = [&](int i, int j) { return dot(half.row[i], rotation.row[j]); };
  return {rotation * patch.centre,
          {entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2)},
          patch.weight};
}

}  // namespace contact
