// Shared by the shape tests: counter-free seeded random numbers, topology checks, bitwise comparison.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "shapes/polyhedron_build.h"

namespace shape_tests {

using shapes::Polyhedron;
using shapes::Vec3d;

inline constexpr double eps = 0x1p-52;

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double uniform(double a, double b) { return a + (b - a) * (static_cast<double>(engine_() >> 11) * 0x1p-53); }
  Vec3d in_box(const Vec3d& lower, const Vec3d& upper) {
    return {uniform(lower.x, upper.x), uniform(lower.y, upper.y), uniform(lower.z, upper.z)};
  }
  Vec3d direction() {
    for (;;) {
      const Vec3d v = in_box({-1, -1, -1}, {1, 1, 1});
      const double n = norm(v);
      if (n > 0.1 && n < 1) return normalized(v);
    }
  }
  shapes::Quatd rotation() {
    const Vec3d axis = direction();
    const double half = uniform(0, std::numbers::pi);
    return {std::cos(half), std::sin(half) * axis.x, std::sin(half) * axis.y, std::sin(half) * axis.z};
  }
  template <class Container>
  void shuffle(Container& c) {
    for (std::size_t i = c.size(); i > 1; --i) std::swap(c[i - 1], c[engine_() % i]);
  }

 private:
  std::mt19937_64 engine_;
};

inline std::vector<Vec3d> random_points(unsigned seed, int count) {
  Random random(seed);
  std::vector<Vec3d> points;
  for (int i = 0; i < count; ++i) points.push_back(random.in_box({-1, -0.7, -0.4}, {1, 0.7, 0.4}));
  return points;
}

// Canonical form: closed, Euler's formula, loops and edges that agree, padded arrays, half-spaces that hold the body.
inline void expect_canonical(const Polyhedron& p) {
  ASSERT_GE(p.vertices.size(), 4u);
  EXPECT_EQ(p.vertices.size() - p.edges.size() + p.faces.size(), 2u);
  ASSERT_EQ(p.face_vertices.size(), 2 * p.edges.size());
  ASSERT_EQ(p.face_edges.size(), p.face_vertices.size());
  std::vector<int> faces_at_vertex(p.vertices.size(), 0), uses(p.edges.size(), 0);
  double size = 0;
  for (const Vec3d& v : p.vertices) size = std::fmax(size, max_abs(v));
  for (std::uint32_t f = 0; f < p.faces.size(); ++f) {
    const auto& face = p.faces[f];
    ASSERT_GE(face.count, 3u);
    EXPECT_NEAR(norm(face.normal), 1, 4 * eps);
    double farthest = -4 * size;
    for (const Vec3d& v : p.vertices) farthest = std::fmax(farthest, dot(face.normal, v));
    EXPECT_EQ(farthest, face.offset);
    for (std::uint32_t i = 0; i < face.count; ++i) {
      const std::uint32_t a = p.face_vertices[face.first + i], b = p.face_vertices[face.first + (i + 1) % face.count];
      const auto& edge = p.edges[p.face_edges[face.first + i]];
      ++faces_at_vertex[a];
      ++uses[p.face_edges[face.first + i]];
      const int side = edge.face[0] == f ? 0 : 1;
      EXPECT_EQ(edge.face[side], f);
      EXPECT_EQ(edge.vertex[side], a);
      EXPECT_EQ(edge.vertex[1 - side], b);
    }
  }
  for (const int n : faces_at_vertex) EXPECT_GE(n, 3);
  for (const int n : uses) EXPECT_EQ(n, 2);
  // Around every vertex its edges, in turn with the faces between them; below every face its next vertex.
  ASSERT_EQ(p.first_spoke.size(), p.vertices.size() + 1);
  ASSERT_EQ(p.spokes.size(), 2 * p.edges.size());
  for (std::uint32_t v = 0; v < p.vertices.size(); ++v) {
    const std::uint32_t first = p.first_spoke[v], end = p.first_spoke[v + 1];
    ASSERT_EQ(static_cast<int>(end - first), faces_at_vertex[v]);
    for (std::uint32_t k = first; k < end; ++k) {
      const auto& spoke = p.spokes[k];
      const auto& next = p.spokes[k + 1 == end ? first : k + 1];
      const auto& edge = p.edges[spoke.edge];
      const int side = edge.vertex[0] == v ? 0 : 1;
      EXPECT_EQ(edge.vertex[side], v);
      EXPECT_EQ(edge.vertex[1 - side], spoke.vertex);
      EXPECT_EQ(edge.face[side], spoke.face);
      EXPECT_TRUE(p.edges[next.edge].face[0] == spoke.face || p.edges[next.edge].face[1] == spoke.face);
    }
  }
  ASSERT_EQ(p.face_rise.size(), p.faces.size());
  for (std::uint32_t f = 0; f < p.faces.size(); ++f) {
    const auto& face = p.faces[f];
    double rise = 4 * size;
    for (std::uint32_t v = 0; v < p.vertices.size(); ++v) {
      bool on_face = false;
      for (std::uint32_t i = 0; i < face.count; ++i) on_face |= p.face_vertices[face.first + i] == v;
      if (!on_face) rise = std::fmin(rise, face.offset - dot(face.normal, p.vertices[v]));
    }
    EXPECT_NEAR(p.face_rise[f], rise, 64 * eps * size);
  }
  // The tip of the triangle over each edge lies in both of its faces, and on the border of one of them.
  ASSERT_EQ(p.edge_tent.size(), p.edges.size());
  for (std::uint32_t i = 0; i < p.edges.size(); ++i) {
    const auto& edge = p.edges[i];
    const Vec3d start = p.vertices[edge.vertex[0]], along = p.vertices[edge.vertex[1]] - start;
    double least = 4 * size;
    for (int side = 0; side < 2; ++side) {
      const auto& face = p.faces[edge.face[side]];
      const Vec3d up = cross(face.normal, side == 0 ? along : -along);
      const Vec3d tip = start + 0.5 * along + (0.5 * std::sqrt(p.edge_tent[i])) * up;
      for (std::uint32_t k = 0; k < face.count; ++k) {
        const Vec3d& from = p.vertices[p.face_vertices[face.first + k]];
        const Vec3d& to = p.vertices[p.face_vertices[face.first + (k + 1) % face.count]];
        const Vec3d inward = normalized(cross(face.normal, to - from));
        least = std::fmin(least, dot(inward, tip - from));
      }
    }
    EXPECT_GE(least, 0);
    EXPECT_LE(least, 0x1p-18 * size);
  }
  ASSERT_EQ(p.lookup.size(), 6 * p.lookup_cells * p.lookup_cells);
  for (const std::uint32_t v : p.lookup) EXPECT_LT(v, p.vertices.size());
  double core = 4 * size;
  for (const auto& f : p.faces) core = std::fmin(core, f.offset - dot(f.normal, p.mass.centre));
  EXPECT_EQ(p.core_radius, core);
  EXPECT_EQ(p.vx.size() % shapes::polyhedron_padding, 0u);
  EXPECT_EQ(p.nx.size() % shapes::polyhedron_padding, 0u);
  EXPECT_GE(p.vx.size(), p.vertices.size());
  for (std::size_t i = 0; i < p.vx.size(); ++i) {
    const Vec3d& v = p.vertices[i < p.vertices.size() ? i : 0];
    EXPECT_TRUE(p.vx[i] == v.x && p.vy[i] == v.y && p.vz[i] == v.z);
  }
  for (std::size_t i = 0; i < p.nx.size(); ++i) {
    const auto& f = p.faces[i < p.faces.size() ? i : 0];
    EXPECT_TRUE(p.nx[i] == f.normal.x && p.ny[i] == f.normal.y && p.nz[i] == f.normal.z && p.nd[i] == f.offset);
  }
}

// Numbers that fix a body apart from the numbering of its vertices and faces, in a fixed order: equal means bit for
// bit. Lengths are multiplied by 2^-k, areas and so on accordingly.
inline std::vector<std::vector<double>> fingerprint(const Polyhedron& p, int k = 0) {
  const auto length = [&](double x) { return std::ldexp(x, -k); };
  std::vector<std::vector<double>> rows;
  for (const Vec3d& v : p.vertices) rows.push_back({length(v.x), length(v.y), length(v.z)});
  for (const auto& f : p.faces) {
    std::vector<std::vector<double>> corners;
    for (std::uint32_t i = 0; i < f.count; ++i) {
      const Vec3d& v = p.vertices[p.face_vertices[f.first + i]];
      corners.push_back({length(v.x), length(v.y), length(v.z)});
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    std::vector<double> row{f.normal.x, f.normal.y, f.normal.z, length(f.offset)};
    for (const auto& c : corners) row.insert(row.end(), c.begin(), c.end());
    rows.push_back(row);
  }
  std::sort(rows.begin(), rows.end());
  const auto& q = p.frame.orientation;
  rows.push_back({std::ldexp(p.mass.volume, -3 * k), length(p.mass.centre.x), length(p.mass.centre.y),
                  length(p.mass.centre.z), length(p.circumradius), length(p.inscribed_radius), q.w, q.x, q.y, q.z,
                  length(p.frame.position.x), length(p.frame.position.y), length(p.frame.position.z)});
  return rows;
}

template <class Build>
std::string refusal(Build build) {
  try {
    build();
  } catch (const shapes::Error& e) {
    return e.what();
  }
  return "";
}
inline bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace shape_tests
