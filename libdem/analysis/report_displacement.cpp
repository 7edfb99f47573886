// What displacement.h finds, as numbers and tables.
#include <cmath>

#include "libdem/analysis/displacement.h"
#include "libdem/analysis/groups.h"
#include "libdem/analysis/stress.h"
#include "libdem/analysis/table.h"

namespace dem::analysis {

namespace {

constexpr int bands = 8;

void add_column(Table& t, const char* name, const char* unit, const std::vector<double>& values) {
  t.columns.push_back({name, unit, values});
}

// One column per number that `of` gives of each local gradient, zero where there is none.
template <class Of>
void add_local(Table& t, const char* name, const char* unit, const std::vector<LocalGradient>& list, Of of) {
  std::vector<double> values;
  for (const LocalGradient& g : list) values.push_back(g.fitted ? of(g) : 0);
  add_column(t, name, unit, values);
}

void add_strains(Table& t, const std::vector<LocalGradient>& list, int dimension) {
  add_local(t, "volume_change", "1", list, [](const LocalGradient& g) { return volume_change(g.gradient); });
  add_local(t, "shear_strain", "1", list,
            [&](const LocalGradient& g) { return deviator(finite_strain(g.gradient), dimension); });
  if (dimension == 3) {
    add_local(t, "curl_x", "rad", list, [](const LocalGradient& g) { return curl_of(g.gradient).x; });
    add_local(t, "curl_y", "rad", list, [](const LocalGradient& g) { return curl_of(g.gradient).y; });
  }
  add_local(t, "curl_z", "rad", list, [](const LocalGradient& g) { return curl_of(g.gradient).z; });
  add_local(t, "non_affine", "m", list, [](const LocalGradient& g) { return std::sqrt(g.left_over); });
}

void add_fitted(Table& t, const char* name, const std::vector<LocalGradient>& list) {
  std::vector<double> values;
  for (const LocalGradient& g : list) values.push_back(g.fitted ? 1 : 0);
  add_column(t, name, "1", values);
}

double share_without(const std::vector<LocalGradient>& list) {
  double n = 0;
  for (const LocalGradient& g : list) n += g.fitted ? 0 : 1;
  return list.empty() ? 0 : n / static_cast<double>(list.size());
}

void add_since_reference(Result& r, Table& bodies, const Snapshot& s, const Settings& settings) {
  const Snapshot& reference = *settings.reference;
  const Displacements u = displacements(s, reference);
  r.add("bodies_of_reference", "1", static_cast<double>(u.known));
  r.add("time_since_reference", "s", s.time - reference.time);
  if (u.known == 0) {
    r.notes.emplace_back("no body of the reference is here");
    return;
  }
  Vec3d mean{};
  double square = 0;
  for (const Vec3d& d : u.of_body) {
    mean += d * (1 / static_cast<double>(u.known));
    square += dot(d, d) / static_cast<double>(u.known);
  }
  for (int k = 0; k < s.dimension; ++k) r.add(std::string("mean_displacement_") + "xyz"[k], "m", mean[k]);
  r.add("rms_displacement", "m", std::sqrt(square));
  const Domain everywhere = settings.region ? *settings.region : domain_of(reference);
  const LocalGradient whole = box_gradients(s, reference, u, Grid(reference, everywhere, {1, 1, 1})).at(0);
  if (whole.fitted) {
    add_tensor(r, "strain", "1", finite_strain(whole.gradient), s.dimension);
    r.add("volume_change", "1", volume_change(whole.gradient));
  }
  for (int k = 0; k < 3; ++k) {
    const char* names[] = {"displacement_x", "displacement_y", "displacement_z"};
    std::vector<double> values;
    for (const Vec3d& d : u.of_body) values.push_back(d[k]);
    add_column(bodies, names[k], "m", values);
  }
  const std::vector<LocalGradient> local = displacement_gradients(s, reference, u);
  add_fitted(bodies, "strain_fitted", local);
  add_strains(bodies, local, s.dimension);
  r.add("without_strain", "1", share_without(local));
  const Grid grid(reference, everywhere, boxes_of(reference, everywhere, settings.boxes));
  const std::vector<LocalGradient> boxes = box_gradients(s, reference, u, grid);
  Table t =
      table_of("boxes", "Strain of the bodies of each box of the reference", {{"x", "m"}, {"y", "m"}, {"z", "m"}});
  for (std::size_t k = 0; k < grid.size(); ++k) {
    const Vec3d x = grid.centre(k);
    add_row(t, x.x, x.y, x.z);
  }
  std::vector<double> count;
  for (const LocalGradient& g : boxes) count.push_back(g.neighbours);
  add_column(t, "bodies", "1", count);
  add_fitted(t, "strain_fitted", boxes);
  add_strains(t, boxes, s.dimension);
  r.tables.push_back(std::move(t));
  r.notes.emplace_back("displacements along periodic axes: to the image that has moved least, below half a cell");
}

void add_rates(Result& r, Table& bodies, const Snapshot& s) {
  const std::vector<LocalGradient> rate = velocity_gradients(s);
  add_fitted(bodies, "rate_fitted", rate);
  add_local(bodies, "divergence", "1/s", rate, [](const LocalGradient& g) { return trace(g.gradient); });
  add_local(bodies, "shear_rate", "1/s", rate,
            [&](const LocalGradient& g) { return deviator(symmetric_part(g.gradient), s.dimension); });
  if (s.dimension == 3) {
    add_local(bodies, "vorticity_x", "1/s", rate, [](const LocalGradient& g) { return curl_of(g.gradient).x; });
    add_local(bodies, "vorticity_y", "1/s", rate, [](const LocalGradient& g) { return curl_of(g.gradient).y; });
  }
  add_local(bodies, "vorticity_z", "1/s", rate, [](const LocalGradient& g) { return curl_of(g.gradient).z; });
  double shear = 0, fitted = 0;
  for (const LocalGradient& g : rate) {
    if (!g.fitted) continue;
    shear += deviator(symmetric_part(g.gradient), s.dimension);
    fitted += 1;
  }
  if (fitted > 0) r.add("mean_shear_rate", "1/s", shear / fitted);
}

void add_band(Table& t, const char* name, const Groups& groups) {
  std::vector<double> values;
  for (const std::uint32_t g : groups.of_body) values.push_back(g == Groups::none ? -1.0 : g);
  add_column(t, name, "1", values);
}

}  // namespace

Result report_displacement(const Snapshot& s, const Settings& settings) {
  Result r;
  if (s.count() == 0) {
    r.notes.emplace_back("no bodies");
    return r;
  }
  Table bodies = table_of(
      "bodies", "Deformation about each body; where fitted is 0 its neighbours do not span the space", {{"id", "1"}});
  for (const std::uint64_t id : s.id) add_row(bodies, id);
  add_band(bodies, "layer", groups_of(s, "layers", settings.reference, bands));
  add_band(bodies, "group", groups_of(s, settings.split, settings.reference, bands));
  if (settings.reference != nullptr)
    add_since_reference(r, bodies, s, settings);
  else
    r.notes.emplace_back("no reference frame: layers of this one, no displacements");
  if (s.has_velocity)
    add_rates(r, bodies, s);
  else
    r.notes.emplace_back("velocities are not known");
  r.tables.push_back(std::move(bodies));
  return r;
}

}  // namespace dem::analysis
