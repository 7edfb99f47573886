#include "libdem/cli/folder.h"

#include <fmt/format.h>

#include <filesystem>
#include <regex>
#include <vector>

#include "libdem/analysis/write.h"
#include "libdem/report/figures.h"

namespace dem::cli {

namespace fs = std::filesystem;

namespace {

bool is_ours(const std::string& name) {
  static const std::regex ours(
      R"((frames\.pvd|record\.h5|checkpoint-\d+\.bin|final\.csv|summary\.json|discharge\.csv|cell\.csv|walls\.csv|)"
      R"(analysis_\w+\.csv|final\.png|report\.html|)"
      R"(frame-\d+\.png|movie\.mp4)(\.part)?)");
  return std::regex_match(name, ours);
}

}  // namespace

void check_folder(const std::string& folder, const std::string& scene, bool force) {
  if (!fs::exists(folder)) return;
  if (!fs::is_directory(folder)) throw InputError(folder + ": is not a folder");
  std::error_code missing;
  if (fs::equivalent(fs::path(folder) / "scene.toml", scene, missing))
    throw InputError(fmt::format("{}: the run would replace its own scene {}; choose another --out", folder, scene));
  if (force || fs::is_empty(folder)) return;
  const auto holds = [&](const char* name) { return fs::exists(fs::path(folder) / name); };
  const bool run = holds("scene.toml") && (holds("summary.json") || holds("frames.pvd") || holds("record.h5"));
  throw InputError(fmt::format("{0}: {1}; choose another --out, or --force to replace {2}{3}", folder,
                               run ? "holds a run" : "is not empty", run ? "it" : "the files that a run writes",
                               run ? ", or go on with: dem resume " + folder : ""));
}

void clear_folder(const std::string& folder) {
  if (!fs::is_directory(folder)) return;
  std::vector<fs::path> doomed;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && is_ours(entry.path().filename().string())) doomed.push_back(entry.path());
  const fs::path frames = fs::path(folder) / "frames";
  if (fs::is_directory(frames))
    for (const auto& entry : fs::directory_iterator(frames))
      if (const auto end = entry.path().extension(); end == ".vtp" || end == ".part") doomed.push_back(entry.path());
  for (const fs::path& path : doomed) fs::remove(path);
  if (fs::is_directory(frames) && fs::is_empty(frames)) fs::remove(frames);
  analysis::clear_analysis((fs::path(folder) / "analysis").string());
  const fs::path figures = fs::path(folder) / "report_figures";
  if (!fs::is_directory(figures)) return;
  report::remove_figures(figures.string());
  fs::remove(figures / "still.png");
  if (fs::is_empty(figures)) fs::remove(figures);
}

Scene scene_of_run(const std::string& folder) {
  const std::string path = (fs::path(folder) / "scene.toml").string();
  if (!fs::is_regular_file(path)) throw InputError(fmt::format("{}: holds no run (no scene.toml)", folder));
  return load_scene(path);
}

}  // namespace dem::cli
