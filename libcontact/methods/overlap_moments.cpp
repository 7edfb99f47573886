#include "libcontact/methods/overlap_moments.h"

#include <cmath>

namespace contact {

namespace {

using Face = OverlapBody::Face;

// Axes with n last.
struct Axes {
  Vec3d t, s, n;
  explicit Axes(const Vec3d& normal) : n(normal) {
    const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
    const Vec3d across = x <= y && x <= z ? Vec3d{1, 0, 0} : y <= z ? Vec3d{0, 1, 0} : Vec3d{0, 0, 1};
    t = cross(across, n);
    t *= 1 / norm(t);
    s = cross(n, t);
  }
  Vec3d operator()(const Vec3d& x) const { return {dot(t, x), dot(s, x), dot(n, x)}; }
};

// Vector area of the surface of one of the two.
void add_surface(const OverlapBody& body, const Face& f, Vec3d& sum) {
  const Vec3d& first = body.corner(f, 0);
  double area = 0;
  for (std::uint32_t k = 2; k < f.count; ++k)
    area += dot(f.normal, cross(body.corner(f, k - 1) - first, body.corner(f, k) - first));
  sum += (0.5 * area) * f.normal;
}

// ∫1, ∫x, ∫xxᵀ about a corner of the body, along Axes.
struct Moments {
  double volume = 0;
  Vec3d first{};
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
  // The cone over a triangle, apex in the origin.
  void add(double v, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    const Vec3d sum = a + b + c;
    volume += v;
    first += (0.25 * v) * sum;
    const double w = 0.05 * v;
    xx += w * (sum.x * sum.x + a.x * a.x + b.x * b.x + c.x * c.x);
    yy += w * (sum.y * sum.y + a.y * a.y + b.y * b.y + c.y * c.y);
    zz += w * (sum.z * sum.z + a.z * a.z + b.z * b.z + c.z * c.z);
    xy += w * (sum.x * sum.y + a.x * a.y + b.x * b.y + c.x * c.y);
    xz += w * (sum.x * sum.z + a.x * a.z + b.x * b.z + c.x * c.z);
    yz += w * (sum.y * sum.z + a.y * a.z + b.y * b.z + c.y * c.z);
  }
};

}  // namespace

OverlapDepth line_of_action(const DepthSlope& s) {
  OverlapDepth out{.depth = s.depth, .gain = norm(s.force)};
  out.normal = s.force * (1 / out.gain);
  out.point = s.centroid + cross(out.normal, s.moment) * (1 / out.gain);
  out.screw = dot(out.normal, s.moment) / out.gain;
  return out;
}

bool depth_slope(const OverlapBody& body, double least, DepthSlope& out) {
  if (body.faces().empty()) return false;
  Vec3d of_self{}, of_other{};
  for (const Face& f : body.faces()) add_surface(body, f, f.of_other ? of_other : of_self);
  const Vec3d surface = 0.5 * (of_self - of_other);
  const double section = norm(surface);
  if (!(section > least)) return false;
  const Axes axes(surface * (1 / section));

  const Vec3d apex = body.corner(body.faces()[0], 0);
  Moments m;
  for (const Face& f : body.faces()) {
    const Vec3d first = body.corner(f, 0) - apex;
    const double height = dot(f.normal, first) / 6;
    Vec3d p = body.corner(f, 1) - apex;
    for (std::uint32_t k = 2; k < f.count; ++k) {
      const Vec3d q = body.corner(f, k) - apex;
      m.add(dot(f.normal, cross(p - first, q - first)) * height, axes(first), axes(p), axes(q));
      p = q;
    }
  }
  if (!(m.volume > 0)) return false;
  const double w = 1 / m.volume;
  const Vec3d c = w * m.first;
  const double xx = w * m.xx - c.x * c.x, yy = w * m.yy - c.y * c.y, xy = w * m.xy - c.x * c.y;
  const double xz = w * m.xz - c.x * c.z, yz = w * m.yz - c.y * c.z, zz = w * m.zz - c.z * c.z;
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 0x1p-100 * (xx * yy))) return false;
  const double bx = (yy * xz - xy * yz) / determinant, by = (xx * yz - xy * xz) / determinant;  // β
  const double variance = zz - bx * xz - by * yz;                                               // (2)
  if (!(variance > 0)) return false;
  const auto residual = [&](const Vec3d& x) {  // r, x from the apex
    const Vec3d y = axes(x) - c;
    return y.z - bx * y.x - by * y.y;
  };

  out.depth = std::sqrt(12 * variance);  // (1)
  const Vec3d centre = axes.t * c.x + axes.s * c.y + axes.n * c.z;
  const double scale = out.depth / (2 * variance * m.volume), turn = out.depth / section;
  const Vec3d beta = axes.t * bx + axes.s * by;
  out.force = out.moment = {};
  for (const Face& f : body.faces()) {  // (4)
    if (f.of_other) {
      const Vec3d first = body.corner(f, 0) - apex;
      Vec3d p = body.corner(f, 1) - apex;
      double r = residual(first), rp = residual(p);
      for (std::uint32_t k = 2; k < f.count; ++k) {
        const Vec3d q = body.corner(f, k) - apex;
        const double rq = residual(q), area = 0.5 * dot(f.normal, cross(p - first, q - first));
        const double squares = r * r + rp * rp + rq * rq, sum = r + rp + rq;
        // ∫λ_k (r² − σ²) over the triangle, λ_k its corners' weights.
        const auto part = [&](double own, double products) {
          return area * ((squares + 2 * own * sum + products) / 30 - variance / 3);
        };
        const double w0 = part(r, rp * rq), w1 = part(rp, r * rq), w2 = part(rq, r * rp);
        out.force -= (w0 + w1 + w2) * f.normal;
        out.moment -= cross(w0 * (first - centre) + w1 * (p - centre) + w2 * (q - centre), f.normal);
        p = q;
        rp = rq;
      }
    }
  }
  out.force *= scale;
  out.moment *= scale;
  for (const Face& f : body.faces()) {  // the rim: sides that a face of self has in common with one of other
    if (f.of_other) continue;
    const double slope = dot(beta, f.normal) * turn;
    if (slope == 0) continue;
    for (std::uint32_t k = 0; k < f.count; ++k) {
      const std::uint32_t i = body.name(f, k), j = body.name(f, k + 1 == f.count ? 0 : k + 1);
      const Face* g = body.across(i, j);
      if (g == nullptr || !g->of_other) continue;
      const double sine = norm(cross(f.normal, g->normal));
      if (!(sine > 0)) continue;
      const Vec3d &x = body.corner(i), &y = body.corner(j);
      const double weight = slope / sine * norm(y - x);
      out.force -= weight * g->normal;
      out.moment -= weight * cross(0.5 * (x + y) - apex - centre, g->normal);
    }
  }
  out.centroid = apex + centre;
  return true;
}

}  // namespace contact
