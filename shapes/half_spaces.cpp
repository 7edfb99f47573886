// Intersection of half-spaces n·x <= d, by duality: about an interior point c the planes become the points n/(d − n·c),
// whose hull has a face for every vertex of the intersection and a vertex for every face.
#include <Eigen/Dense>
#include <algorithm>
#include <map>

#include "shapes/convex.h"
#include "shapes/polyhedron_build.h"

namespace shapes {
namespace {

using convex::Loop;

struct Ball {
  Vec3d centre;
  double radius;
};

// A ball at least half as large as the largest, max r with n_i·x + r <= d_i. Solved as the dual, min Σ λ_i d_i with
// Σ λ_i n_i = 0, Σ λ_i = 1, λ >= 0, by the simplex method with four rows: the worst plane enters, and after many steps
// the first violated one (Bland), which cannot cycle. Four far planes make the first basis.
Ball largest_ball(std::vector<HalfSpace> planes) {
  const double reach = 0x1p12;  // of the largest offset; bounds only where the ball is looked for
  const double s = 1 / std::sqrt(3.0);
  for (const Vec3d& n : {Vec3d{s, s, s}, Vec3d{s, -s, -s}, Vec3d{-s, s, -s}, Vec3d{-s, -s, s}})
    planes.push_back({n, reach});
  const std::size_t given = planes.size() - 4;
  std::size_t basis[4] = {given, given + 1, given + 2, given + 3};
  const auto column = [&](std::size_t i) {
    return Eigen::Vector4d(planes[i].normal.x, planes[i].normal.y, planes[i].normal.z, 1);
  };
  for (std::size_t step = 0; step < 1000 + 100 * planes.size(); ++step) {
    Eigen::Matrix4d b;
    Eigen::Vector4d cost;
    for (int i = 0; i < 4; ++i) {
      b.col(i) = column(basis[i]);
      cost(i) = planes[basis[i]].offset;
    }
    const Eigen::Vector4d ball = b.transpose().fullPivLu().solve(cost);  // x, r
    const double rounding = convex::rounding * (1 + ball.cwiseAbs().maxCoeff());
    double slack = reach;  // of the worst plane at x: the radius of a ball there; r bounds the largest ball from above
    std::size_t worst = given, first = given;
    for (std::size_t i = 0; i < given; ++i) {
      const double distance = planes[i].offset - column(i).head<3>().dot(ball.head<3>());
      if (distance < slack) {
        slack = distance;
        worst = i;
      }
      if (first == given && distance < ball(3) - rounding) first = i;
    }
    const bool found = slack >= 0.5 * ball(3), empty = ball(3) < -rounding;
    if (found || empty || first == given) return {{ball(0), ball(1), ball(2)}, empty ? ball(3) : slack};
    const std::size_t entering = step < 4 * planes.size() ? worst : first;
    const Eigen::FullPivLU<Eigen::Matrix4d> lu(b);
    const Eigen::Vector4d weight = lu.solve(Eigen::Vector4d(0, 0, 0, 1)), direction = lu.solve(column(entering));
    int leaving = -1;
    for (int i = 0; i < 4; ++i) {
      if (direction(i) <= convex::rounding) continue;
      const double ratio = weight(i) * (leaving < 0 ? 1 : direction(leaving));
      const double best = leaving < 0 ? ratio : weight(leaving) * direction(i);
      if (leaving < 0 || ratio < best || (ratio == best && basis[i] < basis[leaving])) leaving = i;
    }
    if (leaving < 0) break;
    basis[leaving] = entering;
  }
  throw Error("half-spaces: no interior point found; allowed: half-spaces with a common interior");
}

// Where three of the planes meet; the three that are most independent, in the order given.
Vec3d meeting_point(const std::vector<HalfSpace>& planes, const Loop& candidates) {
  const HalfSpace* chosen[3] = {&planes[candidates[0]], nullptr, nullptr};
  double best = 0;
  for (const std::uint32_t i : candidates)
    if (const double c = norm(cross(chosen[0]->normal, planes[i].normal)); c > best) {
      best = c;
      chosen[1] = &planes[i];
    }
  if (chosen[1] == nullptr)
    throw Error("half-spaces: parallel planes at a vertex; allowed: planes in general position");
  const Vec3d line = cross(chosen[0]->normal, chosen[1]->normal);
  best = 0;
  for (const std::uint32_t i : candidates)
    if (const double c = std::fabs(dot(line, planes[i].normal)); c > best) {
      best = c;
      chosen[2] = &planes[i];
    }
  if (chosen[2] == nullptr)
    throw Error("half-spaces: parallel planes at a vertex; allowed: planes in general position");
  Eigen::Matrix3d m;
  Eigen::Vector3d d;
  for (int r = 0; r < 3; ++r) {
    m.row(r) << chosen[r]->normal.x, chosen[r]->normal.y, chosen[r]->normal.z;
    d(r) = chosen[r]->offset;
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> lu(m);
  Eigen::Vector3d x = lu.solve(d);
  x += lu.solve(d - m * x);
  return {x(0), x(1), x(2)};
}

// Unit normals, and offsets brought to unit size by 2^-exponent.
std::vector<HalfSpace> normalised(std::span<const HalfSpace> planes, int& exponent) {
  std::vector<HalfSpace> result;
  double largest = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto& [n, d] = planes[i];
    if (!convex::finite(n) || !std::isfinite(d) || !(max_abs(n) > 0))
      throw Error("half-space " + std::to_string(i) +
                  ": normal or offset is zero or not finite; allowed: finite, normal not zero");
    const double length = convex::safe_norm(n);
    result.push_back({convex::unit(n), d / length});
    largest = std::fmax(largest, std::fabs(result.back().offset));
  }
  if (!(largest > 0))
    throw Error("half-spaces: all planes pass through the origin (empty or unbounded); allowed: a bounded body");
  exponent = convex::exponent_above(largest);
  for (HalfSpace& h : result) h.offset = std::ldexp(h.offset, -exponent);
  return result;
}

}  // namespace

Polyhedron polyhedron_from_half_spaces(std::span<const HalfSpace> planes, Frame frame) {
  if (planes.size() < 4) throw Error("half-spaces: " + std::to_string(planes.size()) + "; allowed: at least 4");
  int exponent = 0;
  const std::vector<HalfSpace> unit_planes = normalised(planes, exponent);
  const Ball ball = largest_ball(unit_planes);
  if (!(ball.radius > convex::rounding))
    throw Error("half-spaces: the intersection is empty or has no interior (largest ball " +
                std::to_string(ball.radius) + " of the largest offset); allowed: a body with volume");

  std::vector<Vec3d> dual;
  for (const auto& [n, d] : unit_planes) {
    const double distance = d - dot(n, ball.centre);
    dual.push_back({n.x / distance, n.y / distance, n.z / distance});
  }
  const double tolerance = convex::rounding * convex::largest_coordinate(dual);
  const std::vector<std::uint32_t> kept = convex::distinct_points(dual, tolerance);
  std::vector<Vec3d> dual_points;
  std::vector<HalfSpace> kept_planes;
  for (const std::uint32_t i : kept) {
    dual_points.push_back(dual[i]);
    kept_planes.push_back(unit_planes[i]);
  }
  const char* unbounded = "half-spaces: the intersection is unbounded; allowed: half-spaces that enclose a body";
  std::vector<Loop> dual_faces;
  try {
    dual_faces = convex::hull_faces(dual_points, tolerance);
  } catch (const Error&) {
    throw Error(unbounded);  // the dual points span no volume
  }

  std::vector<Vec3d> corners;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> face_of;  // directed dual edge -> dual face
  for (std::uint32_t f = 0; f < dual_faces.size(); ++f) {
    const Loop& loop = dual_faces[f];
    const Vec3d n = convex::unit(convex::area_vector(dual_points, loop));
    if (!(dot(n, dual_points[loop[0]]) > tolerance)) throw Error(unbounded);  // the corner is at infinity
    corners.push_back(meeting_point(kept_planes, loop));
    for (std::size_t i = 0; i < loop.size(); ++i) face_of[{loop[i], loop[(i + 1) % loop.size()]}] = f;
  }
  // Corners at which more than three planes meet may come out several times, apart by rounding: they are joined.
  const double same_corner = convex::rounding * convex::largest_coordinate(corners);
  std::vector<std::uint32_t> number(corners.size());
  convex::Faces faces;
  for (const std::uint32_t i : convex::distinct_points(corners, same_corner)) {
    faces.rank.push_back(static_cast<std::uint32_t>(faces.vertices.size()));
    faces.vertices.push_back(corners[i]);
  }
  for (std::size_t i = 0; i < corners.size(); ++i)
    while (max_abs(corners[i] - faces.vertices[number[i]]) > same_corner) ++number[i];
  // Around each dual vertex v, the dual faces in turn are the corners of face v: from the face left of v -> w to the
  // one left of v -> w', where w' precedes v in the first. Seen from outside this runs counter-clockwise.
  std::map<std::uint32_t, std::uint32_t> first_neighbour;
  for (const auto& [e, f] : face_of) first_neighbour.emplace(e.first, e.second);
  for (const auto& [v, start] : first_neighbour) {
    Loop face;
    std::uint32_t w = start;
    do {
      const std::uint32_t f = face_of.at({v, w});
      if (face.empty() || face.back() != number[f]) face.push_back(number[f]);
      const Loop& loop = dual_faces[f];
      const auto at = static_cast<std::size_t>(std::find(loop.begin(), loop.end(), v) - loop.begin());
      w = loop[(at + loop.size() - 1) % loop.size()];
    } while (w != start);
    if (face.back() == face.front()) face.pop_back();
    if (face.size() < 3) continue;  // a face below rounding
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    faces.loops.push_back(std::move(face));
  }
  std::sort(faces.loops.begin(), faces.loops.end());
  return convex::assemble(std::move(faces), frame, exponent);
}

}  // namespace shapes
