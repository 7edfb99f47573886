// Grains by random numbers for a scene, and the samples that they follow.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>
#include <set>

#include "libdem/build.h"
#include "libdem/io/io.h"
#include "shapes/generate.h"

namespace dem {
namespace {

constexpr std::uint64_t streams = std::uint64_t(1) << 52;  // away from those of fills and rain

// A CSV file with columns L, W, T; sphericity, or volume and area; set.
class Sample {
 public:
  explicit Sample(const std::string& path)
      : table_(io::read_csv(path)),
        length_(io::column(table_, "L")),
        width_(io::column(table_, "W")),
        thickness_(io::column(table_, "T")),
        sphericity_(io::find_column(table_, "sphericity")),
        volume_(io::find_column(table_, "volume")),
        area_(io::find_column(table_, "area")),
        set_(io::find_column(table_, "set")) {}

  std::vector<shapes::FormTarget> rows_of(const std::string& set) const {
    if (!set.empty() && !set_) input_error(header(), "the file has no column 'set'");
    const auto set_of = [&](std::size_t r) { return set_ ? table_.cell(r, *set_) : std::string(); };
    std::vector<shapes::FormTarget> rows;
    std::set<std::string> sets;
    for (std::size_t r = 0; r < table_.row_count(); ++r) {
      sets.insert(set_of(r));
      if (set.empty() || set_of(r) == set) rows.push_back(row(r));
    }
    if (rows.empty() && !set.empty())
      input_error(header(), fmt::format("no row has set = {}; the file has {}", set, fmt::join(sets, ", ")));
    if (rows.empty()) input_error(header(), "the sample has no rows");
    return rows;
  }

 private:
  Where header() const { return {table_.path, table_.header_line, 1}; }

  double positive(std::size_t r, std::size_t c) const {
    const double x = io::number(table_, r, c);
    if (!(x > 0))
      input_error(table_.where(r, c), fmt::format("{} = {}: allowed > 0", table_.columns[c], table_.cell(r, c)));
    return x;
  }

  shapes::FormTarget row(std::size_t r) const {
    const double length = positive(r, length_), width = positive(r, width_), thickness = positive(r, thickness_);
    if (!(length >= width && width >= thickness))
      input_error(table_.where(r, length_),
                  fmt::format("L, W, T = {}, {}, {}: allowed L >= W >= T", length, width, thickness));
    shapes::FormTarget target{thickness / width, width / length, 0};
    if (sphericity_) {
      const double psi = positive(r, *sphericity_);
      target.sphericity_cubed = psi * psi * psi;
    } else if (volume_ && area_) {
      const double volume = positive(r, *volume_), area = positive(r, *area_);
      target.sphericity_cubed = 36 * std::numbers::pi * (volume / area) * (volume / area) / area;
    }
    if (!(target.sphericity_cubed <= 1))
      input_error(table_.where(r, sphericity_.value_or(volume_.value_or(length_))),
                  "the sphericity is above 1, that of a sphere: are volume and area in the units of L?");
    return target;
  }

  io::Table table_;
  std::size_t length_, width_, thickness_;
  std::optional<std::size_t> sphericity_, volume_, area_, set_;
};

}  // namespace

std::vector<shapes::Polyhedron> generated_grains(const ShapeSpec& s, const Scene& scene) {
  const auto this_one = [&](const ShapeSpec& x) { return x.name == s.name; };
  const auto place = std::find_if(scene.shapes.begin(), scene.shapes.end(), this_one) - scene.shapes.begin();
  const std::uint64_t seed = scene.run.seed, stream = streams + 2 * static_cast<std::uint64_t>(place);
  const auto count = static_cast<std::size_t>(s.variants);
  if (s.kind == "voronoi") return shapes::voronoi_grains(count, s.relaxations, seed, stream);
  const std::vector<shapes::FormTarget> sample = Sample(s.statistic).rows_of(s.set);
  const std::vector<std::size_t> rows = shapes::spread(sample, count, seed, stream);
  std::vector<shapes::Polyhedron> grains;
  for (std::size_t i = 0; i < count; ++i) grains.push_back(shapes::grain_of_form(sample[rows[i]], seed, stream + 1, i));
  return grains;
}

}  // namespace dem
