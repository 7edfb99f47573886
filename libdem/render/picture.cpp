// From a world to what is drawn, and the files of pictures.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <png.h>

#include <algorithm>
#include <cmath>

#include "libdem/io/files.h"
#include "libdem/parts.h"
#include "libdem/render/render.h"

namespace dem::render {

namespace {

// Sum of the magnitudes of the contact forces on each particle, N: the force chains show.
std::vector<double> contact_load(const World& world) {
  std::vector<double> load(world.particles.count(), 0.0);
  const Contacts& c = world.contacts;
  for (std::size_t i = 0; i < c.key.size(); ++i) {
    if (!c.touching[i]) continue;
    const double f = norm(c.slot[c.slot_of(i)].force);
    load[c.index_a[i]] += f;
    if (c.key[i].b < wall_base) load[c.index_b[i]] += f;
  }
  return load;
}

template <class Entries>
std::vector<std::string> names_of(const Entries& entries) {
  std::vector<std::string> names;
  for (const auto& e : entries) names.push_back(e.name);
  return names;
}

// A line is seen edge-on from the front of a plane scene: its solid shows instead, as a strip along it, behind the
// bodies and facing the eye.
void to_strip(io::WallSurface& s, const io::Box& box, const Vec3d& look) {
  const double depth = 0.02 * box.radius(), z = look.z < 0 ? box.lower.z : box.upper.z;
  const Vec3d along{s.normal.y, -s.normal.x, 0};
  const auto before = [&](const Vec3d& a, const Vec3d& b) { return dot(along, a) < dot(along, b); };
  const auto [first, last] = std::minmax_element(s.vertices.begin(), s.vertices.end(), before);
  Vec3d a = *first - along * depth, b = *last + along * depth;  // corners of a box close
  a.z = b.z = z;
  s.vertices = {a, b, b - s.normal * depth, a - s.normal * depth};
  s.corners = {0, 1, 2, 3};
  s.ends = {4};
  s.outline = {1, 1, 1, 1};
  s.normal = {0, 0, look.z < 0 ? 1.0 : -1.0};
}

// A polygon shows its area, as opaque as the solid of a line.
void to_plate(io::WallSurface& s, const Vec3d& look) {
  s.half_space = true;
  s.normal = {0, 0, look.z < 0 ? 1.0 : -1.0};
}

std::size_t place_in_scene(const Scene& scene, const std::string& shape) {
  std::size_t i = 0;
  while (i + 1 < scene.shapes.size() && scene.shapes[i].name != shape) ++i;
  return i;
}

}  // namespace

const std::vector<std::string>& color_names() {
  static const std::vector<std::string> names{"speed", "id", "shape", "size", "material", "species", "force"};
  return names;
}

Picture picture_of(const World& world, const View& view) {
  const auto& known = color_names();
  if (!view.colouring && std::find(known.begin(), known.end(), view.color_by) == known.end())
    throw RunError(fmt::format("unknown colour '{}'; known: {}", view.color_by, fmt::join(known, ", ")));
  const std::string by = view.colouring ? "" : view.color_by;
  const Particles& p = world.particles;
  if (view.colouring && view.colouring->values.size() != p.count())
    throw RunError("colours of a picture: not as many as there are bodies");
  Picture picture;
  const double g = norm(world.scene.gravity);
  if (world.scene.dimension == 2) picture.up = {0, 1, 0};
  if (g > 0) picture.up = world.scene.gravity * (-1 / g);
  const io::Box box = view.box ? *view.box : picture_box(world);
  picture.walls = io::wall_surfaces(world, box);
  if (view.orthographic && std::abs(view.orthographic->z) > 0.9 * norm(*view.orthographic))
    for (io::WallSurface& s : picture.walls) {
      const Wall& wall = world.walls[s.wall];
      if (wall.kind == shapes::Kind::line) to_strip(s, box, *view.orthographic);
      if (wall.kind == shapes::Kind::polygon) to_plate(s, *view.orthographic);
    }
  for (io::WallSurface& c : io::cell_surfaces(world)) picture.walls.push_back(std::move(c));
  if (by == "shape") picture.names = names_of(world.scene.shapes);
  if (by == "material") picture.names = names_of(world.scene.materials);
  if (by == "species") {
    picture.names = names_of(world.scene.species);
    picture.names.insert(picture.names.begin(), "none");
  }
  picture.label = by == "speed"   ? "speed (m/s)"
                  : by == "size"  ? "diameter (m)"
                  : by == "force" ? "contact forces (N)"
                                  : by;
  if (view.colouring) {
    picture.names = view.colouring->names;
    picture.label = view.colouring->label;
  }
  const std::vector<double> load = by == "force" ? contact_load(world) : std::vector<double>{};
  std::size_t place = 0;
  for (const std::uint32_t i : order_by_id(world)) {
    const ShapeEntry& shape = world.shapes[p.shape[i]];
    const double value = view.colouring     ? view.colouring->values[place++]
                         : by == "speed"    ? norm(p.motion[i].velocity)
                         : by == "id"       ? static_cast<double>(p.id[i])
                         : by == "shape"    ? static_cast<double>(place_in_scene(world.scene, shape.family))
                         : by == "size"     ? 2 * p.motion[i].equivalent_radius
                         : by == "material" ? p.material[i]
                         : by == "species"  ? p.species[i]
                                            : load[i];
    if (shape.compound == nullptr) {
      picture.bodies.push_back({shape.kind, shape.drawn(), p.size[i], p.motion[i].position, p.orientation[i], value});
      continue;
    }
    const Mat3d rotation = rotation_matrix(p.orientation[i]);
    for (const auto& part : shape.compound->parts)
      picture.bodies.push_back({kind_of(part.kind), part.solid.get(), part.size * p.size[i].x,
                                p.motion[i].position + rotation * (part.centre * p.size[i].x),
                                p.orientation[i] * part.orientation, value});
  }
  return picture;
}

io::Box picture_box(const World& world) {
  const io::Box particles = io::particle_box(world);
  io::Box all = particles;
  for (const io::WallSurface& s : io::wall_surfaces(world, io::scene_box(world)))
    if (!s.half_space)
      for (const Vec3d& v : s.vertices) all.add(v);
  if (world.cell.periodic) {
    const io::Box cell = io::cell_box(world);
    all.add(cell.lower);
    all.add(cell.upper);
  }
  if (particles.empty) return all.empty ? io::scene_box(world) : all;
  return all.radius() <= 4 * particles.radius() ? all : particles;
}

Image draw(const World& world, const View& view) {
  View framed = view;
  if (!framed.box) framed.box = picture_box(world);
  if (world.scene.dimension == 2 && !framed.orthographic) framed.orthographic = Vec3d{0, 0, -1};
  return draw(picture_of(world, framed), framed);
}

void write_png(const std::string& path, const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = 0;
  const auto encode = [&](void* to) {
    return png_image_write_to_memory(&header, to, &size, 0, image.rgb.data(), 0, nullptr);
  };
  std::vector<std::uint8_t> bytes;
  if (encode(nullptr) != 0) {
    bytes.resize(size);
    if (encode(bytes.data()) != 0) {
      bytes.resize(size);
      io::write_file(path, bytes, io::Durability::renamed);
      return;
    }
  }
  throw RunError("cannot encode the picture " + path + ": " + header.message);
}

}  // namespace dem::render
