// A run that is stopped and resumed ends in the same bytes as one that never stopped.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "tests/program/program.h"

namespace {

using program::Folder;
using program::Outcome;

// Long enough to be stopped in the middle: bodies keep bouncing and rolling on the floor.
std::string long_scene() { return program::replaced(program::small_scene, "steps = 200", "steps = 30000"); }
const std::vector<std::string> frequent{"--set", "output.checkpoint_interval=0.02", "--set", "output.interval=0.05"};

bool has_checkpoint(const std::string& folder) {
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none))
    if (entry.path().extension() == ".bin") return true;
  return false;
}

struct Stopped {
  Outcome outcome;
  bool was_running;
};

// Starts a run, waits for its first checkpoint, and sends it a signal.
Stopped stop(const std::string& scene, const Folder& folder, int signal) {
  std::vector<std::string> arguments{"run", scene, "--out", folder.path("b"), "--threads", "1", "--quiet"};
  arguments.insert(arguments.end(), frequent.begin(), frequent.end());
  const Folder output;
  program::Process process(arguments, output);
  for (int i = 0; i < 5000 && !has_checkpoint(folder.path("b")); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  process.signal(signal);
  const Outcome o = process.wait();
  return {o, !std::filesystem::exists(folder.path("b/final.csv"))};
}

void expect_the_same_end(int signal, int exit_code) {
  const Folder folder;
  const std::string scene = folder.write("scene.toml", long_scene());
  std::vector<std::string> whole{"run", scene, "--out", folder.path("a"), "--threads", "1", "--quiet"};
  whole.insert(whole.end(), frequent.begin(), frequent.end());
  ASSERT_EQ(program::dem(whole).exit_code, 0);
  const Stopped stopped = stop(scene, folder, signal);
  ASSERT_TRUE(stopped.was_running) << "the run ended before it was stopped";
  EXPECT_EQ(stopped.outcome.exit_code, exit_code) << stopped.outcome.err;
  if (signal == SIGINT) {
    EXPECT_NE(stopped.outcome.err.find("dem resume"), std::string::npos);
  }
  const Outcome resumed = program::dem({"resume", folder.path("b"), "--threads", "1"});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_NE(resumed.err.find("goes on at step"), std::string::npos) << resumed.err;
  EXPECT_EQ(program::read(folder.path("a/final.csv")), program::read(folder.path("b/final.csv")));
  EXPECT_EQ(program::read(folder.path("a/frames.pvd")), program::read(folder.path("b/frames.pvd")));

  const Outcome finished = program::dem({"resume", folder.path("b")});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_NE(finished.out.find("finished already"), std::string::npos) << finished.out;
}

TEST(Resume, AfterAnInterrupt) { expect_the_same_end(SIGINT, 130); }
TEST(Resume, AfterAKill) { expect_the_same_end(SIGKILL, 128 + SIGKILL); }

TEST(Resume, WithoutACheckpointStartsAgain) {
  const Folder folder;
  const std::string scene = folder.write("scene.toml", program::small_scene);
  ASSERT_EQ(program::dem({"run", scene, "--out", folder.path("a")}).exit_code, 0);
  std::filesystem::create_directory(folder.path("b"));
  std::filesystem::copy_file(folder.path("a/scene.toml"), folder.path("b/scene.toml"));
  const Outcome o = program::dem({"resume", folder.path("b")});
  ASSERT_EQ(o.exit_code, 0) << o.err;
  EXPECT_EQ(program::read(folder.path("a/final.csv")), program::read(folder.path("b/final.csv")));
}

}  // namespace
