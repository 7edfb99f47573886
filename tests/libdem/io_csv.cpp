// CSV in and out, and the summary.
#include <gtest/gtest.h>
#include <zlib.h>

#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>

#include "libdem/io/io.h"
#include "tests/libdem/io_world.h"

namespace {

using dem::io_test::Folder;

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const dem::InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(IoCsv, FinalCsvRoundTrip) {
  const dem::World world = dem::io_test::small_world();
  const Folder folder("final");
  dem::io::write_final_csv(folder / "final.csv", world);
  std::ifstream in(folder / "final.csv");
  std::string header;
  std::getline(in, header);
  EXPECT_EQ(header, "id,shape,material,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz");

  const dem::io::Table table = dem::io::read_csv(folder / "final.csv");
  ASSERT_EQ(table.row_count(), world.particles.count());
  EXPECT_EQ(table.cell(5, 1), "hexagon");
  EXPECT_EQ(table.cell(4, 2), "steel");
  const auto expect = [&](std::size_t row, const char* name, double value) {
    EXPECT_EQ(dem::io::number(table, row, dem::io::column(table, name)), value) << row << name;
  };
  for (std::size_t i = 0; i < table.row_count(); ++i) {  // 17 digits bring back every bit
    const auto& m = world.particles.motion[i];
    const auto& q = world.particles.orientation[i];
    expect(i, "id", static_cast<double>(world.particles.id[i]));
    expect(i, "x", m.position.x);
    expect(i, "z", m.position.z);
    expect(i, "qw", q.w);
    expect(i, "qz", q.z);
    expect(i, "vz", m.velocity.z);
    expect(i, "wx", m.spin.x);
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "final.csv.part"));
}

TEST(IoCsv, OrderOfStorageDoesNotShow) {
  dem::World world = dem::io_test::small_world();
  world.contacts = {};
  const Folder folder("order");
  dem::io::write_final_csv(folder / "final.csv", world);
  dem::io::Record(folder / "a.h5", world, false).write(world);
  auto& p = world.particles;
  const auto swap_ends = [](auto&... lists) { (std::swap(lists.front(), lists.back()), ...); };
  swap_ends(p.id, p.shape, p.material, p.size, p.motion, p.orientation, p.rotation, p.angular_momentum, p.inertia,
            p.mass, p.force, p.torque);
  dem::io::write_final_csv(folder / "swapped.csv", world);
  EXPECT_EQ(dem::io::read_csv(folder / "final.csv").text, dem::io::read_csv(folder / "swapped.csv").text);
  dem::io::Record(folder / "b.h5", world, false).write(world);
  dem::World a = world, b = world;
  dem::io::load_frame(folder / "a.h5", a, 0);
  dem::io::load_frame(folder / "b.h5", b, 0);
  EXPECT_EQ(a.particles.id, b.particles.id);
  for (std::size_t i = 0; i < a.particles.count(); ++i)
    EXPECT_EQ(a.particles.motion[i].position, b.particles.motion[i].position);
}

TEST(IoCsv, CommentsSpacesAndGzip) {
  const Folder folder("csv_gz");
  const std::string path = folder / "bed.csv.gz",
                    text = "# a bed\r\n\r\nx, radius\r\n# more\r\n 1.5 ,+2e-3\r\n-3,.5\r\n";
  gzFile file = gzopen(path.c_str(), "wb");
  ASSERT_EQ(gzwrite(file, text.data(), static_cast<unsigned>(text.size())), static_cast<int>(text.size()));
  gzclose(file);
  const dem::io::Table table = dem::io::read_csv(path);
  EXPECT_EQ(table.columns, (std::vector<std::string>{"x", "radius"}));
  ASSERT_EQ(table.row_count(), 2u);
  EXPECT_EQ(table.lines, (std::vector<int>{5, 6}));
  EXPECT_EQ(dem::io::number(table, 0, 0), 1.5);
  EXPECT_EQ(dem::io::number(table, 0, 1), 2e-3);
  EXPECT_EQ(dem::io::number(table, 1, 1), 0.5);

  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 12);
  EXPECT_NE(message_of([&] { dem::io::read_csv(path); }).find("cut short"), std::string::npos);
}

TEST(IoCsv, BadNumbersAreRefusedWithTheirPlace) {
  const Folder folder("csv_numbers");
  for (const char* cell : {"0.01x", "nan", "inf", "-inf", "", "1e999", "0x10", "--1", "+-1", "1 2"}) {
    const std::string path = folder / "t.csv";
    std::ofstream(path) << "# comment\nx,radius,z\n1,2,3\n1,  " << cell << ",3\n";
    const dem::io::Table table = dem::io::read_csv(path);
    EXPECT_EQ(dem::io::number(table, 0, 1), 2);
    const std::string message = message_of([&] { dem::io::number(table, 1, 1); });
    EXPECT_NE(message.find("t.csv:4:5"), std::string::npos) << message;
    EXPECT_NE(message.find("radius"), std::string::npos) << message;
  }
}

TEST(IoCsv, BadTablesAreRefusedWithTheirPlace) {
  const Folder folder("csv_tables");
  const auto message = [&](const std::string& text) {
    std::ofstream(folder / "t.csv") << text;
    return message_of([&] { dem::io::column(dem::io::read_csv(folder / "t.csv"), "y"); });
  };
  EXPECT_EQ(message("x,y\n1,2\n"), "no error");
  EXPECT_NE(message("x,y\n1,2\n1\n").find("t.csv:3:2"), std::string::npos);
  EXPECT_NE(message("x,y\n1,2,3\n").find("t.csv:2:5"), std::string::npos);
  EXPECT_NE(message("x,y,x\n").find("t.csv:1:5"), std::string::npos);
  EXPECT_NE(message("x,,y\n").find("t.csv:1:3"), std::string::npos);
  EXPECT_NE(message("x,z\n").find("'y' is missing; the file has x, z"), std::string::npos);
  EXPECT_NE(message("x,\"y\"\n").find("t.csv:1:3"), std::string::npos);
  EXPECT_NE(message("# nothing\n").find("no header"), std::string::npos);
  EXPECT_NE(message_of([&] { dem::io::read_csv(folder / "none.csv"); }).find("none.csv"), std::string::npos);
}

TEST(IoSummary, BalancesAndRates) {
  dem::World world = dem::io_test::small_world();
  const Folder folder("summary");
  const double mass = world.particles.mass[0];
  dem::Vec3d p{};
  for (std::size_t i = 0; i < world.particles.count(); ++i)
    p += world.particles.motion[i].velocity * world.particles.mass[i];
  for (int k = 0; k < 3; ++k) world.balance.impulse[static_cast<std::size_t>(k)].add(p[k]);
  world.balance.initial_mass = mass;
  for (const double m : world.particles.mass) world.balance.initial_mass += m;
  world.balance.removed_mass = mass;
  world.counters.deleted = 1;
  world.discharge = {{50 * world.time_step.dt, 1, mass}};  // one body left at step 50 of 120
  world.times.loop = 2;
  world.times.particle_steps = 770;
  const auto summary = [&] {
    dem::io::write_summary(folder / "summary.json", world, "finished", 2);
    return nlohmann::json::parse(std::ifstream(folder / "summary.json"));
  };
  const auto all = summary();
  EXPECT_EQ(all["particle_steps_per_s"].get<double>(), 385);
  EXPECT_LE(all["momentum_balance"]["relative_error"].get<double>(), 1e-15);
  EXPECT_LE(all["mass_balance"]["relative_error"].get<double>(), 1e-15);
  EXPECT_EQ(all["mass_balance"]["initial_count"], 7);
  EXPECT_EQ(all["state_hash"].get<std::string>().size(), 16u);
  EXPECT_EQ(all["walls"][1]["name"], "side");
  world.balance.impulse[0].add(1e-6 * norm(p));
  EXPECT_NEAR(summary()["momentum_balance"]["relative_error"].get<double>() *
                  all["momentum_balance"]["scale"].get<double>() / norm(p),
              1e-6, 1e-9);
}

}  // namespace
