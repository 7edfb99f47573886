#include "libdem/io/programs.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "libdem/io/io.h"

namespace dem::io {

bool installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  const std::string folders = path ? path : "";
  for (std::size_t begin = 0; begin < folders.size();) {
    const std::size_t end = std::min(folders.find(':', begin), folders.size());
    if (std::filesystem::exists(std::filesystem::path(folders.substr(begin, end - begin)) / program)) return true;
    begin = end + 1;
  }
  return false;
}

void run_gnuplot(const std::string& commands) {
  std::signal(SIGPIPE, SIG_IGN);  // a program that dies shows as a failed write
  std::FILE* pipe = popen("gnuplot", "w");
  if (!pipe) throw RunError("gnuplot does not start");
  const bool written = std::fwrite(commands.data(), 1, commands.size(), pipe) == commands.size();
  if (pclose(pipe) != 0 || !written) throw RunError("gnuplot failed");
}

Said run_in(const std::string& folder, const std::string& program, const std::string& file) {
  const std::string command = "cd " + shell_quoted(folder) + " && " + program + " " + shell_quoted(file) + " 2>&1";
  std::FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) throw RunError(program + " does not start");
  Said said;
  std::array<char, 4096> part{};
  while (const std::size_t n = std::fread(part.data(), 1, part.size(), pipe)) said.text.append(part.data(), n);
  said.succeeded = pclose(pipe) == 0;
  return said;
}

std::string shell_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

std::string gnuplot_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') out += '\'';
    out += c == '\n' ? ' ' : c;
  }
  return out + "'";
}

}  // namespace dem::io
