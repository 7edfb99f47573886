// The child: reads pairs from standard input, one per line, and answers one line each with FCL or libccd.
//
//   witness_peer fcl|epa|mpr
//
// In:  body body x y z         body = type size[3] quaternion[4] [vertices, faces]; A stands at the origin, B at x y z
// Out: overlap gap direction[3] has_points a[3] b[3]      or "threw"
// A pair that takes more than a quarter of a second of processor time ends the process (SIGPROF).
#include <ccd/ccd.h>
#include <ccd/quat.h>
#include <fcl/fcl.h>
#include <sys/time.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

using Vector = Eigen::Vector3d;

struct Body {
  std::string type;
  Vector size;
  Eigen::Quaterniond orientation;
  Vector position;
  std::shared_ptr<std::vector<Vector>> vertices = std::make_shared<std::vector<Vector>>();
  std::shared_ptr<std::vector<int>> faces = std::make_shared<std::vector<int>>();
  int face_count = 0;
};

double number(std::istream& in) {  // streams refuse denormal numbers
  std::string word;
  in >> word;
  return std::strtod(word.c_str(), nullptr);
}
Vector vector(std::istream& in) {
  const double x = number(in), y = number(in);
  return {x, y, number(in)};
}

Body read(std::istream& in) {
  Body b;
  in >> b.type;
  b.size = vector(in);
  const double w = number(in);
  const Vector v = vector(in);
  b.orientation = Eigen::Quaterniond(w, v.x(), v.y(), v.z()).normalized();
  b.position.setZero();
  if (b.type != "polyhedron") return b;
  std::size_t count = 0;
  in >> count;
  for (std::size_t i = 0; i < count; ++i) b.vertices->push_back(vector(in));
  in >> b.face_count;
  for (int f = 0; f < b.face_count; ++f) {
    int corners = 0, corner = 0;
    in >> corners;
    b.faces->push_back(corners);
    for (int k = 0; k < corners; ++k) {
      in >> corner;
      b.faces->push_back(corner);
    }
  }
  return b;
}

void print(bool overlap, double gap, const Vector& n, bool has_points, const Vector& a, const Vector& b) {
  std::printf("%d %.17g %.17g %.17g %.17g %d %.17g %.17g %.17g %.17g %.17g %.17g\n", overlap, gap, n.x(), n.y(), n.z(),
              has_points, a.x(), a.y(), a.z(), b.x(), b.y(), b.z());
}

fcl::CollisionObjectd object(const Body& b) {
  std::shared_ptr<fcl::CollisionGeometryd> geometry;
  if (b.type == "sphere") geometry = std::make_shared<fcl::Sphered>(b.size.x());
  if (b.type == "ellipsoid") geometry = std::make_shared<fcl::Ellipsoidd>(b.size);
  if (b.type == "box") geometry = std::make_shared<fcl::Boxd>(b.size);
  if (b.type == "polyhedron") geometry = std::make_shared<fcl::Convexd>(b.vertices, b.face_count, b.faces);
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  pose.linear() = b.orientation.toRotationMatrix();
  pose.translation() = b.position;
  return fcl::CollisionObjectd(geometry, pose);
}

void answer_by_fcl(const Body& a, const Body& b) {
  const fcl::CollisionObjectd object_a = object(a), object_b = object(b);
  fcl::DistanceRequestd request;
  request.enable_nearest_points = true;
  request.enable_signed_distance = true;
  fcl::DistanceResultd result;
  const double gap = fcl::distance(&object_a, &object_b, request, result);
  const Vector &pa = result.nearest_points[0], &pb = result.nearest_points[1];
  print(gap < 0, gap, gap < 0 ? Vector(pa - pb) : Vector(pb - pa), true, pa, pb);
}

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Body& b = *static_cast<const Body*>(object);
  const Vector n = b.orientation.conjugate() * Vector(direction->v[0], direction->v[1], direction->v[2]);
  Vector p;
  if (b.type == "sphere") {
    p = n.normalized() * b.size.x();
  } else if (b.type == "ellipsoid") {
    p = b.size.cwiseProduct(b.size.cwiseProduct(n).normalized());
  } else if (b.type == "box") {
    for (int k = 0; k < 3; ++k) p[k] = std::copysign(b.size[k] / 2, n[k]);
  } else {
    p = (*b.vertices)[0];
    for (const Vector& v : *b.vertices)
      if (n.dot(v) > n.dot(p)) p = v;
  }
  p = b.orientation * p + b.position;
  ccdVec3Set(point, p.x(), p.y(), p.z());
}

void centre(const void* object, ccd_vec3_t* point) {
  const Body& b = *static_cast<const Body*>(object);
  Vector p = Vector::Zero();  // must lie inside: the origin of a polyhedron need not
  for (const Vector& v : *b.vertices) p += v / static_cast<double>(b.vertices->size());
  p = b.orientation * p + b.position;
  ccdVec3Set(point, p.x(), p.y(), p.z());
}

void answer_by_libccd(const Body& a, const Body& b, bool mpr) {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support;
  ccd.center1 = ccd.center2 = centre;
  double depth = 0;
  ccd_vec3_t direction{}, point{};
  const auto penetration = mpr ? ccdMPRPenetration : ccdGJKPenetration;
  const bool overlap = penetration(&a, &b, &ccd, &depth, &direction, &point) == 0;
  const Vector n(direction.v[0], direction.v[1], direction.v[2]), p(point.v[0], point.v[1], point.v[2]);
  print(overlap, -depth, n, overlap, p, p);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string_view query = argv[1];
  std::string line;
  while (std::getline(std::cin, line)) {
    std::istringstream in(line);
    const Body a = read(in);
    Body b = read(in);
    b.position = vector(in);
    const itimerval limit{{0, 0}, {0, 250000}};
    setitimer(ITIMER_PROF, &limit, nullptr);
    try {
      if (query == "fcl") {
        answer_by_fcl(a, b);
      } else {
        answer_by_libccd(a, b, query == "mpr");
      }
    } catch (const std::exception&) {
      std::puts("threw");
    }
    std::fflush(stdout);
  }
  return 0;
}
