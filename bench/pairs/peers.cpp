// libccd and FCL on the same pairs. They hang on some input: a child process tries every pair first, and only those
// that come back are timed.
#include "bench/pairs/entries.h"

#ifdef BENCH_HAS_PEERS

#include <ccd/ccd.h>
#include <ccd/quat.h>
#include <fcl/fcl.h>

#include <cmath>
#include <map>

#include "tests/guard/child.h"

namespace pairs {

namespace {

using shapes::Kind;

// Vertices and edges of a polyhedron for libccd's call-backs: hill climbing above 32 vertices, a scan below.
struct Corners {
  std::vector<Vec3d> vertices;
  std::vector<std::uint32_t> first, neighbour;

  explicit Corners(const shapes::Polyhedron& shape) : vertices(shape.vertices) {
    std::vector<std::vector<std::uint32_t>> next(vertices.size());
    for (const auto& e : shape.edges) {
      next[e.vertex[0]].push_back(e.vertex[1]);
      next[e.vertex[1]].push_back(e.vertex[0]);
    }
    for (const auto& list : next) {
      first.push_back(static_cast<std::uint32_t>(neighbour.size()));
      neighbour.insert(neighbour.end(), list.begin(), list.end());
    }
    first.push_back(static_cast<std::uint32_t>(neighbour.size()));
  }
  const Vec3d& farthest(const Vec3d& n) const {
    std::size_t best = 0;
    double most = dot(n, vertices[0]);
    if (vertices.size() <= 32) {
      for (std::size_t i = 1; i < vertices.size(); ++i)
        if (const double h = dot(n, vertices[i]); h > most) most = h, best = i;
      return vertices[best];
    }
    for (bool better = true; better;) {
      better = false;
      for (std::uint32_t e = first[best], end = first[best + 1]; e < end; ++e)
        if (const double h = dot(n, vertices[neighbour[e]]); h > most) most = h, best = neighbour[e], better = true;
    }
    return vertices[best];
  }
};

// One copy per geometry, as our own bodies have it.
const Corners& corners_of(const void* geometry) {
  static std::map<const void*, Corners> known;
  return known.try_emplace(geometry, *static_cast<const shapes::Polyhedron*>(geometry)).first->second;
}

struct Solid {
  Body body;
  Vec3d position;
  const Corners* corners = nullptr;

  Solid(const Body& b, const Vec3d& x) : body(b), position(x) {
    if (b.kind == Kind::polyhedron) corners = &corners_of(b.geometry);
  }
};

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
  const Solid& s = *static_cast<const Solid*>(object);
  const Vec3d world{direction->v[0], direction->v[1], direction->v[2]};
  Vec3d p;
  if (s.body.kind == Kind::sphere) {
    p = normalized(world) * s.body.size.x;
  } else {
    const Vec3d n = transposed_times(s.body.rotation, world);
    p = s.body.rotation * (s.body.kind == Kind::ellipsoid ? shapes::support(shapes::Ellipsoid{s.body.size}, n)
                                                          : s.body.size.x * s.corners->farthest(n));
  }
  p += s.position;
  ccdVec3Set(point, p.x, p.y, p.z);
}
void centre(const void* object, ccd_vec3_t* point) {
  const Vec3d& p = static_cast<const Solid*>(object)->position;
  ccdVec3Set(point, p.x, p.y, p.z);
}

struct Answer {
  bool overlap = false;
  double gap = 0;
};

using Ask = std::function<Answer(std::size_t)>;

// Which pairs come back within 50 ms of processor time.
std::vector<std::size_t> answered(std::size_t count, const Ask& ask) {
  const auto answers = guard::in_child(count, 0.05, ask);
  std::vector<std::size_t> list;
  for (std::size_t i = 0; i < count; ++i)
    if (answers[i]) list.push_back(i);
  return list;
}

std::shared_ptr<fcl::CollisionGeometryd> convex(const shapes::Polyhedron& shape, double scale) {
  if (shape.vertices.size() == 8 && shape.faces.size() == 6)  // the cube of edge 1
    return std::make_shared<fcl::Boxd>(scale, scale, scale);
  const auto vertices = std::make_shared<std::vector<Eigen::Vector3d>>();
  for (const Vec3d& v : shape.vertices) vertices->push_back(scale * Eigen::Vector3d(v.x, v.y, v.z));
  const auto faces = std::make_shared<std::vector<int>>();
  for (const auto& f : shape.faces) {
    faces->push_back(static_cast<int>(f.count));
    for (std::uint32_t k = 0; k < f.count; ++k) faces->push_back(static_cast<int>(shape.face_vertices[f.first + k]));
  }
  return std::make_shared<fcl::Convexd>(vertices, static_cast<int>(shape.faces.size()), faces);
}

fcl::CollisionObjectd object(const Body& b, const Vec3d& x) {
  std::shared_ptr<fcl::CollisionGeometryd> geometry;
  if (b.kind == Kind::sphere) geometry = std::make_shared<fcl::Sphered>(b.size.x);
  if (b.kind == Kind::ellipsoid) geometry = std::make_shared<fcl::Ellipsoidd>(b.size.x, b.size.y, b.size.z);
  if (b.kind == Kind::polyhedron) {
    static std::map<std::pair<const void*, double>, std::shared_ptr<fcl::CollisionGeometryd>> known;
    auto& shared = known[{b.geometry, b.size.x}];
    if (!shared) shared = convex(*static_cast<const shapes::Polyhedron*>(b.geometry), b.size.x);
    geometry = shared;
  }
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) pose.linear()(i, j) = b.rotation.row[i][j];
  pose.translation() = Eigen::Vector3d(x.x, x.y, x.z);
  return fcl::CollisionObjectd(geometry, pose);
}

struct Bodies {
  std::vector<Solid> a, b;
  std::vector<fcl::CollisionObjectd> object_a, object_b;
};

using Penetration = int (*)(const void*, const void*, const ccd_t*, ccd_real_t*, ccd_vec3_t*, ccd_vec3_t*);

Ask by_libccd(const std::shared_ptr<Bodies>& bodies, Penetration penetration, double epa, double mpr) {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = support;
  ccd.center1 = ccd.center2 = centre;
  ccd.max_iterations = 1000;
  ccd.epa_tolerance = epa;
  ccd.mpr_tolerance = mpr;
  return [bodies, penetration, ccd](std::size_t i) -> Answer {
    double depth = 0;
    ccd_vec3_t n, p;
    const bool overlap = penetration(&bodies->a[i], &bodies->b[i], &ccd, &depth, &n, &p) == 0;
    return {overlap, -depth};
  };
}

Ask by_fcl_contact(const std::shared_ptr<Bodies>& bodies) {
  fcl::CollisionRequestd request(1, true);
  request.gjk_solver_type = fcl::GST_LIBCCD;
  request.gjk_tolerance = 1e-6;
  return [bodies, request](std::size_t i) -> Answer {
    fcl::CollisionResultd result;
    fcl::collide(&bodies->object_a[i], &bodies->object_b[i], request, result);
    return result.isCollision() ? Answer{true, -result.getContact(0).penetration_depth} : Answer{};
  };
}

Ask by_fcl_distance(const std::shared_ptr<Bodies>& bodies) {
  fcl::DistanceRequestd request(true);
  request.gjk_solver_type = fcl::GST_LIBCCD;
  request.distance_tolerance = 1e-6;
  return [bodies, request](std::size_t i) -> Answer {
    fcl::DistanceResultd result;
    const double gap = fcl::distance(&bodies->object_a[i], &bodies->object_b[i], request, result);
    return {gap > 0, gap};
  };
}

bool known(Kind k) { return k == Kind::sphere || k == Kind::ellipsoid || k == Kind::polyhedron; }

}  // namespace

const char* peers_note() { return "libccd and FCL " FCL_VERSION; }

void add_peers(const Set& set, std::vector<Entry>& entries) {
  if (!known(set.a) || !known(set.b)) return;
  const auto bodies = std::make_shared<Bodies>();
  for (const Pair& p : set.list) {
    const Body &a = set.bodies[p.a], &b = set.bodies[p.b];
    bodies->a.emplace_back(a, Vec3d{});
    bodies->b.emplace_back(b, p.offset);
    bodies->object_a.push_back(object(a, {}));
    bodies->object_b.push_back(object(b, p.offset));
  }
  const auto add = [&](const char* subject, const Ask& ask) {
    const std::vector<std::size_t> list = answered(set.list.size(), ask);
    Entry& e = entries.emplace_back(Entry{&set, subject, list.size(), [list, ask] {
                                            for (const std::size_t i : list) ask(i);
                                          }});
    e.lost = set.list.size() - list.size();
    std::vector<double> errors;
    for (const std::size_t i : list) {
      const Pair& p = set.list[i];
      const Answer answer = ask(i);
      if (!answer.overlap) continue;  // without a number
      const double ours = contact::query(set.bodies[p.a], set.bodies[p.b], p.offset).gap;
      errors.push_back(std::abs(answer.gap - ours) / p.size);
    }
    note_errors(e, std::move(errors));
  };
  if (set.config == "apart") {
    add("FCL distance", by_fcl_distance(bodies));
    return;
  }
  add("libccd MPR", by_libccd(bodies, ccdMPRPenetration, 1e-4, 1e-4));
  add("libccd MPR 1e-10", by_libccd(bodies, ccdMPRPenetration, 1e-4, 1e-10));
  add("libccd EPA", by_libccd(bodies, ccdGJKPenetration, 1e-4, 1e-4));
  add("libccd EPA 1e-10", by_libccd(bodies, ccdGJKPenetration, 1e-10, 1e-4));
  add("FCL", by_fcl_contact(bodies));
}

}  // namespace pairs

#else

namespace pairs {

const char* peers_note() { return "built without libccd and FCL"; }
void add_peers(const Set&, std::vector<Entry>&) {}

}  // namespace pairs

#endif
