#include "libdem/analysis/foreign.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libdem/broad_phase/cells.h"
#include "libdem/build.h"

namespace dem::analysis {
namespace {

Cell cell_of(const Snapshot& s) {
  Cell cell;
  cell.lower = s.lower;
  for (int k = 0; k < 3; ++k) {
    if (!s.periodic[static_cast<std::size_t>(k)]) continue;
    cell.periodic = true;
    cell.lattice.length[k] = s.length[k];
    cell.lattice.inverse[k] = 1 / s.length[k];
  }
  return cell;
}

}  // namespace

void find_sphere_contacts(Snapshot& s, double gap) {
  double largest = 0;
  std::vector<std::uint32_t> round;
  for (std::uint32_t i = 0; i < s.count(); ++i) {
    if (!is_round(s.shape_of(i).kind)) continue;
    largest = std::max(largest, s.radius[i]);
    round.push_back(i);
  }
  if (!(largest > 0)) return;
  const double wider = (1 + gap) * (1 + 0x1p-20);  // those that just touch are not to be missed by rounding
  const Cells cells(
      round, [&](std::uint32_t i) -> const Vec3d& { return s.position[i]; }, 2 * largest * wider, cell_of(s));
  std::vector<std::uint32_t> partners;
  for (const std::uint32_t i : round) {
    partners.clear();
    cells.near(s.position[i], (s.radius[i] + largest) * wider, [&](std::uint32_t first, std::uint32_t last) {
      for (std::uint32_t k = first; k < last; ++k) {
        const std::uint32_t j = cells.order()[k];
        const double sum = s.radius[i] + s.radius[j];
        if (j > i && norm(s.between(s.position[i], s.position[j])) <= sum * (1 + gap)) partners.push_back(j);  // (1)
      }
    });
    std::sort(partners.begin(), partners.end());
    for (const std::uint32_t j : partners) {
      SnapshotContact c;
      c.a = i;
      c.b = j;
      c.branch = s.between(s.position[i], s.position[j]);
      const double distance = norm(c.branch);
      if (!(distance > 0)) continue;  // one in the other's centre: no normal
      c.normal = c.branch * (1 / distance);
      c.overlap = s.radius[i] + s.radius[j] - distance;
      c.point = s.position[i] + c.normal * (s.radius[i] - 0.5 * c.overlap);
      s.contacts.push_back(c);
    }
  }
}

void ForeignBodies::add(ForeignBody body) { bodies_.push_back(std::move(body)); }

std::uint32_t ForeignBodies::shape_of(const Vec3d& a, Snapshot& s) {
  const std::tuple proportions{a.y / a.x, a.z / a.x, 1.0};
  const auto [at, fresh] = shapes_.try_emplace(proportions, static_cast<std::uint32_t>(s.shapes.size()));
  if (fresh) {
    ShapeEntry e;
    if (a.x == a.y && a.y == a.z) {
      make_sphere(1, e);
      e.name = "sphere";
    } else {
      make_ellipsoid({1, a.y / a.x, a.z / a.x}, e);
      e.name = fmt::format("ellipsoid 1 : {:.6g} : {:.6g}", a.y / a.x, a.z / a.x);
    }
    e.family = e.name;
    e.overlap_radius = e.inscribed_radius;
    s.shapes.push_back(std::move(e));
  }
  return at->second;
}

void ForeignBodies::finish(const std::string& source, const ForeignOptions& options, Snapshot& s) {
  std::stable_sort(bodies_.begin(), bodies_.end(),
                   [](const ForeignBody& a, const ForeignBody& b) { return a.id < b.id; });
  for (const ForeignBody& b : bodies_) species_.try_emplace(b.species, 0);
  for (auto& [name, place] : species_) {  // in order of names: the same in every frame that has the same
    place = static_cast<std::uint32_t>(s.materials.size());
    s.materials.push_back(name);
    s.species_names.push_back(name);
  }
  bool unknown = false;
  for (const ForeignBody& b : bodies_) {
    if (!s.id.empty() && b.id == s.id.back()) throw InputError(fmt::format("{}: the id {} stands twice", source, b.id));
    const std::uint32_t shape = shape_of(b.semi_axes, s);
    const double scale = b.semi_axes.x;
    s.id.push_back(b.id);
    s.shape.push_back(shape);
    s.material.push_back(species_[b.species]);
    s.species.push_back(species_[b.species] + 1);
    s.size.push_back(b.semi_axes);
    Vec3d x = b.position;
    for (int k = 0; k < 3; ++k)
      if (s.periodic[static_cast<std::size_t>(k)]) x[k] -= s.length[k] * std::floor((x[k] - s.lower[k]) / s.length[k]);
    s.position.push_back(x);
    s.velocity.push_back(b.velocity);
    s.spin.push_back(b.spin);
    s.rotation.push_back({});
    s.orientation.push_back(b.orientation);
    s.volume.push_back(s.shapes[shape].volume * (scale * scale * scale));
    s.radius.push_back(s.shapes[shape].equivalent_radius * scale);
    s.bounding_radius.push_back(s.shapes[shape].circumradius * scale);
    unknown = unknown || b.mass == 0;
    s.mass.push_back(b.mass > 0 ? b.mass : s.volume.back() * (options.density > 0 ? options.density : 1));
  }
  s.has_rotation = s.has_forces = false;
  s.has_mass = !unknown || options.density > 0;
  if (unknown)
    s.notes.push_back(options.density > 0 ? fmt::format("masses: of the density {} kg/m^3 given", options.density)
                                          : "no masses in the source and no density given: nothing that needs them");
  find_sphere_contacts(s, options.contact_gap);
  const bool round = std::all_of(s.shape.begin(), s.shape.end(), [&](auto k) { return is_round(s.shapes[k].kind); });
  s.has_contacts = round;
  if (!round) s.contacts.clear();
  s.notes.emplace_back(round ? "contacts: found from the places and radii of the spheres, without walls and forces"
                             : "no contacts: the source has none, and they are found between spheres alone");
}

}  // namespace dem::analysis
