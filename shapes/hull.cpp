// Convex hull by Qhull (reentrant interface), made canonical: coplanar facets merged, points that are not extreme
// dropped.
#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <numeric>

#include "shapes/convex.h"
#include "shapes/polyhedron_build.h"

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace shapes::convex {
namespace {

using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;

struct QhullRun {
  qhT state{};
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> messages{std::tmpfile(),
                                                           [](std::FILE* f) { return f ? std::fclose(f) : 0; }};
  QhullRun() { qh_zero(&state, messages.get()); }
  QhullRun(const QhullRun&) = delete;
  QhullRun& operator=(const QhullRun&) = delete;
  ~QhullRun() {
    int long_blocks = 0, total = 0;
    qh_freeqhull(&state, !qh_ALL);
    qh_memfreeshort(&state, &long_blocks, &total);
  }
};

[[noreturn]] void degenerate(const char* what) {
  throw Error(std::string("convex hull: ") + what + "; allowed: points that span a volume");
}

// The cycle through undirected links, each vertex having two.
Loop cycle(const std::vector<DirectedEdge>& links) {
  std::map<std::uint32_t, Loop> neighbours;
  for (const auto& [a, b] : links) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  for (const auto& [v, n] : neighbours)
    if (n.size() != 2) degenerate("a face is not one polygon");
  Loop loop{neighbours.begin()->first};
  std::uint32_t previous = loop[0], at = neighbours.begin()->second[0];
  while (at != loop[0]) {
    loop.push_back(at);
    const Loop& n = neighbours[at];
    const std::uint32_t next = n[0] == previous ? n[1] : n[0];
    previous = at;
    at = next;
  }
  if (loop.size() != neighbours.size()) degenerate("a face is not one polygon");
  return loop;
}

// Qhull's facets as oriented polygons. No call into Qhull after the hull is built: its error exit jumps.
std::vector<Loop> qhull_facets(std::span<const Vec3d> points) {
  std::vector<coordT> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Vec3d& p : points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
  QhullRun run;
  qhT* qh = &run.state;
  char command[] = "qhull Pp";
  const int failed = qh_new_qhull(qh, 3, static_cast<int>(points.size()), coordinates.data(), False, command, nullptr,
                                  run.messages.get());
  if (failed) degenerate("points lie in a plane, on a line, or are fewer than 4");
  const auto index = [&](const vertexT* v) { return static_cast<std::uint32_t>((v->point - coordinates.data()) / 3); };
  std::vector<Loop> loops;
  facetT* facet = nullptr;
  FORALLfacets {
    Loop loop;
    if (facet->simplicial) {
      vertexT *vertex = nullptr, **vertexp = nullptr;
      FOREACHvertex_(facet->vertices) loop.push_back(index(vertex));
    } else {
      std::vector<DirectedEdge> links;
      ridgeT *ridge = nullptr, **ridgep = nullptr;
      FOREACHridge_(facet->ridges) {
        links.emplace_back(index(static_cast<vertexT*>(ridge->vertices->e[0].p)),
                           index(static_cast<vertexT*>(ridge->vertices->e[1].p)));
      }
      loop = cycle(links);
    }
    const Vec3d outward{facet->normal[0], facet->normal[1], facet->normal[2]};
    if (dot(area_vector(points, loop), outward) < 0) std::reverse(loop.begin(), loop.end());
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
    loops.push_back(std::move(loop));
  }
  std::sort(loops.begin(), loops.end());
  return loops;
}

// Facet that holds each directed edge.
std::map<DirectedEdge, std::size_t> edge_owners(const std::vector<Loop>& loops) {
  std::map<DirectedEdge, std::size_t> owner;
  for (std::size_t f = 0; f < loops.size(); ++f)
    for (std::size_t i = 0; i < loops[f].size(); ++i)
      if (!owner.emplace(DirectedEdge{loops[f][i], loops[f][(i + 1) % loops[f].size()]}, f).second)
        degenerate("two faces share a directed edge");
  for (const auto& [e, f] : owner)
    if (!owner.contains({e.second, e.first})) degenerate("an edge has only one face");
  return owner;
}

// Group of every facet. A group grows from its largest facet over neighbours that lie in that facet's plane: the plane
// of the largest one is the most accurate, and keeping it fixed stops a smooth body from being merged round its curve.
std::vector<std::size_t> coplanar_groups(std::span<const Vec3d> points, const std::vector<Loop>& loops,
                                         const std::map<DirectedEdge, std::size_t>& owner, double tolerance) {
  std::vector<Vec3d> area(loops.size());
  for (std::size_t f = 0; f < loops.size(); ++f) area[f] = area_vector(points, loops[f]);
  std::vector<std::size_t> order(loops.size()), group(loops.size(), loops.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return dot(area[a], area[a]) > dot(area[b], area[b]); });
  for (const std::size_t seed : order) {
    if (group[seed] != loops.size()) continue;
    group[seed] = seed;
    if (!(max_abs(area[seed]) > 0)) continue;
    const Vec3d n = unit(area[seed]);
    const Vec3d on_plane = points[loops[seed][0]];
    std::vector<std::size_t> stack{seed};
    while (!stack.empty()) {
      const Loop& loop = loops[stack.back()];
      stack.pop_back();
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::size_t next = owner.at({loop[(i + 1) % loop.size()], loop[i]});
        if (group[next] != loops.size() || dot(area[next], n) < 0) continue;
        const bool coplanar = std::all_of(loops[next].begin(), loops[next].end(), [&](std::uint32_t v) {
          return std::fabs(dot(n, points[v] - on_plane)) <= tolerance;
        });
        if (!coplanar) continue;
        group[next] = seed;
        stack.push_back(next);
      }
    }
  }
  return group;
}

// Boundary of each group, less the vertices that fewer than three groups meet in (inside a face or an edge).
std::vector<Loop> merged(const std::map<DirectedEdge, std::size_t>& owner, const std::vector<std::size_t>& group) {
  std::map<std::size_t, std::map<std::uint32_t, std::uint32_t>> next;  // group -> vertex -> next vertex of its boundary
  for (const auto& [e, f] : owner)
    if (group[owner.at({e.second, e.first})] != group[f] && !next[group[f]].emplace(e.first, e.second).second)
      degenerate("a merged face touches itself");
  std::map<std::uint32_t, int> groups_at;
  for (const auto& [g, boundary] : next)
    for (const auto& [v, w] : boundary) ++groups_at[v];
  std::vector<Loop> result;
  for (const auto& [g, boundary] : next) {
    Loop loop;
    std::size_t steps = 0;
    std::uint32_t at = boundary.begin()->first;
    do {
      if (groups_at[at] >= 3) loop.push_back(at);
      at = boundary.at(at);
    } while (++steps <= boundary.size() && at != boundary.begin()->first);
    if (steps != boundary.size() || loop.size() < 3) degenerate("the body is thinner than the rounding of its points");
    result.push_back(std::move(loop));
  }
  return result;
}

}  // namespace

std::vector<std::uint32_t> distinct_points(std::span<const Vec3d> points, double tolerance) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    const Vec3d &a = points[i], &b = points[j];
    return a.x != b.x ? a.x < b.x : (a.y != b.y ? a.y < b.y : a.z < b.z);
  });
  std::vector<std::uint32_t> kept;
  for (const std::uint32_t i : order) {
    bool seen = false;
    for (std::size_t k = kept.size(); k-- > 0 && points[i].x - points[kept[k]].x <= tolerance && !seen;)
      seen = max_abs(points[i] - points[kept[k]]) <= tolerance;
    if (!seen) kept.push_back(i);
  }
  return kept;
}

std::vector<Loop> hull_faces(std::span<const Vec3d> points, double tolerance) {
  if (points.size() < 4) degenerate("fewer than 4 distinct points");
  Vec3d lower = points[0], upper = points[0];
  for (const Vec3d& p : points)
    for (int i = 0; i < 3; ++i) {
      lower[i] = std::fmin(lower[i], p[i]);
      upper[i] = std::fmax(upper[i], p[i]);
    }
  const Vec3d middle = 0.5 * (lower + upper);  // Qhull's own tolerances grow with the largest coordinate
  std::vector<Vec3d> centred;
  for (const Vec3d& p : points) centred.push_back(p - middle);
  const std::vector<Loop> facets = qhull_facets(centred);
  const auto owner = edge_owners(facets);
  std::vector<Loop> loops = merged(owner, coplanar_groups(centred, facets, owner, tolerance));
  edge_owners(loops);
  return loops;
}

}  // namespace shapes::convex

namespace shapes {

Polyhedron polyhedron_from_points(std::span<const Vec3d> points, Frame frame) {
  if (points.size() < 4) throw Error("polyhedron: " + std::to_string(points.size()) + " points; allowed: at least 4");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!convex::finite(points[i]))
      throw Error("polyhedron: point " + std::to_string(i) + " is not finite; allowed: finite numbers");
  const double largest = convex::largest_coordinate(points);
  if (!(largest > 0)) throw Error("polyhedron: all points are at the origin; allowed: points that span a volume");
  const int exponent = convex::exponent_above(largest);
  std::vector<Vec3d> scaled_points;
  for (const Vec3d& p : points) scaled_points.push_back(convex::times_two_to(p, -exponent));
  const double tolerance = convex::rounding * std::ldexp(largest, -exponent);
  std::vector<Vec3d> candidates;
  const std::vector<std::uint32_t> kept = convex::distinct_points(scaled_points, tolerance);
  for (const std::uint32_t i : kept) candidates.push_back(scaled_points[i]);

  convex::Faces faces{{}, convex::hull_faces(candidates, tolerance), {}};
  std::vector<std::uint32_t> number(candidates.size(), 0);
  for (const convex::Loop& loop : faces.loops)
    for (const std::uint32_t v : loop) number[v] = 1;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (number[i] == 0) continue;
    number[i] = static_cast<std::uint32_t>(faces.vertices.size());
    faces.vertices.push_back(candidates[i]);
    faces.rank.push_back(kept[i]);
  }
  for (convex::Loop& loop : faces.loops)
    for (std::uint32_t& v : loop) v = number[v];
  return convex::assemble(std::move(faces), frame, exponent);
}

}  // namespace shapes
