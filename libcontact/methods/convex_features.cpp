// The end of gjk_epa on polyhedra and polygons: the normal of a face, of a pair of edges, or across an edge, instead of
// that between two points, which nearly touching bodies leave without digits; and the nearest points of those features.
#include <cmath>

#include "libcontact/methods/convex_search.h"
#include "libcontact/methods/point_polyhedron.h"
#include "libcontact/methods/segments.h"
#include "libcontact/scale.h"

namespace contact {

namespace {

// The vertices of one body that a simplex names, and what meets there. Directions are out of the body.
class Named {
 public:
  Named(const ConvexBody& body, const Simplex& s, std::uint32_t ConvexPair::Corner::*vertex) : body_(body) {
    if (!body.has_faces()) return;
    for (int i = 0; i < s.count; ++i) {
      const std::uint32_t v = s.p[i].*vertex;
      bool known = v == ConvexBody::no_vertex;
      for (int k = 0; k < count_; ++k) known = known || vertex_[k] == v;
      if (!known) vertex_[count_++] = v;
    }
  }

  // use(face) for that face around each vertex whose normal is nearest to n; of a polygon an edge.
  template <class Use>
  void for_each_face(const Vec3d& n, Use&& use) const {
    const Vec3d m = transposed_times(body_.rotation, n);
    for (int i = 0; i < count_; ++i) {
      double most = -2;
      std::uint32_t best = ConvexBody::no_vertex;
      const auto offer = [&](std::uint32_t face) {
        if (const double along = dot(normal(face), m); along > most) most = along, best = face;
      };
      if (body_.is_solid()) {
        for_each_spoke(i, [&](const auto& spoke) { offer(spoke.face); });
      } else {
        offer(vertex_[i]);
        offer(polygon().before(vertex_[i]));
      }
      if (best != ConvexBody::no_vertex) use(best);  // none of a direction that is not finite
    }
  }
  // use(start, vector) for the edge at each vertex that is most nearly perpendicular to n, and the lines from one
  // vertex to another; from the body's origin.
  template <class Use>
  void for_each_edge(const Vec3d& n, Use&& use) const {
    if (!body_.is_solid()) return;
    const Vec3d m = transposed_times(body_.rotation, n);
    for (int i = 0; i < count_; ++i) {
      const Vec3d& start = solid().vertices[vertex_[i]];
      double least = 2;
      Vec3d best{};
      for_each_spoke(i, [&](const auto& spoke) {
        const Vec3d e = spoke.to - start;
        if (const double slope = std::abs(dot(e, m)) / norm(e); slope < least) least = slope, best = e;
      });
      use(placed(start), placed(best));
      for (int k = 0; k < i; ++k) use(placed(start), placed(solid().vertices[vertex_[k]] - start));
    }
  }
  template <class Use>
  void for_each_vertex(Use&& use) const {
    for (int i = 0; i < count_; ++i)
      use(placed(body_.is_solid() ? solid().vertices[vertex_[i]] : polygon().vertices[vertex_[i]]));
  }
  Vec3d outward(std::uint32_t face) const { return body_.rotation * normal(face); }
  // How high x, from the body's origin, stands over the face; negative when it stands beside it.
  double height_over(std::uint32_t face, const Vec3d& x) const {
    const Vec3d y = transposed_times(body_.rotation, x);
    if (body_.is_solid()) {
      const auto& f = solid().faces[face];
      return over_face(solid(), f, body_.scale, y) ? dot(f.normal, y) - body_.scale * f.offset : -1;
    }
    const Vec3d start = body_.scale * polygon().vertices[face],
                e = body_.scale * polygon().vertices[polygon().next(face)] - start;
    const double along = dot(y - start, e);
    return along >= 0 && along <= dot(e, e) ? dot(normal(face), y) - body_.scale * polygon().offsets[face] : -1;
  }

 private:
  Vec3d placed(const Vec3d& x) const { return body_.rotation * (body_.scale * x); }
  const Vec3d& normal(std::uint32_t face) const {
    return body_.is_solid() ? solid().faces[face].normal : polygon().normals[face];
  }
  const shapes::Polyhedron& solid() const { return *static_cast<const shapes::Polyhedron*>(body_.geometry); }
  const shapes::Polygon& polygon() const { return *static_cast<const shapes::Polygon*>(body_.geometry); }
  template <class Use>
  void for_each_spoke(int i, Use&& use) const {
    const shapes::Polyhedron& p = solid();
    for (std::uint32_t k = p.first_spoke[vertex_[i]]; k < p.first_spoke[vertex_[i] + 1]; ++k) use(p.spokes[k]);
  }

  const ConvexBody& body_;
  std::uint32_t vertex_[4] = {};
  int count_ = 0;
};

// Nearest points of the features, and what is left of the interval between them.
void bring_points(ConvexSearch& s, const Named& a, const Named& b) {
  const Vec3d& d = s.pair.d;
  const auto offer = [&](const Vec3d& on_a, const Vec3d& on_b) {
    const double distance = norm(on_b - on_a);
    if (!(distance < s.upper)) return;
    s.upper = distance;
    s.set_near(on_a - on_b, on_a);
  };
  const Vec3d on_a = s.near.on_a(), on_b = on_a - s.near.nearest();
  const auto over_a = [&](const Vec3d& x) {
    a.for_each_face(s.normal, [&](std::uint32_t face) {
      if (const double h = a.height_over(face, x); h >= 0) offer(x - h * a.outward(face), x);
    });
  };
  const auto over_b = [&](const Vec3d& x) {
    b.for_each_face(-s.normal, [&](std::uint32_t face) {
      if (const double h = b.height_over(face, x - d); h >= 0) offer(x, x - h * b.outward(face));
    });
  };
  over_a(on_b);
  over_b(on_a);
  b.for_each_vertex([&](const Vec3d& x) { over_a(d + x); });
  a.for_each_vertex(over_b);
  a.for_each_edge(s.normal, [&](const Vec3d& p, const Vec3d& e) {
    const ClosestPoints foot = point_segment(on_b, p, e);
    offer(foot.b, on_b);
    b.for_each_edge(s.normal, [&](const Vec3d& q, const Vec3d& f) {
      const ClosestPoints c = segment_segment(p, e, d + q, f);
      offer(c.a, c.b);
    });
  });
  b.for_each_edge(s.normal, [&](const Vec3d& q, const Vec3d& f) { offer(on_a, point_segment(on_a, d + q, f).b); });
}

}  // namespace

void finish_on_features(ConvexSearch& s) {
  const ConvexPair& pair = s.pair;
  const Named a(pair.a, s.near, &ConvexPair::Corner::vertex_a), b(pair.b, s.near, &ConvexPair::Corner::vertex_b);
  const Vec3d n = s.normal;
  const auto offer = [&](const Vec3d& candidate) {
    Vec3d m;
    if (s.finished() || !(length_and_direction(candidate, m) > 0)) return;
    s.probe(dot(m, n) < 0 ? -m : m);
  };
  a.for_each_face(n, [&](std::uint32_t face) { offer(a.outward(face)); });
  b.for_each_face(-n, [&](std::uint32_t face) { offer(-b.outward(face)); });
  if (!(pair.a.has_corners() && pair.b.has_corners())) return;  // edges and vertices: finish_on_curvature
  a.for_each_edge(n, [&](const Vec3d&, const Vec3d& e) {
    offer(perpendicular(n, e));
    b.for_each_edge(n, [&](const Vec3d&, const Vec3d& f) { offer(cross(e, f)); });
  });
  b.for_each_edge(n, [&](const Vec3d&, const Vec3d& f) { offer(perpendicular(n, f)); });
  if (s.upper > 0 && !s.finished()) bring_points(s, a, b);
}

}  // namespace contact
