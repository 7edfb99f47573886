#include <fmt/format.h>

#include "libdem/deformation.h"
#include "libdem/io/io.h"

namespace dem::io {

namespace {

constexpr const char* columns =
    "time,length_x,length_y,length_z,stress_xx,stress_yy,stress_zz,stress_xy,stress_xz,stress_yz,solid_fraction,"
    "coordination,rattlers,coordination_backbone,translational,elastic,work";

}  // namespace

CellSeries::CellSeries(std::string path, const World& world, bool append)
    : file_(std::move(path), columns, world, append) {}

void CellSeries::write(const World& world) {
  if (file_.ends_at(world.time())) return;
  const Vec3d& length = world.cell.lattice.length;
  const Mat3d s = cell_stress(world);
  const auto mean = [&](int a, int b) { return 0.5 * (s.row[a][b] + s.row[b][a]); };
  const Coordination z = coordination(world);
  const Energies e = energies(world);
  std::string row = TimeSeries::text_of(world.time());
  for (const double v :
       {length.x, length.y, length.z, s.row[0].x, s.row[1].y, s.row[2].z, mean(0, 1), mean(0, 2), mean(1, 2),
        solid_fraction(world), z.all, z.rattlers, z.backbone, e.translational, e.elastic, world.cell.work.value()})
    row += fmt::format(",{:.17g}", v);
  file_.append(world.time(), row + '\n');
}

}  // namespace dem::io
