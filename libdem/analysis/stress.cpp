#include "libdem/analysis/stress.h"

#include <algorithm>
#include <cmath>

#include "libdem/analysis/tensor.h"

namespace dem::analysis {
namespace {

class Boxes {
 public:
  Boxes(const Snapshot& snapshot, const Grid& grid, bool open) : s_(snapshot), grid_(grid), open_(open) {}

  std::size_t of_point(Vec3d x) const {
    if (open_)
      for (int k = 0; k < grid_.dimension(); ++k)
        if (!periodic(k)) x[k] = std::clamp(x[k], grid_.region().lower[k], grid_.region().upper[k]);
    return grid_.index(x);
  }

  // visit(box, share) for the pieces of the way d from x, by what boxes they lie in.
  template <class Visit>
  void along(const Vec3d& x, const Vec3d& d, Visit visit) {
    cuts_.assign({0.0, 1.0});
    for (int k = 0; k < grid_.dimension(); ++k) cut(k, x[k], d[k]);
    std::sort(cuts_.begin(), cuts_.end());
    for (std::size_t i = 0; i + 1 < cuts_.size(); ++i) {
      const double share = cuts_[i + 1] - cuts_[i];
      if (!(share > 0)) continue;
      const std::size_t box = of_point(x + d * (0.5 * (cuts_[i] + cuts_[i + 1])));
      if (box != Grid::none) visit(box, share);
    }
  }

 private:
  bool periodic(int k) const { return s_.periodic[static_cast<std::size_t>(k)]; }
  // Where the way crosses faces of the grid along an axis.
  void cut(int k, double x, double d) {
    if (d == 0) return;
    const double low = std::min(x, x + d), high = std::max(x, x + d);
    const double length = periodic(k) ? s_.length[k] : 0;
    const int first_image = length > 0 ? static_cast<int>(std::floor((low - grid_.region().upper[k]) / length)) : 0;
    const int last_image = length > 0 ? static_cast<int>(std::ceil((high - grid_.region().lower[k]) / length)) : 0;
    const bool inner_alone = open_ && !periodic(k);
    const int first = inner_alone ? 1 : 0, last = inner_alone ? grid_.count(k) - 1 : grid_.count(k);
    const double width = (grid_.region().upper[k] - grid_.region().lower[k]) / grid_.count(k);
    if (!(width > 0)) return;
    for (int image = first_image; image <= last_image; ++image) {
      const double shift = image * length, from = (low - shift - grid_.region().lower[k]) / width,
                   to = (high - shift - grid_.region().lower[k]) / width;
      const int begin = static_cast<int>(std::max<double>(first, std::floor(from))),
                end = static_cast<int>(std::min<double>(last, std::ceil(to)));
      for (int i = begin; i <= end; ++i) {
        const double t = (grid_.face(k, i) + shift - x) / d;
        if (t > 0 && t < 1) cuts_.push_back(t);
      }
    }
  }

  const Snapshot& s_;
  const Grid& grid_;
  bool open_;
  std::vector<double> cuts_;
};

void add_kinetic(const Snapshot& s, const Boxes& boxes, std::vector<Stress>& stress) {
  std::vector<std::size_t> box(s.count());
  std::vector<Vec3d> momentum(stress.size());
  for (std::size_t i = 0; i < s.count(); ++i) {
    box[i] = boxes.of_point(s.position[i]);
    if (box[i] == Grid::none) continue;
    ++stress[box[i]].bodies;
    stress[box[i]].mass += s.mass[i];
    momentum[box[i]] += s.velocity[i] * s.mass[i];
  }
  if (!s.has_velocity || !s.has_mass) return;
  for (std::size_t i = 0; i < s.count(); ++i) {
    if (box[i] == Grid::none) continue;
    Stress& t = stress[box[i]];
    const Vec3d v = s.velocity[i] - momentum[box[i]] * (1 / t.mass);
    add_to(t.kinetic, outer(v, v), s.mass[i]);
  }
}

Table box_table(const Snapshot& s, const Settings& settings) {
  const Grid grid = grid_of(s, settings);
  const std::vector<Stress> stress = stress_in_boxes(s, grid, !settings.region);
  Table t{"boxes", "stress per box, compression positive; x, y, z: its centre", {}};
  const auto column = [&](std::string name, const char* unit, auto value) {
    Column c{std::move(name), unit, {}};
    for (std::size_t b = 0; b < stress.size(); ++b) c.values.push_back(value(b));
    t.columns.push_back(std::move(c));
  };
  for (int k = 0; k < s.dimension; ++k)
    column(std::string(1, "xyz"[k]), "m", [&](std::size_t b) { return grid.centre(b)[k]; });
  column("bodies", "1", [&](std::size_t b) { return static_cast<double>(stress[b].bodies); });
  const auto component = [&](const char* name, int i, int j, auto part) {
    column(std::string(name) + "_" + "xyz"[i] + "xyz"[j], "Pa",
           [&](std::size_t b) { return part(stress[b].total()).row[i][j]; });
  };
  for (int i = 0; i < s.dimension; ++i) component("stress", i, i, symmetric_part);
  for (int i = 0; i < s.dimension; ++i)
    for (int j = i + 1; j < s.dimension; ++j) component("stress", i, j, symmetric_part);
  for (int i = 0; i < s.dimension; ++i)
    for (int j = i + 1; j < s.dimension; ++j) component("antisymmetric", i, j, antisymmetric_part);
  column("pressure", "Pa", [&](std::size_t b) { return trace(stress[b].total()) / s.dimension; });
  column("kinetic_pressure", "Pa", [&](std::size_t b) { return trace(stress[b].kinetic) / s.dimension; });
  column("deviator", "Pa", [&](std::size_t b) { return deviator(stress[b].total(), s.dimension); });
  return t;
}

}  // namespace

Mat3d Stress::total() const {
  Mat3d sum = contacts;
  add_to(sum, kinetic);
  return sum;
}

Mat3d symmetric_part(const Mat3d& m) {
  Mat3d p;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) p.row[i][j] = 0.5 * (m.row[i][j] + m.row[j][i]);
  return p;
}

Mat3d antisymmetric_part(const Mat3d& m) {
  Mat3d p;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) p.row[i][j] = 0.5 * (m.row[i][j] - m.row[j][i]);
  return p;
}

std::vector<Stress> stress_in_boxes(const Snapshot& s, const Grid& grid, bool open) {
  std::vector<Stress> stress(grid.size());
  Boxes boxes(s, grid, open);
  if (s.has_forces)
    for (const SnapshotContact& c : s.contacts) {
      const Mat3d moment = outer(c.force, c.branch);
      boxes.along(s.position[c.a], c.branch,
                  [&](std::size_t box, double share) { add_to(stress[box].contacts, moment, -share); });
    }
  add_kinetic(s, boxes, stress);
  for (Stress& t : stress)
    for (Mat3d* m : {&t.contacts, &t.kinetic})
      for (Vec3d& row : m->row) row *= 1 / grid.box_volume();
  return stress;
}

Stress stress_of(const Snapshot& s, const Settings& settings) {
  return stress_in_boxes(s, Grid(s, region_of(s, settings), {1, 1, 1}), !settings.region)[0];
}

Result report_stress(const Snapshot& s, const Settings& settings) {
  Result r;
  if (s.count() == 0 || !(region_of(s, settings).volume(s) > 0)) {
    r.notes.emplace_back("no bodies: no stress");
    return r;
  }
  if (!s.has_contacts || !s.has_forces)
    r.notes.emplace_back("no forces of contacts in the source: the kinetic part alone");
  if (!s.has_velocity || !s.has_mass) r.notes.emplace_back("no velocities or masses in the source: no kinetic part");
  if (s.has_forces && s.contacts.empty()) r.notes.emplace_back("no contacts: the kinetic part alone");
  const Stress stress = stress_of(s, settings);
  const Mat3d total = stress.total(), skew = antisymmetric_part(total);
  const double pressure = trace(total) / s.dimension;
  r.add("pressure", "Pa", pressure);
  r.add("kinetic_pressure", "Pa", trace(stress.kinetic) / s.dimension);
  add_tensor(r, "stress", "Pa", total, s.dimension);
  for (int i = 0; i < s.dimension; ++i)
    for (int j = i + 1; j < s.dimension; ++j)
      r.add(std::string("antisymmetric_") + "xyz"[i] + "xyz"[j], "Pa", skew.row[i][j]);
  if (pressure > 0)
    r.add("deviator_ratio", "1", deviator(total, s.dimension) / pressure);
  else
    r.notes.emplace_back("no pressure: no ratio of deviator and pressure");
  r.tables.push_back(axes_table("principal", "principal stresses, compression positive, and their axes", "Pa",
                                principal_of(total, s.dimension), s.dimension));
  r.tables.push_back(box_table(s, settings));
  return r;
}

}  // namespace dem::analysis
