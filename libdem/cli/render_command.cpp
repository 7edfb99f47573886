// dem render: pictures and movies of a run's folder.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "libdem/analysis/body_colours.h"
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

// Colours that an analysis gives: bands and deformation since a reference frame, rates.
class Colours {
 public:
  Colours(const RenderArguments& arguments, const std::string& record) : word_(arguments.color_by) {
    const auto& words = analysis::body_colour_words();
    analysed_ = std::find(words.begin(), words.end(), word_) != words.end();
    std::vector<std::string> all = render::color_names();
    if (!analysed_ && std::find(all.begin(), all.end(), word_) == all.end()) {
      all.insert(all.end(), words.begin(), words.end());
      throw InputError(fmt::format("--color-by {}: allowed {}{}", word_, fmt::join(all, ", "), suggestion(word_, all)));
    }
    if (arguments.reference && !(analysed_ && analysis::needs_reference(word_)))
      throw InputError(fmt::format("--reference: colours by {} refer to no other frame", word_));
    if (!analysed_ || !analysis::needs_reference(word_)) return;
    if (!fs::exists(record))
      throw InputError(record + ": the run kept no record (output.hdf5), so there is no frame to refer to");
    const int frames = io::frame_count(record), asked = arguments.reference.value_or(0);
    const int frame = asked < 0 ? asked + frames : asked;
    if (frame < 0 || frame >= frames)
      throw InputError(fmt::format("--reference {}: the record has frames 0 to {}", asked, frames - 1));
    World world = build_world(scene_of_run(arguments.folder));
    io::load_frame(record, world, frame);
    reference_ = analysis::snapshot_of(world);
  }

  void set(render::View& view, const World& world) const {
    if (!analysed_) return;
    analysis::BodyColours c = analysis::body_colours(analysis::snapshot_of(world), word_,
                                                     analysis::needs_reference(word_) ? &reference_ : nullptr);
    view.colouring = render::Colouring{std::move(c.label), std::move(c.names), std::move(c.values)};
  }

  bool analysed() const { return analysed_; }

 private:
  std::string word_;
  bool analysed_ = false;
  analysis::Snapshot reference_;
};

// One box and one colour range for the whole movie, so that nothing jumps. Of what an analysis gives without the
// highest 4 %: single bodies may have any strain.
void fix_view(render::View& view, World& world, const std::string& record, int frames, const Colours& colours) {
  io::Box box = render::picture_box(world);
  render::Range range{0, 0};
  std::vector<double> values;
  for (int k = 0; k < frames; ++k) {
    io::load_frame(record, world, k);
    const io::Box now = render::picture_box(world);
    for (int i = 0; i < 3; ++i) {
      box.lower[i] = std::min(box.lower[i], now.lower[i]);
      box.upper[i] = std::max(box.upper[i], now.upper[i]);
    }
    colours.set(view, world);
    const render::Picture picture = render::picture_of(world, view);
    for (const render::Body& b : picture.bodies) {
      if (!std::isfinite(b.value)) continue;
      range.lower = std::min(range.lower, b.value);
      range.upper = std::max(range.upper, b.value);
      if (colours.analysed()) values.push_back(b.value);
    }
  }
  if (!values.empty()) {
    const auto share = [&](std::size_t hundredths) {
      const auto at = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) * hundredths / 100);
      std::nth_element(values.begin(), at, values.end());
      return *at;
    };
    if (const double high = share(96); high > 0) range.upper = high;
    if (range.lower < 0) range.lower = std::min(share(4), 0.0);
  }
  view.box = box;
  if (range.upper > range.lower) view.range = range;
}

int movie(const RenderArguments& arguments, World& world, render::View view, const std::string& record,
          const Colours& colours) {
  const int frames = io::frame_count(record);
  fix_view(view, world, record, frames, colours);
  const std::string path = arguments.folder + "/movie.mp4";
  if (io::installed("ffmpeg")) {
    Movie out(path, view);
    for (int k = 0; k < frames; ++k) {
      io::load_frame(record, world, k);
      colours.set(view, world);
      out.add(render::draw(world, view));
    }
    out.close();
    fmt::print("{}\n", path);
    return success;
  }
  for (int k = 0; k < frames; ++k) {
    io::load_frame(record, world, k);
    colours.set(view, world);
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
  const std::string record = arguments.folder + "/record.h5";
  const Colours colours(arguments, record);
  World world = build_world(scene_of_run(arguments.folder));
  render::View view;
  view.width = arguments.width;
  view.height = arguments.height;
  view.color_by = arguments.color_by;
  if ((arguments.movie || arguments.frame) && !fs::exists(record))
    throw InputError(record + ": the run kept no record (output.hdf5), only its last state can be drawn");
  if (arguments.movie) return movie(arguments, world, view, record, colours);
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
  colours.set(view, world);
  const std::string path = arguments.folder + "/" + name;
  render::write_png(path, render::draw(world, view));
  fmt::print("{}\n", path);
  return success;
}

}  // namespace dem::cli
