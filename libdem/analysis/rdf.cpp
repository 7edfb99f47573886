#include "libdem/analysis/rdf.h"

#include <fmt/format.h>

#include <limits>
#include <numbers>

#include "libdem/analysis/round_in_box.h"
#include "libdem/scene/where.h"

namespace dem::analysis {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

// The cell's length where the region spans a periodic axis; 0: the region ends at its faces.
double wraps(const Snapshot& s, const Domain& region, int axis) {
  if (!s.periodic[static_cast<std::size_t>(axis)]) return 0;
  const double width = region.upper[axis] - region.lower[axis];
  return std::fabs(width - s.length[axis]) <= 1e-12 * s.length[axis] ? s.length[axis] : 0;
}

// The bodies of the region sorted into cells, each cell's one after the other.
struct Sorted {
  std::vector<Vec3d> position;  // in the region
  std::vector<std::uint32_t> group;
  std::vector<std::size_t> start;  // of a cell
  std::array<int, 3> cells{1, 1, 1};
};

Sorted sorted_into_cells(const Snapshot& s, const Domain& region, const std::vector<std::uint32_t>& group_of,
                         double cell) {
  Sorted out;
  for (int k = 0; k < s.dimension; ++k)
    out.cells[static_cast<std::size_t>(k)] =
        static_cast<int>(std::clamp((region.upper[k] - region.lower[k]) / cell, 1.0, 256.0));
  const Grid grid(s, region, out.cells);
  std::vector<std::size_t> at(s.count());
  out.start.assign(grid.size() + 1, 0);
  for (std::size_t i = 0; i < s.count(); ++i) {
    at[i] = grid.index(s.position[i]);
    if (at[i] != Grid::none) ++out.start[at[i] + 1];
  }
  for (std::size_t c = 0; c < grid.size(); ++c) out.start[c + 1] += out.start[c];
  out.position.resize(out.start.back());
  out.group.resize(out.start.back());
  std::vector<std::size_t> next = out.start;
  for (std::size_t i = 0; i < s.count(); ++i) {
    if (at[i] == Grid::none) continue;
    Vec3d x = s.position[i];
    for (int k = 0; k < s.dimension; ++k)
      if (s.periodic[static_cast<std::size_t>(k)])
        x[k] -= std::floor((x[k] - region.lower[k]) / s.length[k]) * s.length[k];
    const std::size_t place = next[at[i]]++;
    out.position[place] = x;
    out.group[place] = group_of[i];
  }
  return out;
}

class PairCounter {
 public:
  PairCounter(const Sorted& sorted, const Vec3d& wrap, double range, int bins, std::size_t groups)
      : s_(sorted), wrap_(wrap), range_(range), bins_(static_cast<std::size_t>(bins)), groups_(groups) {}

  // counts[(a·groups + b)·bins + bin], of ordered pairs. Whole numbers: the same on any number of threads.
  std::vector<std::uint64_t> all() const {
    std::vector<std::uint64_t> total(groups_ * groups_ * bins_);
    const auto cells = static_cast<std::ptrdiff_t>(s_.start.size() - 1);
#pragma omp parallel
    {
      std::vector<std::uint64_t> own(total.size());
#pragma omp for schedule(dynamic, 4)
      for (std::ptrdiff_t c = 0; c < cells; ++c) from_cell(static_cast<std::size_t>(c), own);
#pragma omp critical
      for (std::size_t k = 0; k < own.size(); ++k) total[k] += own[k];
    }
    return total;
  }

 private:
  static constexpr int reach = 2;  // cells are half a range wide

  void from_cell(std::size_t c, std::vector<std::uint64_t>& counts) const {
    if (s_.start[c] == s_.start[c + 1]) return;
    const auto nx = static_cast<std::size_t>(s_.cells[0]), ny = static_cast<std::size_t>(s_.cells[1]);
    const std::array<int, 3> at{static_cast<int>(c % nx), static_cast<int>(c / nx % ny), static_cast<int>(c / nx / ny)};
    std::array<std::vector<int>, 3> along;
    for (int k = 0; k < 3; ++k) {
      const auto axis = static_cast<std::size_t>(k);
      const int n = s_.cells[axis];
      if (wrap_[k] > 0 && n > 2 * reach) {
        for (int d = -reach; d <= reach; ++d) along[axis].push_back((at[axis] + d + n) % n);
      } else {
        const bool all = wrap_[k] > 0;
        for (int i = all ? 0 : std::max(0, at[axis] - reach); i < (all ? n : std::min(n, at[axis] + reach + 1)); ++i)
          along[axis].push_back(i);
      }
    }
    for (const int z : along[2])
      for (const int y : along[1])
        for (const int x : along[0]) {
          const std::size_t other =
              static_cast<std::size_t>(x) + nx * (static_cast<std::size_t>(y) + ny * static_cast<std::size_t>(z));
          if (other >= c) between(c, other, counts);
        }
  }

  void between(std::size_t c, std::size_t other, std::vector<std::uint64_t>& counts) const {
    const double square = range_ * range_, per_width = static_cast<double>(bins_) / range_;
    for (std::size_t i = s_.start[c]; i < s_.start[c + 1]; ++i)
      for (std::size_t j = other == c ? i + 1 : s_.start[other]; j < s_.start[other + 1]; ++j) {
        Vec3d d = s_.position[j] - s_.position[i];
        for (int k = 0; k < 3; ++k) {
          if (d[k] > 0.5 * wrap_[k]) d[k] -= wrap_[k];
          if (d[k] < -0.5 * wrap_[k]) d[k] += wrap_[k];
        }
        const double r2 = dot(d, d);
        if (!(r2 < square)) continue;
        const std::size_t bin = std::min(bins_ - 1, static_cast<std::size_t>(std::sqrt(r2) * per_width));
        const std::size_t a = s_.group[i], b = s_.group[j];
        ++counts[(a * groups_ + b) * bins_ + bin];
        ++counts[(b * groups_ + a) * bins_ + bin];
      }
  }

  const Sorted& s_;
  Vec3d wrap_;
  double range_;
  std::size_t bins_, groups_;
};

// Sum over the bodies of a group of the shells' parts in the region.
class ShellSums {
 public:
  ShellSums(int dimension, const Domain& region, const Vec3d& wrap, double width, std::size_t bins)
      : planar_(dimension == 2), width_(width), bins_(bins) {
    for (int k = 0; k < dimension; ++k) {
      lower_[k] = wrap[k] > 0 ? -infinity : region.lower[k];
      upper_[k] = wrap[k] > 0 ? infinity : region.upper[k];
    }
  }
  double whole(std::size_t edge) const {  // the ball (disc) of the radius of an edge of bins
    const double r = width_ * static_cast<double>(edge);
    return planar_ ? pi * r * r : 4 * pi / 3 * (r * r * r);
  }
  std::vector<double> of(const Sorted& s, std::uint32_t group) const {
    constexpr std::size_t chunk = 1024;
    const std::size_t chunks = (s.position.size() + chunk - 1) / chunk;
    std::vector<std::vector<double>> part(chunks);
#pragma omp parallel for schedule(dynamic)
    for (std::size_t c = 0; c < chunks; ++c) {
      part[c].assign(bins_, 0.0);
      for (std::size_t i = c * chunk; i < std::min(s.position.size(), (c + 1) * chunk); ++i)
        if (s.group[i] == group) add(s.position[i], part[c]);
    }
    std::vector<double> sum(bins_);
    for (const auto& p : part)
      for (std::size_t k = 0; k < bins_; ++k) sum[k] += p[k];
    return sum;
  }

 private:
  void add(const Vec3d& x, std::vector<double>& sum) const {
    double clear = infinity;
    for (int k = 0; k < (planar_ ? 2 : 3); ++k) clear = std::min({clear, x[k] - lower_[k], upper_[k] - x[k]});
    const double steps = std::floor(clear / width_);
    const std::size_t full =
        steps < static_cast<double>(bins_) ? static_cast<std::size_t>(std::max(0.0, steps)) : bins_;
    for (std::size_t k = 0; k < full; ++k) sum[k] += whole(k + 1) - whole(k);
    double inner = whole(full);
    for (std::size_t k = full; k < bins_; ++k) {
      const double r = width_ * static_cast<double>(k + 1);
      const double outer = planar_ ? disc_in_box(x, r, lower_, upper_) : ball_in_box(x, r, lower_, upper_);
      sum[k] += outer - inner;
      inner = outer;
    }
  }
  bool planar_;
  double width_;
  std::size_t bins_;
  Vec3d lower_{}, upper_{};
};

}  // namespace

double longest_range(const Snapshot& s, const Domain& region) {
  double range = infinity;
  for (int k = 0; k < s.dimension; ++k)
    if (wraps(s, region, k) > 0) range = std::min(range, 0.5 * s.length[k]);
  return range;
}

Rdf rdf_of(const Snapshot& s, const Groups& of, const Domain& region, double range, int bins) {
  range = std::min(range, longest_range(s, region));
  if (!(range > 0) || !std::isfinite(range) || bins < 1)
    throw InputError(fmt::format("radial distribution: range {} m and {} bins; allowed: a finite range > 0, bins >= 1",
                                 range, bins));
  Rdf rdf;
  rdf.width = range / bins;
  rdf.names = of.names;
  Vec3d wrap{};
  double space = 1;
  for (int k = 0; k < s.dimension; ++k) {
    wrap[k] = wraps(s, region, k);
    rdf.bounded = rdf.bounded || !(wrap[k] > 0);
    space *= region.upper[k] - region.lower[k];
  }
  // One group more: of none.
  const std::size_t groups = of.names.size() + 1, n = static_cast<std::size_t>(bins);
  std::vector<std::uint32_t> group_of(s.count());
  std::vector<std::size_t> size(groups);
  const Grid whole(s, region, {1, 1, 1});
  for (std::size_t i = 0; i < s.count(); ++i) {
    group_of[i] = std::min(of.of_body[i], static_cast<std::uint32_t>(groups - 1));
    if (whole.index(s.position[i]) == Grid::none) continue;
    ++size[group_of[i]];
    ++rdf.bodies;
  }
  if (rdf.bodies == 0) return rdf;

  const Sorted sorted = sorted_into_cells(s, region, group_of, 0.5 * range);
  const std::vector<std::uint64_t> counts = PairCounter(sorted, wrap, range, bins, groups).all();
  const ShellSums sums(s.dimension, region, wrap, rdf.width, n);
  std::vector<std::vector<double>> shells(groups);
  std::vector<double> all_shells(n), all_counts(n);
  for (std::size_t a = 0; a < groups; ++a) {
    shells[a] = sums.of(sorted, static_cast<std::uint32_t>(a));
    for (std::size_t k = 0; k < n; ++k) {
      all_shells[k] += shells[a][k];
      for (std::size_t b = 0; b < groups; ++b) all_counts[k] += static_cast<double>(counts[(a * groups + b) * n + k]);
    }
  }
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::size_t about, std::size_t among, const auto& count,
                       const auto& shell) {
    PairDistribution p{a, b, std::vector<double>(n), std::vector<double>(n)};
    const double density = static_cast<double>(among) / space;
    for (std::size_t k = 0; k < n; ++k) {
      p.count[k] = count(k) / static_cast<double>(about);
      p.g[k] = shell[k] > 0 ? count(k) / (density * shell[k]) : 0;  // (1)
    }
    rdf.pairs.push_back(std::move(p));
  };
  add(
      Groups::none, Groups::none, rdf.bodies, rdf.bodies, [&](std::size_t k) { return all_counts[k]; }, all_shells);
  std::vector<std::uint32_t> there;
  for (std::uint32_t a = 0; a + 1 < groups; ++a)
    if (size[a] > 0) there.push_back(a);
  if (there.size() < 2) return rdf;
  for (const std::uint32_t a : there)
    for (const std::uint32_t b : there)
      add(
          a, b, size[a], size[b], [&](std::size_t k) { return static_cast<double>(counts[(a * groups + b) * n + k]); },
          shells[a]);
  return rdf;
}

Result report_rdf(const Snapshot& s, const Settings& settings) {
  Result r;
  if (s.count() < 2) {
    r.notes.emplace_back(s.count() == 0 ? "no bodies" : "one body has no distances");
    return r;
  }
  const Domain region = region_of(s, settings);
  if (!(Grid(s, region, {1, 1, 1}).box_volume() > 0)) {
    r.notes.emplace_back("the region has no volume");
    return r;
  }
  double range = settings.rdf_range > 0 ? settings.rdf_range : 5 * mean_diameter(s);
  const double longest = longest_range(s, region);
  if (range > longest) {
    range = longest;
    r.notes.push_back(fmt::format("range cut to half the periodic cell: {:.6g} m", range));
  }
  const Rdf rdf = rdf_of(s, groups_of(s, settings.split, settings.reference), region, range, settings.rdf_bins);
  if (rdf.bodies < 2) {
    r.notes.emplace_back("fewer than two bodies in the region");
    return r;
  }
  const PairDistribution& all = rdf.pairs[0];
  Table t{"",
          "Radial distribution function",
          {{"r", "m", {}}, {"from", "m", {}}, {"to", "m", {}}, {"count", "1", all.count}, {"g", "1", all.g}}};
  double within = 0;
  Column sum{"count_within", "1", {}};
  std::size_t peak = 0;
  for (std::size_t k = 0; k < all.g.size(); ++k) {
    const double from = rdf.width * static_cast<double>(k), to = rdf.width * static_cast<double>(k + 1);
    t.columns[0].values.push_back(0.5 * (from + to));
    t.columns[1].values.push_back(from);
    t.columns[2].values.push_back(to);
    sum.values.push_back(within += all.count[k]);
    if (all.g[k] > all.g[peak]) peak = k;
  }
  t.columns.push_back(std::move(sum));
  for (std::size_t p = 1; p < rdf.pairs.size(); ++p) {
    const PairDistribution& pair = rdf.pairs[p];
    t.columns.push_back({"g_" + rdf.names[pair.a] + "_" + rdf.names[pair.b], "1", pair.g});
  }
  r.add("bodies", "1", static_cast<double>(rdf.bodies));
  r.add("peak_distance", "m", t.columns[0].values[peak]);
  r.add("peak_height", "1", all.g[peak]);
  r.notes.emplace_back(rdf.bounded ? "boundary corrected: shells count as far as they lie in the region"
                                   : "periodic: distances to the nearest image");
  r.tables.push_back(std::move(t));
  return r;
}

}  // namespace dem::analysis
