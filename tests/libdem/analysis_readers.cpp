// Output of other codes: dumps, tables of bodies; what they lack is said, what is wrong is refused with its place.
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "libdem/analysis/frames.h"
#include "libdem/analysis/read_lammps.h"
#include "libdem/io/io.h"
#include "libdem/random.h"
#include "tests/libdem/io_world.h"
#include "tests/libdem/scenes_in_code.h"

namespace {

using namespace dem;
using namespace dem::analysis;
using io_test::Folder;

std::string write(const Folder& folder, const std::string& name, const std::string& text) {
  std::ofstream(folder / name) << text;
  return folder / name;
}
bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }
bool noted(const Snapshot& s, const std::string& part) {
  return std::any_of(s.notes.begin(), s.notes.end(), [&](const std::string& n) { return has(n, part); });
}
template <class Read>
std::string refusal(const Read& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

// Two frames: of spheres, unordered, with everything; the second scaled and with fewer columns.
const char* const spheres = R"(ITEM: TIMESTEP
1000
ITEM: NUMBER OF ATOMS
3
ITEM: BOX BOUNDS pp ff pp
-1 3
0 2
0 5.0e0
ITEM: ATOMS id type type x y z vx vy vz radius mass omegax omegay omegaz
7 2 2 2.9 0.5 1 1 2 3 0.25 4 0.1 0.2 0.3
3 1 1 -0.8 0.5 1 0 0 0 0.25 5 0 0 0
5 1 1 1 1.5 1 0 0 0 0.5 6 0 0 0
ITEM: TIMESTEP
2000
ITEM: NUMBER OF ATOMS
1
ITEM: BOX BOUNDS ff ff ff
0 2
0 4
0 8
ITEM: ATOMS id type xs ys zs diameter
1 1 0.5 0.25 0.125 3
)";

TEST(AnalysisReaders, DumpOfSpheres) {
  const Folder folder("lammps");
  const std::string path = write(folder, "dump.txt", spheres);
  EXPECT_TRUE(is_lammps_dump(path));
  const LammpsDump dump(path, {0, 1e-5, 0});
  ASSERT_EQ(dump.count(), 2u);
  const Snapshot s = dump.read(0);
  EXPECT_EQ(s.step, 1000u);
  EXPECT_DOUBLE_EQ(s.time, 0.01);
  EXPECT_EQ(s.id, (std::vector<std::uint64_t>{3, 5, 7}));
  EXPECT_EQ(s.position[2], (Vec3d{2.9, 0.5, 1}));
  EXPECT_EQ(s.velocity[2], (Vec3d{1, 2, 3}));
  EXPECT_EQ(s.spin[2], (Vec3d{0.1, 0.2, 0.3}));
  EXPECT_EQ(s.mass, (std::vector<double>{5, 6, 4}));
  EXPECT_EQ(s.radius, (std::vector<double>{0.25, 0.5, 0.25}));
  EXPECT_NEAR(s.volume[1], 4.0 / 3 * std::numbers::pi / 8, 1e-15);
  EXPECT_EQ(s.species, (std::vector<std::uint32_t>{1, 1, 2}));
  EXPECT_EQ(s.species_names[1], "type 2");
  EXPECT_EQ(s.periodic, (std::array<bool, 3>{true, false, true}));
  EXPECT_EQ(s.length, (Vec3d{4, 0, 5}));
  EXPECT_TRUE(s.has_velocity && s.has_mass && s.has_contacts && !s.has_forces && !s.has_rotation);
  // 3 and 7 touch across the periodic face: 0.3 apart, radii 0.25.
  ASSERT_EQ(s.contacts.size(), 1u);
  EXPECT_EQ(s.contacts[0].a, 0u);
  EXPECT_EQ(s.contacts[0].b, 2u);
  EXPECT_NEAR(s.contacts[0].branch.x, -0.3, 1e-15);
  EXPECT_NEAR(s.contacts[0].overlap, 0.2, 1e-15);
  EXPECT_EQ(s.contacts[0].normal.x, -1);

  const Snapshot t = dump.read(1);
  EXPECT_EQ(t.step, 2000u);
  EXPECT_EQ(t.position[0], (Vec3d{1, 1, 1}));
  EXPECT_EQ(t.radius[0], 1.5);
  EXPECT_FALSE(t.has_velocity || t.has_mass);
  EXPECT_TRUE(noted(t, "no velocities") && noted(t, "no masses") && noted(t, "no spins"));
  EXPECT_TRUE(noted(LammpsDump(path, {}).read(1), "numbers of steps"));
  const Snapshot dense = LammpsDump(path, {1000, 0, 0}).read(1);
  EXPECT_TRUE(dense.has_mass);
  EXPECT_DOUBLE_EQ(dense.mass[0], 1000 * dense.volume[0]);
}

TEST(AnalysisReaders, DumpOfEllipsoids) {
  const Folder folder("lammps_ellipsoids");
  const std::string box = "ITEM: TIMESTEP\n5\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n";
  const std::string lammps =
      write(folder, "a.dump",
            box +
                "ITEM: TIME\n0.5\nITEM: ATOMS id xu yu zu shapex shapey shapez quatw quati quatj "
                "quatk\n1 1.25 -0.25 3.5 0.2 0.4 0.6 2 0 0 0\n2 0.5 0.5 0.5 0.2 0.2 0.2 0 1 0 0\n");
  const Snapshot s = LammpsDump(lammps, {}).read(0);
  EXPECT_EQ(s.time, 0.5);
  EXPECT_NEAR(norm(s.position[0] - Vec3d{0.25, 0.75, 0.5}), 0, 1e-15);
  EXPECT_EQ(s.size[0], (Vec3d{0.1, 0.2, 0.3}));
  EXPECT_EQ(s.shape_of(0).kind, shapes::Kind::ellipsoid);
  EXPECT_NEAR(s.volume[0], 4.0 / 3 * std::numbers::pi * 0.006, 1e-15);
  EXPECT_NEAR(s.bounding_radius[0], 0.3, 1e-15);
  EXPECT_EQ(s.orientation[0].w, 1);
  EXPECT_EQ(s.shape_of(1).kind, shapes::Kind::sphere);
  EXPECT_NEAR(s.radius[1], 0.1, 1e-15);
  EXPECT_FALSE(s.has_contacts);
  const std::string columns =
      "ITEM: ATOMS id x y z shapex shapey shapez quat1 quat2 quat3 quat4 blockiness1 blockiness2\n";
  const std::string half =
      write(folder, "b.dump", box + columns + "1 0 0 0 0.1 0.2 0.3 1 0 0 0 2 2\n2 0 0 0 0.1 0.2 0.3 1 0 0 0 2 2\n");
  EXPECT_EQ(LammpsDump(half, {}).read(0).size[0], (Vec3d{0.1, 0.2, 0.3}));
  const std::string blocky =
      write(folder, "c.dump", box + columns + "1 0 0 0 0.1 0.2 0.3 1 0 0 0 2 2\n2 0 0 0 0.1 0.2 0.3 1 0 0 0 8 2\n");
  EXPECT_TRUE(has(refusal([&] { LammpsDump(blocky, {}).read(0); }), "blockiness"));
}

TEST(AnalysisReaders, DamagedDumps) {
  const Folder folder("lammps_bad");
  const std::string whole(spheres);
  const auto said = [&](const std::string& text) {
    const std::string path = write(folder, "bad.dump", text);
    return refusal([&] { LammpsDump(path, {}).read(0); });
  };
  const auto replaced = [&](const std::string& from, const std::string& to) {
    std::string text = whole;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_TRUE(has(said(whole.substr(0, whole.find("5 1 1 1 1.5"))), "cut short"));
  EXPECT_TRUE(has(said(whole.substr(0, whole.find("5 1 1 1 1.5"))), "bad.dump:12:1"));
  EXPECT_TRUE(has(said(replaced("5 1 1 1 1.5", "ITEM: TIMESTEP")), "2 bodies of 3"));
  EXPECT_TRUE(has(said(replaced("0.25 4 0.1", "nan 4 0.1")), "'nan' is not a number"));
  EXPECT_TRUE(has(said(replaced("0.25 4 0.1", "0 4 0.1")), "allowed > 0"));
  EXPECT_TRUE(has(said(replaced(" 0.1 0.2 0.3\n", " 0.1 0.2\n")), "13 values, but 14 columns"));
  EXPECT_TRUE(has(said(replaced("radius", "c_r")), "no sizes"));
  EXPECT_TRUE(has(said(replaced("type x y z", "type a y z")), "no places"));
  EXPECT_TRUE(has(said(replaced("0 2\n", "0 2 0.5\n")), "tilted"));
  EXPECT_TRUE(has(said(replaced("5 1 1 1 1.5", "3 1 1 1 1.5")), "stands twice"));
  EXPECT_TRUE(has(said(replaced("0 5.0e0", "5 5.0e0")), "box is empty"));
  EXPECT_TRUE(has(said("ITEM: NOTHING\n"), "no frame"));
  EXPECT_TRUE(has(said("ITEM: TIMESTEP\n\n"), "the step is missing"));
  EXPECT_FALSE(is_lammps_dump(write(folder, "other.txt", "id,x,y\n")));
}

// Contacts of random spheres of unlike sizes, open and periodic, against all pairs.
TEST(AnalysisReaders, ContactsOfSpheresAgainstAllPairs) {
  Random random(11, 0, 0);
  for (const std::array<bool, 3>& periodic :
       {std::array{false, false, false}, std::array{true, true, true}, std::array{false, true, false}}) {
    Snapshot s;
    s.periodic = periodic;
    s.lower = {1, 2, 3};
    s.length = {2, 3, 2.5};
    ForeignBodies bodies;
    for (std::uint64_t i = 0; i < 400; ++i) {
      ForeignBody b;
      b.id = 1000 - i;
      const double r = random.uniform(0.05, 0.3);
      b.semi_axes = {r, r, r};
      b.position = s.lower + Vec3d{random.uniform(0, 2), random.uniform(0, 3), random.uniform(0, 2.5)};
      bodies.add(b);
    }
    bodies.finish("here", {0, 0, 0.01}, s);
    std::set<std::pair<std::uint32_t, std::uint32_t>> found, expected;
    for (const SnapshotContact& c : s.contacts) found.insert({c.a, c.b});
    EXPECT_EQ(found.size(), s.contacts.size());
    for (std::uint32_t i = 0; i < s.count(); ++i)
      for (std::uint32_t j = i + 1; j < s.count(); ++j)
        if (norm(s.between(s.position[i], s.position[j])) <= 1.01 * (s.radius[i] + s.radius[j]))
          expected.insert({i, j});
    EXPECT_GT(expected.size(), 100u);
    EXPECT_EQ(found, expected);
  }
}

TEST(AnalysisReaders, TablesOfBodies) {
  const Folder folder("bodies_csv");
  const std::string plain = write(folder, "plain.csv", "x,y,z,radius\n0,0,0,1\n1.9,0,0,1\n0,5,0,2\n");
  const Snapshot s = read_bodies_csv(plain, {});
  EXPECT_EQ(s.count(), 3u);
  EXPECT_EQ(s.contacts.size(), 1u);
  EXPECT_FALSE(s.has_velocity || s.has_mass);
  EXPECT_TRUE(noted(s, "numbered as they stand"));
  const std::string full = write(folder, "full.csv",
                                 "id,type,x,y,z,a,b,c,qw,qx,qy,qz,vx,vy,vz,mass\n4,p,0,0,0,1,2,3,1,0,0,0,1,0,0,7\n"
                                 "2,q,0,0,9,2,2,2,1,0,0,0,0,0,0,8\n");
  const Snapshot t = read_bodies_csv(full, {});
  EXPECT_EQ(t.id, (std::vector<std::uint64_t>{2, 4}));
  EXPECT_EQ(t.species_names, (std::vector<std::string>{"p", "q"}));
  EXPECT_EQ(t.mass[1], 7);
  EXPECT_EQ(t.size[1], (Vec3d{1, 2, 3}));
  EXPECT_TRUE(has(refusal([&] { read_bodies_csv(write(folder, "n.csv", "x,y,z\n0,0,0\n"), {}); }), "no sizes"));
  EXPECT_TRUE(has(refusal([&] { read_bodies_csv(write(folder, "r.csv", "x,y,z,radius\n0,0,0,-1\n"), {}); }), "2:7"));
}

// A final.csv has shapes by name: they and their sizes come from the scene beside it.
TEST(AnalysisReaders, FinalTableOfARun) {
  const Folder folder("final_csv");
  const Scene scene = scenes::every_shape(40);
  const World world = scenes::run(scene, 50);
  io::write_final_csv(folder / "final.csv", world);
  EXPECT_TRUE(has(refusal([&] { open_frames(folder / "final.csv", {}).read(0); }), "no sizes"));
  write(folder, "scene.toml", scene_to_toml(scene));
  const Snapshot s = open_frames(folder / "final.csv", {}).read(0), expected = snapshot_of(world);
  EXPECT_EQ(s.id, expected.id);
  EXPECT_EQ(s.position, expected.position);
  EXPECT_EQ(s.velocity, expected.velocity);
  EXPECT_EQ(s.volume, expected.volume);
  EXPECT_EQ(s.shape, expected.shape);
  EXPECT_FALSE(s.has_contacts);
}

TEST(AnalysisReaders, WhichFrames) {
  Frames f{"here", 10, {}};
  const auto list = [&](const char* range) { return select_frames(range, f); };
  using List = std::vector<std::size_t>;
  EXPECT_EQ(list("").size(), 10u);
  EXPECT_EQ(list(":").size(), 10u);
  EXPECT_EQ(list("3"), List{3});
  EXPECT_EQ(list("-1"), List{9});
  EXPECT_EQ(list("2:5"), (List{2, 3, 4}));
  EXPECT_EQ(list("::4"), (List{0, 4, 8}));
  EXPECT_EQ(list("-3:"), (List{7, 8, 9}));
  EXPECT_EQ(list("1:10:8"), (List{1, 9}));
  for (const char* bad : {"10", "-11", "0:11", "5:2", "::0", "::-1", "a", "1:2:3:4", "1.5", "3:3"})
    EXPECT_NE(refusal([&] { list(bad); }), "nothing was refused") << bad;
  f.count = 0;
  EXPECT_TRUE(has(refusal([&] { list(""); }), "no frames"));
}

}  // namespace
