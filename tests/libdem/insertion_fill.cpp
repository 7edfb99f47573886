// Fills: nothing overlaps, nothing lies outside, amounts and distributions are what was asked for.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "libdem/build.h"
#include "libdem/insertion/occupancy.h"
#include "libdem/insertion/region.h"
#include "shapes/math/exponential.h"
#include "tests/libdem/scene_in_time.h"

namespace dem {
namespace {

using scenes::length;

Scene empty() {
  Scene s;
  s.run.steps = 1;
  s.run.dt_auto = false;
  s.run.dt = 1e-6;
  s.materials = {scenes::material("soft", 5e6, 2500, 0.5, 0.4), scenes::material("wall", 5e6, 0, 0.5, 0.4)};
  s.shapes = {scenes::sphere("ball", 0.005), scenes::ellipsoid("egg", {0.004, 0.005, 0.0075})};
  return s;
}

RegionSpec box() { return scenes::box_region("there", {-0.05, -0.04, 0.01}, {0.05, 0.06, 0.11}); }
RegionSpec cylinder() {
  RegionSpec r;
  r.name = "there";
  r.kind = "cylinder";
  r.centre = {0.01, 0.02, 0.03};
  r.axis = {1, -2, 0.5};
  r.radius = 0.05;
  r.height = 0.12;
  return r;
}
RegionSpec ball() {
  RegionSpec r = cylinder();
  r.kind = "sphere";
  r.radius = 0.06;
  return r;
}

FillSpec fill(Arrangement arrangement) {
  FillSpec f;
  f.region = "there";
  f.arrangement = arrangement;
  f.items = {scenes::item("ball", "soft", 0.4, 1), scenes::item("egg", "soft", 0.3, 0.9)};
  return f;
}

// To a half-space, negative behind it; to a mesh, over all of its triangles.
double distance_to_wall(const Wall& wall, const Vec3d& x) {
  const Vec3d local = transposed_times(shapes::rotation_matrix(wall.orientation), x - wall.position);
  if (wall.kind == shapes::Kind::plane) return local.z;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < wall.mesh->triangles.size(); t += 3) {
    Vec3d v[3];
    for (std::size_t k = 0; k < 3; ++k) v[k] = wall.mesh->vertices[wall.mesh->triangles[t + k]];
    // Convex: halve the steps of a search in barycentric coordinates, always to the nearest of the neighbours.
    double u = 0.3, w = 0.3, step = 0.25;
    const auto at = [&](double p, double q) { return length(local - v[0] * (1 - p - q) - v[1] * p - v[2] * q); };
    while (step > 1e-12) {
      const double moves[6][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -1}, {-1, 1}};
      double now = at(u, w), nu = u, nw = w;
      for (const auto& m : moves) {
        const double p = u + step * m[0], q = w + step * m[1];
        if (p < 0 || q < 0 || p + q > 1) continue;
        if (const double d = at(p, q); d < now) now = d, nu = p, nw = q;
      }
      if (nu == u && nw == w)
        step *= 0.5;
      else
        u = nu, w = nw;
    }
    best = std::min(best, at(u, w));
  }
  return best;
}

void expect_free(const World& w, const RegionSpec& spec) {
  const Region region(spec, 3);
  const auto& m = w.particles.motion;
  for (std::size_t i = 0; i < m.size(); ++i) {
    EXPECT_TRUE(region.holds_sphere(m[i].position, m[i].bounding_radius)) << i;
    for (const Wall& wall : w.walls)
      EXPECT_GE(distance_to_wall(wall, m[i].position), m[i].bounding_radius * (1 - 2e-9)) << i << wall.name;
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GE(length(m[i].position - m[j].position), (m[i].bounding_radius + m[j].bounding_radius) * (1 - 2e-9));
  }
}

TEST(Fill, NothingOverlapsNothingIsOutside) {
  for (const RegionSpec& region : {box(), cylinder(), ball()})
    for (const Arrangement a : {Arrangement::random, Arrangement::lattice, Arrangement::automatic}) {
      Scene s = empty();
      s.regions = {region};
      FillSpec f = fill(a);
      f.count = a == Arrangement::lattice ? 60 : 250;
      s.fills = {f};
      const World w = build_world(s);
      EXPECT_EQ(w.particles.count(), f.count);
      expect_free(w, region);
    }
}

TEST(Fill, AvoidsBodiesAndWallsThatAreThere) {
  for (const Arrangement a : {Arrangement::random, Arrangement::lattice, Arrangement::cubic}) {
    Scene s = empty();
    s.regions = {box()};
    s.walls = {scenes::plane("slope", "wall", {0, 0, 0.03}, {0.3, 0, 1}),
               scenes::random_floor("shelf", "wall", 0.03, 3, 0.08, 3)};
    s.bodies = {scenes::body("egg", "soft", {0.02, 0, 0.06}), scenes::body("ball", "soft", {-0.02, 0.01, 0.055})};
    FillSpec f = fill(a);
    f.items = {scenes::item("ball", "soft", 0.5, 1)};
    f.count = 100;
    s.fills = {f};
    const World w = build_world(s);
    EXPECT_EQ(w.particles.count(), 102u);
    expect_free(w, box());
  }
}

TEST(Fill, AMeshIsInTheWayFromTheDistanceOfItsNearestPoint) {
  Scene s = empty();
  s.walls = {scenes::random_floor("shelf", "wall", 0.03, 4, 0.08, 3)};
  const World w = build_world(s);
  const Occupancy there(w, {-1, -1, -1}, {1, 1, 1}), above(w, {-1, -1, 0.08001}, {1, 1, 1});
  EXPECT_FALSE(above.blocked({0, 0, 0.0801}, 0.01));  // what lies outside the box is left out
  Random random(3, 0, 0);
  for (int i = 0; i < 500; ++i) {
    const Vec3d x{random.uniform(-0.06, 0.06), random.uniform(-0.06, 0.06), random.uniform(0, 0.16)};
    const Vec3d foot{std::clamp(x.x, -0.03, 0.03), std::clamp(x.y, -0.03, 0.03), 0.08};
    const double distance = length(x - foot);
    EXPECT_TRUE(there.blocked(x, distance * (1 + 1e-12)));
    EXPECT_FALSE(there.blocked(x, distance * (1 - 1e-12)));
  }
}

// The fill of an empty box as it was before other arrangements came: cell after cell, to the bit.
TEST(Fill, TheJitteredLatticeKeepsItsBits) {
  Scene s = empty();
  FillSpec f;
  f.lower = {-0.05, -0.04, 0.01};
  f.upper = {0.05, 0.06, 0.11};
  f.count = 150;
  f.items = {scenes::item("egg", "soft", 0.6, 0.8), scenes::item("ball", "soft", 0.7, 1)};
  s.fills = {f, f};
  s.fills[1].lower.z += 0.2;
  s.fills[1].upper.z += 0.2;
  s.walls = {scenes::plane("floor", "wall", {0, 0, 0.01}, {0, 0, 1})};
  const World w = build_world(s);
  ASSERT_EQ(w.particles.count(), 300u);
  for (std::size_t stream = 0; stream < 2; ++stream) {
    double largest = 0;
    for (std::size_t i = 0; i < 150; ++i)
      largest = std::max(largest, scenes::motion(w, 150 * stream + i).bounding_radius);
    const double cell = 2 * largest;
    const Vec3d low = s.fills[stream].lower, extent = s.fills[stream].upper - low;
    const double n = std::floor(extent.x / cell), m = std::floor(extent.y / cell);
    for (std::size_t i = 0; i < 150; ++i) {
      const std::size_t at = scenes::place(w, 150 * stream + i);
      Random random(s.run.seed, (std::uint64_t(1) << 32) + stream, i);
      const auto number = static_cast<double>(i);
      const double cell_of[3] = {std::fmod(number, n), std::fmod(std::floor(number / n), m),
                                 std::floor(number / (n * m))};
      const Vec3d pitch{extent.x / n, extent.y / m, cell};
      for (int k = 0; k < 3; ++k)
        EXPECT_EQ(w.particles.motion[at].position[k],
                  low[k] + pitch[k] * (cell_of[k] + 0.5) +
                      (0.5 * pitch[k] - w.particles.motion[at].bounding_radius) * random.uniform(-1, 1));
      const Quatd q = shapes::normalized(random.rotation()), p = w.particles.orientation[at];
      EXPECT_TRUE(p.w == q.w && p.x == q.x && p.y == q.y && p.z == q.z);
    }
  }
}

TEST(Fill, AmountsAreMetWithinHalfABody) {
  Scene s = empty();
  s.regions = {cylinder()};
  const double volume = Region(cylinder(), 3).size();
  EXPECT_NEAR(volume, 3.14159265358979 * 0.0025 * 0.12, 1e-15);
  FillSpec f = fill(Arrangement::random);
  f.solid_fraction = 0.15;
  s.fills = {f};
  const auto mass = [](const World& w) { return w.balance.initial_mass; };
  const double largest = 2500 * 4 / 3.0 * 3.1416 * 0.005 * 0.005 * 0.005;
  EXPECT_NEAR(mass(build_world(s)), 0.15 * volume * 2500, 0.51 * largest);
  s.fills[0].solid_fraction = 0;
  s.fills[0].mass = 0.1;
  EXPECT_NEAR(mass(build_world(s)), 0.1, 0.51 * largest);
}

std::vector<double> factors(const World& w) {
  std::vector<double> list;
  for (const Motion& m : w.particles.motion) list.push_back(m.bounding_radius / 0.005);
  std::sort(list.begin(), list.end());
  return list;
}

Scene many(const FillItem& item, std::uint64_t count) {
  Scene s = empty();
  s.regions = {scenes::box_region("there", {0, 0, 0}, {1, 1, 1})};
  FillSpec f = fill(Arrangement::random);
  f.items = {item};
  f.count = count;
  s.fills = {f};
  return s;
}

// Kolmogorov–Smirnov distance to the truncated lognormal law; 1.63/sqrt(n) is its 1 % point.
TEST(Fill, LognormalSizes) {
  FillItem item = scenes::item("ball", "soft", 0.5, 2);
  item.distribution = SizeDistribution::lognormal;
  item.median = 0.9;
  item.sigma = 0.4;
  const auto list = factors(build_world(many(item, 4000)));
  const auto phi = [](double x) { return 0.5 * std::erfc(-(std::log(x / 0.9) / 0.4) / std::sqrt(2.0)); };
  double worst = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_TRUE(list[i] >= 0.5 * (1 - 1e-15) && list[i] <= 2 * (1 + 1e-15));
    const double f = (phi(list[i]) - phi(0.5)) / (phi(2) - phi(0.5));
    worst = std::max(worst, std::abs(f - (static_cast<double>(i) + 0.5) / 4000));
  }
  EXPECT_LT(worst, 1.63 / std::sqrt(4000.0));
}

TEST(Fill, TablesAreMetExactly) {
  FillItem item = scenes::item("ball", "soft", 1, 1);
  item.distribution = SizeDistribution::table;
  item.table = {{0.5, 1}, {1, 2}, {2, 1}};
  const auto count = [](const std::vector<double>& list, double factor) {
    return std::count_if(list.begin(), list.end(), [&](double f) { return std::abs(f / factor - 1) < 1e-12; });
  };
  const auto by_number = factors(build_world(many(item, 400)));
  EXPECT_EQ(count(by_number, 0.5), 100);
  EXPECT_EQ(count(by_number, 1), 200);
  EXPECT_EQ(count(by_number, 2), 100);
  item.share_by = ShareBy::mass;  // numbers 8 : 2 : 1/8 = 64 : 16 : 1
  const auto by_mass = factors(build_world(many(item, 810)));
  EXPECT_EQ(count(by_mass, 0.5), 640);
  EXPECT_EQ(count(by_mass, 1), 160);
  EXPECT_EQ(count(by_mass, 2), 10);
}

// Neighbours at the distance of the spacing, for a site in the middle.
std::map<int, int> neighbours(const World& w, double spacing) {
  const auto& m = w.particles.motion;
  std::map<int, int> number;
  for (std::size_t i = 0; i < m.size(); ++i) {
    int n = 0;
    for (std::size_t j = 0; j < m.size(); ++j)
      if (j != i) n += std::abs(length(m[i].position - m[j].position) / spacing - 1) < 1e-12 ? 1 : 0;
    ++number[n];
  }
  return number;
}

TEST(Fill, RegularLatticesHaveTheirNeighboursAtExactPlaces) {
  const struct {
    Arrangement arrangement;
    Vec3d extent;  // in spacings
    std::uint64_t sites;
    int neighbours, inner;  // of how many sites
  } cases[] = {{Arrangement::cubic, {4, 4, 4}, 64, 6, 8},
               {Arrangement::fcc, {1 + 4 * std::sqrt(0.5), 1 + 4 * std::sqrt(0.5), 1 + 4 * std::sqrt(0.5)}, 63, 12, 13},
               {Arrangement::hexagonal, {4.5, 1 + 3 * std::sqrt(0.75), 1}, 16, 6, 4}};
  for (const auto& c : cases)
    for (const double spacing : {0.0, 0.012}) {
      Scene s = empty();
      const double a = spacing > 0 ? spacing : 0.01, room = spacing > 0 ? 0.01 - spacing : 0;
      s.regions = {scenes::box_region("there", {0, 0, 0},
                                      {c.extent.x * a + room, c.extent.y * a + room, c.extent.z * a + room})};
      FillSpec f = fill(c.arrangement);
      f.items = {scenes::item("ball", "soft", 1, 1)};
      f.spacing = spacing;
      s.fills = {f};
      const World w = build_world(s);
      EXPECT_EQ(w.particles.count(), c.sites);
      EXPECT_EQ(neighbours(w, a)[c.neighbours], c.inner) << static_cast<int>(c.arrangement);
      EXPECT_EQ(w.particles.motion[scenes::place(w, 0)].position.x, 0.005);
    }
}

std::string refusal(const Scene& s) {
  try {
    build_world(s);
  } catch (const InputError& e) {
    return e.what();
  }
  return "";
}

TEST(Fill, WhatDoesNotFitIsRefusedWithNumbers) {
  Scene s = empty();
  s.regions = {box()};
  FillSpec f = fill(Arrangement::random);
  f.count = 5000;
  s.fills = {f};
  EXPECT_NE(refusal(s).find("of 5000 bodies found a place"), std::string::npos) << refusal(s);
  s.fills[0].arrangement = Arrangement::lattice;
  EXPECT_NE(refusal(s).find("too few free cells for 5000 bodies"), std::string::npos) << refusal(s);
  s.fills[0].arrangement = Arrangement::fcc;
  EXPECT_NE(refusal(s).find("the lattice has"), std::string::npos) << refusal(s);
  s.fills[0].spacing = 0.009;
  EXPECT_NE(refusal(s).find("fill.spacing = 0.009: bounding spheres of diameter 0.01"), std::string::npos)
      << refusal(s);
  s.fills[0].spacing = 0.0101;
  s.fills[0].count = 0;
  s.fills[0].items = {scenes::item("ball", "soft", 0.001, 0.001)};
  s.fills[0].spacing = 1e-5;
  s.regions[0].upper = {10, 10, 10};
  EXPECT_NE(refusal(s).find("too many sites"), std::string::npos) << refusal(s);
  s.regions = {box()};
  s.fills[0] = f;
  s.fills[0].count = 40000000;
  EXPECT_NE(refusal(s).find("bounding spheres of 40000000 bodies alone are"), std::string::npos) << refusal(s);
  s.fills[0].count = 0;
  s.fills[0].mass = 1e9;
  EXPECT_NE(refusal(s).find("needs more bodies than the region holds"), std::string::npos) << refusal(s);
  s.fills[0].mass = 0;
  s.fills[0].count = 1;
  s.regions = {scenes::box_region("there", {0, 0, 0}, {0.001, 1, 1})};
  EXPECT_NE(refusal(s).find("no room for the largest bounding sphere"), std::string::npos) << refusal(s);
}

TEST(Fill, AutomaticTakesRandomPlacesWhereTheLatticeHasNoRoom) {
  FillItem item = scenes::item("ball", "soft", 1, 1);
  item.distribution = SizeDistribution::table;
  item.table = {{0.2, 300}, {1, 1}};
  Scene s = many(item, 600);
  s.regions = {scenes::box_region("there", {0, 0, 0}, {0.05, 0.05, 0.05})};
  s.fills[0].arrangement = Arrangement::automatic;
  const World w = build_world(s);
  EXPECT_EQ(w.particles.count(), 600u);
  expect_free(w, s.regions[0]);
}

TEST(Fill, KeepsClearOfImagesAcrossAPeriodicFace) {
  Scene s = empty();
  s.regions = {box()};
  s.periodic.axes = "xyz";
  s.periodic.lower = box().lower;
  s.periodic.upper = box().upper;
  s.bodies = {scenes::body("ball", "soft", {-0.0495, 0, 0.0115}), scenes::body("egg", "soft", {0, 0.0595, 0.1095})};
  FillSpec f = fill(Arrangement::random);
  f.count = 300;
  s.fills = {f};
  const World w = build_world(s);
  const auto& m = w.particles.motion;
  int straddling = 0;
  for (std::size_t i = 0; i < m.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3d d = w.cell.lattice.nearest(m[i].position - m[j].position);
      straddling += d == m[i].position - m[j].position ? 0 : 1;
      EXPECT_GE(length(d), (m[i].bounding_radius + m[j].bounding_radius) * (1 - 2e-9));
    }
  EXPECT_GT(straddling, 1000);
}

TEST(Fill, InThePlaneEverythingStaysInThePlane) {
  for (const std::string kind : {"box", "disc"})
    for (const Arrangement a :
         {Arrangement::random, Arrangement::lattice, Arrangement::hexagonal, Arrangement::cubic}) {
      Scene s = empty();
      s.dimension = 2;
      s.thickness = 0.01;
      s.law.name = LawName::spring_dashpot;
      s.materials[0].stiffness = 1e4;
      s.shapes = {scenes::sphere("ball", 0.005)};
      s.shapes[0].kind = "disc";
      s.regions = {scenes::box_region("there", {-0.1, -0.1, 0}, {0.1, 0.1, 0})};
      s.regions[0].kind = kind;
      s.regions[0].radius = 0.1;
      FillSpec f = fill(a);
      f.items = {scenes::item("ball", "soft", 0.6, 1)};
      f.solid_fraction = 0.3;
      s.fills = {f};
      const World w = build_world(s);
      const Region region(s.regions[0], 2);
      double area = 0;
      const auto& m = w.particles.motion;
      for (std::size_t i = 0; i < m.size(); ++i) {
        area += 3.14159265358979 * m[i].bounding_radius * m[i].bounding_radius;
        EXPECT_TRUE(region.holds_sphere(m[i].position, m[i].bounding_radius));
        EXPECT_EQ(m[i].position.z, 0);
        EXPECT_EQ(w.particles.orientation[i].x, 0);
        EXPECT_EQ(w.particles.orientation[i].y, 0);
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_GE(length(m[i].position - m[j].position), (m[i].bounding_radius + m[j].bounding_radius) * (1 - 2e-9));
      }
      EXPECT_NEAR(area / region.size(), 0.3, 0.002);
    }
}

TEST(Fill, OrientationsAsGiven) {
  Scene s = many(scenes::item("egg", "soft", 0.5, 1), 10);
  s.fills[0].turned = Turned::given;
  s.fills[0].orientation = scenes::turn({0, 0, 1}, 0.7);
  const World w = build_world(s);
  for (const Quatd& q : w.particles.orientation) EXPECT_NEAR(q.z, std::sin(0.35), 1e-15);
}

TEST(Exponential, IsAccurate) {
  Random random(1, 2, 3);
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(-30, 30), y = std::exp(random.uniform(-60, 60));
    EXPECT_NEAR(shapes::exponential(x) / std::exp(x), 1, 4e-16);
    EXPECT_NEAR(shapes::logarithm(y), std::log(y), 4e-16 * std::max(0.5, std::abs(std::log(y))));
  }
  EXPECT_EQ(shapes::exponential(0), 1);
  EXPECT_EQ(shapes::logarithm(1), 0);
}

}  // namespace
}  // namespace dem
