#include "libdem/forecast/output_cost.h"

#include <unistd.h>

#include <filesystem>
#include <optional>

#include "libdem/analysis/in_run.h"
#include "libdem/forecast/clock.h"
#include "libdem/forecast/memory.h"
#include "libdem/io/io.h"
#include "libdem/render/render.h"

namespace dem::forecast {
namespace {

namespace fs = std::filesystem;

// A folder that goes with everything in it.
struct Scratch {
  fs::path path;
  Scratch() : path(fs::temp_directory_path() / ("dem-check-" + std::to_string(getpid()))) {
    fs::create_directories(path);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  double bytes() const {
    double sum = 0;
    for (const auto& entry : fs::recursive_directory_iterator(path))
      if (entry.is_regular_file()) sum += static_cast<double>(entry.file_size());
    return sum;
  }
};

template <class Work>
double timed(Work&& work) {
  const double begin = thread_seconds();
  work();
  return thread_seconds() - begin;
}

}  // namespace

OutputCost output_cost(const World& world) {
  OutputCost cost;
  try {
    const Scratch folder;
    const OutputSpec& what = world.scene.output;
    std::optional<io::VtkSeries> vtk;
    std::optional<io::Record> record;
    if (what.vtk) vtk.emplace(folder.path.string());
    if (what.hdf5) record.emplace((folder.path / "record.h5").string(), world, false);
    const double empty = folder.bytes();
    cost.frame = timed([&] {
      if (vtk) vtk->write(world);
      if (record) record->write(world);
    });
    if (!world.scene.analysis.what.empty())
      cost.analysis = timed([&] { analysis::InRun(world, folder.path.string(), false).write(world); });
    cost.frame_bytes = folder.bytes() - empty;
    io::write_final_csv((folder.path / "final.csv").string(), world);
    constexpr double picture_bytes = 2e5;  // a picture of grains; an empty one is smaller
    cost.other_bytes = empty + static_cast<double>(fs::file_size(folder.path / "final.csv")) +
                       (what.picture && render::available() ? picture_bytes : 0);
    const double before = folder.bytes();
    cost.checkpoint = timed([&] { io::write_checkpoint(folder.path.string(), world); });
    cost.checkpoint_bytes = folder.bytes() - before;
  } catch (const std::exception&) {
    return {};
  }
  return cost;
}

PictureCost picture_cost(const World& world) {
  if (!world.scene.output.picture || !render::available()) return {};
  // Two sizes tell what each pixel takes from what the scene as such does.
  const auto seconds = [&](int width, int height) {
    render::View view;
    view.width = width;
    view.height = height;
    const double begin = process_seconds();
    render::draw(world, view);
    return process_seconds() - begin;
  };
  const render::View full;
  const double small = seconds(80, 60), larger = seconds(240, 180);
  const double per_pixel = std::max(0.0, larger - small) / (240 * 180 - 80 * 60);
  double corners = 0;
  for (std::size_t i = 0; i < world.particles.count(); ++i) {
    const shapes::Polyhedron* body = world.shapes[world.particles.shape[i]].drawn();
    corners += body ? static_cast<double>(body->face_vertices.size()) : 2;
  }
  constexpr double bytes_per_corner = 160;  // a triangle in single precision and its share of the tree over them
  return {small + per_pixel * full.width * full.height, corners * bytes_per_corner + 8.0 * full.width * full.height};
}

}  // namespace dem::forecast
