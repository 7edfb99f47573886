// Layout of record.h5, SI units, one row per particle (in order of id), wall or contact:
//   /frames/<step>            attributes step, time
//     id shape material species  (0: none) size position orientation(w, x, y, z) velocity spin rotation
//     cell                    of a periodic scene: lower corner and lengths of the box
//     walls/                  present position orientation
//     contacts/               touching records:
//       a b part              b from 2^63 on: a wall
//       part_a share          with bodies of parts: the part of a, the share of the contact's stiffness
//       force centre          on a; of the contact relative to a (left out when all are spheres)
//       history_force history_normal history_overlap history_twist
//       memory                with laws in stages: what else they remember, Contacts::memory
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "libdem/build.h"
#include "libdem/io/hdf5.h"
#include "libdem/io/io.h"
#include "libdem/law_map.h"

namespace dem::io {

namespace {

// Zero padded: the order of names is the order of steps.
std::string name_of(std::uint64_t step) { return fmt::format("{:012}", step); }

// Rows of a vector quantity, taken from each item by `get`.
template <class Items, class Get>
std::vector<double> rows(const Items& items, Get get) {
  std::vector<double> values;
  values.reserve(3 * items.size());
  for (const auto& item : items) {
    const Vec3d v = get(item);
    values.insert(values.end(), {v.x, v.y, v.z});
  }
  return values;
}
template <class Items, class Get>
std::vector<double> quaternion_rows(const Items& items, Get get) {
  std::vector<double> values;
  values.reserve(4 * items.size());
  for (const auto& item : items) {
    const Quatd q = get(item);
    values.insert(values.end(), {q.w, q.x, q.y, q.z});
  }
  return values;
}
Vec3d vector_at(const std::vector<double>& rows, std::size_t i) {
  return {rows[3 * i], rows[3 * i + 1], rows[3 * i + 2]};
}
Quatd quaternion_at(const std::vector<double>& rows, std::size_t i) {
  return {rows[4 * i], rows[4 * i + 1], rows[4 * i + 2], rows[4 * i + 3]};
}

template <class T>
std::vector<T> pick(const std::vector<T>& values, const std::vector<std::uint32_t>& order) {
  std::vector<T> picked;
  for (const std::uint32_t i : order) picked.push_back(values[i]);
  return picked;
}

void put_particles(hdf5::File& file, const std::string& at, const World& world) {
  const Particles& p = world.particles;
  const std::vector<std::uint32_t> order = order_by_id(world);
  const auto put_vectors = [&](const std::string& name, auto get) { file.put(at + name, rows(order, get), 3); };
  file.put(at + "/id", pick(p.id, order), 1);
  file.put(at + "/shape", pick(p.shape, order), 1);
  file.put(at + "/material", pick(p.material, order), 1);
  file.put(at + "/species", pick(p.species, order), 1);
  put_vectors("/size", [&](std::uint32_t i) { return p.size[i]; });
  put_vectors("/position", [&](std::uint32_t i) { return p.motion[i].position; });
  put_vectors("/velocity", [&](std::uint32_t i) { return p.motion[i].velocity; });
  put_vectors("/spin", [&](std::uint32_t i) { return p.motion[i].spin; });
  put_vectors("/rotation", [&](std::uint32_t i) { return p.rotation[i]; });
  file.put(at + "/orientation", quaternion_rows(order, [&](std::uint32_t i) { return p.orientation[i]; }), 4);
}

void put_walls(hdf5::File& file, const std::string& at, const std::vector<Wall>& walls) {
  std::vector<std::uint32_t> present;
  for (const Wall& w : walls) present.push_back(w.present ? 1 : 0);
  file.put(at + "/present", present, 1);
  file.put(at + "/position", rows(walls, [](const Wall& w) { return w.position; }), 3);
  file.put(at + "/orientation", quaternion_rows(walls, [](const Wall& w) { return w.orientation; }), 4);
}

void put_contacts(hdf5::File& file, const std::string& at, const World& world) {
  const Contacts& c = world.contacts;
  const auto& id = world.particles.id;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < c.touching.size(); ++i)
    if (c.touching[i]) kept.push_back(i);
  std::vector<std::uint64_t> a, b;
  std::vector<std::uint32_t> part;
  std::vector<double> overlap, twist;
  for (const std::size_t i : kept) {
    a.push_back(id[c.index_a[i]]);
    b.push_back(c.key[i].b >= wall_base ? c.key[i].b : id[c.index_b[i]]);
    part.push_back(c.key[i].part);
    overlap.push_back(c.history_of(i).overlap);
    twist.push_back(c.history_of(i).twist);
  }
  file.put(at + "/a", a, 1);
  file.put(at + "/b", b, 1);
  file.put(at + "/part", part, 1);
  if (!c.share.empty()) {
    std::vector<std::uint32_t> part_a;
    std::vector<double> share;
    for (const std::size_t i : kept) {
      part_a.push_back(c.key[i].part_a);
      share.push_back(c.share[i]);
    }
    file.put(at + "/part_a", part_a, 1);
    file.put(at + "/share", share, 1);
  }
  file.put(at + "/force", rows(kept, [&](std::size_t i) { return c.slot[c.slot_of(i)].force; }), 3);
  if (!c.centre.empty()) file.put(at + "/centre", rows(kept, [&](std::size_t i) { return c.centre[i]; }), 3);
  file.put(at + "/history_force", rows(kept, [&](std::size_t i) { return c.history_of(i).force_t; }), 3);
  file.put(at + "/history_normal", rows(kept, [&](std::size_t i) { return c.history_of(i).normal; }), 3);
  file.put(at + "/history_overlap", overlap, 1);
  file.put(at + "/history_twist", twist, 1);
  if (c.words == 0) return;
  std::vector<double> memory;
  for (const std::size_t i : kept)
    memory.insert(memory.end(), &c.memory[i * c.words], &c.memory[i * c.words] + c.words);
  file.put(at + "/memory", memory, c.words);
}

void get_particles(const hdf5::File& file, const std::string& at, World& world) {
  Particles& p = world.particles;
  p.id = file.get<std::uint64_t>(at + "/id");
  p.shape = file.get<std::uint32_t>(at + "/shape");
  p.material = file.get<std::uint32_t>(at + "/material");
  p.species = file.get<std::uint32_t>(at + "/species");
  const std::size_t n = p.id.size();
  const auto vectors = [&](const std::string& name) {
    auto values = file.get<double>(at + "/" + name);
    if (values.size() != 3 * n) throw RunError("the record's frame " + at + " is damaged: " + name);
    return values;
  };
  const auto size = vectors("size"), position = vectors("position"), velocity = vectors("velocity"),
             spin = vectors("spin"), rotation = vectors("rotation"),
             orientation = file.get<double>(at + "/orientation");
  const auto known = [&](const std::vector<std::uint32_t>& list, std::size_t count) {
    return list.size() == n && std::all_of(list.begin(), list.end(), [&](std::uint32_t k) { return k < count; });
  };
  if (orientation.size() != 4 * n || !known(p.shape, world.shapes.size()) ||
      !known(p.material, world.materials.size()) || !known(p.species, world.scene.species.size() + 1))
    throw RunError("the record's frame " + at + " does not belong to this scene");
  p.kind.clear();
  for (const std::uint32_t shape : p.shape) p.kind.push_back(world.shapes[shape].kind);
  for (auto* list : {&p.size, &p.rotation, &p.angular_momentum, &p.inertia, &p.force, &p.torque})
    list->assign(n, Vec3d{});
  p.motion.assign(n, Motion{});
  p.orientation.resize(n);
  p.mass.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    p.size[i] = vector_at(size, i);
    p.rotation[i] = vector_at(rotation, i);
    p.orientation[i] = quaternion_at(orientation, i);
    p.motion[i].position = vector_at(position, i);
    p.motion[i].velocity = vector_at(velocity, i);
    p.motion[i].spin = vector_at(spin, i);
    set_mass(world, i, p.size[i].x / world.shapes[p.shape[i]].size.x);
  }
}

void get_walls(const hdf5::File& file, const std::string& at, std::vector<Wall>& walls) {
  const auto present = file.get<std::uint32_t>(at + "/present");
  const auto position = file.get<double>(at + "/position"), orientation = file.get<double>(at + "/orientation");
  if (present.size() != walls.size()) throw RunError("the record's frame " + at + " does not belong to this scene");
  for (std::size_t i = 0; i < walls.size(); ++i) {
    walls[i].present = present[i] != 0;
    walls[i].position = vector_at(position, i);
    walls[i].orientation = quaternion_at(orientation, i);
    walls[i].velocity = walls[i].spin = {};  // not in the record
  }
}

void get_contacts(const hdf5::File& file, const std::string& at, World& world) {
  const auto a = file.get<std::uint64_t>(at + "/a"), b = file.get<std::uint64_t>(at + "/b");
  const auto part = file.get<std::uint32_t>(at + "/part");
  const auto force = file.get<double>(at + "/force"), force_t = file.get<double>(at + "/history_force");
  const auto normal = file.get<double>(at + "/history_normal"), overlap = file.get<double>(at + "/history_overlap");
  const auto twist = file.get<double>(at + "/history_twist");
  const auto& id = world.particles.id;
  const auto index = [&](std::uint64_t k) {
    return static_cast<std::uint32_t>(std::lower_bound(id.begin(), id.end(), k) - id.begin());
  };
  Contacts c;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::uint32_t ib = b[i] >= wall_base ? static_cast<std::uint32_t>(b[i] - wall_base) : index(b[i]);
    c.list({a[i], b[i], part[i]}, index(a[i]), ib, {vector_at(force_t, i), overlap[i], vector_at(normal, i), twist[i]},
           vector_at(force, i));
  }
  if (file.has(at + "/part_a")) {
    const auto part_a = file.get<std::uint32_t>(at + "/part_a");
    for (std::size_t i = 0; i < a.size(); ++i) c.key[i].part_a = part_a[i];
    c.share = file.get<double>(at + "/share");
  }
  if (file.has(at + "/centre")) {
    const auto centre = file.get<double>(at + "/centre");
    for (std::size_t i = 0; i < a.size(); ++i) c.centre.push_back(vector_at(centre, i));
    c.cache.assign(a.size(), {});
  }
  if (file.has(at + "/memory") && !a.empty()) {
    c.memory = file.get<double>(at + "/memory");
    c.words = record_words(world);
    if (c.memory.size() != c.words * a.size()) throw RunError("the record's frame " + at + " is damaged: memory");
  }
  world.contacts = std::move(c);
}

}  // namespace

Record::Record(const std::string& path, const World& world, bool append) : path_(path) {
  if (append) {
    hdf5::File(path_, hdf5::Access::read).children("/frames");  // it must be one of ours
    return;
  }
  hdf5::File file(path_, hdf5::Access::create);
  file.put_attribute("/", "scene", scene_to_toml(world.scene));
  file.put_attribute("/", "version", version);
  file.put_attribute("/", "seed", world.scene.run.seed);
  file.make_group("/frames");
  file.flush();
}

void Record::write(const World& world) {
  hdf5::File file(path_, hdf5::Access::write);
  const std::string at = "/frames/" + name_of(world.step), aside = "/writing";
  if (file.has(at)) return;                 // a frame is a function of its step: written once, it stays
  if (file.has(aside)) file.remove(aside);  // of a run that was killed while it wrote
  file.make_group(aside);
  file.put_attribute(aside, "step", world.step);
  file.put_attribute(aside, "time", world.time());
  put_particles(file, aside, world);
  if (world.cell.periodic) {
    const std::array<Vec3d, 2> box{world.cell.lower, world.cell.lattice.length};
    file.put(aside + "/cell", rows(box, [](const Vec3d& v) { return v; }), 3);
  }
  file.make_group(aside + "/walls");
  put_walls(file, aside + "/walls", world.walls);
  file.make_group(aside + "/contacts");
  put_contacts(file, aside + "/contacts", world);
  file.rename(aside, at);
  file.flush();
}

void Record::truncate_after(std::uint64_t step) {
  hdf5::File file(path_, hdf5::Access::write);
  for (const std::string& name : file.children("/frames"))
    if (name > name_of(step)) file.remove("/frames/" + name);
  file.flush();
}

int frame_count(const std::string& record_path) {
  return static_cast<int>(hdf5::File(record_path, hdf5::Access::read).children("/frames").size());
}

void load_frame(const std::string& record_path, World& world, int frame) {
  const hdf5::File file(record_path, hdf5::Access::read);
  const auto names = file.children("/frames");
  if (frame < 0 || static_cast<std::size_t>(frame) >= names.size())
    throw RunError(fmt::format("frame {} is not in {}: it has frames 0 to {}", frame, record_path,
                               static_cast<long>(names.size()) - 1));
  const std::string at = "/frames/" + names[static_cast<std::size_t>(frame)];
  get_particles(file, at, world);
  if (file.has(at + "/cell")) {
    const auto box = file.get<double>(at + "/cell");
    if (box.size() != 6) throw RunError("the record's frame " + at + " is damaged: cell");
    world.cell.set_lengths(vector_at(box, 1));
  }
  get_walls(file, at + "/walls", world.walls);
  get_contacts(file, at + "/contacts", world);
  world.step = file.attribute(at, "step");
}

}  // namespace dem::io
