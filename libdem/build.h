// The pieces of build_world.
#pragma once

#include "libdem/random.h"
#include "libdem/world.h"
#include "shapes/polyhedron.h"

namespace dem {

// One entry, or all the variants of kinds generated and voronoi.
std::vector<ShapeEntry> make_shapes(const ShapeSpec& spec, const Scene& scene);
// Of these kinds: grains of unit diameter, a function of the scene's seed and the place of the shape in it alone.
std::vector<shapes::Polyhedron> generated_grains(const ShapeSpec& spec, const Scene& scene);
// A polyhedron of a scene, its file or vertices as given or in its principal frame.
shapes::Polyhedron polyhedron_of(const ShapeSpec& spec, shapes::Frame frame);
// Kinds clump and union; what turns out to be a single sphere, ellipsoid or polyhedron becomes that.
void make_body_of_parts(const ShapeSpec& spec, const Scene& scene, ShapeEntry& entry);
// A shape of one polyhedron, in its principal frame.
void make_solid(shapes::Polyhedron polyhedron, ShapeEntry& entry);
void make_sphere(double radius, ShapeEntry& entry);
void make_ellipsoid(const Vec3d& semi_axes, ShapeEntry& entry);
void set_mass_properties(const shapes::MassProperties& mass, ShapeEntry& entry);
Wall make_wall(const WallSpec& spec, std::uint32_t material);

// Appends a body; `where` is kept by the caller for messages. scale multiplies the shape's size.
void add_particle(World& world, std::uint32_t shape, std::uint32_t material, double scale, const Vec3d& position,
                  const Quatd& orientation, const Vec3d& velocity, const Vec3d& spin);
// What follows from shape, material, scale, orientation and spin: mass, inertia, radii, angular momentum.
void set_mass(World& world, std::size_t i, double scale);
// Fills a box; throws InputError when the bodies do not fit.
void add_fill(World& world, const FillSpec& spec, std::uint64_t stream);
void add_csv(World& world, const CsvSpec& spec);

// dt from the smallest stability limit of the scene's contacts.
TimeStep choose_time_step(const World& world);
// Normal and tangential stiffness of a touching contact as it is now, N/m.
using contact::Stiffness;
Stiffness contact_stiffness(const World& world, std::size_t record);
// Of the dashpot of a touching contact of two bodies as it is now, 2 β sqrt(m* kn) with m* from the bodies' masses, N
// s/m.
double contact_damping(const World& world, std::size_t record);
// What the body of a touching contact with a wall opposes to the wall's speed: (1 + 2β) sqrt(kn m), N s/m.
double contact_resistance(const World& world, std::size_t record);
// Of a ball inside the body's shape, about its origin, m.
double inscribed_radius(const World& world, std::size_t particle);
// Of a touching contact: midway in the overlap, or the centre of its patch; world coordinates, m.
Vec3d contact_point(const World& world, std::size_t record);
// The limit of a contact by itself at an overlap that it has or had, s.
double contact_limit(const World& world, std::size_t record, double overlap);
// The smallest limit of the contacts as they are now, s; +infinity without contacts.
double present_limit(const World& world, int threads);

double overlap_radius(const World& world, std::size_t i);  // ShapeEntry::overlap_radius of a body, m
// At random in the way of the scene: about z in two dimensions.
Quatd random_orientation(const World& world, Random& random);
// Gives bodies their species: those that are in the region, of the material and of the shape, where they are named.
void tag_species(World& world, const SpeciesSpec& spec);

std::uint32_t species_index(const World& world, const std::string& name, const Where& where);  // "": 0, none
// An entry by its name; of a family the variant that is due to the next body.
std::uint32_t shape_index(const World& world, const std::string& name, const Where& where);
// All the entries of a name: of a family its variants.
std::vector<std::uint32_t> shape_indices(const World& world, const std::string& name, const Where& where);
std::uint32_t material_index(const World& world, const std::string& name, const Where& where);

}  // namespace dem
