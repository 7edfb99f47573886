// Rounded polyhedra. The body is cut into the core, a prism on every face, a sector of a cylinder along every edge and
// a sector of a ball at every corner, x = y + t n with y on the core's surface, n in the normal cone there, 0 <= t <=
// r. With ∫ over the face, the edge's arc of normals or the corner's spherical polygon of normals:
//
//   V = V₀ + Σ_faces A r + Σ_edges L θ r²/2 + Σ_corners Ω r³/3 = V₀ + A r + M r² + 4π/3 r³                       (1)
//   arc of angle θ, bisector b, e along the edge, q = e × b:
//     ∫n = 2 sin(θ/2) b,   ∫n nᵀ = ½(θ + sin θ) b bᵀ + ½(θ − sin θ) q qᵀ                                        (2)
//   spherical polygon of arcs k with inward poles p_k:  ∫n = ½ Σ θ_k p_k,   ∫n nᵀ = ⅓ (Ω 1 + Σ p_k (∫n)_kᵀ)      (3)
//
// (3) is the divergence theorem on the cone and on the sphere. The moments in t are powers of r: all is exact.
#include "shapes/rounded_polyhedron.h"

#include <cmath>
#include <string>

#include "shapes/convex.h"
#include "shapes/geometry.h"
#include "shapes/polyhedron_build.h"

namespace shapes {
namespace {

Mat3d outer(const Vec3d& a, const Vec3d& b) { return {{a.x * b, a.y * b, a.z * b}}; }
Mat3d sum(const Mat3d& a, const Mat3d& b) { return {{a.row[0] + b.row[0], a.row[1] + b.row[1], a.row[2] + b.row[2]}}; }
Mat3d times(double s, const Mat3d& a) { return {{s * a.row[0], s * a.row[1], s * a.row[2]}}; }
Mat3d twice_symmetric(const Vec3d& a, const Vec3d& b) { return sum(outer(a, b), outer(b, a)); }

struct Moments {  // of a piece: ∫1, ∫x, ∫x xᵀ
  double zeroth = 0;
  Vec3d first{};
  Mat3d second{};
  void add(double z, const Vec3d& f, const Mat3d& s) {
    zeroth += z;
    first += f;
    second = sum(second, s);
  }
};

Moments face_moments(const Polyhedron& p, const Polyhedron::Face& face) {
  Moments m;
  const Vec3d a = p.vertices[p.face_vertices[face.first]];
  for (std::uint32_t i = 1; i + 1 < face.count; ++i) {
    const Vec3d b = p.vertices[p.face_vertices[face.first + i]], c = p.vertices[p.face_vertices[face.first + i + 1]];
    const double area = 0.5 * norm(cross(b - a, c - a));
    const Vec3d s = a + b + c;
    m.add(area, (area / 3) * s, times(area / 12, sum(sum(outer(a, a), outer(b, b)), sum(outer(c, c), outer(s, s)))));
  }
  return m;
}

struct Arc {
  double angle;
  Vec3d first;   // ∫n
  Mat3d second;  // ∫n nᵀ
};

Arc arc_of(const Vec3d& n1, const Vec3d& n2, const Vec3d& along) {
  const Vec3d chord = n2 - n1, middle = n1 + n2;
  const double half_sine = 0.5 * norm(chord), half_cosine = 0.5 * norm(middle);
  const double angle = 2 * std::atan2(half_sine, half_cosine), sine = 2 * half_sine * half_cosine;
  const Vec3d b = normalized(middle), q = cross(along, b);
  return {angle, (2 * half_sine) * b,
          sum(times(0.5 * (angle + sine), outer(b, b)), times(0.5 * (angle - sine), outer(q, q)))};
}

// Solid angle of the triangle of three unit vectors.
double solid_angle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return 2 * std::atan2(std::fabs(dot(a, cross(b, c))), 1 + dot(a, b) + dot(b, c) + dot(c, a));
}

MassProperties from_moments(const Moments& m) {
  MassProperties out;
  out.volume = m.zeroth;
  out.centre = {m.first.x / m.zeroth, m.first.y / m.zeroth, m.first.z / m.zeroth};
  const Vec3d& c = out.centre;
  double moment[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) moment[i][j] = m.second.row[i][j] - m.zeroth * c[i] * c[j];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      out.inertia.row[i][j] = i == j ? moment[(i + 1) % 3][(i + 1) % 3] + moment[(i + 2) % 3][(i + 2) % 3]
                                     : -0.5 * (moment[i][j] + moment[j][i]);
  return out;
}

Polyhedron moved(const Polyhedron& p, const Pose& frame, const Mat3d& rotation) {
  std::vector<Vec3d> points;
  for (const Vec3d& v : p.vertices) points.push_back(transposed_times(rotation, v - frame.position));
  return polyhedron_from_points(points, Frame::as_given);
}

}  // namespace

MassProperties mass_properties(const RoundedPolyhedron& body) {
  const Polyhedron& p = body.core;
  const double r = body.radius, r2 = r * r, r3 = r2 * r, r4 = r2 * r2, r5 = r4 * r;
  Moments total;
  {  // the core: back from its inertia to ∫x xᵀ about the origin
    const Mat3d& inertia = p.mass.inertia;
    const double half_trace = 0.5 * (inertia.row[0].x + inertia.row[1].y + inertia.row[2].z);
    const Vec3d& c = p.mass.centre;
    total.add(p.mass.volume, p.mass.volume * c,
              sum(sum(Mat3d::diagonal({half_trace, half_trace, half_trace}), times(-1, inertia)),
                  times(p.mass.volume, outer(c, c))));
  }
  for (const auto& face : p.faces) {
    const Moments m = face_moments(p, face);
    const Vec3d& n = face.normal;
    total.add(r * m.zeroth, r * m.first + (0.5 * r2 * m.zeroth) * n,
              sum(sum(times(r, m.second), times(0.5 * r2, twice_symmetric(m.first, n))),
                  times(r3 / 3 * m.zeroth, outer(n, n))));
  }
  struct Cone {
    Vec3d inside{}, first{};
    Mat3d poles{};
    double angle = 0;
  };
  std::vector<Cone> cones(p.vertices.size());
  for (const auto& edge : p.edges)
    for (const std::uint32_t v : edge.vertex)
      for (const std::uint32_t f : edge.face) cones[v].inside += p.faces[f].normal;
  for (Cone& cone : cones) cone.inside = normalized(cone.inside);
  for (const auto& edge : p.edges) {
    const Vec3d start = p.vertices[edge.vertex[0]], end = p.vertices[edge.vertex[1]];
    const Vec3d along = convex::unit(end - start), middle = 0.5 * (start + end);
    const double length = convex::safe_norm(end - start);
    const Vec3d &n1 = p.faces[edge.face[0]].normal, &n2 = p.faces[edge.face[1]].normal;
    const Arc arc = arc_of(n1, n2, along);
    total.add(0.5 * r2 * length * arc.angle, (0.5 * r2 * length * arc.angle) * middle + (r3 / 3 * length) * arc.first,
              sum(sum(times(0.5 * r2 * length * arc.angle,
                            sum(outer(middle, middle), times(length * length / 12, outer(along, along)))),
                      times(r3 / 3 * length, twice_symmetric(middle, arc.first))),
                  times(0.25 * r4 * length, arc.second)));
    for (int end_index = 0; end_index < 2; ++end_index) {
      Cone& cone = cones[edge.vertex[end_index]];
      const Vec3d pole = end_index == 0 ? -along : along;  // away from the other end: into the cone of normals
      cone.angle += solid_angle(cone.inside, n1, n2);
      cone.first += (0.5 * arc.angle) * pole;
      cone.poles = sum(cone.poles, outer(pole, arc.first));
    }
  }
  for (std::size_t i = 0; i < cones.size(); ++i) {
    const Cone& cone = cones[i];
    const Vec3d& v = p.vertices[i];
    const Mat3d both = sum(cone.poles, transposed(cone.poles));
    const Mat3d second = times(1.0 / 3, sum(Mat3d::diagonal({cone.angle, cone.angle, cone.angle}), times(0.5, both)));
    total.add(r3 / 3 * cone.angle, (r3 / 3 * cone.angle) * v + (0.25 * r4) * cone.first,
              sum(sum(times(r3 / 3 * cone.angle, outer(v, v)), times(0.25 * r4, twice_symmetric(v, cone.first))),
                  times(0.2 * r5, second)));
  }
  return from_moments(total);
}

double circumradius(const RoundedPolyhedron& body) { return body.core.circumradius + body.radius; }
double inscribed_radius(const RoundedPolyhedron& body) { return body.core.inscribed_radius + body.radius; }
Vec3d support(const RoundedPolyhedron& body, const Vec3d& n) {
  return support(body.core, n) + body.radius * convex::unit(n);
}

RoundedPolyhedron make_rounded(const Polyhedron& core, double radius) {
  if (!(radius > 0) || !std::isfinite(radius))
    throw Error("rounding: " + std::to_string(radius) + "; allowed: finite and > 0 (m)");
  RoundedPolyhedron body{core, radius};
  const MassProperties mass = mass_properties(body);
  const Pose frame = convex::principal_frame(mass, body.core.circumradius + radius);
  const Quatd& q = frame.orientation;
  const bool turned = !(q.x == 0 && q.y == 0 && q.z == 0);
  if (turned || max_abs(frame.position) > 0) {
    const Mat3d rotation = turned ? rotation_matrix(q) : Mat3d::identity();
    body.core = moved(core, frame, rotation);
    body.core.frame = {core.frame.position + rotate(core.frame.orientation, frame.position),
                       normalized(core.frame.orientation * q)};
  }
  return body;
}

Polyhedron drawing_of(const RoundedPolyhedron& body) {
  const Polyhedron ball = make_platonic(Platonic::icosahedron, 1);
  std::vector<Vec3d> directions;
  for (const Vec3d& v : ball.vertices) directions.push_back(normalized(v));
  for (const auto& edge : ball.edges)
    directions.push_back(normalized(ball.vertices[edge.vertex[0]] + ball.vertices[edge.vertex[1]]));
  for (const auto& face : body.core.faces) directions.push_back(face.normal);
  std::vector<Vec3d> points;
  for (const Vec3d& v : body.core.vertices)
    for (const Vec3d& n : directions) points.push_back(v + body.radius * n);
  return polyhedron_from_points(points, Frame::as_given);
}

}  // namespace shapes
