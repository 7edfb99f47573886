#include "tests/program/program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace program {

namespace fs = std::filesystem;

Folder::Folder() {
  std::string name = (fs::temp_directory_path() / "dem-test-XXXXXX").string();
  if (!mkdtemp(name.data())) ADD_FAILURE() << "no temporary folder";
  path_ = name;
}
Folder::~Folder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}
std::string Folder::write(std::string_view name, std::string_view text) const {
  const std::string to = path(name);
  std::ofstream(to, std::ios::binary) << text;
  return to;
}
std::vector<std::string> Folder::files() const {
  std::vector<std::string> out;
  for (const auto& entry : fs::recursive_directory_iterator(path_))
    out.push_back(fs::relative(entry.path(), path_).string());
  std::sort(out.begin(), out.end());
  return out;
}

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

Process::Process(const std::vector<std::string>& arguments, const Folder& folder) : folder_(folder), pid_(fork()) {
  if (pid_ != 0) return;
  std::vector<char*> argv{const_cast<char*>(DEM_PROGRAM)};
  for (const std::string& a : arguments) argv.push_back(const_cast<char*>(a.c_str()));
  argv.push_back(nullptr);
  const int out = open(folder.path("stdout").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  const int err = open(folder.path("stderr").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(out, STDOUT_FILENO);
  dup2(err, STDERR_FILENO);
  execv(DEM_PROGRAM, argv.data());
  _exit(127);
}
void Process::signal(int number) const { kill(pid_, number); }
Outcome Process::wait() {
  int status = 0;
  waitpid(pid_, &status, 0);
  Outcome o;
  o.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  o.out = read(folder_.path("stdout"));
  o.err = read(folder_.path("stderr"));
  return o;
}

Outcome dem(const std::vector<std::string>& arguments) {
  const Folder folder;
  return Process(arguments, folder).wait();
}

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

const char* const small_scene = R"(title = "three bodies"
[run]
steps = 200
dt = 1e-5
[output]
picture = false
[world]
gravity = [0, 0, -9.81]
[law]
name = "hertz_mindlin"
[[material]]
name = "glass"
young = 1e7
poisson = 0.25
density = 2500
restitution = 0.8
friction = 0.5
[[shape]]
name = "ball"
kind = "sphere"
radius = 0.005
[[shape]]
name = "egg"
kind = "ellipsoid"
semi_axes = [0.004, 0.005, 0.006]
[[wall]]
name = "floor"
kind = "plane"
material = "glass"
point = [0, 0, 0]
normal = [0, 0, 1]
[[body]]
shape = "ball"
material = "glass"
position = [0, 0, 0.005]
velocity = [0.1, 0, -0.5]
[[body]]
shape = "egg"
material = "glass"
position = [0.001, 0, 0.0155]
orientation = [0.8, 0.6, 0, 0]
spin = [1, 2, 3]
[[body]]
shape = "ball"
material = "glass"
position = [0.02, 0, 0.006]
velocity = [-1, 0, -0.5]
)";

}  // namespace program
