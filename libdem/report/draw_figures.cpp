// From scripts to drawings, by gnuplot.
#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "libdem/io/files.h"
#include "libdem/io/programs.h"
#include "libdem/report/figures.h"
#include "libdem/world.h"

namespace dem::report {

namespace fs = std::filesystem;

namespace {

constexpr const char* mark = "# Again, in this folder:";

std::string whole_script(const Figure& figure) {
  return fmt::format(
      "# {0}\n{3} gnuplot {1}.gp\n"
      "set terminal svg size 620,400 dynamic noenhanced font 'sans-serif,13' linewidth 1 background 'white'\n"
      "set output '{1}.svg'\nset datafile separator ','\nset datafile columnheaders\n"
      "set key above\nset grid lc rgb '#dddddd'\nset tics nomirror\n{2}",
      figure.title, figure.name, figure.script, mark);
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
}

// From `begin` up to and with `end`, everywhere.
void remove_all(std::string& text, const std::string& begin, const std::string& end) {
  for (std::size_t at = 0; (at = text.find(begin, at)) != std::string::npos;) {
    const std::size_t last = text.find(end, at + begin.size());
    text.erase(at, last == std::string::npos ? last : last + end.size() - at);
  }
}

std::string one_line(const std::string& text) {
  std::string last, line;
  for (const char c : text + "\n")
    if (c == '\n') {
      if (line.find_first_not_of(" \t^") != std::string::npos) last = line;
      line.clear();
    } else {
      line += c;
    }
  return last;
}

}  // namespace

void remove_figures(const std::string& folder) {
  std::vector<fs::path> doomed;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!entry.is_regular_file() || entry.path().extension() != ".gp") continue;
    std::ifstream file(entry.path());
    std::string title, again;
    if (std::getline(file, title) && std::getline(file, again) && again.starts_with(mark))
      doomed.push_back(entry.path());
  }
  for (fs::path& script : doomed) {
    fs::remove(script);
    fs::remove(script.replace_extension(".svg"));
  }
}

std::string svg_in_page(const std::string& svg, const std::string& name) {
  const std::size_t begin = svg.find("<svg");
  if (begin == std::string::npos) return "";
  std::string text = svg.substr(begin);
  remove_all(text, " xmlns=\"", "\"");
  remove_all(text, " xmlns:xlink=\"", "\"");
  remove_all(text, "<title>", "</title>");
  remove_all(text, "<desc>", "</desc>");
  replace_all(text, "xlink:href=", "href=");
  replace_all(text, "id=\"", "id=\"" + name + "-");
  replace_all(text, "id='", "id='" + name + "-");
  replace_all(text, "href='#", "href='#" + name + "-");
  replace_all(text, "href=\"#", "href=\"#" + name + "-");
  replace_all(text, "url(#", "url(#" + name + "-");
  return text;
}

std::vector<Figure> draw_figures(std::vector<Figure> figures, const std::string& folder,
                                 std::vector<std::string>& notes) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw InputError(fmt::format("{}: cannot make this folder: {}", folder, failed.message()));
  remove_figures(folder);
  for (const Figure& f : figures) io::write_file((fs::path(folder) / (f.name + ".gp")).string(), whole_script(f));
  if (!io::installed("gnuplot")) {
    if (!figures.empty())
      notes.push_back(
          fmt::format("gnuplot is not installed (package gnuplot-nox): no figures; their scripts are in {}", folder));
    return {};
  }
  std::vector<Figure> drawn;
  for (Figure& f : figures) {
    const io::Said said = io::run_in(folder, "gnuplot", f.name + ".gp");
    f.svg = svg_in_page(io::read_file(fs::path(folder) / (f.name + ".svg")), f.name);
    if (said.succeeded && !f.svg.empty()) {
      drawn.push_back(std::move(f));
      continue;
    }
    fs::remove(fs::path(folder) / (f.name + ".svg"));
    notes.push_back(fmt::format("figure {}: gnuplot says: {}", f.name, one_line(said.text)));
  }
  return drawn;
}

}  // namespace dem::report
