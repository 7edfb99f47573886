// (1)–(4) of overlap_depth.h over the triangles and sides of a body. Compiled once per instruction set.
#pragma GCC diagnostic ignored "-Wpsabi"  // rows are passed within this file alone
#include <limits>

#include "libcontact/kernels/gather.h"
#include "libcontact/kernels/in_line.h"
#include "libcontact/kernels/overlap_sums.h"
#include "shapes/math/pack.h"

namespace contact::kernels {
inline namespace KERNEL_SET {
namespace {

using shapes::Pack;
using shapes::Vec3;
using shapes::Vec3d;
using std::experimental::element_aligned;

using Row = double __attribute__((vector_size(32)));
using Unaligned = double __attribute__((vector_size(32), may_alias, aligned(8)));
using V = Vec3<Row>;

inline Row all(double x) { return Row{x, x, x, x}; }
inline V all(const Vec3d& x) { return {all(x.x), all(x.y), all(x.z)}; }
inline double total(const Row& x) { return (x[0] + x[1]) + (x[2] + x[3]); }
inline Vec3d total(const V& x) { return {total(x.x), total(x.y), total(x.z)}; }

inline V turned(const Row& a, const Row& b, const Row& c, const Row& d) {
  const Row p = __builtin_shufflevector(a, b, 0, 4, 2, 6), q = __builtin_shufflevector(a, b, 1, 5, 3, 7);
  const Row r = __builtin_shufflevector(c, d, 0, 4, 2, 6), s = __builtin_shufflevector(c, d, 1, 5, 3, 7);
  return {__builtin_shufflevector(p, r, 0, 1, 4, 5), __builtin_shufflevector(q, s, 0, 1, 4, 5),
          __builtin_shufflevector(p, r, 2, 3, 6, 7)};
}
inline Row row(const OverlapRow& x) { return *reinterpret_cast<const Unaligned*>(&x); }
// What four entries of a list name.
template <class Entry>
inline V points(const OverlapRow* of, const Entry* list, std::uint32_t Entry::*name) {
  return turned(row(of[list[0].*name]), row(of[list[1].*name]), row(of[list[2].*name]), row(of[list[3].*name]));
}
inline void put(OverlapRow* to, const V& v) {
  const Row zero{}, p = __builtin_shufflevector(v.x, v.y, 0, 4, 2, 6),
                    q = __builtin_shufflevector(v.x, v.y, 1, 5, 3, 7);
  const Row r = __builtin_shufflevector(v.z, zero, 0, 4, 2, 6), s = __builtin_shufflevector(v.z, zero, 1, 5, 3, 7);
  *reinterpret_cast<Unaligned*>(to) = __builtin_shufflevector(p, r, 0, 1, 4, 5);
  *reinterpret_cast<Unaligned*>(to + 1) = __builtin_shufflevector(q, s, 0, 1, 4, 5);
  *reinterpret_cast<Unaligned*>(to + 2) = __builtin_shufflevector(p, r, 2, 3, 6, 7);
  *reinterpret_cast<Unaligned*>(to + 3) = __builtin_shufflevector(q, s, 2, 3, 6, 7);
}

// ∫ of a cone or a body: volume, ∫x, ∫xxᵀ, each with a factor of its own.
struct Moments {
  Row volume{}, xx{}, yy{}, zz{}, xy{}, xz{}, yz{};
  V first{};
  void add(const Row& v, const V& a) {
    const V w{v * a.x, v * a.y, v * a.z};
    xx += w.x * a.x;
    yy += w.y * a.y;
    zz += w.z * a.z;
    xy += w.x * a.y;
    xz += w.x * a.z;
    yz += w.y * a.z;
  }
};

}  // namespace

KERNEL_IN_LINE bool overlap_slope(const OverlapLists& in, double size, DepthSlope& out) {
  const Vec3d apex{in.corner[0].x, in.corner[0].y, in.corner[0].z};
  const V origin = all(apex);
  V area{};  // twice the vector area of what lies of self's surface in other
  for (std::size_t i = 0; i < in.rim_count; i += 4)
    area += cross(points(in.corner, in.rim + i, &OverlapSide::from) - origin,
                  points(in.corner, in.rim + i, &OverlapSide::to) - origin);
  const Vec3d surface = total(area) * 0.5;
  const double section = norm(surface);
  if (!(section > least_depth * least_depth * size * size)) return false;
  const Vec3d n = surface * (1 / section);
  Vec3d t, s;
  tangent_frame(n, t, s);

  // Along the axes, from the middle of the corners: about that an even body has no moment at all, not one of rounding.
  const V at = all(t), as = all(s), an = all(n);
  V sum{};
  for (std::size_t i = 0; i < in.filled_corners; i += 4) {
    const OverlapRow* c = in.corner + i;
    const V x = turned(row(c[0]), row(c[1]), row(c[2]), row(c[3])) - origin;
    const V arm{dot(at, x), dot(as, x), dot(an, x)};
    sum += arm;
    put(in.places + i, arm);
  }
  const Vec3d middle = total(sum) * (1 / static_cast<double>(in.corners));
  const Row shift{middle.x, middle.y, middle.z, 0};
  for (std::size_t i = 0; i < in.filled_corners; ++i)
    *reinterpret_cast<Unaligned*>(in.places + i) = row(in.places[i]) - shift;

  // Of a cone of volume v over a triangle: ∫x = v/4 Σ, ∫xxᵀ = v/20 (ΣΣᵀ + Σ xxᵀ), Σ the sum of its four corners.
  const V top = all(-middle);
  Moments m;
  for (std::size_t i = 0; i < in.cone_count; i += 4) {
    const V f = points(in.places, in.cones + i, &OverlapTriangle::a),
            p = points(in.places, in.cones + i, &OverlapTriangle::b),
            q = points(in.places, in.cones + i, &OverlapTriangle::c);
    const Row v = dot(f - top, cross(p - top, q - top));
    const V corners = (top + f) + (p + q);
    m.volume += v;
    m.first += V{v * corners.x, v * corners.y, v * corners.z};
    m.add(v, corners);
    m.add(v, f);
    m.add(v, p);
    m.add(v, q);
  }
  const double sixfold = total(m.volume);
  if (!(sixfold > 0)) return false;
  const double w = 0.05 / sixfold;
  const Vec3d c = total(m.first) * (0.25 / sixfold);
  const auto second = [&](const Row& of_cones, double a, double b, double ca, double cb) {
    return w * (total(of_cones) + sixfold * (a * b)) - ca * cb;
  };
  const double xx = second(m.xx, middle.x, middle.x, c.x, c.x), yy = second(m.yy, middle.y, middle.y, c.y, c.y),
               zz = second(m.zz, middle.z, middle.z, c.z, c.z), xy = second(m.xy, middle.x, middle.y, c.x, c.y),
               xz = second(m.xz, middle.x, middle.z, c.x, c.z), yz = second(m.yz, middle.y, middle.z, c.y, c.z);
  // The tilt β of the overlap's middle, and what it leaves of the variance along n (2).
  const double determinant = xx * yy - xy * xy;
  if (!(determinant > 0x1p-100 * (xx * yy))) return false;
  const double inverse = 1 / determinant, tilt_u = (yy * xz - xy * yz) * inverse,
               tilt_v = (xx * yz - xy * xz) * inverse;
  const double variance = zz - tilt_u * xz - tilt_v * yz;
  if (!(variance > 0)) return false;
  const double volume = sixfold * (1.0 / 6), depth = std::sqrt(12 * variance);  // (1)
  if (!(depth > least_depth * size)) return false;

  // ∫λ (r² − σ²) over other's faces, λ = 1 in one corner of a triangle and 0 in the others (4).
  const Row level = all(c.z - tilt_u * c.x - tilt_v * c.y), u = all(tilt_u), v = all(tilt_v), sigma = all(variance);
  const auto residual = [&](const V& x) { return (x.z - level) - (u * x.x + v * x.y); };
  V press{}, turn{};
  for (std::size_t i = 0; i < in.other_count; i += 4) {
    const V a = points(in.places, in.of_other + i, &OverlapTriangle::a),
            b = points(in.places, in.of_other + i, &OverlapTriangle::b),
            d = points(in.places, in.of_other + i, &OverlapTriangle::c);
    const Row ra = residual(a), rb = residual(b), rd = residual(d);
    const Row squares = ra * ra + rb * rb + rd * rd, sum_r = ra + rb + rd, limit = 10.0 * sigma;
    const auto weight = [&](const Row& own, const Row& others) {
      return (squares + 2.0 * (own * sum_r) + others) - limit;
    };
    const Row wa = weight(ra, rb * rd), wb = weight(rb, ra * rd), wd = weight(rd, ra * rb), all_w = wa + wb + wd;
    const V twice = cross(b - a, d - a);
    press += V{all_w * twice.x, all_w * twice.y, all_w * twice.z};
    const V arm{wa * a.x + wb * b.x + wd * d.x, wa * a.y + wb * b.y + wd * d.y, wa * a.z + wb * b.z + wd * d.z};
    turn += cross(arm, twice);
  }
  const auto back = [&](const Vec3d& x) { return t * x.x + s * x.y + n * x.z; };
  const double scale = -depth / (120 * variance * volume);
  Vec3d force = back(total(press) * scale), moment = back(total(turn) * scale);

  // The rim, along the body's axes.
  const Vec3d about = apex + back(middle);
  const V slope = all((depth / section) * (tilt_u * t + tilt_v * s)), here = all(about);
  V pull{}, couple{};
  for (std::size_t i = 0; i < in.rim_count; i += 4) {
    const V normal = points(in.normal, in.rim + i, &OverlapSide::left),
            across = points(in.normal, in.rim + i, &OverlapSide::right),
            from = points(in.corner, in.rim + i, &OverlapSide::from) - here,
            to = points(in.corner, in.rim + i, &OverlapSide::to) - here;
    const V sine = cross(normal, across);  // runs along the side
    const Row square = dot(sine, sine), none{};
    const auto known = square > 0x1p-60;  // else in one plane to rounding: nowhere in particular
    const Row ratio = known ? dot(to - from, sine) / (known ? square : none + 1.0) : none;
    const Row weight = dot(slope, normal) * ratio;
    const V f{weight * across.x, weight * across.y, weight * across.z};
    pull += f;
    couple += cross(from + to, f);
  }
  force -= total(pull);
  moment -= total(couple) * 0.5;
  const Vec3d to_centroid = back(c);
  out.depth = depth;
  out.force = force;
  out.centroid = about + to_centroid;
  out.moment = moment - cross(to_centroid, force);
  out.volume = volume;
  out.tt = xx;
  out.uu = yy;
  out.tu = xy;
  out.t = t;
  out.u = s;
  return true;
}

// Of many planes a ball about the corners tells of most that no corner lies over them.
KERNEL_IN_LINE std::size_t overlap_cutting(const Points& normals, const double* offsets, std::size_t planes,
                                           const OverlapRow* corner, std::size_t filled, std::uint32_t* out) {
  constexpr std::size_t width = Pack::size(), few = 16;
  // Number by number: what has just been written so is not read as a row without a wait.
  Vec3d middle{};
  double radius = std::numeric_limits<double>::infinity();
  if (normals.count > few) {
    for (std::size_t i = 0; i < filled; ++i) middle += Vec3d{corner[i].x, corner[i].y, corner[i].z};
    middle *= 1 / static_cast<double>(filled);
    double square = 0;
    for (std::size_t i = 0; i < filled; ++i) {
      const Vec3d arm = Vec3d{corner[i].x, corner[i].y, corner[i].z} - middle;
      const double here = dot(arm, arm);
      square = here > square ? here : square;
    }
    radius = std::sqrt(square) * (1 + 0x1p-20);
  }
  const Pack x = middle.x, y = middle.y, z = middle.z, reach = radius;
  std::size_t found = 0;
  for (std::size_t i = 0; i < normals.count; i += width) {
    const Pack nx(normals.x + i, element_aligned), ny(normals.y + i, element_aligned),
        nz(normals.z + i, element_aligned), nd(offsets + i, element_aligned);
    if (none_of(x * nx + y * ny + z * nz + reach > nd)) continue;
    Pack most = -std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < filled; ++k) most = max(most, corner[k].x * nx + corner[k].y * ny + corner[k].z * nz);
    if (none_of(most > nd)) continue;
    double over[width];
    (most - nd).copy_to(over, element_aligned);
    for (std::size_t lane = 0; lane < width; ++lane) {
      out[found] = static_cast<std::uint32_t>(i + lane);
      found += static_cast<std::size_t>(over[lane] > 0) & static_cast<std::size_t>(i + lane < planes);
    }
  }
  return found;
}

KERNEL_IN_LINE std::size_t overlap_deepest(const OverlapPlanes& planes, std::size_t count, const Vec3d* corner,
                                           std::size_t corners, std::size_t& deepest) {
  const auto at = [](double* list, std::size_t i) -> Row { return *reinterpret_cast<const Unaligned*>(list + i); };
  std::size_t kept = 0;
  double farthest = 0;
  for (std::size_t i = 0; i < count; i += 4) {
    const Row x = at(planes.x, i), y = at(planes.y, i), z = at(planes.z, i), level = at(planes.level, i);
    Row most = all(-std::numeric_limits<double>::infinity());
    for (std::size_t k = 0; k < corners; ++k) {
      const Row over = x * corner[k].x + y * corner[k].y + z * corner[k].z - level;
      most = over > most ? over : most;
    }
    for (std::size_t lane = 0; lane < 4 && i + lane < count; ++lane) {
      if (!(most[lane] > 0)) continue;
      if (most[lane] > farthest) farthest = most[lane], deepest = kept;
      planes.x[kept] = x[lane];
      planes.y[kept] = y[lane];
      planes.z[kept] = z[lane];
      planes.level[kept++] = level[lane];
    }
  }
  return kept;
}

const OverlapKernels& overlap_set() {
  static const OverlapKernels set{overlap_slope, overlap_cutting, overlap_deepest};
  return set;
}

}  // namespace KERNEL_SET
}  // namespace contact::kernels
