#include <fmt/format.h>

#include <iterator>

#include "libdem/io/files.h"
#include "libdem/io/io.h"

namespace dem::io {

void write_final_csv(const std::string& path, const World& world) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "id,shape,material,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\n");
  const auto add = [&](std::initializer_list<double> values) {
    for (const double v : values) fmt::format_to(out, ",{:.17g}", v);
  };
  const Particles& p = world.particles;
  for (const std::uint32_t i : order_by_id(world)) {
    const Motion& m = p.motion[i];
    const Quatd& q = p.orientation[i];
    fmt::format_to(out, "{},{},{}", p.id[i], world.shapes[p.shape[i]].name, world.scene.materials[p.material[i]].name);
    add({m.position.x, m.position.y, m.position.z, q.w, q.x, q.y, q.z});
    add({m.velocity.x, m.velocity.y, m.velocity.z, m.spin.x, m.spin.y, m.spin.z});
    text.push_back('\n');
  }
  write_file(path, {text.data(), text.size()});
}

void write_discharge_csv(const std::string& path, const World& world) {
  std::string text = "time,count,mass\n";
  for (const DischargePoint& d : world.discharge) text += fmt::format("{:.17g},{},{:.17g}\n", d.time, d.count, d.mass);
  write_file(path, text);
}

}  // namespace dem::io
