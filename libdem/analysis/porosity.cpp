#include "libdem/analysis/porosity.h"

#include <cmath>

#include "libdem/analysis/table.h"
#include "libdem/analysis/wall_planes.h"

namespace dem::analysis {

namespace {

using shapes::HalfSpace;

std::vector<HalfSpace> faces_of(const Domain& region, int dimension) {
  std::vector<HalfSpace> planes;
  for (int k = 0; k < dimension; ++k)
    for (const double side : {-1.0, 1.0}) {
      Vec3d n{};
      n[k] = side;
      planes.push_back({n, side * (side < 0 ? region.lower[k] : region.upper[k])});
    }
  return planes;
}

double depth_of(const Vec3d& x, std::span<const HalfSpace> planes) {
  double depth = std::numeric_limits<double>::infinity();
  for (const HalfSpace& h : planes) depth = std::min(depth, h.offset - dot(h.normal, x));
  return depth;
}

// Volume of the region at least `depth` from the planes.
double space_beyond(const Snapshot& s, const Domain& region, std::span<const HalfSpace> planes, double depth) {
  Domain box = region;
  if (s.dimension == 2) box.lower.z = 0, box.upper.z = s.thickness;
  CutSolid solid = CutSolid::box(box.lower, box.upper);
  for (const HalfSpace& h : planes) solid.cut(h.normal, h.offset - depth);
  return solid.volume();
}

// Adds what lies of body i, and of its images, in every slab: differences of what lies beyond their two sides.
void add_body(const Snapshot& s, const BoxShares& shares, const Grid& whole, std::span<const HalfSpace> planes,
              double width, std::size_t i, std::vector<double>& slab) {
  const std::size_t slabs = slab.size();
  std::vector<HalfSpace> cutting = faces_of(whole.region(), s.dimension);
  const std::size_t faces = cutting.size();
  cutting.insert(cutting.end(), planes.begin(), planes.end());
  const Grid::Box box = shares.bounds(i);
  whole.each_touched(box.lower, box.upper, [&](std::size_t, const Vec3d& shift) {
    const double middle = depth_of(s.position[i] + shift, planes), reach = s.bounding_radius[i];
    const double first = std::floor((middle - reach) / width), last = std::ceil((middle + reach) / width);
    if (last <= 0 || first >= static_cast<double>(slabs)) return;
    const auto beyond = [&](double k) {
      for (std::size_t p = 0; p < planes.size(); ++p) cutting[faces + p].offset = planes[p].offset - k * width;
      return shares.in_half_spaces(i, shift, cutting);
    };
    double at = std::max(0.0, first), before = beyond(at);
    for (; at < std::min(last, static_cast<double>(slabs)); ++at) {
      const double after = beyond(at + 1);
      slab[static_cast<std::size_t>(at)] += before - after;
      before = after;
    }
  });
}

Table table_of(const std::string& name, const std::string& title, const std::string& variable, double start,
               const PorosityProfile& p) {
  Table t{name, title, {{variable, "m", {}}, {"from", "m", {}}, {"to", "m", {}}, {"porosity", "1", {}}}};
  for (std::size_t k = 0; k < p.porosity.size(); ++k) {
    if (!(p.volume[k] > 0)) continue;
    const double from = start + p.width * static_cast<double>(k);
    t.columns[0].values.push_back(from + 0.5 * p.width);
    t.columns[1].values.push_back(from);
    t.columns[2].values.push_back(from + p.width);
    t.columns[3].values.push_back(p.porosity[k]);
  }
  return t;
}

}  // namespace

PorosityProfile porosity_from(const Snapshot& s, const BoxShares& shares, const Domain& region,
                              std::span<const HalfSpace> planes, double width, std::size_t slabs) {
  PorosityProfile p;
  p.width = width;
  const Grid whole(s, region, {1, 1, 1});
  constexpr std::size_t chunk = 1024;
  const std::size_t chunks = (s.count() + chunk - 1) / chunk;
  std::vector<std::vector<double>> part(chunks);
#pragma omp parallel for schedule(dynamic)
  for (std::size_t c = 0; c < chunks; ++c) {
    part[c].assign(slabs, 0.0);
    for (std::size_t i = c * chunk; i < std::min(s.count(), (c + 1) * chunk); ++i)
      add_body(s, shares, whole, planes, width, i, part[c]);
  }
  double before = space_beyond(s, region, planes, 0);
  const double all = before;
  for (std::size_t k = 0; k < slabs; ++k) {
    double solid = 0;
    for (const auto& one : part) solid += one[k];
    const double after = space_beyond(s, region, planes, width * static_cast<double>(k + 1)), space = before - after;
    before = after;
    const bool there = space > 1e-13 * all;
    p.volume.push_back(there ? space : 0);
    p.porosity.push_back(there ? 1 - solid / space : 1);
  }
  return p;
}

Result report_porosity(const Snapshot& s, const Settings& settings) {
  Result r;
  if (s.count() == 0) {
    r.notes.emplace_back("no bodies");
    return r;
  }
  const Domain region = region_of(s, settings);
  const double space = Grid(s, region, {1, 1, 1}).box_volume(), diameter = mean_diameter(s);
  if (!(space > 0)) {
    r.notes.emplace_back("the region has no volume");
    return r;
  }
  const BoxShares shares(s);
  r.notes = shares.notes();
  double solid = 0;
  for (int axis = 0; axis < s.dimension; ++axis) {
    Vec3d n{};
    n[axis] = -1;
    const double length = region.upper[axis] - region.lower[axis];
    const double slabs = std::clamp(std::round(10 * length / diameter), 1.0, 2000.0);
    const PorosityProfile p = porosity_from(s, shares, region, std::vector<HalfSpace>{{n, -region.lower[axis]}},
                                            length / slabs, static_cast<std::size_t>(slabs));
    const std::string name(1, "xyz"[axis]);
    r.tables.push_back(table_of(name, "Porosity along " + name, name, region.lower[axis], p));
    if (axis == 0)
      for (std::size_t k = 0; k < p.volume.size(); ++k) solid += (1 - p.porosity[k]) * p.volume[k];
  }
  for (const SnapshotWall& wall : s.walls) {
    if (!wall.present) continue;
    const std::vector<HalfSpace> planes = side_of(planes_of(wall, s));
    if (planes.empty()) {
      r.notes.push_back("no profile from wall \"" + wall.name + "\": bodies lie on both sides of its planes");
      continue;
    }
    double deepest = 0;
    for (std::size_t i = 0; i < s.count(); ++i)
      deepest = std::max(deepest, depth_of(s.position[i], planes) + s.bounding_radius[i]);
    const double slabs = std::clamp(std::ceil(10 * deepest / diameter), 1.0, 100.0);  // up to ten diameters
    const PorosityProfile p = porosity_from(s, shares, region, planes, diameter / 10, static_cast<std::size_t>(slabs));
    r.tables.push_back(table_of("wall_" + file_word(wall.name), "Porosity over the distance from wall " + wall.name,
                                "distance", 0, p));
  }
  r.add("porosity", "1", 1 - solid / space);
  return r;
}

}  // namespace dem::analysis
