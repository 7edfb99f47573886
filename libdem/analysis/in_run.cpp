#include "libdem/analysis/in_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>

#include "libdem/analysis/write.h"
#include "libdem/io/files.h"

namespace dem::analysis {

namespace {

constexpr std::string_view units_mark = "# units: ";

std::vector<std::string> split(std::string_view text, std::string_view between) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t at = text.find(between);
    parts.emplace_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + between.size());
  }
}

}  // namespace

GrowingSeries::GrowingSeries(std::string path, bool append, double time) : path_(std::move(path)) {
  columns_ = {{"time", "s"}, {"step", "1"}};
  if (append) {
    const std::string text = io::read_file(path_);
    std::vector<std::string> lines = split(text, "\n");
    lines.pop_back();  // half a line of a run that was killed, or nothing
    if (lines.size() >= 2 && lines[0].starts_with(units_mark)) {
      columns_.clear();
      for (const std::string& c : split(std::string_view(lines[0]).substr(units_mark.size()), ", "))
        columns_.push_back({c.substr(0, c.find(' ')), c.substr(std::min(c.find(' ') + 1, c.size()))});
      for (std::size_t l = 2; l < lines.size(); ++l) {
        double at = 0;
        const auto [end, error] = std::from_chars(lines[l].data(), lines[l].data() + lines[l].size(), at);
        if (error != std::errc{} || at > time) break;
        last_ = lines[l].substr(0, static_cast<std::size_t>(end - lines[l].data()));
        rows_ += lines[l] + "\n";
      }
    }
  }
  begin();
  rows_.clear();
}

std::string GrowingSeries::heading() const {
  std::string units(units_mark), names;
  for (const Name& c : columns_) {
    const bool first = &c == columns_.data();
    units += fmt::format("{}{} {}", first ? "" : ", ", c.name, c.unit);
    names += (first ? "" : ",") + c.name;
  }
  return units + "\n" + names + "\n";
}

void GrowingSeries::begin() const { io::write_file(path_, heading() + rows_); }

bool GrowingSeries::ends_at(double time) const { return last_ == csv_number(time); }

void GrowingSeries::add(double time, std::uint64_t step, const Result& result) {
  std::vector<std::string> cells{csv_number(time), std::to_string(step)};
  cells.resize(columns_.size());
  const std::size_t before = columns_.size();
  const auto put = [&](const std::string& name, const std::string& unit, double value) {
    auto at = std::find_if(columns_.begin(), columns_.end(), [&](const Name& c) { return c.name == name; });
    if (at == columns_.end()) at = columns_.insert(at, {name, unit});
    cells.resize(columns_.size());
    cells[static_cast<std::size_t>(at - columns_.begin())] = csv_number(value);
  };
  for (const Scalar& s : result.scalars) {
    put(s.name, s.unit, s.value);
    if (s.error) put(s.name + "_error", s.unit, *s.error);
  }
  std::string row;
  for (const std::string& c : cells) row += (&c == cells.data() ? "" : ",") + c;
  row += "\n";
  last_ = cells[0];
  if (columns_.size() > before) {  // rows so far have empty cells there
    std::vector<std::string> lines = split(io::read_file(path_), "\n");
    lines.pop_back();
    for (std::size_t l = 2; l < lines.size(); ++l)
      rows_ += lines[l] + std::string(columns_.size() - before, ',') + "\n";
    rows_ += row;
    begin();
    rows_.clear();
    return;
  }
  std::ofstream file(path_, std::ios::app);
  file << row;
  file.close();
  if (!file) throw RunError("cannot write " + path_);
}

std::vector<const Quantity*> quantities_of(const AnalysisSpec& spec) {
  const auto named = [&](const char* name) {
    return std::find(spec.what.begin(), spec.what.end(), name) != spec.what.end();
  };
  std::vector<const Quantity*> list;
  for (const Quantity& q : quantities())
    if (named("all") || named(q.name)) list.push_back(&q);
  return list;
}

Settings settings_of(const AnalysisSpec& spec) {
  Settings s;
  if (!(spec.region_lower == spec.region_upper)) s.region = Domain{spec.region_lower, spec.region_upper};
  for (int k = 0; k < 3; ++k) s.boxes[static_cast<std::size_t>(k)] = static_cast<int>(spec.boxes[k]);
  s.bins = spec.bins;
  s.rdf_range = spec.rdf_range;
  s.rdf_bins = spec.rdf_bins;
  s.voronoi_points = spec.voronoi_points;
  s.split = spec.split;
  s.strong_force = spec.strong_force;
  s.base_wall = spec.base_wall;
  return s;
}

Result result_of(const Quantity& q, const Snapshot& s, const Settings& settings) {
  if (!q.needs_contacts || s.has_contacts) return q.of(s, settings);
  Result none;
  none.notes.emplace_back("not computed: the source has no contacts");
  return none;
}

InRun::InRun(const World& world, const std::string& folder, bool resumed)
    : quantities_(quantities_of(world.scene.analysis)),
      reference_(resumed ? snapshot_of(build_world(world.scene)) : snapshot_of(world)),
      settings_(settings_of(world.scene.analysis)) {
  for (const Quantity* q : quantities_)
    files_.emplace_back(fmt::format("{}/analysis_{}.csv", folder, q->name), resumed, world.time());
}

void InRun::write(const World& world) {
  const bool done =
      std::all_of(files_.begin(), files_.end(), [&](const GrowingSeries& f) { return f.ends_at(world.time()); });
  if (done) return;
  const Snapshot now = snapshot_of(world);
  settings_.reference = &reference_;
  for (std::size_t k = 0; k < files_.size(); ++k)
    if (!files_[k].ends_at(now.time)) files_[k].add(now.time, now.step, result_of(*quantities_[k], now, settings_));
}

}  // namespace dem::analysis
