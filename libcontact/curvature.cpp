#include "libcontact/curvature.h"

#include <algorithm>
#include <cmath>

#include "libcontact/scale.h"

namespace contact {

namespace {

using shapes::Kind;

// From the symmetric matrix of the radii of curvature in the frame (t1, t2), and its determinant.
Curvature from_radii(double r11, double r12, double r22, double determinant, const Vec3d& t1, const Vec3d& t2) {
  const double half = 0.5 * (r11 - r22), away = std::sqrt(half * half + r12 * r12);
  const double larger = 0.5 * (r11 + r22) + away;
  Curvature c;
  c.least = 1 / larger;
  c.most = larger / determinant;
  // Eigenvector of the larger radius, from the row of ρ − larger·1 that is the longer one.
  Vec3d along = half >= 0 ? t1 * (half + away) + t2 * r12 : t1 * r12 + t2 * (away - half);
  const double length = std::sqrt(dot(along, along));
  along = length > 0 ? along * (1 / length) : t1;
  c.least_direction = along;
  // t1, t2 span the plane: the other direction is `along`, a quarter turn on.
  c.most_direction = t2 * dot(along, t1) - t1 * dot(along, t2);
  return c;
}

Curvature of_ellipsoid(const Vec3d& semi_axes, const Mat3d& rotation, const Vec3d& outward) {
  const Scale scale = scale_of(max_abs(semi_axes));
  const Vec3d d = semi_axes * scale.down, n = transposed_times(rotation, outward);
  Vec3d t1, t2;
  shapes::tangent_frame(n, t1, t2);
  const double h = norm(scaled(d, n));
  const Vec3d cofactor = Vec3d{d.y * d.z, d.x * d.z, d.x * d.y} * (1 / h);
  const Vec3d w1 = scaled(cofactor, t1), w2 = scaled(cofactor, t2);
  const double root = cofactor.x * d.x / h;                                                           // abc/h²
  Curvature c = from_radii(dot(w2, w2) / h, -dot(w1, w2) / h, dot(w1, w1) / h, root * root, t1, t2);  // (1), (2)
  c.least *= scale.down;
  c.most *= scale.down;
  c.least_direction = rotation * c.least_direction;
  c.most_direction = rotation * c.most_direction;
  return c;
}

bool of_potential_particle(const Placed<shapes::PotentialParticle>& body, const Vec3d& outward, Curvature& out) {
  const Vec3d n = transposed_times(body.rotation, outward);
  const auto at = shapes::support_from_centre(*body.shape, n);
  if (!at.found) return false;
  Vec3d t1, t2;
  shapes::tangent_frame(n, t1, t2);
  const auto r = shapes::curvature_radii(at, n, t1, t2);
  out = from_radii(r.k11, r.k12, r.k22, r.k11 * r.k22 - r.k12 * r.k12, t1, t2);
  out.least /= body.scale;
  out.most /= body.scale;
  out.least_direction = body.rotation * out.least_direction;
  out.most_direction = body.rotation * out.most_direction;
  return true;
}

Curvature even(double value, const Vec3d& outward) {
  Curvature c{value, value, {}, {}};
  shapes::tangent_frame(outward, c.least_direction, c.most_direction);
  return c;
}

}  // namespace

bool curvature(const Body& body, const Vec3d& outward, Curvature& out) {
  switch (body.kind) {
    case Kind::sphere:
    case Kind::disc:
      out = even(1 / body.size.x, outward);
      return true;
    case Kind::rounded_polyhedron:
      out = even(1 / body.size.y, outward);
      return true;
    case Kind::plane:
    case Kind::line:
    case Kind::mesh:
      out = even(0, outward);
      return true;
    case Kind::ellipsoid:
      out = of_ellipsoid(body.size, body.rotation, outward);
      return true;
    case Kind::ellipse: {
      const double a = body.size.x, b = body.size.y;
      const Vec3d n = transposed_times(body.rotation, outward);
      const double x = a * n.x, y = b * n.y, h = std::sqrt(x * x + y * y);
      out = even((h / a) * (h / b) * (h / a) / b, outward);  // h³/(ab)²
      return true;
    }
    case Kind::potential_particle:
      return of_potential_particle(placed<shapes::PotentialParticle>(body), outward, out);
    default:
      return false;
  }
}

RelativeCurvature relative_curvature(const Curvature& a, const Curvature& b) {
  const double c = dot(a.least_direction, b.least_direction), s = dot(a.least_direction, b.most_direction);
  const double cosine2 = c * c, sine2 = s * s;
  const double da = a.most - a.least, db = b.most - b.least;
  const double sum = 0.5 * (a.least + a.most + b.least + b.most);  // (3)
  // (da − db)² + 4 da db cos²ω = da² + db² + 2 da db cos 2ω
  const double difference = 0.5 * std::sqrt((da - db) * (da - db) + 4 * da * db * cosine2);  // (4)
  const double product = 0.25 * (a.least * a.most + b.least * b.most + (a.least * b.least + a.most * b.most) * sine2 +
                                 (a.least * b.most + a.most * b.least) * cosine2);  // (5)
  RelativeCurvature out;
  out.most = 0.5 * (sum + difference);
  out.least = out.most > 0 ? std::min(product / out.most, out.most) : 0;
  out.radius_eff = 0.5 / std::sqrt(product);  // (6)
  return out;
}

bool relative_curvature(const Body& a, const Body& b, const Vec3d& normal, RelativeCurvature& out) {
  Curvature of_a, of_b;
  if (!curvature(a, normal, of_a) || !curvature(b, -normal, of_b)) return false;
  if (!(of_a.most > 0 || of_b.most > 0)) return false;
  out = relative_curvature(of_a, of_b);
  return true;
}

}  // namespace contact
