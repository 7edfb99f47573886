// Mass of a union: parts that overlap are taken together, by the most exact way that their kinds allow.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "shapes/cells.h"
#include "shapes/compound_parts.h"
#include "shapes/geometry.h"

namespace shapes::compound {
namespace {

using Kind = Compound::PartKind;

// Back from the inertia about the centre of mass to ∫x xᵀ about the origin.
Moments moments_of(const MassProperties& m) {
  const Mat3d& i = m.inertia;
  const Vec3d& c = m.centre;
  const double half_trace = 0.5 * (i.row[0].x + i.row[1].y + i.row[2].z);
  Moments out;
  out.zeroth = m.volume;
  out.first = m.volume * c;
  out.diagonal = Vec3d{half_trace - i.row[0].x, half_trace - i.row[1].y, half_trace - i.row[2].z} +
                 m.volume * Vec3d{c.x * c.x, c.y * c.y, c.z * c.z};
  out.mixed = Vec3d{-i.row[1].z, -i.row[0].z, -i.row[0].y} + m.volume * Vec3d{c.y * c.z, c.z * c.x, c.x * c.y};
  return out;
}

Moments moments_of(const Part& part) {
  if (part.kind == Kind::polyhedron) return moments_of(part.solid.mass);
  MassProperties m = mass_properties(Ellipsoid{part.size});
  if (part.kind == Kind::ellipsoid) {
    const Mat3d turned = part.rotation * m.inertia * transposed(part.rotation);
    m.inertia = turned;
  }
  m.centre = part.centre;
  return moments_of(m);
}

// Groups of parts that hang together by overlaps; the parts of different groups do not overlap.
std::vector<std::vector<const Part*>> overlapping_groups(const std::vector<Part>& parts) {
  std::vector<std::size_t> root(parts.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i];
    return i;
  };
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (!surely_apart(parts[j], parts[i])) {
        const std::size_t a = find(i), b = find(j);
        root[std::max(a, b)] = std::min(a, b);
      }
  std::vector<std::vector<const Part*>> groups(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) groups[find(i)].push_back(&parts[i]);
  std::erase_if(groups, [](const auto& g) { return g.empty(); });
  return groups;
}

}  // namespace

double highest(const Part& part, const Vec3d& n) {
  if (part.kind == Kind::polyhedron) return dot(n, support(part.solid, n));
  if (part.kind == Kind::sphere) return dot(n, part.centre) + part.size.x;
  return dot(n, part.centre) + norm(scaled(part.size, transposed_times(part.rotation, n)));
}

bool surely_apart(const Part& a, const Part& b) {
  const auto middle = [](const Part& p) { return p.kind == Kind::polyhedron ? p.solid.mass.centre : p.centre; };
  const Vec3d d = middle(b) - middle(a);
  if (!(max_abs(d) > 0)) return false;
  const auto separates = [&](const Vec3d& n) { return highest(a, n) <= lowest(b, n) + 64 * 0x1p-52; };
  if (separates(normalized(d))) return true;
  if (a.kind == Kind::sphere && b.kind == Kind::sphere) return false;
  for (const auto& f : a.solid.faces)
    if (separates(f.normal)) return true;
  for (const auto& f : b.solid.faces)
    if (separates(-f.normal)) return true;
  if (a.kind != Kind::polyhedron || b.kind != Kind::polyhedron) return false;
  return !(convex::volume_of(convex::intersection(convex::cell_of(a.solid), b.solid)) > 0);
}

void Moments::add(const Moments& m) {
  zeroth += m.zeroth;
  first += m.first;
  diagonal += m.diagonal;
  mixed += m.mixed;
  error += m.error;
}

Moments moments_of_union(const std::vector<Part>& parts) {
  Moments total;
  for (const auto& group : overlapping_groups(parts)) {
    const auto all = [&](Kind k) {
      return std::all_of(group.begin(), group.end(), [k](auto* p) { return p->kind == k; });
    };
    if (group.size() == 1) {
      total.add(moments_of(*group[0]));
    } else if (all(Kind::polyhedron)) {
      std::vector<const Polyhedron*> solids;
      for (const Part* p : group) solids.push_back(&p->solid);
      for (const convex::Cell& cell : convex::disjoint_cells(solids)) total.add(moments_of(convex::mass_of(cell)));
    } else {
      total.add(all(Kind::sphere) ? moments_of_balls(group) : moments_by_lines(group));
    }
  }
  return total;
}

MassProperties mass_of(const Moments& m) {
  const double v = m.zeroth;
  MassProperties out;
  out.volume = v;
  out.centre = {m.first.x / v, m.first.y / v, m.first.z / v};
  const Vec3d& c = out.centre;
  const Vec3d d = m.diagonal - v * Vec3d{c.x * c.x, c.y * c.y, c.z * c.z};
  Vec3d o = m.mixed - v * Vec3d{c.y * c.z, c.z * c.x, c.x * c.y};
  // Below the error of the quadrature an axis is a principal axis.
  for (int k = 0; k < 3; ++k)
    if (std::fabs(o[k]) <= 8 * m.error) o[k] = 0;
  out.inertia = {{{d.y + d.z, -o.z, -o.y}, {-o.z, d.z + d.x, -o.x}, {-o.y, -o.x, d.x + d.y}}};
  return out;
}

}  // namespace shapes::compound
