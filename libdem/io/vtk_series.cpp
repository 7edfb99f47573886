#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>

#include "libdem/io/files.h"
#include "libdem/io/io.h"
#include "libdem/io/vtk_pieces.h"

namespace dem::io {

namespace fs = std::filesystem;

VtkSeries::VtkSeries(std::string folder) : folder_(std::move(folder)) {
  fs::create_directories(folder_ + "/frames");
  std::ifstream index(folder_ + "/frames.pvd");
  const std::regex entry("<DataSet timestep=\"([^\"]+)\" part=\"([0-9]+)\" file=\"frames/[a-z]+_([0-9]+)\\.vtp\"/>");
  std::smatch match;
  for (std::string line; std::getline(index, line);) {
    if (!std::regex_search(line, match, entry)) continue;
    const std::uint64_t step = std::stoull(match[3]);
    if (frames_.empty() || frames_.back().step != step) frames_.push_back({step, match[1], {}});
    frames_.back().parts.push_back(std::stoul(match[2]));
  }
}

std::string VtkSeries::file_of(std::size_t part, std::uint64_t step) const {
  return fmt::format("frames/{}_{:06}.vtp", vtk_pieces[part].name, step);
}

void VtkSeries::write(const World& world) {
  std::erase_if(frames_, [&](const Frame& f) { return f.step == world.step; });
  Frame frame{world.step, fmt::format("{:.17g}", world.time()), {}};
  for (std::size_t part = 0; part < vtk_pieces.size(); ++part)
    if (vtk_pieces[part].write(folder_ + "/" + file_of(part, world.step), world)) frame.parts.push_back(part);
  const auto later = [&](const Frame& f) { return f.step > world.step; };
  frames_.insert(std::find_if(frames_.begin(), frames_.end(), later), std::move(frame));
  write_index();
}

void VtkSeries::truncate_after(std::uint64_t step) {
  for (const Frame& f : frames_)
    if (f.step > step)
      for (const std::size_t part : f.parts) fs::remove(folder_ + "/" + file_of(part, f.step));
  std::erase_if(frames_, [&](const Frame& f) { return f.step > step; });
  write_index();
}

void VtkSeries::write_index() const {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
      "byte_order=\"LittleEndian\">\n<Collection>\n";
  for (const Frame& f : frames_)
    for (const std::size_t part : f.parts)
      text += fmt::format("<DataSet timestep=\"{}\" part=\"{}\" file=\"{}\"/>\n", f.time, part, file_of(part, f.step));
  write_file(folder_ + "/frames.pvd", text + "</Collection>\n</VTKFile>\n");
}

}  // namespace dem::io
