#include "bench/laws/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "libdem/io/programs.h"

namespace laws {
namespace {

// Letters, not bytes.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}
std::string padded(const std::string& text, std::size_t wide) {
  return text + std::string(width(text) < wide ? wide - width(text) : 0, ' ');
}
std::string number(double v) { return fmt::format("{:.9g}", v); }

}  // namespace

void Report::topic(const std::string& name, const std::string& what) {
  fmt::print("\n{}: {}\n{} {:>16} {:>16} {:>10}  pass\n", name, what, padded("item", 70), "expected", "got", "error");
}

void Report::heading(const std::string& text) { fmt::print("-- {}\n", text); }

void Report::row(const std::string& item, const std::string& expected, const std::string& got, const std::string& error,
                 bool ok) {
  (ok ? passed_ : failed_) += 1;
  fmt::print("{} {:>16} {:>16} {:>10}  {}\n", padded(item, 70), expected, got, error, ok ? "yes" : "NO");
  std::fflush(stdout);
}

void Report::near(const std::string& item, double expected, double got, double tolerance) {
  const double error = std::abs(got - expected);
  row(fmt::format("{} ±{:.1g}", item, tolerance), number(expected), number(got), fmt::format("{:.1e}", error),
      error <= tolerance);
}

void Report::close(const std::string& item, double expected, double got, double tolerance) {
  const double error = std::abs(got / expected - 1);
  row(fmt::format("{} ±{:.1g} rel", item, tolerance), number(expected), number(got), fmt::format("{:.1e}", error),
      error <= tolerance);
}

void Report::at_most(const std::string& item, double bound, double got) {
  row(item, fmt::format("<= {:.3g}", bound), fmt::format("{:.6g}", got), "", got <= bound);
}

void Report::at_least(const std::string& item, double bound, double got) {
  row(item, fmt::format(">= {:.3g}", bound), fmt::format("{:.6g}", got), "", got >= bound);
}

void Report::is_true(const std::string& item, bool ok, const std::string& expected, const std::string& got) {
  row(item, expected, got, "", ok);
}

void Report::note(const std::string& item, const std::string& text) {
  fmt::print("{} {:>16} {:>16}\n", padded(item, 70), "", text);
}
void Report::note(const std::string& item, double got) { note(item, fmt::format("{:.6g}", got)); }

void Report::csv(const std::string& name, const std::string& header,
                 const std::vector<std::vector<double>>& rows) const {
  if (!draws()) return;
  std::ofstream file(path(name + ".csv"));
  file << header << '\n';
  for (const auto& r : rows) {
    std::string line;
    for (const double v : r) line += fmt::format("{}{:.10g}", line.empty() ? "" : ",", v);
    file << line << '\n';
  }
}

void Report::figure(const std::string& name, const std::string& commands) const {
  if (!draws() || !dem::io::installed("gnuplot")) return;
  dem::io::run_gnuplot(
      fmt::format("cd {}\nset terminal pngcairo size 900,650\nset output {}\nset datafile separator "
                  "','\nset grid\nset key outside bottom center horizontal noenhanced\n{}\n",
                  dem::io::gnuplot_quoted(folder_), dem::io::gnuplot_quoted(name + ".png"), commands));
}

}  // namespace laws
