#include "libcontact/methods/difference_corner.h"

#include "shapes/vertex_lookup.h"

namespace contact {
namespace {

std::uint32_t climb_from_lookup(const shapes::Polyhedron& p, const Vec3d& direction) {
  return climb(p, direction, p.lookup[shapes::lookup_patch(direction, p.lookup_cells)]).index;
}

std::uint32_t face_of(const shapes::Polyhedron& p, std::uint32_t u, std::uint32_t v, std::uint32_t w, bool& found) {
  found = false;
  for (std::uint32_t k = p.first_spoke[u]; k < p.first_spoke[u + 1]; ++k) {
    const auto& face = p.faces[p.spokes[k].face];
    int held = 0;
    for (std::uint32_t i = 0; i < face.count; ++i) {
      const std::uint32_t x = p.face_vertices[face.first + i];
      held += x == v || x == w ? 1 : 0;
    }
    if (held == 2) {
      found = true;
      return p.spokes[k].face;
    }
  }
  return 0;
}

std::uint32_t edge_of(const shapes::Polyhedron& p, std::uint32_t u, std::uint32_t v, bool& found) {
  for (std::uint32_t k = p.first_spoke[u]; k < p.first_spoke[u + 1]; ++k)
    if (p.spokes[k].vertex == v) return p.spokes[k].edge;
  found = false;
  return 0;
}

}  // namespace

Corner support(const PolyhedronPair& pair, const Vec3d& n) {
  Corner c;
  const Vec3d m = transposed_times(pair.other_to_self, n);
  const kernels::Points a = points_of(*pair.self), b = points_of(*pair.other);
  const bool scan_a = a.count <= scan_limit, scan_b = b.count <= scan_limit;
  if (scan_a && scan_b) {
    Extreme found[2];
    kernels::search_kernels().lowest_two(a, -n, b, m, found);
    c.a = found[0].index;
    c.b = found[1].index;
  } else {
    c.a = scan_a ? highest_vertex(*pair.self, n).index : climb_from_lookup(*pair.self, n);
    c.b = scan_b ? lowest_vertex(*pair.other, m).index : climb_from_lookup(*pair.other, -m);
  }
  c.at = pair.self_vertex(c.a) - pair.other_vertex(c.b);
  return c;
}

DifferenceFacet facet_of(const PolyhedronPair& pair, const Corner& u, const Corner& v, const Corner& w) {
  if (u.a == Corner::inner || v.a == Corner::inner || w.a == Corner::inner) return {};
  const bool ab = u.a == v.a, bc = v.a == w.a, ca = w.a == u.a;
  const bool one_a = ab && bc, three_a = !ab && !bc && !ca;
  const bool uv = u.b == v.b, vw = v.b == w.b, wu = w.b == u.b;
  const bool one_b = uv && vw, three_b = !uv && !vw && !wu;
  bool found = true;
  DifferenceFacet facet;
  if (one_b && three_a) {
    facet = {DifferenceFacet::face_of_a, face_of(*pair.self, u.a, v.a, w.a, found), u.b};
  } else if (one_a && three_b) {
    facet = {DifferenceFacet::face_of_b, u.a, face_of(*pair.other, u.b, v.b, w.b, found)};
  } else if (!one_a && !one_b && !three_a && !three_b) {
    facet = {DifferenceFacet::edges, edge_of(*pair.self, u.a, ab ? w.a : v.a, found),
             edge_of(*pair.other, u.b, uv ? w.b : v.b, found)};
  } else {
    found = false;
  }
  return found ? facet : DifferenceFacet{};
}

}  // namespace contact
