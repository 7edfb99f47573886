#include <fmt/format.h>

#include <iterator>

#include "libdem/io/io.h"

namespace dem::io {

namespace {

constexpr const char* columns =
    "time,wall,x,y,z,force_x,force_y,force_z,torque_x,torque_y,torque_z,power,impulse_x,impulse_y,impulse_z,work,area,"
    "mean_pressure";

// m²; 0 when the wall has none: no mesh, and the scene does not state one.
double area_of(const Wall& w) {
  if (w.kind != shapes::Kind::mesh) return w.motion.area;
  double area = 0;
  const auto& m = *w.mesh;
  for (std::size_t t = 0; t < m.triangles.size(); t += 3) {
    const Vec3d &a = m.vertices[m.triangles[t]], &b = m.vertices[m.triangles[t + 1]],
                &c = m.vertices[m.triangles[t + 2]];
    area += 0.5 * norm(cross(b - a, c - a));
  }
  return area;
}

// Per wall: the normal parts of its contacts' forces, N.
std::vector<double> pressing(const World& world) {
  std::vector<double> sum(world.walls.size());
  for (const ContactReport& c : touching_contacts(world))
    if (c.wall) sum[c.b] -= dot(c.force, c.normal);
  return sum;
}

}  // namespace

WallSeries::WallSeries(std::string path, const World& world, bool append)
    : file_(std::move(path), columns, world, append) {}

void WallSeries::write(const World& world) {
  if (file_.ends_at(world.time())) return;
  const std::string time = TimeSeries::text_of(world.time());
  const std::vector<double> normal = pressing(world);
  std::string rows;
  const auto out = std::back_inserter(rows);
  for (std::size_t i = 0; i < world.walls.size(); ++i) {
    const Wall& w = world.walls[i];
    if (!w.present) continue;
    fmt::format_to(out, "{},{}", time, w.name);
    const auto add = [&](std::initializer_list<double> values) {
      for (const double v : values) fmt::format_to(out, ",{:.17g}", v);
    };
    for (const Vec3d& v : {w.position, w.force, w.torque}) add({v.x, v.y, v.z});
    add({wall_power(w), w.load.impulse[0].value(), w.load.impulse[1].value(), w.load.impulse[2].value(),
         w.load.work.value()});
    const double area = area_of(w);
    if (area > 0)
      add({area, normal[i] / area});
    else
      rows += ",,";
    rows += '\n';
  }
  file_.append(world.time(), rows);
}

}  // namespace dem::io
