#include "libcontact/methods/gjk.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/methods/segments.h"

namespace contact {
namespace {

constexpr int iteration_limit = 64;

struct SimplexVertex {
  Vec3d y;  // other − self
  Vec3d a, b;
  std::uint32_t on_self, on_other;
};

struct Simplex {
  SimplexVertex vertex[4];
  double weight[4];
  int count = 0;

  Vec3d nearest() const {
    Vec3d sum{};
    for (int i = 0; i < count; ++i) sum += weight[i] * vertex[i].y;
    return sum;
  }
};

// Weights of the point of a sub-simplex nearest to the origin; `chosen` has a bit per vertex that takes part.
struct Nearest {
  double weight[4] = {};
  double square = std::numeric_limits<double>::infinity();
};

void consider(const Simplex& s, const double (&weight)[4], Nearest& best) {
  Vec3d y{};
  for (int i = 0; i < s.count; ++i) y += weight[i] * s.vertex[i].y;
  const double square = dot(y, y);
  if (square < best.square) {
    best.square = square;
    std::copy(weight, weight + 4, best.weight);
  }
}

// All vertices, and the insides of all edges and triangles: the nearest point of a simplex lies in one of them, unless
// the origin is inside.
Nearest nearest_of_boundary(const Simplex& s) {
  Nearest best;
  for (int i = 0; i < s.count; ++i) {
    double w[4] = {};
    w[i] = 1;
    consider(s, w, best);
    for (int j = i + 1; j < s.count; ++j) {
      const Vec3d e = s.vertex[j].y - s.vertex[i].y;
      const double t = -dot(s.vertex[i].y, e), square = dot(e, e);
      if (t > 0 && t < square) {
        double v[4] = {};
        v[j] = t / square;
        v[i] = 1 - v[j];
        consider(s, v, best);
      }
      for (int k = j + 1; k < s.count; ++k) {
        const Vec3d f = s.vertex[k].y - s.vertex[i].y;
        const Vec3d n = cross(e, f), w0 = s.vertex[i].y;
        const double area = dot(n, n);
        const double wj = -dot(cross(w0, f), n), wk = -dot(cross(e, w0), n);
        if (area > 0 && wj > 0 && wk > 0 && wj + wk < area) {
          double v[4] = {};
          v[j] = wj / area;
          v[k] = wk / area;
          v[i] = 1 - v[j] - v[k];
          consider(s, v, best);
        }
      }
    }
  }
  return best;
}

bool holds_origin(const Simplex& s) {
  if (s.count < 4) return false;
  for (int i = 0; i < 4; ++i) {
    const Vec3d& p = s.vertex[(i + 1) & 3].y;
    const Vec3d n = cross(s.vertex[(i + 2) & 3].y - p, s.vertex[(i + 3) & 3].y - p);
    const double inner = dot(n, s.vertex[i].y - p), origin = -dot(n, p);
    if (!(inner * origin > 0)) return false;
  }
  return true;
}

// What is known so far: the nearest points found and the best supporting planes.
struct Best {
  const PolyhedronPair& pair;
  PolyhedronDistance found;

  void points(const Vec3d& a, const Vec3d& b) {
    const double distance = norm(b - a);
    if (distance < found.upper) found.upper = distance, found.on_self = a, found.on_other = b;
  }
  void direction(const Vec3d& v) {
    const double length = norm(v);
    if (!(length > 0)) return;
    const Vec3d n = v * (1 / length);
    const double value = pair.separation(n).value;
    if (value > found.lower) found.lower = value, found.normal = n;
  }
};

void run_gjk(Best& best, double size) {
  const PolyhedronPair& pair = best.pair;
  const auto vertex_of = [&](const Separation& s) {
    SimplexVertex v;
    v.a = pair.self_vertex(s.on_self);
    v.b = pair.other_vertex(s.on_other);
    v.y = v.b - v.a;
    v.on_self = s.on_self;
    v.on_other = s.on_other;
    return v;
  };
  Simplex s;
  s.vertex[0] = vertex_of(pair.separation(best.found.normal));
  s.weight[0] = 1;
  s.count = 1;
  for (int& i = best.found.iterations; i < iteration_limit; ++i) {
    const Vec3d v = s.nearest();
    const double square = dot(v, v);
    if (!(square > 16 * epsilon * epsilon * size * size)) break;
    const double length = std::sqrt(square);
    const Vec3d n = v * (1 / length);
    const Separation support = pair.separation(n);
    if (support.value > best.found.lower) best.found.lower = support.value, best.found.normal = n;
    bool repeated = length - support.value <= 4 * epsilon * size;
    for (int k = 0; k < s.count; ++k)
      repeated |= s.vertex[k].on_self == support.on_self && s.vertex[k].on_other == support.on_other;
    if (repeated) break;
    s.vertex[s.count++] = vertex_of(support);
    if (holds_origin(s)) break;
    const Nearest nearest = nearest_of_boundary(s);
    if (!(nearest.square < square)) {  // no progress in rounding: keep what was found
      --s.count;
      break;
    }
    int kept = 0;
    for (int k = 0; k < s.count; ++k)
      if (nearest.weight[k] > 0) s.vertex[kept] = s.vertex[k], s.weight[kept++] = nearest.weight[k];
    s.count = kept;
  }
  if (s.count == 4) return;  // the origin inside: the points found so far stand
  Vec3d a{}, b{};
  for (int k = 0; k < s.count; ++k) a += s.weight[k] * s.vertex[k].a, b += s.weight[k] * s.vertex[k].b;
  best.points(a, b);
}

// Vertex of `pair.other` over a face of `pair.self`, for the vertices and faces within `depth` of the supporting
// planes. Where bodies touch, rounding may put the vertex behind the face: its foot is a point of the face all the
// same.
template <class Report>
void vertices_over_faces(const PolyhedronPair& pair, const Vec3d& n, double depth, Report&& report) {
  const double highest = pair.highest_of_self(n).value, lowest = pair.lowest_of_other(n).value;
  for (const auto& face : pair.self->faces) {
    const std::uint32_t* loop = pair.self->face_vertices.data() + face.first;
    bool near = false;
    for (std::uint32_t k = 0; k < face.count && !near; ++k) near = dot(n, pair.self_vertex(loop[k])) >= highest - depth;
    if (!near) continue;
    for (std::uint32_t j = 0; j < pair.other->vertices.size(); ++j) {
      const Vec3d v = pair.other_vertex(j);
      if (dot(n, v) > lowest + depth) continue;
      const double level = dot(face.normal, v) - pair.self_scale * face.offset;
      bool over = true;
      for (std::uint32_t k = 0; k < face.count && over; ++k) {
        const Vec3d p = pair.self_vertex(loop[k]), q = pair.self_vertex(loop[k + 1 == face.count ? 0 : k + 1]);
        over = dot(cross(face.normal, q - p), v - p) >= 0;
      }
      if (over) report(v - level * face.normal, v, face.normal, level);
    }
  }
}

void compare_features(Best& best, double size) {
  const PolyhedronPair& pair = best.pair;
  const Vec3d n = best.found.normal;
  const double depth = (best.found.upper - best.found.lower) + 2 * polyhedron_rounding * size;
  const double close = best.found.upper + 4 * epsilon * size;
  const Vec3d away{};
  vertices_over_faces(pair, n, depth, [&](const Vec3d& a, const Vec3d& b, const Vec3d& normal, double level) {
    if (std::abs(level) > close) return;
    best.points(a, b);
    best.direction(normal);
  });
  const PolyhedronPair swapped = pair.swapped();
  const Vec3d m = -transposed_times(pair.other_to_self, n);
  vertices_over_faces(swapped, m, depth, [&](const Vec3d& b, const Vec3d& a, const Vec3d& normal, double level) {
    if (std::abs(level) > close) return;
    best.points(pair.other_to_self * a + pair.offset, pair.other_to_self * b + pair.offset);
    best.direction(away - pair.other_to_self * normal);
  });
  const double highest = pair.highest_of_self(n).value, lowest = pair.lowest_of_other(n).value;
  for (const auto& ea : pair.self->edges) {
    const Vec3d p = pair.self_vertex(ea.vertex[0]), e = pair.self_vertex(ea.vertex[1]) - p;
    if (std::max(dot(n, p), dot(n, p + e)) < highest - depth) continue;
    for (const auto& eb : pair.other->edges) {
      const Vec3d q = pair.other_vertex(eb.vertex[0]), f = pair.other_vertex(eb.vertex[1]) - q;
      if (std::min(dot(n, q), dot(n, q + f)) > lowest + depth) continue;
      const ClosestPoints c = segment_segment(p, e, q, f);
      if (norm(c.b - c.a) > close) continue;
      best.points(c.a, c.b);
      best.direction(c.normal);
      // Of nearly parallel edges the common perpendicular is known to eps over their angle only. The points are known
      // to eps L: across one edge their difference is off by eps L/gap about it, which moves neither edge's ends.
      best.direction(perpendicular(c.b - c.a, e));
    }
  }
}

}  // namespace

PolyhedronDistance polyhedron_distance(const PolyhedronPair& pair, const Vec3d& normal, double size) {
  const Separation start = pair.separation(normal);
  const Vec3d a = pair.self_vertex(start.on_self), b = pair.other_vertex(start.on_other);
  Best best{pair, {start.value, norm(b - a), normal, a, b, 0}};
  run_gjk(best, size);
  if (best.found.upper - best.found.lower > 8 * epsilon * size) compare_features(best, size);
  return best.found;
}

}  // namespace contact
