#include "libdem/analysis/frames.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <memory>
#include <optional>

#include "libdem/analysis/read_lammps.h"
#include "libdem/build.h"
#include "libdem/io/io.h"
#include "libdem/law_map.h"

namespace dem::analysis {

namespace fs = std::filesystem;

namespace {

std::shared_ptr<World> world_of(const fs::path& folder) {
  const fs::path scene = folder / "scene.toml";
  if (!fs::is_regular_file(scene))
    throw InputError(fmt::format("{}: holds no run (no scene.toml)", folder.empty() ? "." : folder.string()));
  return std::make_shared<World>(build_world(load_scene(scene.string())));
}

// What is wrong with a record is bad input, not a failed run.
template <class Read>
auto as_input(const Read& read) {
  try {
    return read();
  } catch (const RunError& error) {
    throw InputError(error.what());
  }
}

// What the contacts of a frame store follows from what the record keeps of them.
Snapshot snapshot_of_frame(const World& world) {
  Snapshot s = snapshot_of(world);
  const Contacts& c = world.contacts;
  if (c.count() == 0 || c.words == record_words(world))
    s.elastic = energies(world).elastic;
  else
    s.notes.emplace_back("the record has no memory of contacts: what they store is not known");
  return s;
}

Frames frames_of_record(const fs::path& record, const std::shared_ptr<World>& world) {
  const std::string path = record.string();
  const auto count = static_cast<std::size_t>(as_input([&] { return io::frame_count(path); }));
  return {path, count, [world, path](std::size_t frame) {
            as_input([&] {
              io::load_frame(path, *world, static_cast<int>(frame));
              return 0;
            });
            return snapshot_of_frame(*world);
          }};
}

Frames frames_of_folder(const fs::path& folder) {
  const auto world = world_of(folder);
  if (fs::exists(folder / "record.h5")) return frames_of_record(folder / "record.h5", world);
  const auto checkpoint = io::read_last_checkpoint(folder.string());
  if (!checkpoint)
    throw InputError(fmt::format("{}: the run kept no record (output.hdf5) and no checkpoint", folder.string()));
  load_state(*world, checkpoint->state);
  return {folder.string(), 1, [world](std::size_t) {
            Snapshot s = snapshot_of(*world);
            s.notes.emplace_back("the run kept no record (output.hdf5): its last state alone");
            return s;
          }};
}

std::optional<long> part_of(std::string_view text, const std::string& range) {
  if (text.empty()) return {};
  long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    throw InputError(fmt::format("--frames {}: allowed A:B:S with whole numbers, or A; '{}' is none", range, text));
  return value;
}

}  // namespace

Frames open_frames(const std::string& path, const ForeignOptions& options) {
  const fs::path at(path);
  if (fs::is_directory(at)) return frames_of_folder(at);
  if (!fs::exists(at)) throw InputError(path + ": there is no such folder or file");
  if (at.extension() == ".h5") return frames_of_record(at, world_of(at.parent_path()));
  if (is_lammps_dump(path)) {
    const auto dump = std::make_shared<const LammpsDump>(path, options);
    return {path, dump->count(), [dump](std::size_t frame) { return dump->read(frame); }};
  }
  if (at.extension() == ".csv" || at.extension() == ".gz")
    return {path, 1, [path, options](std::size_t) { return read_bodies_csv(path, options); }};
  throw InputError(path +
                   ": not known; allowed: the folder of a run, its record.h5, a LAMMPS or LIGGGHTS text dump, a .csv "
                   "file of bodies");
}

std::vector<std::size_t> select_frames(const std::string& range, const Frames& frames) {
  const auto count = static_cast<long>(frames.count);
  if (count == 0) throw InputError(frames.source + ": has no frames");
  std::vector<std::string_view> parts;
  for (std::string_view rest = range;;) {
    const std::size_t colon = rest.find(':');
    parts.push_back(rest.substr(0, colon));
    if (colon == std::string_view::npos) break;
    rest.remove_prefix(colon + 1);
  }
  if (parts.size() > 3) throw InputError(fmt::format("--frames {}: allowed A:B:S, or A", range));
  const bool single = parts.size() == 1 && !parts[0].empty();
  const auto place = [&](std::optional<long> given, long otherwise, long last) {
    if (!given) return otherwise;
    const long at = *given < 0 ? *given + count : *given;
    if (at < 0 || at > last)
      throw InputError(fmt::format("--frames {}: {} has frames 0 to {}", range, frames.source, count - 1));
    return at;
  };
  const long first = place(part_of(parts[0], range), 0, count - 1);
  if (single) return {static_cast<std::size_t>(first)};
  const long end = parts.size() > 1 ? place(part_of(parts[1], range), count, count) : count;
  const long step = parts.size() > 2 ? part_of(parts[2], range).value_or(1) : 1;
  if (step < 1) throw InputError(fmt::format("--frames {}: the step is {}; allowed from 1", range, step));
  std::vector<std::size_t> list;
  for (long k = first; k < end; k += step) list.push_back(static_cast<std::size_t>(k));
  if (list.empty()) throw InputError(fmt::format("--frames {}: no frame is left", range));
  return list;
}

}  // namespace dem::analysis
