// dem analyse: the quantities of libdem/analysis over the frames of a run or of another code's output.
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <filesystem>

#include "libdem/analysis/flow.h"
#include "libdem/analysis/frames.h"
#include "libdem/analysis/in_run.h"
#include "libdem/analysis/write.h"
#include "libdem/cli/commands.h"
#include "libdem/cli/progress.h"
#include "libdem/scene/nearest.h"

namespace dem::cli {

namespace fs = std::filesystem;
using analysis::Quantity;

namespace {

std::vector<const Quantity*> asked(const std::vector<std::string>& what) {
  std::vector<std::string> names;
  for (const Quantity& q : analysis::quantities()) names.emplace_back(q.name);
  bool all = false;
  for (const std::string& name : what) {
    all = all || name == "all";
    if (name != "all" && analysis::find_quantity(name) == nullptr)
      throw InputError(fmt::format("--what {}: there is no such quantity{}; dem list quantities shows them all", name,
                                   suggestion(name, names)));
  }
  std::vector<const Quantity*> list;
  for (const Quantity& q : analysis::quantities()) {
    const bool named = std::find(what.begin(), what.end(), q.name) != what.end();
    if (all || named || (what.empty() && !q.costly)) list.push_back(&q);
  }
  return list;
}

analysis::Settings settings_of(const AnalyseOptions& a) {
  analysis::Settings s;
  if (!a.boxes.empty() && a.boxes.size() != 2 && a.boxes.size() != 3)
    throw InputError(
        fmt::format("--boxes: {} number{}; allowed two or three", a.boxes.size(), a.boxes.size() == 1 ? "" : "s"));
  for (const int n : a.boxes)
    if (n < 0) throw InputError(fmt::format("--boxes {}: allowed from 0", n));
  for (std::size_t k = 0; k < a.boxes.size(); ++k) s.boxes[k] = a.boxes[k];
  if (a.region.size() == 6)
    s.region = analysis::Domain{{a.region[0], a.region[1], a.region[2]}, {a.region[3], a.region[4], a.region[5]}};
  else if (a.region.size() == 4)
    s.region = analysis::Domain{{a.region[0], a.region[1], 0}, {a.region[2], a.region[3], 0}};
  else if (!a.region.empty())
    throw InputError(fmt::format("--region: {} numbers; allowed six, or four in the plane", a.region.size()));
  if (s.region)
    for (int k = 0; k < (a.region.size() == 6 ? 3 : 2); ++k)
      if (!(s.region->lower[k] < s.region->upper[k]))
        throw InputError(fmt::format("--region: along {} from {} to {}; allowed: lower < upper", "xyz"[k],
                                     s.region->lower[k], s.region->upper[k]));
  s.bins = a.bins;
  s.rdf_range = a.rdf_range;
  s.rdf_bins = a.rdf_bins;
  s.voronoi_points = a.voronoi_points;
  s.split = a.split;
  s.strong_force = a.strong_force;
  s.base_wall = a.base_wall;
  return s;
}

// What a frame of a region in space cannot be asked of the plane, and the other way round.
void check_region(const AnalyseOptions& a, const analysis::Snapshot& s) {
  if (!a.region.empty() && (a.region.size() == 6) != (s.dimension == 3))
    throw InputError(fmt::format("--region: {} numbers; allowed {} in {}", a.region.size(), s.dimension == 3 ? 6 : 4,
                                 s.dimension == 3 ? "space" : "the plane"));
}

std::string with_unit(double value, const std::string& unit) {
  return unit == "1" ? fmt::format("{:.6g}", value) : fmt::format("{:.6g} {}", value, unit);
}

// Of several frames the mean over the steady part and its error, else the value of the one frame.
std::string text_of(const analysis::ScalarSeries& s, const std::vector<double>& times) {
  const std::vector<double> values = s.present();
  if (values.empty()) return "-";
  if (values.size() == 1) {
    std::string text = with_unit(values[0], s.unit);
    for (const auto& e : s.errors)
      if (e) text += fmt::format(" ± {:.2g}", *e);
    return text;
  }
  const analysis::MeanOverTime m = s.mean();
  const analysis::SteadyPart steady = s.steady();
  std::string text =
      with_unit(m.mean, s.unit) + fmt::format(" ± {}{:.2g}", m.settled ? "" : ">= ", m.error.value_or(0));
  if (steady.steady && values.size() == times.size())
    text += fmt::format("  steady from t = {:.6g} s", times[steady.from]);
  else
    text += steady.steady ? "  steady" : steady.decided ? "  not steady" : fmt::format("  {} frames", values.size());
  return text + fmt::format(", last {}", with_unit(values.back(), "1"));
}

// How long bodies were there, of those that left; empty where none did.
analysis::Table residence_table(const analysis::Residence& residence) {
  analysis::Table t{"residence",
                    "bodies that have left: frames between which they were there; since_start 1: or longer",
                    {{"id", "1", {}}, {"entered", "s", {}}, {"left", "s", {}}, {"since_start", "1", {}}}};
  for (const auto& stay : residence.stays()) {
    t.columns[0].values.push_back(static_cast<double>(stay.id));
    t.columns[1].values.push_back(stay.entered);
    t.columns[2].values.push_back(stay.left);
    t.columns[3].values.push_back(stay.from_start ? 1 : 0);
  }
  return t;
}

void print(const analysis::Writer& writer) {
  for (const analysis::QuantitySeries& q : writer.series()) {
    fmt::print("{}\n", q.quantity->name);
    std::size_t width = 0;
    for (const analysis::ScalarSeries& s : q.scalars) width = std::max(width, s.name.size());
    for (const analysis::ScalarSeries& s : q.scalars)
      fmt::print("  {:<{}}  {}\n", s.name, width, text_of(s, writer.times()));
    for (const analysis::QuantitySeries::Note& n : q.notes)
      fmt::print(
          "  note: {}{}\n", n.text,
          n.frames < writer.times().size() ? fmt::format(" ({} of {} frames)", n.frames, writer.times().size()) : "");
  }
}

}  // namespace

std::string folder_of(const AnalyseArguments& a) {
  if (!a.out.empty()) return a.out;
  const fs::path source(a.source);
  if (fs::is_directory(source)) return (source / "analysis").string();
  if (source.extension() == ".h5") return (source.parent_path() / "analysis").string();
  return (source.parent_path() / source.stem()).string() + "_analysis";
}

int analyse_command(const AnalyseArguments& a) {
  const std::vector<const Quantity*> what = asked(a.options.what);
  analysis::Settings settings = settings_of(a.options);
  if (a.threads > 0) omp_set_num_threads(a.threads);
  const analysis::Frames frames = analysis::open_frames(a.source, {a.density, a.time_step, a.contact_gap});
  const std::vector<std::size_t> list = select_frames(a.options.frames, frames);
  analysis::Snapshot reference, before;
  if (a.options.reference || frames.count > 1) {
    const auto count = static_cast<long>(frames.count), at = a.options.reference.value_or(0);
    const long place = at < 0 ? at + count : at;
    if (place < 0 || place >= count)
      throw InputError(fmt::format("--reference {}: {} has frames 0 to {}", at, frames.source, count - 1));
    reference = frames.read(static_cast<std::size_t>(place));
    settings.reference = &reference;
  }
  const std::string folder = folder_of(a);
  analysis::Snapshot now = frames.read(list[0]);  // bad input ends here, nothing written
  check_region(a.options, now);
  analysis::prepare_folder(folder);
  analysis::Writer writer(folder, frames.source, what, list.size() == 1);
  WorkProgress progress(list.size() * what.size(), a.quiet);
  const Quantity* flow = analysis::find_quantity("flow");
  if (std::find(what.begin(), what.end(), flow) == what.end()) flow = nullptr;
  analysis::Residence residence;
  std::size_t done = 0;
  for (std::size_t f = 0; f < list.size(); ++f) {
    if (f > 0) {
      before = std::move(now);
      now = frames.read(list[f]);
    }
    settings.before = f > 0 ? &before : nullptr;
    writer.begin_frame(list[f], now);
    if (flow != nullptr) residence.add(now);
    for (const Quantity* q : what) {
      progress.show(done++, fmt::format("frame {} of {}: {}", f + 1, list.size(), q->name));
      writer.add(*q, result_of(*q, now, settings));
    }
  }
  if (flow != nullptr && !residence.stays().empty()) writer.add_of_all(*flow, residence_table(residence));
  writer.finish();
  progress.end();
  if (a.silent) return success;
  if (!a.quiet) print(writer);
  fmt::print("{}: {} frame{}, {} quantit{}\n", folder, list.size(), list.size() == 1 ? "" : "s", what.size(),
             what.size() == 1 ? "y" : "ies");
  return success;
}

}  // namespace dem::cli
