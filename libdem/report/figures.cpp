#include "libdem/report/figures.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "libdem/io/programs.h"
#include "libdem/report/words.h"

namespace dem::report {

namespace {

namespace fs = std::filesystem;

std::string label(const std::string& name, const std::string& unit) {
  return io::gnuplot_quoted(unit.empty() || unit == "1" ? words(name) : fmt::format("{} ({})", words(name), unit));
}

bool has_rows(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  int lines = 0;
  while (lines < 2 && std::getline(file, line))
    if (!line.empty() && line[0] != '#') ++lines;
  return lines == 2;
}

struct Line {
  std::string column, with, title;
};

class Figures {
 public:
  Figures(const Listing& listing, std::string data) : listing_(listing), data_(std::move(data)) {}

  // Scalars of one unit over time; those that there are.
  void add_series(const std::string& quantity, const std::vector<std::string>& names, const std::string& title) {
    const ListedQuantity* q = listing_.quantity(quantity);
    if (q == nullptr || listing_.frames.size() < 2) return;
    std::vector<std::string> plots;
    std::string unit, first;
    for (const std::string& name : names) {
      const ListedScalar* s = q->scalar(name);
      if (s == nullptr || s->frames < 2) continue;
      if (plots.empty()) {
        unit = s->unit;
        first = name;
      }
      plots.push_back(plot(quantity + "_series.csv", "time", {name, "linespoints pt 7 ps 0.35 lw 1.5", words(name)}));
    }
    if (plots.empty()) return;
    const std::string y = plots.size() == 1 ? first : words(quantity);
    list_.push_back({fmt::format("series_{}_{}", quantity, first), title + " over time",
                     fmt::format("set xlabel 'time (s)'\nset ylabel {}\n{}", label(y, unit), joined(plots)), ""});
  }

  // Columns of a table over another of its columns, of the last frame that has rows.
  void add_table(const std::string& quantity, const std::string& table, const std::string& x,
                 const std::vector<Line>& lines, const std::string& y, const std::string& settings = "") {
    const ListedTable* t = find(quantity, table);
    if (t == nullptr) return;
    const std::string file = last_file(*t);
    if (file.empty() || t->unit_of(x).empty()) return;
    std::vector<std::string> plots;
    for (const Line& line : lines)
      if (!t->unit_of(line.column).empty()) plots.push_back(plot(file, x, line));
    if (plots.empty()) return;
    const std::string name = table.empty() ? quantity : quantity + "_" + table;
    list_.push_back({name, t->title.empty() ? words(name) : t->title,
                     fmt::format("set xlabel {}\nset ylabel {}\n{}{}", label(x, t->unit_of(x)),
                                 label(y, t->unit_of(lines[0].column)), settings, joined(plots)),
                     ""});
  }

  // Mean with its standard deviation and the range, over the size of the boxes.
  void add_envelope() {
    const ListedTable* t = find("density", "envelope");
    if (t == nullptr) return;
    const std::string file = last_file(*t);
    if (file.empty()) return;
    const std::string data = io::gnuplot_quoted(data_ + "/" + file);
    list_.push_back({"density_envelope", t->title,
                     fmt::format("set xlabel {0}\nset ylabel 'packing density'\n"
                                 "plot {1} using 'box_edge':'least':'greatest' with filledcurves fs solid 0.15 lc 1 "
                                 "title 'least to greatest', \\\n"
                                 "  {1} using 'box_edge':'mean':'standard_deviation' with yerrorbars pt 7 ps 0.5 lc 1 "
                                 "title 'mean and standard deviation'\n",
                                 label("box_edge", t->unit_of("box_edge")), data),
                     ""});
  }

  // Closed curves in polar coordinates, by number and by force.
  void add_rose(const std::string& plane) {
    const ListedTable* t = find("rose", plane);
    if (t == nullptr) return;
    const std::string file = last_file(*t);
    if (file.empty()) return;
    const std::string data = io::gnuplot_quoted(data_ + "/" + file);
    list_.push_back(
        {"rose_" + plane, t->title,
         fmt::format("set polar\nset angles radians\nunset border\nunset xtics\nunset ytics\n"
                     "set grid polar 30\nset size square\nset rrange [0:*]\n"
                     "set tmargin at screen 0.84\nset bmargin at screen 0.06\n"
                     "set label '{1}' at graph 1.05,0.5 center\nset label '{2}' at graph 0.5,1.05 center\n"
                     "plot {0} using 'angle':'density' with impulses lw 7 lc rgb '#9fb8dd' title 'by number', \\\n"
                     "  {0} using 'angle':'force_density' with points pt 7 ps 0.5 lc 2 title 'by force', \\\n"
                     "  {0} using 'angle':'fit' with lines lw 1.5 lc 1 title 'fit by number'\n",
                     data, plane[0], plane[1]),
         ""});
  }

  const Listing& listing() const { return listing_; }
  std::vector<Figure> take() { return std::move(list_); }

 private:
  const ListedTable* find(const std::string& quantity, const std::string& table) const {
    const ListedQuantity* q = listing_.quantity(quantity);
    return q == nullptr ? nullptr : q->table(table);
  }
  std::string last_file(const ListedTable& t) const {
    for (auto at = t.files.rbegin(); at != t.files.rend(); ++at)
      if (has_rows(fs::path(listing_.folder) / *at)) return *at;
    return "";
  }
  std::string plot(const std::string& file, const std::string& x, const Line& line) const {
    return fmt::format("{} using '{}':'{}' with {} {}", io::gnuplot_quoted(data_ + "/" + file), x, line.column,
                       line.with, line.title.empty() ? "notitle" : "title " + io::gnuplot_quoted(line.title));
  }
  static std::string joined(const std::vector<std::string>& plots) {
    std::string text = "plot ";
    for (const std::string& p : plots) text += (&p == plots.data() ? "" : ", \\\n  ") + p;
    return text + "\n";
  }

  const Listing& listing_;
  std::string data_;
  std::vector<Figure> list_;
};

void add_all_series(Figures& to) {
  to.add_series("energy", {"translational", "rotational", "elastic"}, "Energy of motion");
  to.add_series("energy", {"potential"}, "Potential energy");
  to.add_series("velocity", {"mean_speed", "largest_speed"}, "Speed of the bodies");
  to.add_series("velocity", {"temperature"}, "Granular temperature");
  to.add_series("density", {"solid_fraction"}, "Packing density");
  to.add_series("coordination", {"coordination", "coordination_with_walls", "mechanical_coordination"},
                "Coordination number");
  to.add_series("stress", {"pressure", "kinetic_pressure", "stress_deviator"}, "Stress");
  to.add_series("forces", {"mean_normal_force", "mean_tangential_force"}, "Mean contact forces");
  to.add_series("fabric", {"fabric_deviator", "branch_deviator", "force_fabric_deviator"}, "Fabric deviator");
  to.add_series("mixing", {"lacey", "lacey_index", "segregation_intensity", "intensity_of_segregation"}, "Mixing");
  to.add_series("displacement", {"rms_displacement"}, "Root mean square displacement");
  to.add_series("flow", {"discharge_rate", "inflow_rate"}, "Discharge and inflow");
  to.add_series("repose", {"angle", "angle_of_repose"}, "Angle of repose");
  if (const ListedQuantity* walls = to.listing().quantity("walls")) {
    std::vector<std::string> normal;
    for (const ListedScalar& s : walls->scalars)
      if (s.name.ends_with("_normal_force")) normal.push_back(s.name);
    to.add_series("walls", normal, "Normal force on walls");
  }
}

}  // namespace

std::vector<Figure> figures_of(const Listing& listing, const std::string& data) {
  const std::string line = "lines lw 1.5", dots = "linespoints pt 7 ps 0.35 lw 1.5",
                    boxes = "boxes fs solid 0.5 border lt -1";
  Figures to(listing, data);
  add_all_series(to);
  to.add_table("rdf", "", "r", {{"g", line, ""}}, "g");
  to.add_table("coordination", "distribution", "contacts", {{"share", boxes, ""}}, "share of bodies",
               "set boxwidth 0.8\nset xrange [-0.6:*]\nset yrange [0:*]\n");
  to.add_table("forces", "normal", "force_over_mean", {{"density", "points pt 7 ps 0.6", ""}}, "P(f/<f>)",
               "set logscale y\n");
  for (const char* plane : {"xy", "xz", "yz"}) to.add_rose(plane);
  to.add_envelope();
  to.add_table("voronoi", "distribution", "local_density", {{"probability_density", dots, ""}}, "probability density");
  if (const ListedQuantity* porosity = listing.quantity("porosity"))
    for (const ListedTable& t : porosity->tables)
      to.add_table("porosity", t.name, t.columns.empty() ? "" : t.columns[0], {{"porosity", "histeps lw 1.5", ""}},
                   "porosity", "set yrange [0:1]\n");
  to.add_table("velocity", "distribution", "speed", {{"density", dots, ""}}, "density");
  for (const char* axis : {"x", "y", "z"})
    to.add_table(
        "flow", axis, axis,
        {{"velocity_x", dots, "velocity x"}, {"velocity_y", dots, "velocity y"}, {"velocity_z", dots, "velocity z"}},
        "mean velocity");
  return to.take();
}

}  // namespace dem::report
