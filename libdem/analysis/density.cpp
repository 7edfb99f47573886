#include "libdem/analysis/density.h"

#include <cmath>
#include <set>

#include "libdem/analysis/pairs.h"

namespace dem::analysis {

namespace {

void add_vector(Table& t, const std::string& name, const std::string& unit, const std::vector<Vec3d>& values,
                int dimension, bool axial) {
  for (int k = 0; k < 3; ++k) {
    if (dimension == 2 && (axial ? k < 2 : k == 2)) continue;
    Column c{name + "_" + "xyz" [k], unit, {}};
    for (const Vec3d& v : values) c.values.push_back(v[k]);
    t.columns.push_back(std::move(c));
  }
}

Table box_table(const Snapshot& s, const Grid& grid, const BoxFields& f) {
  Table t{"boxes", "Packing density and mean motion in boxes", {}};
  std::vector<Vec3d> centres;
  for (std::size_t b = 0; b < grid.size(); ++b) centres.push_back(grid.centre(b));
  for (int k = 0; k < s.dimension; ++k) {
    Column c{std::string(1, "xyz"[k]), "m", {}};
    for (const Vec3d& x : centres) c.values.push_back(x[k]);
    t.columns.push_back(std::move(c));
  }
  t.columns.push_back({"solid_fraction", "1", f.solid_fraction});
  t.columns.push_back({"bodies", "1", f.bodies});
  if (s.has_rotation) add_vector(t, "rotation", "rad", f.rotation, s.dimension, true);
  if (s.has_velocity) {
    add_vector(t, "spin", "rad/s", f.spin, s.dimension, true);
    add_vector(t, "velocity", "m/s", f.velocity, s.dimension, false);
    t.columns.push_back({"granular_temperature", "m²/s²", f.granular_temperature});
    add_vector(t, "flux", "m/s", f.flux, s.dimension, false);
  }
  if (s.has_contacts) t.columns.push_back({"coordination", "1", f.coordination});
  return t;
}

Table envelope_table(const std::vector<EnvelopePoint>& points) {
  Table t{"envelope",
          "Packing density over the size of the boxes",
          {{"box_edge", "m", {}},
           {"boxes", "1", {}},
           {"mean", "1", {}},
           {"standard_deviation", "1", {}},
           {"standard_error", "1", {}},
           {"least", "1", {}},
           {"greatest", "1", {}}}};
  for (const EnvelopePoint& p : points) {
    const double row[] = {p.edge, static_cast<double>(p.boxes), p.mean, p.deviation, p.error, p.least, p.greatest};
    for (std::size_t k = 0; k < t.columns.size(); ++k) t.columns[k].values.push_back(row[k]);
  }
  return t;
}

}  // namespace

std::vector<double> solid_fractions(const BoxShares& shares, const Grid& grid) {
  std::vector<double> fraction(grid.size());
  for (const BoxShare& share : shares.on(grid)) fraction[share.box] += share.volume / grid.box_volume();
  return fraction;
}

BoxFields box_fields(const Snapshot& s, const BoxShares& shares, const Grid& grid) {
  BoxFields f;
  const std::size_t n = grid.size();
  for (auto* field : {&f.solid_volume, &f.solid_fraction, &f.bodies, &f.granular_temperature, &f.coordination})
    field->resize(n);
  for (auto* field : {&f.rotation, &f.spin, &f.velocity, &f.flux}) field->resize(n);
  for (const BoxShare& share : shares.on(grid)) {
    f.solid_volume[share.box] += share.volume;
    f.flux[share.box] += (share.volume / grid.box_volume()) * s.velocity[share.body];  // (2)
  }
  const Pairs pairs = pairs_of(s);
  std::vector<std::size_t> box(s.count());
  for (std::size_t i = 0; i < s.count(); ++i) {
    const std::size_t b = box[i] = grid.index(s.position[i]);
    if (b == Grid::none) continue;
    f.bodies[b] += 1;
    f.rotation[b] += s.rotation[i];  // (9.39)
    f.spin[b] += s.spin[i];
    f.velocity[b] += s.velocity[i];
    f.coordination[b] += pairs.contacts_of(i);
  }
  for (std::size_t b = 0; b < n; ++b) {
    f.solid_fraction[b] = f.solid_volume[b] / grid.box_volume();  // (1)
    const double one = f.bodies[b] > 0 ? 1 / f.bodies[b] : 0;
    f.rotation[b] *= one;
    f.spin[b] *= one;
    f.velocity[b] *= one;
    f.coordination[b] *= one;
  }
  for (std::size_t i = 0; i < s.count(); ++i) {
    if (box[i] == Grid::none) continue;
    const Vec3d own = s.velocity[i] - f.velocity[box[i]];
    f.granular_temperature[box[i]] += dot(own, own) / (s.dimension * f.bodies[box[i]]);
  }
  return f;
}

EnvelopePoint envelope_point(const std::vector<double>& fractions, const Grid& grid) {
  EnvelopePoint p;
  p.boxes = fractions.size();
  p.edge = 1;
  for (int k = 0; k < grid.dimension(); ++k)
    p.edge *= (grid.region().upper[k] - grid.region().lower[k]) / grid.count(k);
  p.edge = grid.dimension() == 2 ? std::sqrt(p.edge) : std::cbrt(p.edge);
  if (fractions.empty()) return p;
  const auto n = static_cast<double>(p.boxes);
  p.least = p.greatest = fractions[0];
  for (const double d : fractions) {
    p.mean += d / n;
    p.least = std::min(p.least, d);
    p.greatest = std::max(p.greatest, d);
  }
  if (p.boxes < 2) return p;
  double squares = 0;
  for (const double d : fractions) squares += (d - p.mean) * (d - p.mean);
  p.deviation = std::sqrt(squares / (n - 1));
  p.error = p.deviation / std::sqrt(n);
  return p;
}

std::vector<EnvelopePoint> density_envelope(const Snapshot& s, const BoxShares& shares, const Domain& region) {
  std::vector<EnvelopePoint> points;
  std::set<std::array<int, 3>> done;
  const double diameter = mean_diameter(s);
  if (!(diameter > 0)) return points;
  for (const double width : {1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0, 48.0, 64.0, 1e9}) {
    std::array<int, 3> boxes{1, 1, 1};
    for (int k = 0; k < s.dimension; ++k)
      boxes[static_cast<std::size_t>(k)] =
          static_cast<int>(std::clamp((region.upper[k] - region.lower[k]) / (width * diameter), 1.0, 512.0));
    if (!done.insert(boxes).second) continue;
    const Grid grid(s, region, boxes);
    points.push_back(envelope_point(solid_fractions(shares, grid), grid));
  }
  return points;
}

Result report_density(const Snapshot& s, const Settings& settings) {
  Result r;
  if (s.count() == 0) {
    r.notes.emplace_back("no bodies");
    return r;
  }
  const Grid grid = grid_of(s, settings);
  const double volume = grid.box_volume() * static_cast<double>(grid.size());
  if (!(volume > 0)) {
    r.notes.emplace_back("the region has no volume");
    return r;
  }
  const BoxShares shares(s);
  r.notes = shares.notes();
  const BoxFields f = box_fields(s, shares, grid);
  double solid = 0, bodies = 0;
  Vec3d rotation{}, flux{};
  for (std::size_t b = 0; b < grid.size(); ++b) {
    solid += f.solid_volume[b];
    bodies += f.bodies[b];
    rotation += f.bodies[b] * f.rotation[b];
    flux += f.flux[b] * (1 / static_cast<double>(grid.size()));
  }
  const EnvelopePoint point = envelope_point(f.solid_fraction, grid);
  r.add("solid_fraction", "1", solid / volume);
  if (point.boxes > 1) r.scalars.back().error = point.error;
  r.add("solid_volume", "m³", solid);
  r.add("region_volume", "m³", volume);
  r.add("bodies", "1", bodies);
  for (int k = 0; k < 3; ++k) {
    if (s.has_rotation && bodies > 0 && (s.dimension == 3 || k == 2))
      r.add(std::string("mean_rotation_") + "xyz"[k], "rad", rotation[k] / bodies);
    if (s.has_velocity && k < s.dimension) r.add(std::string("flux_") + "xyz"[k], "m/s", flux[k]);
  }
  if (point.boxes > 1) r.add("solid_fraction_deviation", "1", point.deviation);
  r.notes.emplace_back("solid fractions by exact shares; where bodies overlap both count");
  if (!s.has_rotation) r.notes.emplace_back("accumulated rotation is not known");
  if (!s.has_velocity) r.notes.emplace_back("velocities are not known");
  r.tables.push_back(box_table(s, grid, f));
  r.tables.push_back(envelope_table(density_envelope(s, shares, grid.region())));
  return r;
}

}  // namespace dem::analysis
