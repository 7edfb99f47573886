#include <fmt/format.h>

#include <iterator>

#include "libdem/io/files.h"
#include "libdem/io/io.h"

namespace dem::io {

void write_final_csv(const std::string& path, const World& world) {
  constexpr std::size_t piece = 1 << 16;
  NewFile file(path);
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "id,shape,material,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz{}\n",
                 world.scene.species.empty() ? "" : ",species");
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
    if (!world.scene.species.empty()) fmt::format_to(out, ",{}", species_name(world, p.species[i]));
    text.push_back('\n');
    if (text.size() < piece) continue;
    file.write(std::string_view(text.data(), text.size()));
    text.clear();
  }
  file.write(std::string_view(text.data(), text.size()));
  file.done(Durability::renamed);
}

void write_discharge_csv(const std::string& path, const World& world) {
  std::string text = "time,count,mass,outlet,outlet_count,outlet_mass,species\n";
  std::vector<std::uint64_t> count(world.outlets.size());
  std::vector<double> mass(world.outlets.size());
  double before = 0;
  for (const DischargePoint& d : world.discharge) {
    ++count[d.outlet];
    mass[d.outlet] += d.mass - before;
    before = d.mass;
    text += fmt::format("{:.17g},{},{:.17g},{},{},{:.17g},{}\n", d.time, d.count, d.mass, world.outlets[d.outlet].name,
                        count[d.outlet], mass[d.outlet], species_name(world, d.species));
  }
  write_file(path, text);
}

}  // namespace dem::io
