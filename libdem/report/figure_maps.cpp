#include "libdem/report/figure_maps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace dem::report {

namespace {

constexpr std::array<const char*, 3> axes{"x", "y", "z"};
// As pictures have them (libdem/render/color.h), and blue over white to red for what has a sign.
constexpr const char* sequential =
    "set palette defined (0 '#484296', 1 '#4060a0', 2 '#327ba3', 3 '#27949d', 4 '#26ad8b', 5 '#48c270', 6 '#7ed350', "
    "7 '#bcdf38', 8 '#fde725')\n";
constexpr const char* diverging =
    "set palette defined (-1 '#2166ac', -0.5 '#92c5de', 0 '#f7f7f7', 0.5 '#f4a582', 1 '#b2182b')\n";

std::vector<double> levels_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const double apart = values.empty() ? 0 : 1e-6 * (values.back() - values.front());
  std::vector<double> levels;
  for (const double v : values)
    if (levels.empty() || v - levels.back() > apart) levels.push_back(v);
  return levels;
}

double quantile(std::vector<double> values, double share) {
  values.erase(std::remove_if(values.begin(), values.end(), [](double v) { return !std::isfinite(v); }), values.end());
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Pictures of space look along x or y: that which is shorter.
std::size_t shorter_side(const std::array<double, 3>& extent) { return extent[0] < extent[1] ? 0 : 1; }

// A layer of the boxes of a table, as a picture: u to the right, v up.
struct Layer {
  std::string file;
  io::Table rows;
  std::size_t u = 0, v = 1, across = 2;
  std::array<double, 3> width{}, lower{}, upper{};  // of a box; of all; m
  std::optional<double> at;                         // place of the layer where there are several
  std::vector<bool> in;                             // rows of the layer that hold bodies
  bool fitted = false;                              // of strains
  int fewest = 1;                                   // bodies of a box that is shown
  std::string where() const { return at ? fmt::format(", layer at {} = {:.3g} m", axes[across], *at) : ""; }
  // Condition on a row, for gnuplot.
  std::string condition() const {
    std::string text = fmt::format("column('bodies') >= {}", fewest);
    if (fitted) text += " && column('strain_fitted') > 0";
    if (at) text += fmt::format(" && abs(column('{}') - ({})) < {}", axes[across], *at, 0.5 * width[across]);
    return text;
  }
};

std::optional<Layer> layer_of(const FigureList& list, const std::string& quantity) {
  const ListedTable* t = list.table(quantity, "boxes");
  if (t == nullptr || t->unit_of("bodies").empty()) return {};
  Layer layer;
  layer.file = list.last_file(*t);
  if (layer.file.empty()) return {};
  layer.rows = list.rows(layer.file);
  std::array<std::vector<double>, 3> levels;
  std::array<double, 3> extent{};
  for (std::size_t k = 0; k < 3; ++k) {
    levels[k] = levels_of(numbers(layer.rows, axes[k]));
    const auto n = static_cast<double>(levels[k].size());
    layer.width[k] = n > 1 ? (levels[k].back() - levels[k].front()) / (n - 1) : 0;
    extent[k] = n * layer.width[k];
    layer.lower[k] = levels[k].front() - 0.5 * layer.width[k];
    layer.upper[k] = levels[k].back() + 0.5 * layer.width[k];
  }
  layer.across = levels[2].size() == 1 ? 2 : shorter_side(extent);
  layer.u = layer.across == 0 ? 1 : 0;
  layer.v = layer.across == 2 ? 1 : 2;
  if (levels[layer.u].size() < 2 || levels[layer.v].size() < 2) return {};
  if (levels[layer.across].size() > 1) layer.at = levels[layer.across][levels[layer.across].size() / 2];
  const std::vector<double> bodies = numbers(layer.rows, "bodies"), place = numbers(layer.rows, axes[layer.across]);
  layer.fitted = !t->unit_of("strain_fitted").empty();
  if (layer.fitted) layer.fewest = t->unit_of("curl_x").empty() ? 6 : 8;  // twice what spans
  const std::vector<double> fitted = layer.fitted ? numbers(layer.rows, "strain_fitted") : bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    layer.in.push_back(bodies[i] >= layer.fewest && fitted[i] > 0 &&
                       (!layer.at || std::abs(place[i] - *layer.at) < 0.5 * layer.width[layer.across]));
  return layer;
}

// Distance of marks, so that about `count` of them fit: 1, 2 or 5 of a power of ten.
double marks(double range, double count) {
  const double rough = range / count, power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double step : {1.0, 2.0, 5.0})
    if (rough <= step * power) return step * power;
  return 10 * power;
}

// Axes of one scale; few marks along the one that is short.
std::string frame_of(const std::string& u, const std::string& v, double u0, double u1, double v0, double v1) {
  std::string text = fmt::format(
      "set xlabel '{} (m)'\nset ylabel '{} (m)'\nset size ratio -1\nset xrange [{}:{}]\nset yrange [{}:{}]\nunset "
      "grid\n",
      u, v, u0, u1, v0, v1);
  const double wide = 1.5 * (v1 - v0);  // the drawing's shape
  text += fmt::format("set xtics {}\n", marks(u1 - u0, std::clamp(6 * (u1 - u0) / wide, 3.0, 6.0)));
  text += fmt::format("set ytics {}\n", marks(v1 - v0, std::clamp(6 * wide / (u1 - u0), 3.0, 6.0)));
  return text;
}

struct Field {
  std::string name, title, label, unit;
  std::string value;           // for gnuplot
  std::vector<double> values;  // of each row
  bool has_sign = false;
  std::string before{}, arrows{};  // further plots
};

std::vector<double> shown(const Layer& layer, const std::vector<double>& values) {
  std::vector<double> list;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (layer.in[i]) list.push_back(values[i]);
  return list;
}

// As many marks on the key as it is long.
std::string key_marks(double range, double wide, double tall) {
  return fmt::format("set cbtics {}\n", marks(range, std::clamp(9 * tall / wide, 3.0, 6.0)));
}

void add_field(FigureList& to, const Layer& layer, const Field& f) {
  std::vector<double> list = shown(layer, f.values);
  if (list.size() < 2) return;
  for (double& v : list) v = f.has_sign ? std::abs(v) : v;
  // Strains of few boxes may be anything.
  const double top = quantile(list, layer.fitted ? 0.9 : 0.98), low = quantile(list, 0);
  if (!(top > (f.has_sign ? 0 : std::min(low, 0.0)))) return;  // zero everywhere
  const std::string colours = f.has_sign ? fmt::format("{}set cbrange [{}:{}]\n", diverging, -top, top)
                                         : fmt::format("{}set cbrange [{}:{}]\n", sequential, std::min(low, 0.0), top);
  to.add(
      f.name, f.title + layer.where() + to.when(layer.file),
      frame_of(axes[layer.u], axes[layer.v], layer.lower[layer.u], layer.upper[layer.u], layer.lower[layer.v],
               layer.upper[layer.v]) +
          colours +
          key_marks(f.has_sign ? 2 * top : top - std::min(low, 0.0), layer.upper[layer.u] - layer.lower[layer.u],
                    layer.upper[layer.v] - layer.lower[layer.v]) +
          fmt::format("set title {} offset 0,-0.5\n", axis_label(f.label, f.unit)) + f.before +
          fmt::format("plot {} using ({} ? column('{}') : NaN):'{}':({}):({}):({}) with boxxyerror fs solid noborder "
                      "lc palette notitle{}\n",
                      to.quoted(layer.file), layer.condition(), axes[layer.u], axes[layer.v],
                      0.5 * layer.width[layer.u], 0.5 * layer.width[layer.v], f.value, f.arrows));
}

Field column_field(const Layer& layer, const std::string& quantity, const std::string& column, const std::string& title,
                   const std::string& unit, bool has_sign = false) {
  return {quantity + "_map_" + column, title,   column, unit, fmt::format("column('{}')", column),
          numbers(layer.rows, column), has_sign};
}

}  // namespace

void add_flow_maps(FigureList& to) {
  const std::optional<Layer> layer = layer_of(to, "density");
  if (!layer) return;
  const std::string u = std::string("velocity_") + axes[layer->u], v = std::string("velocity_") + axes[layer->v];
  const std::vector<double> along = numbers(layer->rows, u), up = numbers(layer->rows, v);
  Field speed{"density_map_speed",
              "Mean velocity of the bodies in boxes",
              "speed",
              "m/s",
              fmt::format("sqrt(column('{0}')**2 + column('{1}')**2)", u, v),
              {},
              false,
              ""};
  for (std::size_t i = 0; i < along.size(); ++i) speed.values.push_back(std::hypot(along[i], up[i]));
  const double fastest = quantile(shown(*layer, speed.values), 0.98);
  if (fastest > 0) {
    const double longest = 0.95 * std::min(layer->width[layer->u], layer->width[layer->v]);
    speed.before = fmt::format("arrow(v) = {} / (v > {} ? v : {})\n", longest, fastest, fastest);
    speed.arrows = fmt::format(
        ", \\\n  {0} using ({1} ? column('{2}') : NaN):'{3}':(arrow({4})*column('{5}')):"
        "(arrow({4})*column('{6}')) with vectors head filled lc rgb '#202020' lw 1 notitle",
        to.quoted(layer->file), layer->condition(), axes[layer->u], axes[layer->v], speed.value, u, v);
  }
  add_field(to, *layer, speed);
  add_field(to, *layer,
            column_field(*layer, "density", "granular_temperature", "Granular temperature in boxes", "m²/s²"));
}

namespace {

// A point for each body, coloured by the density of its cell; of space those about the middle.
void add_local_density(FigureList& to, const std::string& quantity) {
  const ListedTable* t = to.table(quantity, "cells");
  if (t == nullptr) return;
  const std::string file = to.last_file(*t);
  if (file.empty()) return;
  const io::Table rows = to.rows(file);
  std::array<std::vector<double>, 3> x;
  std::array<double, 3> low{}, extent{};
  for (std::size_t k = 0; k < 3; ++k) {
    x[k] = numbers(rows, axes[k]);
    const auto [least, most] = std::minmax_element(x[k].begin(), x[k].end());
    low[k] = *least;
    extent[k] = *most - *least;
  }
  const std::size_t across = extent[2] > 0 ? shorter_side(extent) : 2, u = across == 0 ? 1 : 0, v = across == 2 ? 1 : 2;
  if (!(extent[u] > 0 && extent[v] > 0)) return;
  const std::vector<double> density = numbers(rows, "local_density");
  const double least = quantile(density, 0.05), most = quantile(density, 0.98);
  const double edge = std::cbrt(quantile(numbers(rows, "cell_volume"), 0.5)), middle = quantile(x[across], 0.5);
  const bool all = extent[across] <= 1.5 * edge;
  double shown = 0;
  for (const double at : x[across]) shown += all || std::abs(at - middle) < 0.5 * edge ? 1 : 0;
  const double apart = std::sqrt(extent[u] * extent[v] / shown), pixels = 480 / std::max(extent[u], 1.4 * extent[v]);
  const std::string in = all ? "1" : fmt::format("abs(column('{}') - ({})) < {}", axes[across], middle, 0.5 * edge);
  to.add(quantity + "_map",
         (quantity == "voronoi" ? "Local density, of radical cells" : "Local density, of set-Voronoi cells") +
             (all ? "" : fmt::format(", of bodies about {} = {:.3g} m", axes[across], middle)) + to.when(file),
         frame_of(axes[u], axes[v], low[u] - apart, low[u] + extent[u] + apart, low[v] - apart,
                  low[v] + extent[v] + apart) +
             sequential + key_marks(most > least ? most - least : 1, extent[u], extent[v]) +
             fmt::format(
                 "set cbrange [{:.3g}:{:.3g}]\nset title 'local density' offset 0,-0.5\n"
                 "plot {} using ({} ? column('{}') : NaN):'{}':'local_density' with points pt 7 ps {:.2g} lc palette "
                 "notitle\n",
                 least, most > least ? most : least + 1, to.quoted(file), in, axes[u], axes[v],
                 std::clamp(apart * pixels / 14, 0.3, 2.5)));
}

}  // namespace

void add_packing_maps(FigureList& to) {
  if (const std::optional<Layer> layer = layer_of(to, "density"))
    add_field(to, *layer, column_field(*layer, "density", "solid_fraction", "Packing density in boxes", "1"));
  add_local_density(to, to.table("set_voronoi", "cells") != nullptr ? "set_voronoi" : "voronoi");
}

void add_stress_maps(FigureList& to) {
  const std::optional<Layer> layer = layer_of(to, "stress");
  if (!layer) return;
  add_field(to, *layer, column_field(*layer, "stress", "pressure", "Pressure in boxes", "Pa"));
  add_field(to, *layer, column_field(*layer, "stress", "deviator", "Stress deviator in boxes", "Pa"));
}

void add_deformation_maps(FigureList& to) {
  const std::optional<Layer> layer = layer_of(to, "displacement");
  if (!layer) return;
  add_field(
      to, *layer,
      column_field(*layer, "displacement", "shear_strain", "Shear strain since the reference, over its boxes", "1"));
  add_field(to, *layer,
            column_field(*layer, "displacement", "volume_change", "Volume change since the reference, over its boxes",
                         "1", true));
  add_field(to, *layer,
            column_field(*layer, "displacement", std::string("curl_") + axes[layer->across],
                         "Curl of the displacement, twice the rotation, over boxes of the reference", "rad", true));
}

void add_force_network(FigureList& to) {
  const ListedTable* t = to.table("forces", "network");
  if (t == nullptr) return;
  const std::string file = to.last_file(*t);
  if (file.empty()) return;
  const io::Table rows = to.rows(file);
  std::array<std::vector<double>, 3> from, end;
  std::array<double, 3> low{}, high{};
  for (std::size_t k = 0; k < 3; ++k) {
    from[k] = numbers(rows, std::string("from_") + axes[k]);
    end[k] = numbers(rows, std::string("to_") + axes[k]);
    low[k] = *std::min_element(from[k].begin(), from[k].end());
    high[k] = *std::max_element(from[k].begin(), from[k].end());
  }
  const std::size_t across =
      high[2] > low[2] ? shorter_side({high[0] - low[0], high[1] - low[1], high[2] - low[2]}) : 2;
  const std::size_t u = across == 0 ? 1 : 0, v = across == 2 ? 1 : 2;
  std::vector<double> length;
  for (std::size_t i = 0; i < from[0].size(); ++i)
    length.push_back(std::hypot(end[0][i] - from[0][i], end[1][i] - from[1][i], end[2][i] - from[2][i]));
  // In space the lines about the middle, one typical line to either side.
  const double middle = quantile(from[across], 0.5), reach = quantile(length, 0.5);
  const bool all = high[across] - low[across] <= 2 * reach;
  std::string in = "1";
  if (!all)
    in = fmt::format("abs(column('from_{0}') - ({1})) < {2} && abs(column('to_{0}') - ({1})) < {2}", axes[across],
                     middle, reach);
  struct Class {
    double least, most, width;
    const char *colour, *title;
  };
  const double least = from[0].size() > 12000 ? 0.5 : 0;  // so that the drawing stays small
  const std::array<Class, 5> classes{{{least, 0.5, 0.4, "#9fb3c8", "below 0.5"},
                                      {0.5, 1, 0.8, "#6f93bd", "0.5 to 1"},
                                      {1, 2, 1.6, "#e0a030", "1 to 2"},
                                      {2, 4, 3, "#d9601a", "2 to 4"},
                                      {4, 1e300, 5, "#a01020", "4 and more"}}};
  std::vector<std::string> plots;
  for (const Class& c : classes)
    if (c.least < c.most)
      plots.push_back(
          fmt::format("{0} using (({1}) && column('relative') >= {2} && column('relative') < {3} ? "
                      "column('from_{4}') : NaN):'from_{5}':(column('to_{4}')-column('from_{4}')):"
                      "(column('to_{5}')-column('from_{5}')) with vectors nohead lw {6} lc rgb '{7}' title '{8}'",
                      to.quoted(file), in, c.least, c.most, axes[u], axes[v], c.width, c.colour, c.title));
  const double edge = reach;
  to.add(
      "forces_network",
      (all ? "Force network: normal forces over their mean"
           : fmt::format("Force network about {} = {:.3g} m: normal forces over their mean", axes[across], middle)) +
          to.when(file),
      frame_of(axes[u], axes[v], low[u] - edge, high[u] + edge, low[v] - edge, high[v] + edge) + joined_plots(plots));
}

void add_free_surface(FigureList& to) {
  const ListedTable* t = to.table("repose", "surface");
  if (t == nullptr) return;
  const std::string file = to.last_file(*t);
  if (file.empty()) return;
  const io::Table rows = to.rows(file);
  const std::vector<double> height = numbers(rows, "height");
  // Along the widest axis that the height is not counted along.
  std::size_t along = 3;
  double widest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::vector<double> x = numbers(rows, axes[k]);
    double least = x[0], most = x[0], base_least = x[0] - height[0], base_most = base_least;
    for (std::size_t i = 0; i < x.size(); ++i) {
      least = std::min(least, x[i]);
      most = std::max(most, x[i]);
      base_least = std::min(base_least, x[i] - height[i]);
      base_most = std::max(base_most, x[i] - height[i]);
    }
    const bool vertical = base_most - base_least <= 1e-9 * (most - least);
    if (vertical || most - least <= widest) continue;
    widest = most - least;
    along = k;
  }
  if (along == 3) return;
  to.add("repose_surface", t->title + to.when(file),
         fmt::format("set xlabel '{0} (m)'\nset ylabel 'height (m)'\nset size ratio -1\nset yrange [0:*]\n"
                     "plot {1} using '{0}':'height' with points pt 7 ps 0.6 notitle\n",
                     axes[along], to.quoted(file)));
}

void add_directions(FigureList& to) {
  const ListedTable* t = to.table("rose", "sphere");
  if (t == nullptr) return;
  const std::string file = to.last_file(*t);
  if (file.empty()) return;
  to.add("rose_sphere",
         std::string("Contact normals in space: half sphere seen along z, areas kept; contacts per solid angle") +
             to.when(file),
         fmt::format(
             "set size ratio -1\nset xrange [-1.1:1.1]\nset yrange [-1.1:1.1]\nset xlabel 'x'\nset ylabel 'y'\n"
             "unset grid\nunset tics\nset cbtics\nset border 0\nset parametric\nset trange [0:2*pi]\n{0}"
             "set cblabel 'density (1/sr)'\n"
             "r(z) = z < 0 ? -sqrt(1 + z) : sqrt(1 - z)\nh(x, y) = x == 0 && y == 0 ? 1 : sqrt(x**2 + y**2)\n"
             "plot {1} using (r(column('z'))*column('x')/h(column('x'), column('y'))):"
             "(r(column('z'))*column('y')/h(column('x'), column('y'))):'density' with points pt 7 ps 1.4 lc palette "
             "notitle, cos(t), sin(t) with lines lc rgb '#888888' notitle\n",
             sequential, to.quoted(file)));
}

}  // namespace dem::report
