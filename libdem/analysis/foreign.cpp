#include "libdem/analysis/foreign.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libdem/build.h"

namespace dem::analysis {
namespace {

// Bodies by cells at least as wide as the largest pair's reach; along periodic axes the cells go round.
class Cells {
 public:
  Cells(const Snapshot& s, double reach) : s_(s) {
    Vec3d upper{};
    for (int k = 0; k < 3; ++k) {
      const bool wraps = periodic(k);
      lower_[k] = wraps ? s.lower[k] : s.position[0][k];
      upper[k] = wraps ? s.lower[k] + s.length[k] : s.position[0][k];
    }
    for (const Vec3d& x : s.position)
      for (int k = 0; k < 3; ++k)
        if (!periodic(k)) {
          lower_[k] = std::min(lower_[k], x[k]);
          upper[k] = std::max(upper[k], x[k]);
        }
    const double most = std::cbrt(4.0 * static_cast<double>(s.count())) + 1;  // along an axis
    for (int k = 0; k < 3; ++k) {
      const double width = upper[k] - lower_[k];
      count_[k] = static_cast<long>(std::clamp(std::floor(width / reach), 1.0, std::max(most, 1.0)));
      inverse_[k] = width > 0 ? static_cast<double>(count_[k]) / width : 0;
    }
    start_.resize(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]) + 1);
    std::vector<std::size_t> cell;
    for (const Vec3d& x : s.position) {
      cell.push_back(place(along(x, 0), along(x, 1), along(x, 2)));
      ++start_[cell.back() + 1];
    }
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    bodies_.resize(s.count());
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    for (std::uint32_t i = 0; i < s.count(); ++i) bodies_[next[cell[i]]++] = i;
  }

  // visit(j) for every body in the cells at and around that of x, each once.
  template <class Visit>
  void around(const Vec3d& x, Visit visit) const {
    long near[3][3];
    int many[3];
    for (int k = 0; k < 3; ++k) many[k] = neighbours(k, along(x, k), near[k]);
    for (int c = 0; c < many[2]; ++c)
      for (int b = 0; b < many[1]; ++b)
        for (int a = 0; a < many[0]; ++a) {
          const std::size_t cell = place(near[0][a], near[1][b], near[2][c]);
          for (std::size_t n = start_[cell]; n < start_[cell + 1]; ++n) visit(bodies_[n]);
        }
  }

 private:
  bool periodic(int k) const { return s_.periodic[static_cast<std::size_t>(k)]; }
  long along(const Vec3d& x, int k) const {
    return std::clamp(static_cast<long>(std::floor((x[k] - lower_[k]) * inverse_[k])), 0L, count_[k] - 1);
  }
  std::size_t place(long i, long j, long k) const {
    return static_cast<std::size_t>(i + count_[0] * (j + count_[1] * k));
  }
  int neighbours(int k, long at, long (&list)[3]) const {
    int n = 0;
    for (long d = -1; d <= 1; ++d) {
      long i = at + d;
      if (periodic(k)) i = (i + count_[k]) % count_[k];
      if (i < 0 || i >= count_[k] || std::find(list, list + n, i) != list + n) continue;
      list[n++] = i;
    }
    return n;
  }

  const Snapshot& s_;
  Vec3d lower_{}, inverse_{};
  long count_[3]{};
  std::vector<std::size_t> start_;
  std::vector<std::uint32_t> bodies_;
};

}  // namespace

void find_sphere_contacts(Snapshot& s, double gap) {
  double largest = 0;
  for (std::size_t i = 0; i < s.count(); ++i)
    if (is_round(s.shape_of(i).kind)) largest = std::max(largest, s.radius[i]);
  if (!(largest > 0)) return;
  const Cells cells(s, 2 * largest * (1 + gap));
  std::vector<std::uint32_t> partners;
  for (std::uint32_t i = 0; i < s.count(); ++i) {
    if (!is_round(s.shape_of(i).kind)) continue;
    partners.clear();
    cells.around(s.position[i], [&](std::uint32_t j) {
      if (j <= i || !is_round(s.shape_of(j).kind)) return;
      const double sum = s.radius[i] + s.radius[j];
      if (norm(s.between(s.position[i], s.position[j])) <= sum * (1 + gap)) partners.push_back(j);  // (1)
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
