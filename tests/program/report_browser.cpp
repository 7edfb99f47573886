// The page of dem report in a browser without a display (package chromium): it runs without an error of its own and
// draws every body. The picture stays beside the tests: report.png.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>

#include "libdem/io/programs.h"
#include "libdem/report/three.h"
#include "tests/program/page.h"
#include "tests/program/program.h"

namespace {

using program::Folder;

struct Browsed {
  std::string page, errors;  // the document after its scripts ran; lines of the console
};

Browsed browse(const Folder& folder, const std::string& address, const std::string& picture) {
  const std::string command =
      "timeout 50 chromium --headless=new --no-sandbox --disable-dev-shm-usage --use-angle=swiftshader "
      "--enable-unsafe-swiftshader --hide-scrollbars --window-size=1240,1000 --virtual-time-budget=4000 "
      "--host-resolver-rules='MAP * ~NOTFOUND' --enable-logging=stderr --user-data-dir=" +
      dem::io::shell_quoted(folder.path("profile")) + " --screenshot=" + dem::io::shell_quoted(picture) +
      " --dump-dom " + dem::io::shell_quoted("file://" + address) + " 2> " + dem::io::shell_quoted(folder.path("log"));
  Browsed out;
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return out;
  std::array<char, 65536> part{};
  while (const std::size_t n = std::fread(part.data(), 1, part.size(), pipe)) out.page.append(part.data(), n);
  pclose(pipe);
  std::string line;
  for (const char c : program::read(folder.path("log")))
    if (c != '\n') {
      line += c;
    } else {
      if (line.find(":CONSOLE") != std::string::npos) out.errors += line + "\n";
      line.clear();
    }
  return out;
}

TEST(ReportInABrowser, DrawsEveryBody) {
  if (!dem::io::installed("chromium")) GTEST_SKIP() << "chromium is not installed";
  if (const auto three = dem::report::find_three(); !three.why.empty()) GTEST_SKIP() << three.why;
  const Folder folder;
  const std::string scene = folder.write("scene.toml", program::small_scene), run = folder.path("run");
  ASSERT_EQ(program::dem({"run", scene, "--out", run, "--quiet"}).exit_code, 0);
  ASSERT_EQ(program::dem({"report", run, "--quiet"}).exit_code, 0);
  const std::string picture = std::filesystem::absolute("report.png").string();
  std::filesystem::remove(picture);
  const Browsed last = browse(folder, run + "/report.html", picture);
  EXPECT_EQ(last.errors, "");
  EXPECT_EQ(program::body_attribute(last.page, "data-view"), "three") << last.page.substr(0, 500);
  EXPECT_EQ(program::body_attribute(last.page, "data-bodies"), "3");
  EXPECT_EQ(program::body_attribute(last.page, "data-shown"), "3");
  EXPECT_GT(std::atoi(program::body_attribute(last.page, "data-triangles").c_str()), 3 * 100);
  EXPECT_TRUE(std::filesystem::exists(picture));
  const Browsed first = browse(folder, run + "/report.html#frame=0&colour=size", picture);
  EXPECT_EQ(first.errors, "");
  EXPECT_EQ(program::body_attribute(first.page, "data-frame"), "0");
  const Browsed bands = browse(folder, run + "/report.html#colour=layers", picture);
  EXPECT_EQ(bands.errors, "");
  EXPECT_NE(bands.page.find("<div class=\"label\">layers</div>"), std::string::npos);
  EXPECT_NE(bands.page.find("<span class=\"name\">height "), std::string::npos);
}

}  // namespace
