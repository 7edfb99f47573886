// Mesh facets: a flat region of any triangulation is one plane; edges and vertices answer once.
#include <gtest/gtest.h>

#include <algorithm>

#include "libcontact/methods/analytic.h"
#include "libcontact/methods/facet.h"
#include "libcontact/methods/features.h"
#include "libcontact/methods/polyhedron_plane.h"
#include "libcontact/methods/sat.h"
#include "shapes/mesh_build.h"
#include "tests/libcontact/poly_reference.h"

namespace {

using namespace contact;
using namespace reference;
using shapes::Mesh;

Placed<Mesh> wall(const Mesh& mesh, std::uint32_t facet, const Quatd& q = {}) {
  return {&mesh, facet, 1, rotation_matrix(q)};
}

// A rectangle [−2, 2]², on a grid with moved inner points and diagonals by chance.
Mesh rectangle(Draw& draw) {
  constexpr std::uint32_t n = 4;
  std::vector<Vec3d> points;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t j = 0; j <= n; ++j) {
      const bool inner = i > 0 && j > 0 && i < n && j < n;
      points.push_back(
          {-2.0 + i + (inner ? draw.between(-0.2, 0.2) : 0), -2.0 + j + (inner ? draw.between(-0.2, 0.2) : 0), 0});
    }
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t a = i * (n + 1) + j, b = a + n + 1, c = b + 1, d = a + 1;
      const auto add = [&](std::uint32_t x, std::uint32_t y, std::uint32_t z) {
        triangles.insert(triangles.end(), {x, y, z});
      };
      if (draw.index(2))
        add(a, b, c), add(a, c, d);
      else
        add(a, b, d), add(b, c, d);
    }
  return shapes::mesh_from_triangles(points, triangles);
}

Mesh box_mesh(const Vec3d& half) {
  const Polyhedron box = shapes::make_box(2.0 * half);
  std::vector<std::uint32_t> triangles;
  for (const auto& f : box.faces)
    for (std::uint32_t k = 1; k + 1 < f.count; ++k)
      for (const std::uint32_t i : {0u, k, k + 1}) triangles.push_back(box.face_vertices[f.first + i]);
  return shapes::mesh_from_triangles(box.vertices, triangles);
}

void expect_same(const Contact& facet, const Contact& plane, double size, int i) {
  ASSERT_EQ(facet.status, plane.status) << i;
  ASSERT_NEAR(facet.gap, plane.gap, 1e-12 * size) << i;
  ASSERT_LE(norm(facet.normal - plane.normal), 1e-12) << i;
  if (plane.gap > 0) return;
  ASSERT_LE(norm(facet.patch.centre - plane.patch.centre), 1e-12 * size) << i;
  for (int k = 0; k < 6; ++k) ASSERT_NEAR(facet.patch.spread[k], plane.patch.spread[k], 1e-12 * size * size) << i;
}

TEST(MeshFacets, TriangulatedFloorIsThePlane) {
  Draw draw(41);
  const Polyhedron solids[2] = {shapes::make_box({0.5, 0.4, 0.3}), grain("cement140_06.off")};
  for (int i = 0; i < 3000; ++i) {
    const Mesh mesh = rectangle(draw);
    ASSERT_EQ(mesh.facets.size(), 1u);
    const Quatd q = draw.orientation(), qa = draw.orientation();
    const Mat3d r = rotation_matrix(q);
    // Every third body stands right over a point of the triangulation, every third over one of its edges.
    Vec3d over{draw.between(-1, 1), draw.between(-1, 1), 0};
    const auto corner = [&](std::size_t k) { return mesh.vertices[mesh.triangles[k]]; };
    const std::size_t t = 3 * draw.index(mesh.triangles.size() / 3);
    if (i % 3 == 1) over = corner(t);
    if (i % 3 == 2) over = corner(t) + draw.unit() * (corner(t + 1) - corner(t));
    over.x = std::clamp(over.x, -1.2, 1.2), over.y = std::clamp(over.y, -1.2, 1.2);
    const double height = draw.between(0.1, 0.5), side = i % 2 ? 1 : -1;
    const Vec3d d = -(r * (over + Vec3d{0, 0, side * height})), n = r * Vec3d{0, 0, side};
    Options options;
    options.overlap_only = i % 5 == 0;
    expect_same(Features::query(Placed<shapes::Sphere>{0.3}, wall(mesh, 0, q), d, {}, nullptr),
                Analytic::query(Placed<shapes::Sphere>{0.3}, Placed<shapes::Plane>{n}, d, {}, nullptr), 1, i);
    const Placed<shapes::Ellipsoid> ellipsoid{{0.5, 0.3, 0.2}, rotation_matrix(qa)};
    expect_same(Features::query(ellipsoid, wall(mesh, 0, q), d, {}, nullptr),
                Analytic::query(ellipsoid, Placed<shapes::Plane>{n}, d, {}, nullptr), 1, i);
    const auto solid = place(solids[i % 2], 0.6 / solids[i % 2].circumradius, qa);
    const Contact plane = PolyhedronPlane::query(solid, {n}, d, {}, nullptr);
    expect_same(Features::query(solid, wall(mesh, 0, q), d, {}, nullptr), plane, 1, i);
    const Contact quick = Features::query(solid, wall(mesh, 0, q), d, options, nullptr);
    ASSERT_EQ(quick.status, plane.status);
  }
}

struct Found {
  int count = 0;
  Contact contact;
};
template <class Body>
Found contacts(const Body& body, const Mesh& mesh, const Vec3d& d) {
  Found found;
  Options options;
  options.overlap_only = true;
  for (std::uint32_t f = 0; f < mesh.facets.size(); ++f) {
    const Contact c = Features::query(body, wall(mesh, f), d, options, nullptr);
    if (c.status == Status::overlapping) ++found.count, found.contact = c;
  }
  return found;
}

// Outside a convex box, a sphere or ellipsoid meets the mesh once, with the gap and normal of the solid box.
TEST(MeshFacets, ConvexBoxAnswersOnceLikeTheSolid) {
  const Vec3d half{1, 0.8, 0.6};
  const Mesh mesh = box_mesh(half);
  ASSERT_EQ(mesh.facets.size(), 6u);
  ASSERT_EQ(mesh.edges.size(), 12u);
  const Polyhedron box = shapes::make_box(2.0 * half);
  Draw draw(12);
  Options options;
  options.overlap_only = true;
  int edges = 0, corners = 0, touching = 0;
  for (int i = 0; i < 8000; ++i) {
    const Vec3d at = {draw.between(-1.3, 1.3), draw.between(-1.1, 1.1), draw.between(-0.9, 0.9)};
    const Placed<shapes::Sphere> sphere{0.2};
    const Contact solid = Features::query(sphere, place(box, 1, {}), -at, options, nullptr);
    if (solid.gap > -0.15) {  // the centre stays outside
      const Found found = contacts(sphere, mesh, -at);
      ASSERT_EQ(found.count, solid.status == Status::overlapping ? 1 : 0) << i;
      if (found.count) {
        ++touching;
        ASSERT_NEAR(found.contact.gap, solid.gap, 1e-14);
        ASSERT_LE(norm(found.contact.normal - solid.normal), 1e-13);
        const Vec3d n = solid.normal;
        const int zero = (n.x == 0) + (n.y == 0) + (n.z == 0);
        edges += zero == 1, corners += zero == 0;
      }
    }
    const Placed<shapes::Ellipsoid> ellipsoid{{0.25, 0.2, 0.15}, rotation_matrix(draw.orientation())};
    const Contact round = Features::query(ellipsoid, place(box, 1, {}), -at, options, nullptr);
    if (round.gap > -0.05) {
      const Found found = contacts(ellipsoid, mesh, -at);
      ASSERT_EQ(found.count, round.status == Status::overlapping ? 1 : 0) << i;
      if (found.count) {
        ASSERT_NEAR(found.contact.gap, round.gap, 1e-14);
        ASSERT_LE(norm(found.contact.normal - round.normal), 1e-7);
      }
    }
  }
  EXPECT_GT(touching, 800);
  EXPECT_GT(edges, 120);
  EXPECT_GT(corners, 8);
}

// A polyhedron outside a convex box mesh is met by one facet alone, whether on a face, an edge or a corner, with the
// gap and normal of the solid box: corners of the mesh in a large face and corners of the polyhedron in the mesh alike.
TEST(MeshFacets, PolyhedraMeetABoxMeshOnceLikeTheSolid) {
  const Vec3d half{1, 0.8, 0.6};
  const Mesh mesh = box_mesh(half);
  const Polyhedron box = shapes::make_box(2.0 * half);
  const Polyhedron solids[] = {shapes::make_box({0.7, 0.5, 0.4}), shapes::make_box({3, 3, 1}),
                               shapes::make_platonic(shapes::Platonic::dodecahedron, 0.5), grain("cement140_06.off")};
  Draw draw(3);
  int faces = 0, edges = 0, corners = 0;
  for (int i = 0; i < 2000; ++i) {
    const Polyhedron& p = solids[i % 4];
    const auto solid = place(p, i % 4 == 3 ? 0.5 / p.circumradius : 1, draw.orientation());
    const Vec3d direction = draw.direction();
    const double depth = i % 8 < 4 ? 0.01 : 0.05;
    double near = 0, far = 4;
    for (int k = 0; k < 45; ++k) {
      const double middle = 0.5 * (near + far);
      (Sat::query(solid, place(box, 1, {}), direction * middle, {}, nullptr).gap < -depth ? near : far) = middle;
    }
    const Contact exact = Sat::query(solid, place(box, 1, {}), direction * near, {}, nullptr);
    const Found found = contacts(solid, mesh, direction * near);
    ASSERT_EQ(found.count, 1) << i;
    ASSERT_NEAR(found.contact.gap, exact.gap, 1e-13) << i;
    ASSERT_LE(norm(found.contact.normal - exact.normal), 1e-12) << i;
    const Vec3d n = exact.normal;
    const double most = max_abs(n);
    const bool corner_in_face = std::any_of(
        p.faces.begin(), p.faces.end(), [&](const auto& f) { return dot(solid.rotation * f.normal, n) > 1 - 1e-12; });
    (most > 1 - 1e-12 ? faces : (corner_in_face ? corners : edges)) += 1;
  }
  EXPECT_GT(faces, 200);
  EXPECT_GT(edges, 200);
  EXPECT_GT(corners, 200);
}

// A body that lies past the border of a sheet, with its lowest point under it, does not meet it.
TEST(MeshFacets, BeyondTheBorderAndUnderneathIsNoContact) {
  const Mesh mesh = shapes::mesh_from_triangles(std::vector<Vec3d>{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
                                                std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3});
  const Quatd tilt{std::cos(M_PI / 8), 0, -std::sin(M_PI / 8), 0};  // the z axis leans to −x
  const Polyhedron rod = shapes::make_box({0.1, 0.1, 2});
  const Placed<shapes::Ellipsoid> needle{{0.1, 0.1, 1}, rotation_matrix(tilt)};
  const Vec3d axis = rotation_matrix(tilt).column(2);
  ASSERT_LT(axis.x, 0);
  const Vec3d at{-1.5, 0, 0.2};  // its lower end points to +x, under the sheet; the axis passes x = −1.3 at z = 0
  for (const bool quick : {false, true}) {
    Options options;
    options.overlap_only = quick;
    EXPECT_EQ(Features::query(place(rod, 1, tilt), wall(mesh, 0), -at, options, nullptr).status, Status::separated);
    EXPECT_EQ(Features::query(needle, wall(mesh, 0), -at, options, nullptr).status, Status::separated);
  }
  const Vec3d through{-0.9, 0, 0.2};
  EXPECT_EQ(Features::query(place(rod, 1, tilt), wall(mesh, 0), -through, {}, nullptr).status, Status::overlapping);
}

// Two rectangles that meet in a room's corner: the concave edge never answers, each wall is a plane.
TEST(MeshFacets, ConcaveEdgeIsSilent) {
  const std::vector<Vec3d> points{{0, -2, 0}, {2, -2, 0}, {2, 2, 0}, {0, 2, 0}, {0, -2, 2}, {0, 2, 2}};
  const std::vector<std::uint32_t> triangles{0, 1, 2, 0, 2, 3, 0, 3, 5, 0, 5, 4};
  const Mesh mesh = shapes::mesh_from_triangles(points, triangles);
  ASSERT_EQ(mesh.facets.size(), 2u);
  Draw draw(9);
  for (int i = 0; i < 3000; ++i) {
    const Vec3d at{draw.between(0.05, 0.4), draw.between(-1, 1), draw.between(0.05, 0.4)};
    for (std::uint32_t f = 0; f < 2; ++f) {
      const Contact ball = Features::query(Placed<shapes::Sphere>{0.2}, wall(mesh, f), -at, {}, nullptr);
      const bool floor = std::abs(mesh.facets[f].normal.z) > 0.5;
      EXPECT_NEAR(ball.gap, (floor ? at.z : at.x) - 0.2, 1e-15);
      const Placed<shapes::Ellipsoid> ellipsoid{{0.3, 0.2, 0.1}, rotation_matrix(draw.orientation())};
      const Contact round = Features::query(ellipsoid, wall(mesh, f), -at, {}, nullptr);
      if (round.status == Status::overlapping) {
        EXPECT_NEAR(std::abs(floor ? round.normal.z : round.normal.x), 1, 1e-15);
      }
    }
  }
}

// The open border of a sheet: a sphere rolls off it round the edge, without a jump.
TEST(MeshFacets, OpenBorderIsContinuous) {
  Draw draw(6);
  const Mesh mesh = rectangle(draw);
  Contact previous;
  for (int i = 0; i <= 2000; ++i) {
    const Vec3d at{1.9 + 1e-4 * i, 0.3, 0.25};
    const Contact c = Features::query(Placed<shapes::Sphere>{0.3}, wall(mesh, 0), -at, {}, nullptr);
    const double exact = at.x <= 2 ? 0.25 : std::hypot(at.x - 2, 0.25);
    EXPECT_NEAR(c.gap, exact - 0.3, 1e-15);
    if (i > 0) {
      EXPECT_LE(norm(c.normal - previous.normal), 1e-3);
    }
    previous = c;
  }
}

// A polyhedron that slides off a border: the gap goes to zero without a jump, and lateral contact is not taken for
// depth.
TEST(MeshFacets, PolyhedronSlidesOffABoxMesh) {
  const Mesh mesh = box_mesh({1, 1, 1});
  const Polyhedron small = shapes::make_box({0.5, 0.5, 0.5});
  // Resting on the top, half over the edge: one contact, 0.01 deep, centred on the common part.
  const Found top = contacts(place(small, 1, {}), mesh, -Vec3d{1.0, 0, 1.24});
  ASSERT_EQ(top.count, 1);
  EXPECT_NEAR(top.contact.gap, -0.01, 1e-15);
  EXPECT_NEAR(top.contact.patch.centre.x, -0.125, 1e-14);
  // Beside the box, its upper part above the top: the side answers, the top does not.
  const Found side = contacts(place(small, 1, {}), mesh, -Vec3d{1.24, 0, 0.9});
  ASSERT_EQ(side.count, 1);
  EXPECT_NEAR(side.contact.gap, -0.01, 1e-15);
  EXPECT_NEAR(side.contact.normal.x, -1, 1e-15);
  // Turned by 45° with a face on the box's edge: once, along the face.
  const double h = std::sqrt(0.5), reach = (0.25 - 0.01) * h;
  const Quatd tilted{std::cos(M_PI / 8), 0, std::sin(M_PI / 8), 0};
  const Found edge = contacts(place(small, 1, tilted), mesh, -Vec3d{1 + reach, 0.1, 1 + reach});
  ASSERT_EQ(edge.count, 1);
  EXPECT_NEAR(edge.contact.gap, -0.01, 1e-14);
  EXPECT_LE(norm(edge.contact.normal + Vec3d{h, 0, h}), 1e-14);
  EXPECT_NEAR(edge.contact.patch.centre.y, 0, 1e-14);
}

// A flat region as a fan about a point that need not be a corner, of corners in order; `hole`: a ring about the
// corners' middle.
Mesh fan(const std::vector<Vec3d>& corners, bool hole) {
  std::vector<Vec3d> points = corners;
  std::vector<std::uint32_t> triangles;
  const auto n = static_cast<std::uint32_t>(corners.size());
  for (const Vec3d& c : corners)
    if (hole) points.push_back(0.4 * c);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    if (hole)
      triangles.insert(triangles.end(), {i, j, n + j, i, n + j, n + i});
    else if (i > 0 && j > 0)
      triangles.insert(triangles.end(), {0, i, j});
  }
  return shapes::mesh_from_triangles(points, triangles);
}

// Whether a point lies over a facet is told by the facet's inner circle or by its borders: the same.
TEST(MeshFacets, TheInnerCircleOnlySavesTime) {
  std::vector<Vec3d> disc, corner{{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
  for (int i = 0; i < 64; ++i) disc.push_back({std::cos(2 * M_PI * i / 64), std::sin(2 * M_PI * i / 64), 0});
  const Mesh meshes[] = {fan(disc, false), fan(disc, true), fan(corner, false),
                         fan({{0, 0, 0}, {5, 0, 0}, {0, 1, 0}}, false)};
  Draw draw(77);
  std::size_t within = 0, outside = 0;
  for (const Mesh& mesh : meshes) {
    ASSERT_EQ(mesh.facets.size(), 1u);
    Mesh plain = mesh;
    plain.facets[0].inner_radius = 0;
    const auto& circle = mesh.facets[0];
    EXPECT_EQ(circle.inner_radius > 0,
              &mesh == meshes || &mesh == meshes + 3);  // the centroid of the others is without
    const Scale unit = scale_of(8);
    const FacetView view(wall(mesh, 0), {0, 0, 1}, unit, unit.down * 8),
        bare(wall(plain, 0), {0, 0, 1}, unit, unit.down * 8);
    for (int i = 0; i < 20000; ++i) {
      Vec3d x{draw.between(-1.2, 5.2), draw.between(-1.2, 3.2), draw.between(-1, 1)};
      if (i % 4 == 0) {  // about the circle
        const double turn = draw.between(0, 2 * M_PI),
                     r = circle.inner_radius * (1 + draw.between(-1, 1) * (i % 8 == 0 ? 1e-14 : 0.1));
        x = circle.inner_centre + Vec3d{r * std::cos(turn), r * std::sin(turn), x.z};
      }
      const bool inside = bare.over_region(0, unit.down * x);
      ASSERT_EQ(view.over_region(0, unit.down * x), inside) << i;
      (inside ? within : outside) += 1;
    }
  }
  EXPECT_GT(within, 10000u);
  EXPECT_GT(outside, 10000u);
}

}  // namespace
