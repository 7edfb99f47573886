#include "libdem/analysis/write.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "libdem/io/files.h"
#include "libdem/io/io.h"
#include "libdem/io/vtp.h"

namespace dem::analysis {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr std::size_t block_count = 10;  // of the blocks of time, each of two frames at least

std::string heading(const std::vector<Column>& columns) {
  std::string units = "# units: ", names;
  for (const Column& c : columns) {
    const bool first = &c == columns.data();
    units += fmt::format("{}{} {}", first ? "" : ", ", c.name, c.unit);
    names += (first ? "" : ",") + c.name;
  }
  return units + "\n" + names + "\n";
}

std::optional<double> finite(double value) {
  return std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}
Json json_of(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }
Json json_of(const std::vector<std::optional<double>>& values) {
  Json list = Json::array();
  for (const auto& v : values) list.push_back(json_of(v));
  return list;
}
std::string cell_of(const std::optional<double>& value) { return value ? csv_number(*value) : ""; }

bool any(const std::vector<std::optional<double>>& values) {
  return std::any_of(values.begin(), values.end(), [](const auto& v) { return v.has_value(); });
}

// Times of the frames that have a value.
std::vector<double> times_of(const ScalarSeries& s, const std::vector<double>& times) {
  std::vector<double> list;
  for (std::size_t i = 0; i < s.values.size(); ++i)
    if (s.values[i]) list.push_back(times[i]);
  return list;
}

// <quantity>.csv, <quantity>_….csv, <quantity>_….vtp and the files of all together.
bool is_ours(const std::string& name) {
  if (name == "series_summary.csv") return true;
  return (name.ends_with(".csv") || name.ends_with(".vtp")) &&
         std::any_of(quantities().begin(), quantities().end(), [&](const Quantity& q) {
           const std::string_view stem = std::string_view(name).substr(0, name.size() - 4);
           return stem == q.name || stem.starts_with(std::string(q.name) + "_");
         });
}

void remove_files_of_analysis(const fs::path& folder) {
  std::vector<fs::path> doomed;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && is_ours(entry.path().filename().string())) doomed.push_back(entry.path());
  for (const fs::path& p : doomed) fs::remove(p);
}

void add_note(QuantitySeries& series, const std::string& text, std::uint64_t step) {
  for (QuantitySeries::Note& n : series.notes)
    if (n.text == text) {
      ++n.frames;
      return;
    }
  series.notes.push_back({text, 1, step});
}

}  // namespace

std::string csv_number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

void write_surface(const Surface& surface, const std::string& path) {
  io::Vtp vtp;
  vtp.set_points(surface.points, false);
  vtp.set_cells(surface.lines ? io::Vtp::Cells::lines : io::Vtp::Cells::polygons, surface.corners, surface.ends);
  for (const Column& c : surface.columns) vtp.add_cell_array(c.name, 1, c.values);
  for (const Column& c : surface.at_points) vtp.add_point_array(c.name, 1, c.values);
  vtp.write(path);
}

std::string csv_of(const Table& table) {
  std::string head = heading(table.columns);
  if (!table.title.empty()) head.insert(head.find('\n') + 1, "# " + table.title + "\n");
  fmt::memory_buffer text;
  text.append(head);
  const std::size_t rows = table.columns.empty() ? 0 : table.columns[0].values.size();
  for (std::size_t r = 0; r < rows; ++r) {
    for (const Column& c : table.columns) {
      if (&c != table.columns.data()) text.push_back(',');
      if (std::isfinite(c.values[r])) fmt::format_to(std::back_inserter(text), "{}", c.values[r]);
    }
    text.push_back('\n');
  }
  return fmt::to_string(text);
}

std::vector<double> ScalarSeries::present() const {
  std::vector<double> list;
  for (const auto& v : values)
    if (v) list.push_back(*v);
  return list;
}

MeanOverTime ScalarSeries::mean() const {
  const std::vector<double> all = present();
  return mean_over_time(std::span(all).subspan(steady_part(all).from));
}

Writer::Writer(std::string folder, std::string source, const std::vector<const Quantity*>& quantities, bool single)
    : folder_(std::move(folder)), source_(std::move(source)), single_(single) {
  for (const Quantity* q : quantities) series_.push_back({q, {}, {}, {}});
}

std::string Writer::file(const std::string& name, const std::string& text) {
  io::write_file((fs::path(folder_) / name).string(), text);
  files_.push_back(name);
  return name;
}

void Writer::begin_frame(std::size_t frame, const Snapshot& s) {
  frames_.push_back(frame);
  bodies_.push_back(s.count());
  contacts_.push_back(s.contacts.size());
  steps_.push_back(s.step);
  times_.push_back(s.time);
  for (const std::string& n : s.notes)
    if (std::find(notes_.begin(), notes_.end(), n) == notes_.end()) notes_.push_back(n);
}

QuantitySeries& Writer::series_of(const Quantity& quantity) {
  return *std::find_if(series_.begin(), series_.end(),
                       [&](const QuantitySeries& s) { return s.quantity == &quantity; });
}

void Writer::add(const Quantity& quantity, const Result& result) {
  QuantitySeries& series = series_of(quantity);
  const std::size_t frames = frames_.size();
  const std::uint64_t step = steps_.back();
  for (const Scalar& x : result.scalars) {
    auto s = std::find_if(series.scalars.begin(), series.scalars.end(),
                          [&](const ScalarSeries& t) { return t.name == x.name; });
    if (s == series.scalars.end()) s = series.scalars.insert(s, {x.name, x.unit, {}, {}});
    s->values.resize(frames);
    s->errors.resize(frames);
    s->values.back() = finite(x.value);
    if (x.error) s->errors.back() = finite(*x.error);
    if (!std::isfinite(x.value)) add_note(series, x.name + " is not finite", step);
  }
  for (ScalarSeries& s : series.scalars) {
    s.values.resize(frames);
    s.errors.resize(frames);
  }
  for (const std::string& n : result.notes) add_note(series, n, step);
  for (const Table& t : result.tables) {
    std::string name = quantity.name;
    if (!t.name.empty()) name += "_" + t.name;
    if (!single_) name += fmt::format("_{:012}", step);
    write_table(series, t, name + ".csv");
  }
  for (const Surface& x : result.surfaces) {
    if (!single_ && !x.lines) {
      add_note(series, "surface " + x.name + ": written where one frame alone is analysed", step);
      continue;
    }
    std::string name = quantity.name + ("_" + x.name);
    if (!single_) name += fmt::format("_{:012}", step);
    write_surface(x, (fs::path(folder_) / (name + ".vtp")).string());
    files_.push_back(name + ".vtp");
  }
}

void Writer::add_of_all(const Quantity& quantity, const Table& table) {
  write_table(series_of(quantity), table, fmt::format("{}_{}.csv", quantity.name, table.name));
}

void Writer::write_table(QuantitySeries& series, const Table& t, const std::string& name) {
  auto known = std::find_if(series.tables.begin(), series.tables.end(),
                            [&](const QuantitySeries::TableFiles& k) { return k.head.name == t.name; });
  if (known == series.tables.end()) {
    QuantitySeries::TableFiles fresh;
    fresh.head.name = t.name;
    fresh.head.title = t.title;
    known = series.tables.insert(known, std::move(fresh));
  }
  known->head.columns.clear();
  for (const Column& c : t.columns) {
    known->head.columns.push_back({c.name, c.unit, {}});
    if (!std::all_of(c.values.begin(), c.values.end(), [](double v) { return std::isfinite(v); }))
      add_note(series, fmt::format("table {}: {} has values that are not finite: empty cells", t.name, c.name),
               steps_.back());
  }
  known->files.push_back(file(name, csv_of(t)));
}

void Writer::write_series(const QuantitySeries& series) {
  if (series.scalars.empty()) return;
  std::vector<Column> columns{{"time", "s", {}}, {"step", "1", {}}};
  for (const ScalarSeries& s : series.scalars) {
    columns.push_back({s.name, s.unit, {}});
    if (any(s.errors)) columns.push_back({s.name + "_error", s.unit, {}});
  }
  std::string text = heading(columns);
  for (std::size_t f = 0; f < times_.size(); ++f) {
    text += fmt::format("{},{}", csv_number(times_[f]), steps_[f]);
    for (const ScalarSeries& s : series.scalars) {
      text += "," + cell_of(s.values[f]);
      if (any(s.errors)) text += "," + cell_of(s.errors[f]);
    }
    text += '\n';
  }
  file(std::string(series.quantity->name) + "_series.csv", text);
}

void Writer::write_blocks(const QuantitySeries& series) {
  Table t{"",
          "means over blocks of time; errors from the scatter in a block, as if its frames were independent",
          {{"first_time", "s", {}}, {"last_time", "s", {}}, {"frames", "1", {}}}};
  for (const ScalarSeries& s : series.scalars) {
    const std::vector<double> values = s.present();
    if (values.size() != times_.size() || values.size() < 2 * block_count) continue;
    Column mean{s.name, s.unit, {}}, error{s.name + "_error", s.unit, {}};
    const bool first = t.columns.size() == 3;
    for (const Block& b : block_means(values, block_count)) {
      mean.values.push_back(b.mean);
      error.values.push_back(b.error);
      if (!first) continue;
      t.columns[0].values.push_back(times_[b.first]);
      t.columns[1].values.push_back(times_[b.first + b.count - 1]);
      t.columns[2].values.push_back(static_cast<double>(b.count));
    }
    t.columns.push_back(std::move(mean));
    t.columns.push_back(std::move(error));
  }
  if (t.columns.size() > 3) file(std::string(series.quantity->name) + "_blocks.csv", csv_of(t));
}

void Writer::write_summary() {
  std::string text =
      "# units: of last, mean, error and deviation in the column unit; steady_from s\n"
      "# mean and error over the part from steady_from on, over all frames where that is empty; settled 0: the error "
      "is "
      "a lower bound\n"
      "quantity,name,unit,frames,last,mean,error,deviation,steady_from,block,settled\n";
  for (const QuantitySeries& q : series_)
    for (const ScalarSeries& s : q.scalars) {
      const std::vector<double> values = s.present();
      if (values.empty()) continue;
      const SteadyPart steady = s.steady();
      const MeanOverTime m = s.mean();
      text +=
          fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", q.quantity->name, s.name, s.unit, values.size(),
                      csv_number(values.back()), csv_number(m.mean), cell_of(m.error), csv_number(m.deviation),
                      steady.steady ? csv_number(times_of(s, times_)[steady.from]) : "", m.block, m.settled ? 1 : 0);
    }
  file("series_summary.csv", text);
}

void Writer::write_json() {
  Json units{{"time", "s"}, {"steady_from", "s"}};
  Json quantities = Json::object();
  for (const QuantitySeries& q : series_) {
    Json scalars = Json::object(), tables = Json::array(), notes = Json::array();
    for (const ScalarSeries& s : q.scalars) {
      units[std::string(q.quantity->name) + "." + s.name] = s.unit;
      Json x{{"unit", s.unit}, {"values", json_of(s.values)}};
      if (any(s.errors)) x["errors"] = json_of(s.errors);
      if (const std::vector<double> values = s.present(); values.size() > 1) {
        const SteadyPart steady = s.steady();
        const MeanOverTime m = s.mean();
        x["steady"] = steady.decided ? Json(steady.steady) : Json(nullptr);
        x["steady_from"] = steady.steady ? Json(times_of(s, times_)[steady.from]) : Json(nullptr);
        x["mean"] = m.mean;
        x["error"] = json_of(m.error);
        x["error_settled"] = m.settled;
        x["deviation"] = m.deviation;
      }
      scalars[s.name] = x;
    }
    for (const QuantitySeries::TableFiles& t : q.tables) {
      Json columns = Json::array();
      for (const Column& c : t.head.columns) columns.push_back({{"name", c.name}, {"unit", c.unit}});
      tables.push_back({{"name", t.head.name}, {"title", t.head.title}, {"columns", columns}, {"files", t.files}});
    }
    for (const QuantitySeries::Note& n : q.notes)
      notes.push_back({{"text", n.text}, {"frames", n.frames}, {"first_step", n.first_step}});
    quantities[q.quantity->name] = {{"what", q.quantity->what},
                                    {"equation", q.quantity->equation},
                                    {"scalars", scalars},
                                    {"tables", tables},
                                    {"notes", notes}};
  }
  Json frames = Json::array();
  for (std::size_t f = 0; f < frames_.size(); ++f)
    frames.push_back({{"frame", frames_[f]},
                      {"step", steps_[f]},
                      {"time", times_[f]},
                      {"bodies", bodies_[f]},
                      {"contacts", contacts_[f]}});
  std::vector<std::string> files = files_;
  files.emplace_back("analysis.json");
  const Json all{{"units", units},   {"source", source_}, {"version", io::version},   {"complete", true},
                 {"frames", frames}, {"notes", notes_},   {"quantities", quantities}, {"files", files}};
  file("analysis.json", all.dump(1) + "\n");
}

void Writer::finish() {
  for (const QuantitySeries& q : series_) {
    write_series(q);
    write_blocks(q);
  }
  write_summary();
  write_json();
}

void prepare_folder(const std::string& folder) {
  const fs::path path(folder), listing = path / "analysis.json";
  std::error_code failed;
  fs::create_directories(path, failed);
  if (failed || !fs::is_directory(path))
    throw InputError(fmt::format("{}: cannot make this folder{}", folder, failed ? ": " + failed.message() : ""));
  if (!fs::is_empty(path) && (!fs::exists(listing) || fs::exists(path / "scene.toml")))
    throw InputError(folder + ": is not empty and holds no analysis; choose another --out");
  remove_files_of_analysis(path);
  io::write_file(listing.string(), "{\"complete\": false}\n");
}

void clear_analysis(const std::string& folder) {
  const fs::path path(folder), listing = path / "analysis.json";
  if (!fs::is_regular_file(listing)) return;
  remove_files_of_analysis(path);
  fs::remove(listing);
  if (fs::is_empty(path)) fs::remove(path);
}

}  // namespace dem::analysis
