// Meshes: welding, facets and real edges do not depend on how a flat region is cut into triangles.
#include <map>

#include "shapes/mesh_build.h"
#include "tests/shapes/support.h"

namespace shape_tests {
namespace {

using shapes::Mesh;
using shapes::mesh_from_triangles;

struct Soup {
  std::vector<Vec3d> vertices;
  std::vector<std::uint32_t> triangles;
};

// A rectangle a × b cut at random: a grid with moved inner points (boundary points move along it), random diagonals,
// random winding when `mixed`; every triangle has its own three vertices.
Soup rectangle(Random& random, double a, double b, int n, bool mixed) {
  std::vector<Vec3d> grid;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double u = i == 0 || i == n ? i : i + random.uniform(-0.3, 0.3),
                   v = j == 0 || j == n ? j : j + random.uniform(-0.3, 0.3);
      grid.push_back({a * u / n, b * v / n, 0});
    }
  Soup soup;
  const auto add = [&](int p, int q, int r) {
    if (mixed && random.uniform(0, 1) < 0.5) std::swap(q, r);
    for (const int k : {p, q, r}) {
      soup.triangles.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
      soup.vertices.push_back(grid[static_cast<std::size_t>(k)]);
    }
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int p = i * (n + 1) + j, q = p + n + 1;
      if (random.uniform(0, 1) < 0.5) {
        add(p, q, q + 1);
        add(p, q + 1, p + 1);
      } else {
        add(p, q, p + 1);
        add(q, q + 1, p + 1);
      }
    }
  return soup;
}

// Lists, owners and winding agree with each other.
void expect_consistent(const Mesh& m, double tolerance) {
  std::vector<int> seen(m.triangles.size() / 3, 0);
  std::uint32_t edges = 0;
  for (std::uint32_t f = 0; f < m.facets.size(); ++f) {
    const auto& facet = m.facets[f];
    EXPECT_NEAR(norm(facet.normal), 1, 4 * eps);
    for (std::uint32_t i = 0; i < facet.triangle_count; ++i) {
      const std::uint32_t t = m.facet_triangles[facet.first_triangle + i];
      ++seen[t];
      const Vec3d corner[3] = {m.vertices[m.triangles[3 * t]], m.vertices[m.triangles[3 * t + 1]],
                               m.vertices[m.triangles[3 * t + 2]]};
      EXPECT_GT(dot(cross(corner[1] - corner[0], corner[2] - corner[0]), facet.normal), 0);
      for (const Vec3d& v : corner) {
        EXPECT_NEAR(dot(facet.normal, v), facet.offset, tolerance);
        for (int k = 0; k < 3; ++k) EXPECT_TRUE(v[k] >= facet.lower[k] && v[k] <= facet.upper[k]);
      }
    }
    for (std::uint32_t i = 0; i < facet.edge_count; ++i) {
      const auto& edge = m.edges[m.facet_edges[facet.first_edge + i]];
      EXPECT_EQ(edge.facet[0], f);
      EXPECT_LT(edge.facet[0], edge.facet[1]);
      ++edges;
    }
  }
  for (const int n : seen) EXPECT_EQ(n, 1);
  EXPECT_EQ(edges, m.edges.size());
  // Each edge stands once in the border of each of its facets and at each of its ends, and looks into them.
  std::size_t borders = 0;
  for (std::uint32_t f = 0; f < m.facets.size(); ++f) {
    borders += m.facets[f].border_count;
    for (std::uint32_t i = 0; i < m.facets[f].border_count; ++i) {
      const std::uint32_t e = m.facet_borders[m.facets[f].first_border + i];
      if (i > 0) {
        EXPECT_LT(m.facet_borders[m.facets[f].first_border + i - 1], e);
      }
      const auto& edge = m.edges[e];
      const Vec3d inward = edge.inward[edge.facet[0] == f ? 0 : 1], start = m.vertices[edge.vertex[0]];
      EXPECT_TRUE(edge.facet[0] == f || edge.facet[1] == f);
      EXPECT_NEAR(norm(inward), 1, 8 * eps);
      EXPECT_NEAR(dot(inward, m.facets[f].normal), 0, 8 * eps);
      EXPECT_NEAR(dot(inward, m.vertices[edge.vertex[1]] - start), 0, tolerance + 16 * eps);
      if (m.facets[f].border_count == 4) {  // convex: all of it lies on that side
        for (std::uint32_t k = 0; k < 4; ++k)
          for (const std::uint32_t v : m.edges[m.facet_borders[m.facets[f].first_border + k]].vertex)
            EXPECT_GE(dot(inward, m.vertices[v] - start), -tolerance - 16 * eps);
      }
    }
  }
  std::size_t open = 0;
  for (const auto& edge : m.edges) {
    open += edge.facet[1] == Mesh::none;
    if (edge.facet[1] == Mesh::none) {
      EXPECT_TRUE(edge.inward[1] == (Vec3d{}));
    }
  }
  EXPECT_EQ(borders + open, 2 * m.edges.size());
  ASSERT_EQ(m.first_vertex_edge.size(), m.vertices.size() + 1);
  EXPECT_EQ(m.first_vertex_edge.back(), 2 * m.edges.size());
  for (std::uint32_t v = 0; v < m.vertices.size(); ++v)
    for (std::uint32_t i = m.first_vertex_edge[v]; i < m.first_vertex_edge[v + 1]; ++i) {
      const auto& edge = m.edges[m.vertex_edges[i]];
      EXPECT_TRUE(edge.vertex[0] == v || edge.vertex[1] == v);
    }
}

TEST(Mesh, random_triangulation_of_a_rectangle_is_one_facet_with_four_edges) {
  Random random(51);
  for (int repeat = 0; repeat < 30; ++repeat) {
    Soup soup = rectangle(random, 3, 0.7, 1 + repeat % 9, repeat % 2 == 1);
    const auto rotation = random.rotation();
    const bool flat = repeat < 6;  // as it is, then rotated and moved
    if (!flat)
      for (Vec3d& v : soup.vertices) v = rotate(rotation, v) + Vec3d{0.2, 4, -3};
    const Mesh m = mesh_from_triangles(soup.vertices, soup.triangles);
    ASSERT_EQ(m.facets.size(), 1u);
    expect_consistent(m, 64 * eps);
    ASSERT_EQ(m.edges.size(), 4u);
    double boundary = 0;
    for (const auto& e : m.edges) {
      EXPECT_EQ(e.facet[1], Mesh::none);
      boundary += norm(m.vertices[e.vertex[0]] - m.vertices[e.vertex[1]]);
    }
    EXPECT_NEAR(boundary, 2 * (3 + 0.7), 64 * eps);
    if (flat) {
      EXPECT_TRUE(std::fabs(m.facets[0].normal.z) == 1 && m.facets[0].offset == 0);
    }
    // The facet looks the way its lowest triangle was wound.
    const auto corner = [&](std::size_t i) { return soup.vertices[soup.triangles[i]]; };
    EXPECT_GT(dot(m.facets[0].normal, cross(corner(1) - corner(0), corner(2) - corner(0))), 0);
  }
}

Soup box_soup(const Polyhedron& p) {
  Soup soup{p.vertices, {}};
  for (const auto& f : p.faces)
    for (std::uint32_t i = 1; i + 1 < f.count; ++i)
      soup.triangles.insert(soup.triangles.end(),
                            {p.face_vertices[f.first], p.face_vertices[f.first + i], p.face_vertices[f.first + i + 1]});
  return soup;
}

TEST(Mesh, box_has_six_facets_and_twelve_edges) {
  const Soup soup = box_soup(shapes::make_box({1, 2, 3}));
  const Mesh m = mesh_from_triangles(soup.vertices, soup.triangles);
  expect_consistent(m, 0);
  EXPECT_EQ(m.facets.size(), 6u);
  EXPECT_EQ(m.edges.size(), 12u);
  for (const auto& e : m.edges) EXPECT_NE(e.facet[1], Mesh::none);
}

TEST(Mesh, shallow_fold_is_an_edge_and_rounding_is_not) {
  const std::vector<std::uint32_t> triangles = {0, 1, 2, 0, 2, 3};
  for (const double rise : {1e-6, 1e-9, 1e-11, 0.0}) {
    const Mesh m = mesh_from_triangles(std::vector<Vec3d>{{0, 0, 0}, {1, 0, rise}, {1, 1, 0}, {0, 1, 0}}, triangles);
    EXPECT_EQ(m.facets.size(), rise > 1e-10 ? 2u : 1u) << rise;
    EXPECT_EQ(m.edges.size(), rise > 1e-10 ? 5u : 4u) << rise;
  }
}

TEST(Mesh, finely_cut_cylinder_keeps_its_facets) {
  const int n = 720;  // half a degree each
  Soup soup;
  for (int i = 0; i < n; ++i)
    for (const double z : {0.0, 1.0})
      soup.vertices.push_back({std::cos(2 * std::numbers::pi * i / n), std::sin(2 * std::numbers::pi * i / n), z});
  for (std::uint32_t i = 0; i < 2 * n; i += 2) {
    const std::uint32_t j = (i + 2) % (2 * n);
    soup.triangles.insert(soup.triangles.end(), {i, j, j + 1, i, j + 1, i + 1});
  }
  const Mesh m = mesh_from_triangles(soup.vertices, soup.triangles);
  EXPECT_EQ(m.facets.size(), static_cast<std::size_t>(n));
  EXPECT_EQ(m.edges.size(), static_cast<std::size_t>(3 * n));
}

TEST(Mesh, change_of_units_gives_the_same_bits) {
  Random random(52);
  Soup soup = rectangle(random, 2, 1, 5, true);
  for (Vec3d& v : soup.vertices) v = rotate(shapes::Quatd{0.6, 0.8, 0, 0}, v) + Vec3d{1, 2, 3};
  const Mesh m = mesh_from_triangles(soup.vertices, soup.triangles);
  for (const int k : {-300, -20, 20, 300}) {
    auto moved = soup.vertices;
    for (Vec3d& v : moved) v = {std::ldexp(v.x, k), std::ldexp(v.y, k), std::ldexp(v.z, k)};
    const Mesh q = mesh_from_triangles(moved, soup.triangles);
    ASSERT_EQ(q.facets.size(), m.facets.size());
    EXPECT_EQ(q.triangles, m.triangles);
    EXPECT_TRUE(q.facets[0].normal == m.facets[0].normal);
    EXPECT_EQ(q.facets[0].offset, std::ldexp(m.facets[0].offset, k));
  }
}

TEST(Mesh, welds_what_rounding_has_parted) {
  Soup soup = box_soup(shapes::make_box({1, 1, 1}));
  Random random(53);
  Soup split;
  for (const std::uint32_t v : soup.triangles) {
    split.triangles.push_back(static_cast<std::uint32_t>(split.vertices.size()));
    split.vertices.push_back(soup.vertices[v] + random.in_box({-1e-13, -1e-13, -1e-13}, {1e-13, 1e-13, 1e-13}));
  }
  const Mesh m = mesh_from_triangles(split.vertices, split.triangles);
  EXPECT_EQ(m.vertices.size(), 8u);
  EXPECT_EQ(m.facets.size(), 6u);
  EXPECT_EQ(m.edges.size(), 12u);
}

TEST(Mesh, refuses_bad_input) {
  const std::vector<Vec3d> vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5, 0, 0}};
  const auto refused = [&](const std::vector<std::uint32_t>& t) {
    return refusal([&] { mesh_from_triangles(vertices, t); });
  };
  EXPECT_EQ(refused({0, 1, 2}), "");
  EXPECT_TRUE(holds(refused({0, 1, 5}), "vertex index 5; allowed: below the number of vertices, 5"));
  EXPECT_TRUE(holds(refused({0, 1}), "2 indices"));
  EXPECT_TRUE(holds(refused({}), "0 indices"));
  EXPECT_TRUE(holds(refused({0, 1, 2, 0, 4, 1}), "triangle 1 has no area"));
  EXPECT_TRUE(holds(refused({0, 1, 2, 0, 1, 1}), "triangle 1 has no area"));
  EXPECT_TRUE(holds(refused({0, 1, 2, 1, 0, 3, 0, 1, 3}), "triangles 0, 1, 2 share one edge"));
  EXPECT_TRUE(holds(refusal([] {
                      mesh_from_triangles(std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, INFINITY, 0}},
                                          std::vector<std::uint32_t>{0, 1, 2});
                    }),
                    "vertex 2 is not finite"));
}

}  // namespace
}  // namespace shape_tests
