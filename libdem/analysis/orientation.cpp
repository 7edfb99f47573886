#include "libdem/analysis/orientation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libdem/analysis/grid.h"
#include "libdem/analysis/table.h"

namespace dem::analysis {

namespace {

using shapes::Kind;

constexpr double alike = 1e-6;  // relative difference of extents or moments below which they are equal
bool same(double a, double b) { return std::abs(a - b) <= alike * std::max(std::abs(a), std::abs(b)); }

// Along the largest of three numbers, across the smallest where the other two are equal; nothing where all are.
std::optional<Vec3d> distinct(const Vec3d& extent) {
  int order[] = {0, 1, 2};
  std::stable_sort(order, order + 3, [&](int i, int j) { return extent[i] > extent[j]; });
  const double large = extent[order[0]], middle = extent[order[1]], small = extent[order[2]];
  Vec3d axis{};
  if (!same(large, middle))
    axis[order[0]] = 1;
  else if (!same(middle, small))
    axis[order[2]] = 1;
  else
    return std::nullopt;
  return axis;
}

// Principal axis of the larger second moment of a polygon's area about its centroid.
std::optional<Vec3d> long_axis(const shapes::Polygon& p) {
  Mat3d m{};
  for (std::uint32_t i = 0; i < p.vertices.size(); ++i) {
    const Vec3d a = p.vertices[i] - p.centroid, b = p.vertices[p.next(i)] - p.centroid;
    const double twice = a.x * b.y - a.y * b.x;  // ∫ x xᵀ over the triangle from the centroid: twice/24 (…)
    add_to(m, outer(a + b, a + b), twice / 24);
    add_to(m, outer(a, a), twice / 24);
    add_to(m, outer(b, b), twice / 24);
  }
  const Principal axes = principal_of(m, 2);
  if (same(axes.value[0], axes.value[1])) return std::nullopt;
  return axes.axis[0];
}

std::optional<Vec3d> axis_of_shape(const ShapeEntry& e, const Vec3d& size, int dimension) {
  switch (e.kind) {
    case Kind::sphere:
    case Kind::disc:
      return std::nullopt;
    case Kind::ellipsoid:
      return distinct(size);
    case Kind::ellipse:
      if (same(size.x, size.y)) return std::nullopt;
      return size.x > size.y ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    case Kind::polygon:
      return e.polygon ? long_axis(*e.polygon) : std::nullopt;
    default:
      if (dimension == 2) return std::nullopt;
      return distinct(-e.inertia);  // least inertia: longest
  }
}

double p2(const Vec3d& u, const Vec3d& n, int dimension) {
  const double c = dot(u, n);
  return dimension == 3 ? 1.5 * c * c - 0.5 : 2 * c * c - 1;
}

void add_walls(Result& r, const Snapshot& s) {
  double radius = 0;
  for (const double x : s.radius) radius += x / static_cast<double>(s.count());
  for (const SnapshotWall& wall : s.walls) {
    if (!wall.present) continue;
    if (!is_half_space(wall.kind)) {
      r.notes.push_back(fmt::format("wall {}: alignment along meshes and polygons is not measured", wall.name));
      continue;
    }
    Table t =
        table_of("wall_" + file_word(wall.name), "Mean P2 of body axis and normal of " + wall.name + " by distance",
                 {{"distance", "m"}, {"bodies", "1"}, {"p2", "1"}});
    for (const WallAlignment& a : wall_alignment(s, wall, radius, 10 * radius)) add_row(t, a.distance, a.bodies, a.p2);
    r.tables.push_back(std::move(t));
  }
}

}  // namespace

std::optional<Vec3d> body_axis(const Snapshot& s, std::size_t i) {
  const std::optional<Vec3d> axis = axis_of_shape(s.shape_of(i), s.size[i], s.dimension);
  if (!axis) return std::nullopt;
  return rotate(s.orientation[i], *axis);
}

NematicOrder nematic_order(const std::vector<Vec3d>& axes, int dimension) {
  NematicOrder order;
  order.bodies = axes.size();
  if (axes.empty()) return order;
  Mat3d mean{};
  for (const Vec3d& u : axes) add_to(mean, outer(u, u), 1 / static_cast<double>(axes.size()));
  for (int i = 0; i < dimension; ++i)
    for (int j = 0; j < dimension; ++j)
      order.tensor.row[i][j] = (dimension * mean.row[i][j] - (i == j ? 1 : 0)) / (dimension - 1);  // (1)
  order.principal = principal_of(order.tensor, dimension);
  return order;
}

std::vector<WallAlignment> wall_alignment(const Snapshot& s, const SnapshotWall& wall, double width, double range) {
  const Vec3d n = wall.normal();
  const auto bins = static_cast<std::size_t>(std::max(std::ceil(range / width - 1e-9), 0.0));
  std::vector<WallAlignment> list(bins);
  for (std::size_t i = 0; i < s.count(); ++i) {
    const double distance = dot(n, s.position[i] - wall.position);
    if (!(distance >= 0 && distance < range)) continue;
    const std::optional<Vec3d> u = body_axis(s, i);
    if (!u) continue;
    WallAlignment& bin = list[std::min(static_cast<std::size_t>(distance / width), bins - 1)];
    bin.bodies += 1;
    bin.p2 += p2(*u, n, s.dimension);
  }
  for (std::size_t k = 0; k < bins; ++k) {
    list[k].distance = (static_cast<double>(k) + 0.5) * width;
    if (list[k].bodies > 0) list[k].p2 /= list[k].bodies;
  }
  std::erase_if(list, [](const WallAlignment& a) { return a.bodies <= 0; });
  return list;
}

Result report_orientation(const Snapshot& s, const Settings& settings) {
  Result r;
  if (s.count() == 0) {
    r.notes.emplace_back("no bodies");
    return r;
  }
  const Grid whole(s, region_of(s, settings), {1, 1, 1});
  std::vector<Vec3d> axes;
  Table bodies = table_of("bodies", "Axis of each body that has one, without a sense",
                          {{"id", "1"}, {"axis_x", "1"}, {"axis_y", "1"}, {"axis_z", "1"}});
  for (std::size_t i = 0; i < s.count(); ++i) {
    const std::optional<Vec3d> u = body_axis(s, i);
    if (!u || (settings.region && whole.index(s.position[i]) == Grid::none)) continue;
    axes.push_back(*u);
    add_row(bodies, s.id[i], u->x, u->y, u->z);
  }
  r.add("bodies_with_axis", "1", static_cast<double>(axes.size()));
  if (axes.empty()) {
    r.notes.emplace_back("no body has a longest or shortest axis");
    return r;
  }
  const NematicOrder order = nematic_order(axes, s.dimension);
  add_tensor(r, "order", "1", order.tensor, s.dimension);
  const Vec3d& director = order.principal.axis[0];
  for (int k = 0; k < s.dimension; ++k) r.add(std::string("director_") + "xyz"[k], "1", director[k]);
  if (norm(s.gravity) > 0) {
    const Vec3d down = s.gravity * (1 / norm(s.gravity));
    double mean = 0;
    for (const Vec3d& u : axes) mean += p2(u, down, s.dimension) / static_cast<double>(axes.size());
    r.add("order_along_gravity", "1", mean);
  }
  r.notes.push_back(fmt::format("order_1 is the nematic order S; of isotropic bodies it would be about {:.2g}",
                                1 / std::sqrt(static_cast<double>(axes.size()))));
  r.tables.push_back(
      axes_table("axes", "Principal values and axes of the order tensor", "1", order.principal, s.dimension));
  r.tables.push_back(std::move(bodies));
  add_walls(r, s);
  return r;
}

}  // namespace dem::analysis
