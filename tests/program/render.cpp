// dem render as a user calls it: colours of an analysis, frames that they refer to, movies, what it refuses.
#include "libdem/render/render.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "libdem/analysis/body_colours.h"
#include "libdem/io/programs.h"
#include "tests/program/program.h"

namespace {

using program::Folder;
using program::Outcome;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

class Render : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new Folder;
    const std::string scene = folder_->write("scene.toml", program::small_scene);
    ASSERT_EQ(program::dem({"run", scene, "--out", run(), "--quiet"}).exit_code, 0);
  }
  static void TearDownTestSuite() { delete folder_; }
  void SetUp() override {
    if (!dem::render::available()) GTEST_SKIP() << "built without Embree";
  }
  static std::string run() { return folder_->path("run"); }
  static std::string picture(const std::vector<std::string>& arguments) {
    std::vector<std::string> all{"render", run(), "--size", "160x120"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Outcome o = program::dem(all);
    EXPECT_EQ(o.exit_code, 0) << o.err;
    return program::read(o.out.substr(0, o.out.find('\n')));
  }
  static void expect_refused(const std::vector<std::string>& arguments, const std::string& part) {
    std::vector<std::string> all{"render", run()};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Outcome o = program::dem(all);
    EXPECT_EQ(o.exit_code, 2) << o.out << o.err;
    EXPECT_TRUE(has(o.err, part)) << o.err;
    EXPECT_EQ(std::count(o.err.begin(), o.err.end(), '\n'), 1) << o.err;
  }
  static Folder* folder_;
};
Folder* Render::folder_ = nullptr;

TEST_F(Render, EveryColourDrawsAFrame) {
  const std::string speed = picture({"--frame", "0"});
  EXPECT_EQ(picture({"--frame", "0", "--color-by", "speed"}), speed);
  for (const std::string& word : dem::analysis::body_colour_words())
    EXPECT_NE(picture({"--frame", "1", "--colour", word}), speed) << word;
  // Bands of the first frame and of the last differ: bodies have fallen.
  EXPECT_NE(picture({"--frame", "0", "--colour", "layers"}),
            picture({"--frame", "0", "--colour", "layers", "--reference", "-1"}));
  // The last state as the last frame.
  const std::string last = picture({"--colour", "displacement"});
  EXPECT_EQ(last, picture({"--frame", "1", "--colour", "displacement"}));
  EXPECT_NE(last, speed);
}

TEST_F(Render, MovieOfBands) {
  const Outcome o = program::dem({"render", run(), "--movie", "--colour", "strain", "--size", "160x120"});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const bool encoded = dem::io::installed("ffmpeg");
  EXPECT_TRUE(std::filesystem::exists(run() + (encoded ? "/movie.mp4" : "/frame-00000.png"))) << o.out;
}

TEST_F(Render, Refuses) {
  expect_refused({"--colour", "layer"}, "did you mean layers?");
  expect_refused({"--colour", "layers", "--reference", "99"}, "--reference 99: the record has frames 0 to");
  expect_refused({"--colour", "speed", "--reference", "0"}, "colours by speed refer to no other frame");
  expect_refused({"--colour", "vorticity", "--reference", "0"}, "refer to no other frame");
  const std::string scene = folder_->path("scene.toml"), bare = folder_->path("bare");
  ASSERT_EQ(program::dem({"run", scene, "--out", bare, "--quiet", "--set", "output.hdf5=false"}).exit_code, 0);
  const Outcome o = program::dem({"render", bare, "--colour", "layers"});
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_TRUE(has(o.err, "no frame to refer to")) << o.err;
  EXPECT_EQ(program::dem({"render", bare, "--colour", "contacts", "--size", "160x120"}).exit_code, 0);
}

}  // namespace
