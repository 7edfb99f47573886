#include "libdem/analysis/fabric.h"

#include <algorithm>

#include "libdem/analysis/grid.h"
#include "libdem/analysis/table.h"

namespace dem::analysis {

namespace {

constexpr std::size_t slot(int x, int y) {  // of monomials x^i y^j z^(4−i−j)
  std::size_t s = 0;
  for (int i = 0; i < x; ++i) s += static_cast<std::size_t>(5 - i);
  return s + static_cast<std::size_t>(y);
}

void add_moments(Result& r, const char* name, const DirectionMoments& m, int dimension) {
  if (m.weight() > 0) add_tensor(r, name, "1", m.second(), dimension);
}

Table fourth_table(const DirectionMoments& m, int dimension) {
  Table t = table_of("fourth_order", "Mean of products of four components of the contact normals",
                     {{"x_times", "1"}, {"y_times", "1"}, {"z_times", "1"}, {"mean", "1"}});
  for (int x = 4; x >= 0; --x)
    for (int y = 4 - x; y >= 0; --y) {
      const int z = 4 - x - y;
      if (dimension == 2 && z > 0) continue;
      std::array<int, 4> axis{};
      for (int k = 0; k < 4; ++k) axis[static_cast<std::size_t>(k)] = k < x ? 0 : (k < x + y ? 1 : 2);
      add_row(t, x, y, z, m.fourth(axis[0], axis[1], axis[2], axis[3]));
    }
  return t;
}

}  // namespace

void DirectionMoments::add(const Vec3d& d, double weight) {
  weight_ += weight;
  add_to(second_, outer(d, d), weight);
  const std::array<double, 5> x{1, d.x, d.x * d.x, d.x * d.x * d.x, d.x * d.x * d.x * d.x},
      y{1, d.y, d.y * d.y, d.y * d.y * d.y, d.y * d.y * d.y * d.y},
      z{1, d.z, d.z * d.z, d.z * d.z * d.z, d.z * d.z * d.z * d.z};
  std::size_t s = 0;
  for (std::size_t i = 0; i < 5; ++i)
    for (std::size_t j = 0; i + j < 5; ++j) fourth_[s++] += weight * x[i] * y[j] * z[4 - i - j];
}

Mat3d DirectionMoments::second() const {
  Mat3d m{};
  if (weight_ > 0) add_to(m, second_, 1 / weight_);
  return m;
}

double DirectionMoments::fourth(int i, int j, int k, int l) const {
  std::array<int, 3> n{};
  for (const int axis : {i, j, k, l}) ++n[static_cast<std::size_t>(axis)];
  return weight_ > 0 ? fourth_[slot(n[0], n[1])] / weight_ : 0;
}

Fabric fabric_of(const Snapshot& s, const Pairs& pairs, const Domain& region) {
  Fabric f;
  f.contacts = pairs.bodies.size();
  for (const Pair& p : pairs.bodies) {
    f.normals.add(p.normal);
    const double length = norm(p.branch);
    f.mean_branch += length / static_cast<double>(f.contacts);
    if (length > 0) f.branches.add(p.branch * (1 / length));
    if (p.pressing > 0) f.forces.add(p.normal, p.pressing);
  }
  double radius = 0;
  for (const double r : s.radius) radius += r / static_cast<double>(s.count());
  const double volume = Grid(s, region, {1, 1, 1}).box_volume();
  if (volume > 0) f.factor = 2 * static_cast<double>(f.contacts) * radius / volume;  // (9.47)
  return f;
}

Mat3d second_order_fit(const Mat3d& second, int dimension) {
  Mat3d d{};
  for (int i = 0; i < dimension; ++i)
    for (int j = 0; j < dimension; ++j)
      d.row[i][j] = (dimension == 3 ? 7.5 : 4.0) * (second.row[i][j] - (i == j ? 1.0 / dimension : 0));
  return d;
}

Result report_fabric(const Snapshot& s, const Settings& settings) {
  Result r;
  if (lacks_contacts(s, r)) return r;
  const Domain region = region_of(s, settings);
  const Fabric f = fabric_of(s, within(pairs_of(s), s, settings.region), region);
  r.add("contacts", "1", static_cast<double>(f.contacts));
  if (f.contacts == 0) {
    r.notes.emplace_back("no contacts between bodies");
    return r;
  }
  add_moments(r, "fabric", f.normals, s.dimension);
  add_moments(r, "branch", f.branches, s.dimension);
  r.add("mean_branch", "m", f.mean_branch);
  if (s.has_forces && f.forces.weight() > 0)
    add_moments(r, "force_fabric", f.forces, s.dimension);
  else
    r.notes.emplace_back("no contact presses: no fabric weighted by force");
  if (f.factor > 0) {
    Mat3d scaled{};
    add_to(scaled, f.normals.second(), f.factor);
    add_tensor(r, "fabric_density", "1/m^2", scaled, s.dimension);
    r.notes.emplace_back("fabric_density: F of (9.47), with the volume of the region; of unit 1/m^2");
  }
  add_tensor(r, "fit", "1", second_order_fit(f.normals.second(), s.dimension), s.dimension);
  const Principal axes = principal_of(f.normals.second(), s.dimension);
  r.tables.push_back(axes_table("axes", "Principal values and axes of the contact normals", "1", axes, s.dimension));
  r.tables.push_back(fourth_table(f.normals, s.dimension));
  return r;
}

}  // namespace dem::analysis
