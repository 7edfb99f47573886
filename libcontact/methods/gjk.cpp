#include "libcontact/methods/gjk.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "libcontact/methods/difference_corner.h"
#include "libcontact/methods/segments.h"

namespace contact {
namespace {

constexpr int iteration_limit = 64;

struct SimplexVertex {
  Vec3d y;  // other − self
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

// The part of a simplex that is nearest to the origin: its vertices, the weights of the nearest point.
struct Nearest {
  int count, vertex[3];
  double weight[3];
  double square = std::numeric_limits<double>::infinity();
};

// Of the last vertex and of the insides of the edges and triangles at it: every other point of the boundary belongs to
// the simplex before, whose nearest point is known to be farther. Unless the origin is inside.
Nearest nearest_of_boundary(const Simplex& s) {
  const int last = s.count - 1;
  const Vec3d& w = s.vertex[last].y;
  Nearest best{1, {last}, {1}, dot(w, w)};
  Vec3d edge[3];
  for (int i = 0; i < last; ++i) {
    const Vec3d e = edge[i] = s.vertex[i].y - w;
    const double t = -dot(w, e), square = dot(e, e);
    if (!(t > 0 && t < square)) continue;
    const double along = t / square;
    const Vec3d y = (1 - along) * w + along * s.vertex[i].y;
    if (const double d = dot(y, y); d < best.square) best = {2, {last, i}, {1 - along, along}, d};
  }
  for (int i = 0; i < last; ++i)
    for (int j = i + 1; j < last; ++j) {
      const Vec3d n = cross(edge[i], edge[j]);
      const double area = dot(n, n);
      const double wi = -dot(cross(w, edge[j]), n), wj = -dot(cross(edge[i], w), n);
      if (!(area > 0 && wi > 0 && wj > 0 && wi + wj < area)) continue;
      const double ti = wi / area, tj = wj / area, rest = 1 - ti - tj;
      const Vec3d y = rest * w + ti * s.vertex[i].y + tj * s.vertex[j].y;
      if (const double d = dot(y, y); d < best.square) best = {3, {last, i, j}, {rest, ti, tj}, d};
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
    if (length > 0) unit_direction(v * (1 / length));
  }
  void unit_direction(const Vec3d& n) {
    const Separation at = pair.separation(n);
    if (at.value > found.lower) found.lower = at.value, found.normal = n, found.at = at;
  }
};

// Supports of large bodies are found by walks, which may end early: a direction counts as it does over all vertices.
void run_gjk(Best& best, double size) {
  const PolyhedronPair& pair = best.pair;
  Simplex s;
  s.vertex[0] = {pair.other_vertex(best.found.at.on_other) - pair.self_vertex(best.found.at.on_self),
                 best.found.at.on_self, best.found.at.on_other};
  s.weight[0] = 1;
  s.count = 1;
  double highest = best.found.lower;
  Vec3d normal = best.found.normal;
  for (int& i = best.found.iterations; i < iteration_limit; ++i) {
    const Vec3d v = s.nearest();
    const double square = dot(v, v);
    if (!(square > 16 * epsilon * epsilon * size * size)) break;
    const double length = std::sqrt(square);
    const Vec3d n = v * (1 / length);
    const Corner corner = support(pair, n);
    const double value = -dot(n, corner.at);
    if (value > highest) highest = value, normal = n;
    bool repeated = length - value <= 4 * epsilon * size;
    for (int k = 0; k < s.count; ++k) repeated |= s.vertex[k].on_self == corner.a && s.vertex[k].on_other == corner.b;
    if (repeated) break;
    s.vertex[s.count++] = {-corner.at, corner.a, corner.b};
    if (holds_origin(s)) break;
    const Nearest nearest = nearest_of_boundary(s);
    if (!(nearest.square < square)) {  // no progress in rounding: keep what was found
      --s.count;
      break;
    }
    SimplexVertex kept[3];
    for (int k = 0; k < nearest.count; ++k) kept[k] = s.vertex[nearest.vertex[k]];
    s.count = nearest.count;
    for (int k = 0; k < s.count; ++k) s.vertex[k] = kept[k], s.weight[k] = nearest.weight[k];
  }
  best.unit_direction(normal);
  if (s.count == 4) return;  // the origin inside: the points found so far stand
  Vec3d a{}, b{};
  for (int k = 0; k < s.count; ++k) {
    a += s.weight[k] * pair.self_vertex(s.vertex[k].on_self);
    b += s.weight[k] * pair.other_vertex(s.vertex[k].on_other);
  }
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

PolyhedronDistance polyhedron_distance(const PolyhedronPair& pair, const Vec3d& normal, const Separation& at,
                                       double size) {
  const Vec3d a = pair.self_vertex(at.on_self), b = pair.other_vertex(at.on_other);
  Best best{pair, {at.value, norm(b - a), normal, a, b, 0, at}};
  run_gjk(best, size);
  if (best.found.upper - best.found.lower > 8 * epsilon * size) compare_features(best, size);
  return best.found;
}

}  // namespace contact
