#include "libdem/report/figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "libdem/io/programs.h"
#include "libdem/report/figure_list.h"
#include "libdem/report/figure_maps.h"
#include "libdem/report/words.h"

namespace dem::report {

namespace {

constexpr const char* line = "lines lw 1.5";
constexpr const char* dots = "linespoints pt 7 ps 0.35 lw 1.5";

// Mean with its standard deviation and the range, over the size of the boxes.
void add_envelope(FigureList& to) {
  const ListedTable* t = to.table("density", "envelope");
  if (t == nullptr) return;
  const std::string file = to.last_file(*t);
  if (file.empty()) return;
  to.add("density_envelope", t->title + to.when(file),
         fmt::format("set xlabel {0}\nset ylabel 'packing density'\n"
                     "plot {1} using 'box_edge':'least':'greatest' with filledcurves fs solid 0.15 lc 1 "
                     "title 'least to greatest', \\\n"
                     "  {1} using 'box_edge':'mean':'standard_deviation' with yerrorbars pt 7 ps 0.5 lc 1 "
                     "title 'mean and standard deviation'\n",
                     axis_label("box_edge", t->unit_of("box_edge")), to.quoted(file)));
}

// Closed curves in polar coordinates, by number and by force.
void add_rose(FigureList& to, const std::string& plane) {
  const ListedTable* t = to.table("rose", plane);
  if (t == nullptr) return;
  const std::string file = to.last_file(*t);
  if (file.empty()) return;
  const io::Table rows = to.rows(file);
  double rim = 0;
  for (const char* column : {"density", "force_density"})
    for (const double v : numbers(rows, column)) rim = std::max(rim, std::isfinite(v) ? v : 0);
  if (!(rim > 0)) return;
  to.add("rose_" + plane, t->title + to.when(file),
         fmt::format("set polar\nset angles radians\nunset border\nunset xtics\nunset ytics\nunset raxis\n"
                     "set rtics {3}\nset format r ''\nset grid polar 30\nset size square\nset rrange [0:{4}]\n"
                     "set tmargin at screen 0.84\nset bmargin at screen 0.06\n"
                     "set label '{1}' at graph 1.05,0.5 center\nset label '{2}' at graph 0.5,1.05 center\n"
                     "set label 'rim: {4:.3g}/rad' at graph 1.0,0.02 left\n"
                     "plot {0} using 'angle':'density' with impulses lw 7 lc rgb '#9fb8dd' title 'by number', \\\n"
                     "  {0} using 'angle':'force_density' with points pt 7 ps 0.5 lc 2 title 'by force', \\\n"
                     "  {0} using 'angle':'fit' with lines lw 1.5 lc 1 title 'fit by number'\n",
                     to.quoted(file), plane[0], plane[1], rim / 2, rim));
}

// Scalars of the walls that end so, one line a wall.
void add_wall_series(FigureList& to, const std::string& ending, const std::string& title, const std::string& y) {
  const ListedQuantity* walls = to.listing().quantity("walls");
  if (walls == nullptr) return;
  std::vector<std::string> names;
  for (const ListedScalar& s : walls->scalars)
    if (s.name.ends_with(ending)) names.push_back(s.name);
  to.add_series("walls", names, title, y);
}

// Pressure against height, one line a wall.
void add_wall_profiles(FigureList& to) {
  const ListedQuantity* walls = to.listing().quantity("walls");
  if (walls == nullptr) return;
  std::vector<std::string> plots;
  for (const ListedTable& t : walls->tables) {
    const std::string file = t.name.starts_with("height_") ? to.last_file(t) : "";
    if (!file.empty())
      plots.push_back(fmt::format("{} using 'pressure':'height' with linespoints pt 7 ps 0.5 lw 1.5 title {}",
                                  to.quoted(file), io::gnuplot_quoted(words(t.name.substr(7)) + to.when(file))));
  }
  if (plots.empty()) return;
  to.add("walls_height", "Pressure on the walls over height",
         "set xlabel 'pressure (Pa)'\nset ylabel 'height (m)'\nset xrange [0:*]\n" + joined_plots(plots));
}

void add_discharge(FigureList& to, const Folders& folders) {
  if (folders.run.empty() || !has_rows((std::filesystem::path(folders.run_here) / "discharge.csv").string())) return;
  to.add("discharge", "Mass that the outlets have taken",
         fmt::format("set xlabel 'time (s)'\nset ylabel 'mass (kg)'\nplot {} using 'time':'mass' with steps lw 1.5 "
                     "notitle\n",
                     io::gnuplot_quoted(folders.run + "/discharge.csv")));
}

void add_residence(FigureList& to) {
  const ListedTable* t = to.table("flow", "residence");
  if (t == nullptr) return;
  const std::string file = to.last_file(*t);
  if (file.empty()) return;
  to.add("flow_residence", "Bodies that have left, by how long they were seen",
         fmt::format("set xlabel 'time of stay (s)'\nset ylabel 'bodies that left sooner'\n"
                     "plot {} using (column('left') - column('entered')):(1) smooth cumulative with steps lw 1.5 "
                     "notitle\n",
                     to.quoted(file)));
}

void add_motion(FigureList& to) {
  to.begin_group("Energy and motion");
  to.add_series("energy", {"translational", "rotational", "elastic"}, "Energy of motion and of contacts", "energy");
  to.add_series("energy", {"potential"}, "Potential energy", "potential energy");
  to.add_series("velocity", {"mean_speed", "largest_speed"}, "Speed of the bodies", "speed");
  to.add_series("velocity", {"temperature"}, "Granular temperature", "temperature");
  if (const ListedQuantity* q = to.listing().quantity("velocity"))
    if (const ListedScalar* bodies = q->scalar("bodies"); bodies != nullptr && !bodies->constant)
      to.add_series("velocity", {"bodies"}, "Number of bodies", "bodies");
  to.add_table("velocity", "distribution", "speed", {{"density", dots, ""}}, "density");
}

void add_packing(FigureList& to) {
  to.begin_group("Packing");
  to.add_series("density", {"solid_fraction"}, "Packing density", "packing density");
  to.add_table("rdf", "", "r", {{"g", line, ""}}, "g");
  add_envelope(to);
  add_packing_maps(to);
  for (const char* cells : {"voronoi", "set_voronoi"})
    to.add_table(cells, "distribution", "local_density", {{"probability_density", dots, ""}}, "probability density");
  if (const ListedQuantity* porosity = to.listing().quantity("porosity"))
    for (const ListedTable& t : porosity->tables)
      to.add_table("porosity", t.name, t.columns.empty() ? "" : t.columns[0], {{"porosity", line, ""}}, "porosity",
                   "set yrange [0:1]\n");
  to.add_series("orientation", {"order_1", "order_along_gravity"}, "Order of the bodies' axes", "order");
}

void add_contacts(FigureList& to) {
  to.begin_group("Contacts and forces");
  to.add_series("coordination", {"coordination", "coordination_with_walls", "mechanical_coordination"},
                "Coordination number", "contacts per body");
  to.add_table("coordination", "distribution", "contacts", {{"share", "boxes fs solid 0.5 border lt -1", ""}},
               "share of bodies", "set boxwidth 0.8\nset xrange [-0.6:*]\nset yrange [0:*]\n");
  add_force_network(to);
  to.add_series("forces", {"mean_normal_force", "mean_tangential_force"}, "Mean contact forces", "force");
  to.add_table("forces", "normal", "force_over_mean", {{"density", "points pt 7 ps 0.6", ""}}, "P(f/<f>)",
               "set logscale y\n");
  to.add_table("forces", "mobilised", "ratio", {{"density", dots, ""}}, "density");
  to.add_series("fabric", {"fabric_deviator", "branch_deviator", "force_fabric_deviator"}, "Fabric deviator",
                "deviator");
  for (const char* plane : {"xy", "xz", "yz"}) add_rose(to, plane);
  add_directions(to);
}

void add_stress(FigureList& to) {
  to.begin_group("Stress and walls");
  to.add_series("stress", {"pressure", "kinetic_pressure", "stress_deviator"}, "Pressure and deviator", "stress");
  to.add_series("stress", {"stress_xx", "stress_yy", "stress_zz"}, "Normal stresses", "stress");
  to.add_series("stress", {"stress_xy", "stress_xz", "stress_yz"}, "Shear stresses", "stress");
  add_stress_maps(to);
  add_wall_series(to, "_normal_force", "Normal force on walls", "force");
  for (const char* axis : {"x", "y", "z"})
    add_wall_series(to, std::string("_force_") + axis, std::string("Force on walls along ") + axis, "force");
  for (const char* axis : {"x", "y", "z"})
    add_wall_series(to, std::string("_torque_") + axis, std::string("Torque on walls about ") + axis, "torque");
  add_wall_profiles(to);
}

void add_flow(FigureList& to, const Folders& folders) {
  to.begin_group("Flow");
  add_discharge(to, folders);
  to.add_series("flow", {"discharge_rate", "inflow_rate"}, "Discharge and inflow", "mass per time");
  add_residence(to);
  add_flow_maps(to);
  for (const char* axis : {"x", "y", "z"})
    to.add_table(
        "flow", axis, axis,
        {{"velocity_x", dots, "velocity x"}, {"velocity_y", dots, "velocity y"}, {"velocity_z", dots, "velocity z"}},
        "mean velocity");
}

void add_deformation(FigureList& to) {
  to.begin_group("Deformation, mixing, surface");
  to.add_series("displacement", {"rms_displacement"}, "Root mean square displacement", "displacement");
  to.add_series("displacement", {"strain_xx", "strain_yy", "strain_zz", "strain_xy", "strain_xz", "strain_yz"},
                "Strain of all bodies together", "strain");
  to.add_series("displacement", {"volume_change"}, "Volume change of all bodies together", "volume change");
  add_deformation_maps(to);
  to.add_series("mixing", {"lacey", "segregation_intensity", "rsd_group_0"}, "Mixing", "index");
  to.add_series("repose", {"angle_of_repose", "surface_tilt"}, "Angle of repose and tilt of the surface", "angle");
  add_free_surface(to);
}

}  // namespace

std::vector<Figure> figures_of(const Listing& listing, const Folders& folders) {
  FigureList to(listing, folders.data);
  add_motion(to);
  add_packing(to);
  add_contacts(to);
  add_stress(to);
  add_flow(to, folders);
  add_deformation(to);
  return to.take();
}

}  // namespace dem::report
