#include "libdem/report/figure_list.h"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

#include "libdem/io/programs.h"
#include "libdem/report/words.h"

namespace dem::report {

namespace fs = std::filesystem;

std::string axis_label(const std::string& name, const std::string& unit) {
  return io::gnuplot_quoted(unit.empty() || unit == "1" ? words(name) : fmt::format("{} ({})", words(name), unit));
}

bool has_rows(const std::string& path, int least) {
  std::ifstream file(path);
  std::string line;
  int lines = 0;
  while (lines <= least && std::getline(file, line))
    if (!line.empty() && line[0] != '#') ++lines;
  return lines > least;
}

std::string joined_plots(const std::vector<std::string>& plots) {
  std::string text = "plot ";
  for (const std::string& p : plots) text += (&p == plots.data() ? "" : ", \\\n  ") + p;
  return text + "\n";
}

std::vector<double> numbers(const io::Table& table, const std::string& column) {
  const std::optional<std::size_t> at = io::find_column(table, column);
  if (!at) return std::vector<double>(table.row_count(), 0.0);
  std::vector<double> list;
  for (std::size_t r = 0; r < table.row_count(); ++r) {
    const std::string cell = table.cell(r, *at);
    list.push_back(cell.empty() ? std::numeric_limits<double>::quiet_NaN() : std::strtod(cell.c_str(), nullptr));
  }
  return list;
}

void FigureList::add(const std::string& name, const std::string& title, const std::string& script) {
  list_.push_back({name, title, script, group_, ""});
}

void FigureList::add_series(const std::string& quantity, const std::vector<std::string>& names,
                            const std::string& title, const std::string& y) {
  const ListedQuantity* q = listing_.quantity(quantity);
  if (q == nullptr || listing_.frames.size() < 2) return;
  std::vector<std::string> plots;
  std::string unit, first;
  for (const std::string& name : names) {
    const ListedScalar* s = q->scalar(name);
    if (s == nullptr || s->frames < 2 || (s->constant && s->last.value_or(0) == 0)) continue;
    if (plots.empty()) {
      unit = s->unit;
      first = name;
    }
    plots.push_back(plot(quantity + "_series.csv", "time", {name, "linespoints pt 7 ps 0.35 lw 1.5", words(name)}));
  }
  if (plots.empty()) return;
  add(fmt::format("series_{}_{}", quantity, first), title + " over time",
      fmt::format("set xlabel 'time (s)'\nset ylabel {}\n{}", axis_label(y, unit), joined_plots(plots)));
}

void FigureList::add_table(const std::string& quantity, const std::string& table_name, const std::string& x,
                           const std::vector<Line>& lines, const std::string& y, const std::string& settings) {
  const ListedTable* t = table(quantity, table_name);
  if (t == nullptr) return;
  const std::string file = last_file(*t);
  const int least = lines[0].with.starts_with("boxes") ? 1 : 2;
  if (file.empty() || t->unit_of(x).empty() || !has_rows((fs::path(listing_.folder) / file).string(), least)) return;
  std::vector<std::string> plots;
  for (const Line& line : lines)
    if (!t->unit_of(line.column).empty()) plots.push_back(plot(file, x, line));
  if (plots.empty()) return;
  const std::string name = table_name.empty() ? quantity : quantity + "_" + table_name;
  add(name, (t->title.empty() ? words(name) : t->title) + when(file),
      fmt::format("set xlabel {}\nset ylabel {}\n{}{}", axis_label(x, t->unit_of(x)),
                  axis_label(y, t->unit_of(lines[0].column)), settings, joined_plots(plots)));
}

const ListedTable* FigureList::table(const std::string& quantity, const std::string& name) const {
  const ListedQuantity* q = listing_.quantity(quantity);
  return q == nullptr ? nullptr : q->table(name);
}

std::string FigureList::last_file(const ListedTable& t) const {
  for (auto at = t.files.rbegin(); at != t.files.rend(); ++at)
    if (has_rows((fs::path(listing_.folder) / *at).string())) return *at;
  return "";
}

std::string FigureList::when(const std::string& file) const {
  for (const Frame& f : listing_.frames)
    if (&f != &listing_.frames.back() && file.ends_with(fmt::format("_{:012}.csv", f.step)))
      return fmt::format(", at t = {:.4g} s", f.time);
  return "";
}

std::string FigureList::quoted(const std::string& file) const { return io::gnuplot_quoted(data_ + "/" + file); }

io::Table FigureList::rows(const std::string& file) const {
  return io::read_csv((fs::path(listing_.folder) / file).string());
}

std::string FigureList::plot(const std::string& file, const std::string& x, const Line& line) const {
  return fmt::format("{} using '{}':'{}' with {} {}", quoted(file), x, line.column, line.with,
                     line.title.empty() ? "notitle" : "title " + io::gnuplot_quoted(line.title));
}

}  // namespace dem::report
