#include "libdem/run.h"

#include <omp.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>

#include "libdem/analysis/in_run.h"
#include "libdem/deformation.h"
#include "libdem/forces.h"
#include "libdem/io/files.h"
#include "libdem/io/io.h"
#include "libdem/render/render.h"
#include "libdem/stopwatch.h"

namespace dem {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

bool due(std::uint64_t step, std::uint64_t every) { return every > 0 && step % every == 0; }

// Everything that a run writes while it goes.
class Output {
 public:
  Output(const World& world, const RunOptions& options, bool resumed)
      : options_(options),
        frame_every_(steps_between(world.scene.output.interval, world.time_step.dt)),
        checkpoint_every_(steps_between(world.scene.output.checkpoint_interval, world.time_step.dt)),
        cell_every_(steps_between(world.scene.output.cell_interval, world.time_step.dt)),
        walls_every_(steps_between(world.scene.output.walls_interval, world.time_step.dt)),
        analysis_every_(steps_between(world.scene.analysis.interval, world.time_step.dt)),
        silent_(options.folder.empty()) {
    if (silent_) return;
    fs::create_directories(options.folder);
    if (!resumed) io::write_file(path("scene.toml"), scene_to_toml(world.scene));
    const OutputSpec& what = world.scene.output;
    if (what.vtk) vtk_.emplace(options.folder);
    if (is_whole(world)) cell_.emplace(path("cell.csv"), world, resumed);
    if (what.walls && !world.walls.empty()) walls_.emplace(path("walls.csv"), world, resumed);
    if (!world.scene.analysis.what.empty()) analysis_.emplace(world, options.folder, resumed);
    if (what.hdf5) record_.emplace(path("record.h5"), world, resumed && fs::exists(path("record.h5")));
    if (resumed) {  // frames that the stopped run wrote after its last checkpoint will come again
      if (vtk_) vtk_->truncate_after(world.step);
      if (record_) record_->truncate_after(world.step);
    } else {
      frame(world);
    }
  }

  bool due_now(std::uint64_t step) const {
    return !silent_ && (due(step, frame_every_) || due(step, checkpoint_every_) || (cell_ && due(step, cell_every_)) ||
                        (walls_ && due(step, walls_every_)) || (analysis_ && due(step, analysis_every_)));
  }
  // Frames come before the checkpoint of the same step: a resume then has every frame up to its checkpoint.
  void write_due(const World& world) {
    if (due(world.step, frame_every_)) frame(world);
    if (cell_ && due(world.step, cell_every_)) cell_->write(world);
    if (walls_ && due(world.step, walls_every_)) walls_->write(world);
    if (analysis_ && due(world.step, analysis_every_)) analysis_->write(world);
    if (due(world.step, checkpoint_every_)) checkpoint(world);
  }
  void checkpoint(const World& world) const {
    if (!silent_) io::write_checkpoint(options_.folder, world);
  }
  void frame(const World& world) {
    if (vtk_) vtk_->write(world);
    if (record_) record_->write(world);
    if (cell_ && (cell_every_ == 0 || world.step == 0)) cell_->write(world);
    if (walls_ && (walls_every_ == 0 || world.step == 0)) walls_->write(world);
    if (analysis_ && (analysis_every_ == 0 || world.step == 0)) analysis_->write(world);
  }
  // The state as it is, whether the run reached its end or failed.
  void state(const World& world) {
    if (silent_) return;
    frame(world);
    if (cell_) cell_->write(world);
    if (walls_) walls_->write(world);
    if (analysis_) analysis_->write(world);
    io::write_final_csv(path("final.csv"), world);
    if (!world.scene.outlets.empty()) io::write_discharge_csv(path("discharge.csv"), world);
  }
  void picture(const World& world) const {
    if (!silent_ && world.scene.output.picture && render::available())
      render::write_png(path("final.png"), render::draw(world, render::View{}));
  }
  void summary(const World& world, const std::string& end) const {
    if (!silent_) io::write_summary(path("summary.json"), world, end, options_.threads);
  }

 private:
  std::string path(const char* name) const { return options_.folder + "/" + name; }

  const RunOptions& options_;
  std::uint64_t frame_every_, checkpoint_every_, cell_every_, walls_every_, analysis_every_;
  bool silent_;
  std::optional<io::VtkSeries> vtk_;
  std::optional<io::Record> record_;
  std::optional<io::WallSeries> walls_;
  std::optional<analysis::InRun> analysis_;
  std::optional<io::CellSeries> cell_;  // of a box that is periodic along every axis
};

// Adds the wall time of a piece of work to a sum.
template <class Work>
void timed(double& sum, Work&& work) {
  const auto start = Clock::now();
  work();
  sum += seconds_since(start);
}

}  // namespace

// A thread must have enough to do between two barriers to be worth waking.
int default_threads(const World& world) {
  constexpr std::size_t particles_per_thread = 200;
  return static_cast<int>(std::clamp<std::size_t>(world.particles.count() / particles_per_thread, 1,
                                                  static_cast<std::size_t>(omp_get_num_procs())));
}

RunEnd run(World& world, const RunOptions& options, bool resumed) {
  const auto began = Clock::now();
  Output output(world, options, resumed);
  world.times.output += seconds_since(began);
  auto shown = Clock::now();
  try {
    while (!finished(world)) {
      const bool interrupted = options.interrupt && options.interrupt->load(std::memory_order_relaxed);
      if (interrupted && !world.ahead) {
        timed(world.times.output, [&] {
          output.checkpoint(world);
          output.summary(world, "interrupted");
        });
        return RunEnd::interrupted;
      }
      const bool looked_at = interrupted || options.observe || output.due_now(world.step + 1);
      advance(world, options.threads, !looked_at && world.step + 1 < total_steps(world));
      if (options.observe) options.observe(world);
      if (output.due_now(world.step)) timed(world.times.output, [&] { output.write_due(world); });
      if (options.progress && seconds_since(shown) >= 0.1) {
        options.progress(world);
        shown = Clock::now();
      }
    }
  } catch (const RunError& error) {
    // Where bodies have moved on, forces were not kept: what is written is that of where they are.
    if (world.ahead && !world.contacts.stale) compute_forces(world, options.threads, 0.0);
    output.state(world);
    output.summary(world, std::string("failed: ") + error.what());
    throw;
  }
  if (options.progress) options.progress(world);
  timed(world.times.output, [&] {
    output.checkpoint(world);
    output.state(world);
    output.picture(world);
  });
  output.summary(world, world.ended_by > 0 ? "finished: " + ended_by(world)
                                           : "finished");  // the last file: where it says so, the run is complete
  return RunEnd::finished;
}

}  // namespace dem
