// dem law: impacts and paths against closed forms, what it refuses, and a fit that finds what made its data.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "tests/program/program.h"

namespace {

using program::Folder;
using program::Outcome;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

constexpr const char* ball = R"(
[law]
name = "hertz_mindlin"
[[material]]
name = "alumina"
young = 380e9
poisson = 0.23
density = 4000
friction = 0.092
restitution = 0.98
[a]
radius = 0.0025
[b]
)";

constexpr const char* impact = "[impact]\nspeed = 3.9\nangle_deg = 60\n";

// The number behind a word of the summary.
double number_after(const std::string& text, const std::string& word) {
  const std::size_t at = text.find("\n" + word);
  EXPECT_NE(at, std::string::npos) << word << "\nnot in\n" << text;
  return at == std::string::npos ? 0 : std::atof(text.c_str() + at + 1 + word.size());
}

std::vector<std::vector<double>> rows_of(const std::string& csv) {
  std::vector<std::vector<double>> rows;
  std::stringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::vector<double> row;
    std::stringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::atof(cell.c_str()));
    rows.push_back(row);
  }
  return rows;
}

// A contact that slides all the way: vt' = vt − μ(1 + e) vn, R w' = (5/2) μ(1 + e) vn.
TEST(LawCommand, ASlidingImpactFollowsItsClosedForm) {
  const Folder folder;
  const Outcome o = program::dem({"law", folder.write("a.toml", std::string(ball) + impact + "steps_per_contact = 400"),
                                  "--out", folder.path("a.csv")});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const double e = number_after(o.out, "restitution"), vn = 3.9 * std::cos(M_PI / 3), vt = 3.9 * std::sin(M_PI / 3);
  EXPECT_NEAR(e, 0.98, 1e-5);
  EXPECT_NEAR(number_after(o.out, "tangential restitution"), 1 - 0.092 * (1 + e) * vn / vt, 1e-4);
  // The force acts at half the overlap below the surface.
  const double spin = number_after(o.out, "spin afterwards") / (-2.5 * 0.092 * (1 + e) * vn / 0.0025);
  EXPECT_LT(spin, 1);
  EXPECT_GT(spin, 1 - 0.5 * number_after(o.out, "peak overlap") / 0.0025);
  const std::string csv = program::read(folder.path("a.csv"));
  EXPECT_TRUE(csv.starts_with("t [s],overlap [m],slip_x [m],slip_y [m],normal_force [N],")) << csv.substr(0, 200);
  const auto rows = rows_of(csv);
  EXPECT_NEAR(static_cast<double>(rows.size()), 400, 3);
  double peak = 0;
  for (const auto& r : rows) peak = std::max(peak, r[1]);
  EXPECT_NEAR(peak / number_after(o.out, "peak overlap"), 1, 1e-8);
}

TEST(LawCommand, APathIsFollowedFromItsFileAndFromRows) {
  const Folder folder;
  folder.write("path.csv",
               "t,overlap,slip_x,slip_y,rotation\n0,0,0,0,0\n1,1e-6,0,0,0\n2,1e-6,1e-9,0,0\n3,1e-6,1e-9,0,1\n");
  const std::string from_file =
      folder.write("f.toml", std::string(ball) + "[path]\nfile = \"path.csv\"\nsubsteps = 50\n");
  const Outcome o = program::dem({"law", from_file, "--out", folder.path("f.csv")});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const auto rows = rows_of(program::read(folder.path("f.csv")));
  ASSERT_EQ(rows.size(), 151u);
  const double young_eff = 190e9 / (1 - 0.23 * 0.23), shear_eff = 0.5 * (380e9 / 2.46) / (2 - 0.23);
  const double a = std::sqrt(0.0025 * 1e-6);
  EXPECT_NEAR(rows[100][4] / (4.0 / 3 * young_eff * a * 1e-6), 1, 1e-12);  // Hertz, at rest across
  EXPECT_NEAR(rows[100][5] / (8 * shear_eff * a * 1e-9), 1, 3e-3);         // 8 G* a, and the dashpot's part
  const auto& turned = rows[150];                                          // by one radian, with what it remembers
  EXPECT_NEAR(std::atan2(turned[6], turned[5]), 1, 1e-4);
  EXPECT_NEAR(std::hypot(turned[5], turned[6]) / (8 * shear_eff * a * 1e-9), 1, 1e-9);

  const std::string inline_rows = folder.write(
      "r.toml", std::string(ball) + "[path]\nrows = [[0,0,0,0],[1,1e-6,0,0],[2,1e-6,1e-9,0]]\nsubsteps = 50\n");
  ASSERT_EQ(program::dem({"law", inline_rows, "--out", folder.path("r.csv")}).exit_code, 0);
  const std::string whole = program::read(folder.path("f.csv")), part = program::read(folder.path("r.csv"));
  EXPECT_EQ(whole.substr(0, part.size()), part);
}

TEST(LawCommand, RefusesWithThePlaceOfTheMistake) {
  const Folder folder;
  const auto refusal = [&](const std::string& text) {
    const Outcome o = program::dem({"law", folder.write("bad.toml", text)});
    EXPECT_EQ(o.exit_code, 2) << text << o.out;
    return o.err;
  };
  const std::string good = std::string(ball) + impact;
  EXPECT_TRUE(has(refusal(program::replaced(good, "friction = 0.092", "friction = -1")), "bad.toml:9:12:"));
  EXPECT_TRUE(has(refusal(program::replaced(good, "speed", "sped")), "did you mean impact.speed?"));
  EXPECT_TRUE(has(refusal(program::replaced(good, "radius = 0.0025", "")), "bad.toml:11:1: a.radius is missing"));
  EXPECT_TRUE(has(refusal(program::replaced(good, "[b]", "[b]\nmass = 1")), "a plane (b without a radius) is held"));
  EXPECT_TRUE(has(refusal(program::replaced(good, "density = 4000\n", "")), "needs mass, density"));
  EXPECT_TRUE(has(refusal(program::replaced(good, "angle_deg", "tangential_speed")), "goes with normal_speed"));
  EXPECT_TRUE(has(refusal(good + "[path]\nrows = [[0,0,0,0],[0,1,0,0]]\n"), "not both"));
  EXPECT_TRUE(has(refusal(std::string(ball) + "[path]\nrows = [[0,0,0,0],[0,1,0,0]]\n"), "bad.toml:15:19:"));
  EXPECT_TRUE(has(refusal(ball), "needs [path] or [impact]"));
  folder.write("path.csv", "t,overlap,slip_x\n0,0,0\n");
  EXPECT_TRUE(has(refusal(std::string(ball) + "[path]\nfile = \"path.csv\"\n"), "slip_y"));
  EXPECT_TRUE(has(refusal(program::replaced(good, "\"hertz_mindlin\"", "\"linear_spring\"")), "stiffness"));
}

TEST(LawCommand, APictureIsDrawnOrItSaysWhyNot) {
  const Folder folder;
  const Outcome o =
      program::dem({"law", folder.write("a.toml", std::string(ball) + impact), "--plot", folder.path("it's.png")});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  if (has(o.err, "gnuplot is not installed")) return;
  EXPECT_GT(std::filesystem::file_size(folder.path("it's.png")), 1000u);
}

TEST(LawCommand, AFitFindsWhatMadeItsData) {
  const Folder folder;
  const std::string text = std::string(ball) + impact;
  std::string data = "speed,angle_deg,restitution,rebound_angle_deg,duration\n";
  for (const char* angle : {"0.5", "20", "40", "70"}) {
    const Outcome o = program::dem({"law", folder.write("a.toml", program::replaced(text, "60", angle))});
    data += std::string("3.9,") + angle + "," + std::to_string(number_after(o.out, "restitution")) + "," +
            std::to_string(number_after(o.out, "rebound angle, centre")) + ",\n";
  }
  const std::string measured = folder.write("measured.csv", data);
  std::string other = program::replaced(text, "friction = 0.092", "friction = 0.5");
  other = program::replaced(other, "restitution = 0.98", "restitution = 0.6");
  const Outcome o =
      program::dem({"law", folder.write("b.toml", other + "[fit]\nparameters = [\"friction\", \"restitution\"]\n"),
                    "--fit", measured});
  if (has(o.err, "built without")) GTEST_SKIP() << o.err;
  ASSERT_EQ(o.exit_code, 0) << o.err;
  EXPECT_NEAR(number_after("\n" + o.out, "friction"), 0.092, 2e-5);
  EXPECT_NEAR(number_after("\n" + o.out, "restitution"), 0.98, 2e-5);
  EXPECT_TRUE(has(o.out, "over 4 values")) << o.out;
  EXPECT_EQ(program::dem({"law", folder.path("a.toml"), "--fit", measured}).exit_code, 2);
  const Outcome wrong = program::dem({"law", folder.path("b.toml"), "--fit", folder.write("w.csv", "speed,e\n1,1\n")});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(has(wrong.err, "w.csv:1") && has(wrong.err, "column e")) << wrong.err;
}

}  // namespace
