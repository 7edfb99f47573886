// Shapes of parts of a scene: clumps of spheres, unions of other shapes.
#include <algorithm>

#include "libdem/build.h"
#include "libdem/io/io.h"
#include "shapes/compound_build.h"
#include "shapes/geometry.h"
#include "shapes/polyhedron_build.h"

namespace dem {
namespace {

shapes::CompoundPart part_of(const PartSpec& part, const Scene& scene) {
  const auto spec =
      std::find_if(scene.shapes.begin(), scene.shapes.end(), [&](const ShapeSpec& s) { return s.name == part.shape; });
  if (spec == scene.shapes.end()) throw shapes::Error("the part \"" + part.shape + "\" is not defined");
  const shapes::Pose pose{part.position, part.orientation};
  if (spec->kind == "sphere") return {shapes::Sphere{spec->radius}, pose};
  if (spec->kind == "ellipsoid") return {shapes::Ellipsoid{spec->semi_axes}, pose};
  return {polyhedron_of(*spec, shapes::Frame::as_given), pose};
}

std::vector<std::array<double, 4>> spheres_of_file(const std::string& path) {
  const io::Table table = io::read_csv(path);
  std::size_t columns[4];
  constexpr const char* names[] = {"x", "y", "z", "radius"};
  for (std::size_t k = 0; k < 4; ++k) columns[k] = io::column(table, names[k]);
  std::vector<std::array<double, 4>> spheres;
  for (std::size_t r = 0; r < table.row_count(); ++r) {
    auto& ball = spheres.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) ball[k] = io::number(table, r, columns[k]);
    if (!(ball[3] > 0))
      input_error(table.where(r, columns[3]), "radius = " + table.cell(r, columns[3]) + ": allowed radius > 0");
  }
  if (spheres.empty()) input_error({path, table.header_line, 1}, "the file has no spheres");
  return spheres;
}

shapes::Compound clump_of(std::vector<std::array<double, 4>> spheres, double diameter) {
  std::vector<shapes::CompoundPart> parts;
  const auto make = [&](double scale) {
    parts.clear();
    for (const auto& ball : spheres)
      parts.push_back({shapes::Sphere{scale * ball[3]}, {scale * Vec3d{ball[0], ball[1], ball[2]}, {}}});
    return shapes::make_compound(parts);
  };
  shapes::Compound body = make(1);
  return diameter > 0 ? make(diameter / (2 * shapes::equivalent_radius(body.mass.volume))) : body;
}

shapes::Compound body_of(const ShapeSpec& s, const Scene& scene) {
  if (s.kind == "clump")
    return clump_of(s.spheres_file.empty() ? s.spheres : spheres_of_file(s.spheres_file), s.diameter);
  std::vector<shapes::CompoundPart> parts;
  for (const PartSpec& part : s.parts) parts.push_back(part_of(part, scene));
  return shapes::make_compound(parts);
}

}  // namespace

void make_body_of_parts(const ShapeSpec& s, const Scene& scene, ShapeEntry& e) {
  shapes::Compound body = body_of(s, scene);
  if (body.parts.size() == 1) {
    const shapes::Compound::Part& only = body.parts[0];
    if (only.kind == shapes::Compound::PartKind::sphere) return make_sphere(only.size.x, e);
    if (only.kind == shapes::Compound::PartKind::ellipsoid) return make_ellipsoid(only.size, e);
    return make_solid(*only.solid, e);
  }
  e.kind = shapes::Kind::compound;
  e.size = {1, 1, 1};
  set_mass_properties(body.mass, e);
  e.circumradius = body.circumradius;
  e.inscribed_radius = body.parts[0].inscribed_radius;
  for (const auto& part : body.parts) e.inscribed_radius = std::min(e.inscribed_radius, part.inscribed_radius);
  e.compound = std::make_shared<const shapes::Compound>(std::move(body));
}

}  // namespace dem
