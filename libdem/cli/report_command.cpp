// dem report: the page of a run, from its analysis, which is made first where it is missing or older than the run.
#include <fmt/format.h>

#include <filesystem>

#include "libdem/cli/commands.h"
#include "libdem/cli/folder.h"
#include "libdem/cli/model_lines.h"
#include "libdem/io/files.h"
#include "libdem/io/io.h"
#include "libdem/render/render.h"
#include "libdem/report/listing.h"
#include "libdem/report/report.h"

namespace dem::cli {

namespace fs = std::filesystem;

namespace {

// Whether the analysis in the folder is whole and not older than what it is of.
bool stands(const fs::path& analysis, const std::string& source) {
  if (!report::is_complete(analysis.string())) return false;
  std::error_code failed;
  return fs::last_write_time(analysis / "analysis.json", failed) >= fs::last_write_time(source, failed) && !failed;
}

// The picture that the run has made, else one of its last frame; empty: there is none.
std::string still_of(const fs::path& run, World& world, const std::string& folder) {
  if (fs::exists(run / "final.png")) return (run / "final.png").string();
  if (!render::available() || !fs::exists(run / "record.h5")) return "";
  io::load_frame((run / "record.h5").string(), world, io::frame_count((run / "record.h5").string()) - 1);
  fs::create_directories(folder);
  std::string path = (fs::path(folder) / "still.png").string();
  render::View view;
  view.width = 720;
  view.height = 540;
  render::write_png(path, render::draw(world, view));
  return path;
}

// What goes on from a file to its run; empty: another code's output.
fs::path run_of(const std::string& source) {
  fs::path path(source);
  if (fs::is_directory(path)) return path;
  return path.extension() == ".h5" ? fs::absolute(path).parent_path() : fs::path();
}

std::string page_of(const ReportArguments& a, const fs::path& run) {
  if (a.page.empty())
    return run.empty() ? (fs::path(a.analyse.source).parent_path() / fs::path(a.analyse.source).stem()).string() +
                             "_report.html"
                       : (run / "report.html").string();
  if (!a.page.ends_with(".html")) throw InputError(fmt::format("--out {}: allowed a file that ends in .html", a.page));
  const fs::path folder = fs::absolute(a.page).parent_path();
  if (!fs::is_directory(folder))
    throw InputError(fmt::format("--out {}: there is no folder {}", a.page, folder.string()));
  return a.page;
}

}  // namespace

int report_command(const ReportArguments& a) {
  const fs::path run = run_of(a.analyse.source);
  report::Input input;
  input.page = page_of(a, run);
  input.analysis = folder_of(a.analyse);
  input.max_bodies = static_cast<std::size_t>(a.max_bodies);
  const analysis::Frames frames =
      analysis::open_frames(a.analyse.source, {a.analyse.density, a.analyse.time_step, a.analyse.contact_gap});
  if (const auto asked = a.analyse.options.reference)
    input.reference = analysis::select_frames(fmt::format("{}", *asked), frames)[0];
  if (!(a.analyse.options == AnalyseOptions{}) || !stands(input.analysis, frames.source)) {
    AnalyseArguments analyse = a.analyse;
    analyse.silent = true;
    analyse_command(analyse);
  }
  if (!run.empty()) {
    World world = build_world(scene_of_run(run.string()));
    input.run = run.string();
    input.title = world.scene.title;
    input.scene = io::read_file(run / "scene.toml");
    for (const auto& [name, text] : model_lines(world)) input.model.emplace_back(name, text);
    input.still = still_of(run, world, report::figures_folder(input.page));
  }
  const report::Outcome outcome = report::write_report(input, frames);
  for (const std::string& note : outcome.notes) fmt::print(stderr, "{}\n", note);
  fmt::print("{}: {} figure{}, {} bod{}\n", input.page, outcome.figures, outcome.figures == 1 ? "" : "s",
             outcome.bodies, outcome.bodies == 1 ? "y" : "ies");
  return success;
}

}  // namespace dem::cli
