// dem render: pictures and movies of a run's folder.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "libdem/cli/commands.h"
#include "libdem/cli/folder.h"
#include "libdem/io/io.h"
#include "libdem/io/programs.h"
#include "libdem/render/render.h"
#include "libdem/scene/nearest.h"

namespace dem::cli {

namespace {

namespace fs = std::filesystem;

constexpr int frames_per_second = 25;
constexpr const char* encoding = "-c:v libx264 -pix_fmt yuv420p -vf 'pad=ceil(iw/2)*2:ceil(ih/2)*2'";

// Raw pictures through a pipe into ffmpeg.
class Movie {
 public:
  Movie(const std::string& path, const render::View& view) : path_(path) {
    std::signal(SIGPIPE, SIG_IGN);  // an encoder that dies shows as a failed write
    const std::string command =
        fmt::format("ffmpeg -loglevel error -y -f rawvideo -pix_fmt rgb24 -s {}x{} -r {} -i - {} {}", view.width,
                    view.height, frames_per_second, encoding, io::shell_quoted(path));
    pipe_ = popen(command.c_str(), "w");
    if (!pipe_) throw RunError("ffmpeg does not start");
  }
  Movie(const Movie&) = delete;
  Movie& operator=(const Movie&) = delete;
  ~Movie() {
    if (pipe_) pclose(pipe_);
  }
  void add(const render::Image& image) {
    if (std::fwrite(image.rgb.data(), 1, image.rgb.size(), pipe_) != image.rgb.size()) failed();
  }
  void close() {
    FILE* pipe = std::exchange(pipe_, nullptr);
    if (pclose(pipe) != 0) failed();
  }

 private:
  [[noreturn]] void failed() const { throw RunError("ffmpeg failed on " + path_); }
  std::string path_;
  FILE* pipe_ = nullptr;
};

// One box and one colour range for the whole movie, so that nothing jumps.
void fix_view(render::View& view, World& world, const std::string& record, int frames) {
  io::Box box = render::picture_box(world);
  render::Range range{0, 0};
  for (int k = 0; k < frames; ++k) {
    io::load_frame(record, world, k);
    const io::Box now = render::picture_box(world);
    for (int i = 0; i < 3; ++i) {
      box.lower[i] = std::min(box.lower[i], now.lower[i]);
      box.upper[i] = std::max(box.upper[i], now.upper[i]);
    }
    const render::Picture picture = render::picture_of(world, view);
    for (const render::Body& b : picture.bodies) range.upper = std::max(range.upper, b.value);
  }
  view.box = box;
  if (range.upper > range.lower) view.range = range;
}

int movie(const RenderArguments& arguments, World& world, render::View view, const std::string& record) {
  const int frames = io::frame_count(record);
  fix_view(view, world, record, frames);
  const std::string path = arguments.folder + "/movie.mp4";
  if (io::installed("ffmpeg")) {
    Movie out(path, view);
    for (int k = 0; k < frames; ++k) {
      io::load_frame(record, world, k);
      out.add(render::draw(world, view));
    }
    out.close();
    fmt::print("{}\n", path);
    return success;
  }
  for (int k = 0; k < frames; ++k) {
    io::load_frame(record, world, k);
    render::write_png(fmt::format("{}/frame-{:05}.png", arguments.folder, k), render::draw(world, view));
  }
  fmt::print("{}/frame-00000.png … frame-{:05}.png\n", arguments.folder, frames - 1);
  fmt::print(stderr,
             "ffmpeg is not installed; where it is, make the movie with:\n  ffmpeg -r {} -i {}/frame-%05d.png {} {}\n",
             frames_per_second, io::shell_quoted(arguments.folder), encoding, io::shell_quoted(path));
  return success;
}

}  // namespace

int render_command(const RenderArguments& arguments) {
  if (!render::available()) throw RunError("this program was built without Embree: no pictures");
  const auto& colors = render::color_names();
  if (std::find(colors.begin(), colors.end(), arguments.color_by) == colors.end())
    throw InputError(fmt::format("--color-by {}: allowed {}{}", arguments.color_by, fmt::join(colors, ", "),
                                 suggestion(arguments.color_by, colors)));
  World world = build_world(scene_of_run(arguments.folder));
  render::View view;
  view.width = arguments.width;
  view.height = arguments.height;
  view.color_by = arguments.color_by;
  const std::string record = arguments.folder + "/record.h5";
  if ((arguments.movie || arguments.frame) && !fs::exists(record))
    throw InputError(record + ": the run kept no record (output.hdf5), only its last state can be drawn");
  if (arguments.movie) return movie(arguments, world, view, record);
  std::string name = "final.png";
  if (arguments.frame) {
    const int frames = io::frame_count(record);
    if (*arguments.frame < 0 || *arguments.frame >= frames)
      throw InputError(fmt::format("--frame {}: the record has frames 0 to {}", *arguments.frame, frames - 1));
    io::load_frame(record, world, *arguments.frame);
    name = fmt::format("frame-{:05}.png", *arguments.frame);
  } else if (const auto checkpoint = io::read_last_checkpoint(arguments.folder)) {
    load_state(world, checkpoint->state);
  }
  const std::string path = arguments.folder + "/" + name;
  render::write_png(path, render::draw(world, view));
  fmt::print("{}\n", path);
  return success;
}

}  // namespace dem::cli
