// A VTK file as VTK's own reader sees it.
#pragma once

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

namespace dem::io_test {

constexpr int no_vtk = 77;

// What tests/vtk_reader.py says of a file; the exit code goes to `code`, no_vtk: not installed.
inline nlohmann::json read_with_vtk(const std::string& file, int& code) {
  const std::string command = "/usr/bin/python3 '" PROJECT_ROOT "/tests/vtk_reader.py' '" + file + "'";
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  char chunk[4096];
  while (const std::size_t n = std::fread(chunk, 1, sizeof chunk, pipe)) text.append(chunk, n);
  code = WEXITSTATUS(pclose(pipe));
  return code == 0 ? nlohmann::json::parse(text) : nlohmann::json();
}

}  // namespace dem::io_test
