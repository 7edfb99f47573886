#include "libcontact/methods/plane_slope.h"

#include <cmath>

#include "libcontact/methods/depth_spread.h"
#include "libcontact/methods/overlap_moments.h"

namespace contact {

template <class Visit>
void PlaneOverlap::each_triangle(Visit&& visit) const {
  std::uint32_t first = 0;
  for (const std::uint32_t end : ends_) {
    const DepthPoint& a = points_[first];
    for (std::uint32_t i = first + 1; i + 1 < end; ++i) {
      const DepthPoint &b = points_[i], &c = points_[i + 1];
      visit(0.5 * std::abs((b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u)), a, b, c);
    }
    first = end;
  }
}

bool PlaneOverlap::slope(const PlaneFrame& plane, double size, OverlapDepth& out) const {
  if (points_.size() < 3) return false;
  const double u0 = points_[0].u, v0 = points_[0].v;
  // ∫h, ∫x h, ∫x x h with x = (u, v, h) about (u0, v0, 0); ∫h² is twice ∫z, ∫h³ three times ∫z².
  double h = 0, uh = 0, vh = 0, hh = 0, uuh = 0, vvh = 0, uvh = 0, uhh = 0, vhh = 0, hhh = 0;
  each_triangle([&](double area, const DepthPoint& a, const DepthPoint& b, const DepthPoint& c) {
    const double au = a.u - u0, bu = b.u - u0, cu = c.u - u0, av = a.v - v0, bv = b.v - v0, cv = c.v - v0;
    const double t12 = area / 12, t60 = area / 60;
    const double su = au + bu + cu, sv = av + bv + cv, sh = a.h + b.h + c.h;
    const double uh2 = au * a.h + bu * b.h + cu * c.h, vh2 = av * a.h + bv * b.h + cv * c.h,
                 hh2 = a.h * a.h + b.h * b.h + c.h * c.h, uu2 = au * au + bu * bu + cu * cu,
                 vv2 = av * av + bv * bv + cv * cv, uv2 = au * av + bu * bv + cu * cv;
    // ∫xyz = T/60 (Σx Σy Σz + Σx Σyz + Σy Σxz + Σz Σxy + 2 Σxyz)
    const auto third = [&](double x, double y, double z, double yz, double xz, double xy, double xyz) {
      return t60 * (x * y * z + x * yz + y * xz + z * xy + 2 * xyz);
    };
    h += area / 3 * sh;
    uh += t12 * (su * sh + uh2);
    vh += t12 * (sv * sh + vh2);
    hh += t12 * (sh * sh + hh2);
    uuh += third(su, su, sh, uh2, uh2, uu2, au * au * a.h + bu * bu * b.h + cu * cu * c.h);
    vvh += third(sv, sv, sh, vh2, vh2, vv2, av * av * a.h + bv * bv * b.h + cv * cv * c.h);
    uvh += third(su, sv, sh, vh2, uh2, uv2, au * av * a.h + bu * bv * b.h + cu * cv * c.h);
    uhh += third(su, sh, sh, hh2, uh2, uh2, au * a.h * a.h + bu * b.h * b.h + cu * c.h * c.h);
    vhh += third(sv, sh, sh, hh2, vh2, vh2, av * a.h * a.h + bv * b.h * b.h + cv * c.h * c.h);
    hhh += third(sh, sh, sh, hh2, hh2, hh2, a.h * a.h * a.h + b.h * b.h * b.h + c.h * c.h * c.h);
  });
  if (!(h > 0)) return false;
  const double w = 1 / h, u = w * uh, v = w * vh, z = 0.5 * w * hh;
  const double uu = w * uuh - u * u, vv = w * vvh - v * v, uv = w * uvh - u * v;
  const double uz = 0.5 * w * uhh - u * z, vz = 0.5 * w * vhh - v * z, zz = w * hhh / 3 - z * z;
  Tilt tilt;
  if (!find_tilt(uu, vv, zz, uv, uz, vz, tilt)) return false;
  const double variance = tilt.variance;
  double sum = 0, along_u = 0, along_v = 0;  // ∫(r² − σ²) (1, u, v) over the plane
  each_triangle([&](double area, const DepthPoint& a, const DepthPoint& b, const DepthPoint& c) {
    const auto residual = [&](const DepthPoint& p) {
      return z + tilt.u * (p.u - u0 - u) + tilt.v * (p.v - v0 - v);
    };  // −r
    const CornerWeights at_corner(area, residual(a), residual(b), residual(c), variance);
    sum += at_corner.sum();
    along_u += at_corner.a * (a.u - u0) + at_corner.b * (b.u - u0) + at_corner.c * (c.u - u0);
    along_v += at_corner.a * (a.v - v0) + at_corner.b * (b.v - v0) + at_corner.c * (c.v - v0);
  });
  if (!(sum > 0)) return false;
  out.depth = std::sqrt(12 * variance);  // (1)
  if (!(out.depth > least_depth * size)) return false;
  out.gain = out.depth / (2 * variance * h) * sum;
  out.normal = -plane.normal;
  out.point = plane(u0 + along_u / sum, v0 + along_v / sum, -z);
  out.screw = 0;
  return true;
}

}  // namespace contact
