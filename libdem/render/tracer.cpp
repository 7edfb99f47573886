#include "libdem/render/tracer.h"

#ifdef DEM_HAS_EMBREE

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace dem::render {

bool available() { return true; }

namespace {

using Triangle = std::array<std::uint32_t, 3>;

// A sphere or an ellipsoid: to_unit maps it onto the unit sphere about the origin.
struct Round {
  Vec3d centre, size;
  Mat3d rotation;
  std::uint32_t body;
  Vec3d to_unit(const Vec3d& v) const {
    const Vec3d b = transposed_times(rotation, v);
    return {b.x / size.x, b.y / size.y, b.z / size.z};
  }
};

// Ray against |x|² = 1 in the scaled space, where o and d are the ray's origin and direction:
//   t = −(o·d)/(d·d) ∓ sqrt((1 − |o − d (o·d)/(d·d)|²) / (d·d)).
// The square of the distance from the centre to the line is formed from a difference of vectors: no cancellation.
bool intersect(const Round& round, const RTCRay& ray, double& t, Vec3d& normal) {
  const Vec3d o = round.to_unit(Vec3d{ray.org_x, ray.org_y, ray.org_z} - round.centre);
  const Vec3d d = round.to_unit({ray.dir_x, ray.dir_y, ray.dir_z});
  const double dd = dot(d, d), middle = -dot(o, d) / dd;
  const Vec3d foot = o + d * middle;
  const double rest = 1 - dot(foot, foot);
  if (rest < 0) return false;
  const double half = std::sqrt(rest / dd);
  for (const double root : {middle - half, middle + half}) {
    if (!(root > static_cast<double>(ray.tnear) && root < static_cast<double>(ray.tfar))) continue;
    t = root;
    const Vec3d u = o + d * root;
    normal = round.rotation * Vec3d{u.x / round.size.x, u.y / round.size.y, u.z / round.size.z};
    return true;
  }
  return false;
}

void round_bounds(const RTCBoundsFunctionArguments* args) {
  const Round& r = static_cast<const Round*>(args->geometryUserPtr)[args->primID];
  float* lower = &args->bounds_o->lower_x;
  float* upper = &args->bounds_o->upper_x;
  for (int k = 0; k < 3; ++k) {  // half extent along an axis: |D Rᵀ e|
    const double half = norm(scaled(r.size, r.rotation.row[k])) * (1 + 1e-5);
    lower[k] = static_cast<float>(r.centre[k] - half) - 1e-6f;
    upper[k] = static_cast<float>(r.centre[k] + half) + 1e-6f;
  }
}

void round_intersect(const RTCIntersectFunctionNArguments* args) {
  if (!args->valid[0]) return;
  auto* both = reinterpret_cast<RTCRayHit*>(args->rayhit);
  double t;
  Vec3d n;
  if (!intersect(static_cast<const Round*>(args->geometryUserPtr)[args->primID], both->ray, t, n)) return;
  both->ray.tfar = static_cast<float>(t);
  both->hit = {};
  both->hit.Ng_x = static_cast<float>(n.x);
  both->hit.Ng_y = static_cast<float>(n.y);
  both->hit.Ng_z = static_cast<float>(n.z);
  both->hit.primID = args->primID;
  both->hit.geomID = args->geomID;
  both->hit.instID[0] = args->context->instID[0];
}

void round_occluded(const RTCOccludedFunctionNArguments* args) {
  if (!args->valid[0]) return;
  auto* ray = reinterpret_cast<RTCRay*>(args->ray);
  double t;
  Vec3d n;
  if (intersect(static_cast<const Round*>(args->geometryUserPtr)[args->primID], *ray, t, n)) ray->tfar = -INFINITY;
}

RTCRay to_embree(const Ray& ray, double near, double far) {
  RTCRay r{};
  r.org_x = static_cast<float>(ray.origin.x);
  r.org_y = static_cast<float>(ray.origin.y);
  r.org_z = static_cast<float>(ray.origin.z);
  r.dir_x = static_cast<float>(ray.direction.x);
  r.dir_y = static_cast<float>(ray.direction.y);
  r.dir_z = static_cast<float>(ray.direction.z);
  r.tnear = static_cast<float>(near);
  r.tfar = static_cast<float>(far);
  r.mask = ~0u;
  return r;
}

Vec3d unit_normal(const RTCHit& hit) { return normalized(Vec3d{hit.Ng_x, hit.Ng_y, hit.Ng_z}); }

struct WallTriangle {
  std::uint32_t surface;
  double altitude[3];  // above the edge opposite to each corner; infinite when that edge is no outline
};

}  // namespace

struct Tracer::Scene {
  RTCDevice device = rtcNewDevice(nullptr);
  RTCScene bodies = rtcNewScene(device), walls = rtcNewScene(device);
  std::vector<Round> rounds;
  unsigned round_geometry = RTC_INVALID_GEOMETRY_ID;
  std::vector<std::uint32_t> triangle_body;
  std::vector<WallTriangle> wall_triangles;
  std::vector<io::WallSurface> surfaces;

  ~Scene() {
    rtcReleaseScene(bodies);
    rtcReleaseScene(walls);
    rtcReleaseDevice(device);
  }

  void add_rounds(const std::vector<Body>& list) {
    for (std::uint32_t i = 0; i < list.size(); ++i)
      if (list[i].polyhedron == nullptr)
        rounds.push_back({list[i].position, list[i].size, rotation_matrix(list[i].orientation), i});
    if (rounds.empty()) return;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(rounds.size()));
    rtcSetGeometryUserData(geometry, rounds.data());
    rtcSetGeometryBoundsFunction(
        geometry, [](const RTCBoundsFunctionArguments* a) { round_bounds(a); }, nullptr);
    rtcSetGeometryIntersectFunction(geometry, round_intersect);
    rtcSetGeometryOccludedFunction(geometry, round_occluded);
    rtcCommitGeometry(geometry);
    round_geometry = rtcAttachGeometry(bodies, geometry);
    rtcReleaseGeometry(geometry);
  }

  void add_triangles(RTCScene to, const std::vector<Vec3d>& vertices, const std::vector<Triangle>& triangles) {
    if (triangles.empty()) return;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* v = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                          3 * sizeof(float), vertices.size()));
    for (const Vec3d& p : vertices)
      for (int k = 0; k < 3; ++k) *v++ = static_cast<float>(p[k]);
    auto* t = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                  3 * sizeof(std::uint32_t), triangles.size()));
    for (const Triangle& corner : triangles) t = std::copy(corner.begin(), corner.end(), t);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(to, geometry);
    rtcReleaseGeometry(geometry);
  }

  void add_polyhedra(const std::vector<Body>& list) {
    std::vector<Vec3d> vertices;
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < list.size(); ++i) {
      if (list[i].polyhedron == nullptr) continue;
      const shapes::Polyhedron& shape = *list[i].polyhedron;
      const Mat3d r = rotation_matrix(list[i].orientation);
      const auto base = static_cast<std::uint32_t>(vertices.size());
      for (const Vec3d& v : shape.vertices) vertices.push_back(list[i].position + r * (list[i].size.x * v));
      for (const auto& face : shape.faces) {
        const std::uint32_t* loop = &shape.face_vertices[face.first];
        for (std::uint32_t k = 2; k < face.count; ++k) {
          triangles.push_back({base + loop[0], base + loop[k - 1], base + loop[k]});
          triangle_body.push_back(i);
        }
      }
    }
    add_triangles(bodies, vertices, triangles);
  }

  void add_walls() {
    std::vector<Vec3d> vertices;
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
      const io::WallSurface& s = surfaces[i];
      const auto base = static_cast<std::uint32_t>(vertices.size());
      vertices.insert(vertices.end(), s.vertices.begin(), s.vertices.end());
      std::uint32_t first = 0;
      for (const std::uint32_t end : s.ends) {
        for (std::uint32_t k = first + 2; k < end; ++k) {
          const Triangle t{base + s.corners[first], base + s.corners[k - 1], base + s.corners[k]};
          // edges opposite to the corners: k − 1 → k, k → first (outline only in the last triangle), first → k − 1
          const bool outline[3] = {s.outline[k - 1] != 0, k + 1 == end && s.outline[k] != 0,
                                   k == first + 2 && s.outline[first] != 0};
          WallTriangle w{i, {no_hit, no_hit, no_hit}};
          const double area2 = norm(cross(vertices[t[1]] - vertices[t[0]], vertices[t[2]] - vertices[t[0]]));
          for (std::size_t c = 0; c < 3; ++c)
            if (outline[c]) w.altitude[c] = area2 / norm(vertices[t[(c + 2) % 3]] - vertices[t[(c + 1) % 3]]);
          triangles.push_back(t);
          wall_triangles.push_back(w);
        }
        first = end;
      }
    }
    add_triangles(walls, vertices, triangles);
  }
};

Tracer::Tracer(const std::vector<Body>& bodies, const std::vector<io::WallSurface>& walls)
    : scene_(std::make_unique<Scene>()) {
  Scene& s = *scene_;
  s.surfaces = walls;
  for (RTCScene scene : {s.bodies, s.walls}) rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
  s.add_rounds(bodies);
  s.add_polyhedra(bodies);
  s.add_walls();
  for (RTCScene scene : {s.bodies, s.walls}) rtcCommitScene(scene);
  if (rtcGetDeviceError(s.device) != RTC_ERROR_NONE) throw RunError("the ray tracer could not build its scene");
}

Tracer::~Tracer() = default;

BodyHit Tracer::body(const Ray& ray) const {
  RTCRayHit both{};
  both.ray = to_embree(ray, 0, no_hit);
  both.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene_->bodies, &context, &both);
  if (both.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  const bool round = both.hit.geomID == scene_->round_geometry;
  const std::uint32_t body = round ? scene_->rounds[both.hit.primID].body : scene_->triangle_body[both.hit.primID];
  return {static_cast<double>(both.ray.tfar), unit_normal(both.hit), body};
}

bool Tracer::blocked(const Ray& ray, double far) const {
  RTCRay r = to_embree(ray, 0, far);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(scene_->bodies, &context, &r);
  return r.tfar < 0;
}

WallHit Tracer::wall(const Ray& ray, double near, double far) const {
  RTCRayHit both{};
  both.ray = to_embree(ray, near, far);
  both.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene_->walls, &context, &both);
  if (both.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  const WallTriangle& t = scene_->wall_triangles[both.hit.primID];
  const double u = static_cast<double>(both.hit.u), v = static_cast<double>(both.hit.v), weight[3] = {1 - u - v, u, v};
  WallHit hit{static_cast<double>(both.ray.tfar), unit_normal(both.hit), t.surface, no_hit};
  for (int k = 0; k < 3; ++k)
    if (t.altitude[k] < no_hit) hit.edge = std::min(hit.edge, std::abs(weight[k]) * t.altitude[k]);
  const io::WallSurface& s = scene_->surfaces[t.surface];
  if (s.half_space)
    hit.normal = s.normal;
  else if (dot(hit.normal, ray.direction) > 0)
    hit.normal = -hit.normal;
  return hit;
}

}  // namespace dem::render

#else

namespace dem::render {

bool available() { return false; }

struct Tracer::Scene {};
Tracer::Tracer(const std::vector<Body>&, const std::vector<io::WallSurface>&) {
  throw RunError("pictures need Embree, which was not there when this program was built (Debian: libembree-dev)");
}
Tracer::~Tracer() = default;
BodyHit Tracer::body(const Ray&) const { return {}; }
bool Tracer::blocked(const Ray&, double) const { return false; }
WallHit Tracer::wall(const Ray&, double, double) const { return {}; }

}  // namespace dem::render

#endif
