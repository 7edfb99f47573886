#include <fmt/format.h>

#include <charconv>
#include <fstream>

#include "libdem/deformation.h"
#include "libdem/io/files.h"
#include "libdem/io/io.h"

namespace dem::io {

namespace {

constexpr const char* columns =
    "time,length_x,length_y,length_z,stress_xx,stress_yy,stress_zz,stress_xy,stress_xz,stress_yz,solid_fraction,"
    "coordination,rattlers,coordination_backbone,translational,elastic,work\n";

std::string text_of(double time) { return fmt::format("{:.17g}", time); }

}  // namespace

CellSeries::CellSeries(std::string path, const World& world, bool append) : path_(std::move(path)) {
  std::string kept = columns;
  std::ifstream file(path_);
  std::string line;
  if (append && std::getline(file, line))
    while (std::getline(file, line) && !file.eof()) {  // a run that was killed may have left half a line
      double time = 0;
      const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), time);
      if (error != std::errc{} || time > world.time()) break;
      last_ = line.substr(0, static_cast<std::size_t>(end - line.data()));
      kept += line + "\n";
    }
  file.close();
  write_file(path_, kept);
}

void CellSeries::write(const World& world) {
  const std::string time = text_of(world.time());
  if (time == last_) return;
  last_ = time;
  const Vec3d& length = world.cell.lattice.length;
  const Mat3d s = cell_stress(world);
  const auto mean = [&](int a, int b) { return 0.5 * (s.row[a][b] + s.row[b][a]); };
  const Coordination z = coordination(world);
  const Energies e = energies(world);
  std::string row = time;
  for (const double v :
       {length.x, length.y, length.z, s.row[0].x, s.row[1].y, s.row[2].z, mean(0, 1), mean(0, 2), mean(1, 2),
        solid_fraction(world), z.all, z.rattlers, z.backbone, e.translational, e.elastic, world.cell.work.value()})
    row += fmt::format(",{:.17g}", v);
  std::ofstream file(path_, std::ios::app);
  file << row << '\n';
  file.close();
  if (!file) throw RunError("cannot write " + path_);
}

}  // namespace dem::io
