// A scene as resolved: every value present, checked, in SI units. The schema table (scene/schema.cpp) is the one place
// that states each key's name, type, unit, range, default and meaning; this struct only holds the values.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "libdem/scene/scene_insertion.h"
#include "shapes/math/quat.h"

namespace dem {

using shapes::Quatd;
using shapes::Vec3d;

struct RunSpec {
  double time = 0;  // s; 0 when `steps` is given instead
  std::uint64_t steps = 0;
  bool dt_auto = true;
  double dt = 0;                    // s, when not auto
  double dt_fraction = 0.1;         // of the smallest stability limit
  double dt_overlap = 0.01;         // overlap / smaller radius at which nonlinear laws are judged
  int dt_contacts = 6;              // contacts per body whose stiffness rows are summed
  double skin = -1;                 // m; < 0: auto
  std::uint64_t rebuild_every = 0;  // steps; 0: when a body has moved by half the skin; 1: every step
  std::uint64_t seed = 1;
  bool turn_spheres = true;             // false: orientations of spheres and discs, which no contact asks for, stay
  std::string until;                    // condition that ends the run before its time; see libdem/events/condition.h
  std::uint64_t check_every = 100;      // steps between looks at the conditions of `until` and of events
  double max_initial_overlap = 0.05;    // of the smaller inscribed radius
  double max_uncertified_share = 1e-4;  // of contact-steps
};

struct OutputSpec {
  double interval = 0;             // s between frames; 0: only the first and last
  double checkpoint_interval = 0;  // s of simulated time; 0: at the end and on interrupt only
  double cell_interval = 0;        // s between rows of cell.csv; 0: with the frames
  double walls_interval = 0;       // s between rows of walls.csv; 0: with the frames
  bool vtk = true, hdf5 = true, picture = true, walls = true;
};

struct AnalysisSpec {                    // what a run finds out about itself as it goes; see libdem/analysis
  std::vector<std::string> what;         // quantities; empty: none
  double interval = 0;                   // s between rows; 0: with the frames
  Vec3d boxes{};                         // along x, y, z; 0: about four mean diameters each
  Vec3d region_lower{}, region_upper{};  // m; equal: everything
  int bins = 36, rdf_bins = 200, voronoi_points = 0;
  double rdf_range = 0;  // m; 0: five mean diameters
  std::string split = "species";
  double strong_force = 1;
  std::string base_wall;  // empty: the lowest
};

struct MaterialSpec {
  std::string name;
  double young = 0;        // Pa
  double poisson = 0.3;    // –
  double density = 0;      // kg/m³
  double restitution = 1;  // –, 1 = undamped
  double friction = 0;     // –
  double stiffness = 0;    // N/m, linear laws only
  bool rigid = false;      // out of both E* and G*
  // Of some laws only; contact::Material says what they are.
  double viscous_time = 0, yield_pressure = 0, work_of_adhesion = 0;        // s, Pa, J/m²
  double surface_energy = 0;                                                // J/m², half the work of adhesion
  double plastic_stiffness = 0, adhesive_stiffness = 0, plastic_depth = 0;  // N/m, N/m, –
  double rolling_friction = 0, rolling_viscosity = 0, rolling_damping = 0;  // –, s/m, –
  double twisting_friction = 0;                                             // –
  double cohesion = 0;                                                      // N
  double contact_angle = 0;                                                 // rad
  std::string like;    // a named material; its values are in the members above
  std::string source;  // of the values that come from it; no key
  Where where;
};

struct MaterialPairSpec {  // overrides what mixing would give; NaN = mixed
  std::string a, b;
  double restitution = std::numeric_limits<double>::quiet_NaN();
  double friction = std::numeric_limits<double>::quiet_NaN();
  double stiffness = std::numeric_limits<double>::quiet_NaN();
  double work_of_adhesion = std::numeric_limits<double>::quiet_NaN();
  double rolling_friction = std::numeric_limits<double>::quiet_NaN();
  double twisting_friction = std::numeric_limits<double>::quiet_NaN();
  double cohesion = std::numeric_limits<double>::quiet_NaN();
  std::string published;  // name of a published friction coefficient; its value is in `friction`
  std::string source;     // of that value; no key
  Where where;
};

// The named combinations, in the order of contact::named_laws.
enum class LawName {
  linear_spring,
  spring_dashpot,
  hertz_mindlin,
  hertz_mindlin_deresiewicz,
  mindlin_deresiewicz_exact,
  jkr_thornton,
  partially_latching_spring,
  thornton_ning,
  thornton_ning_adhesive,
  viscoelastic_hertz,
  adhesive_plastic_spring,
  dmt,
};
inline constexpr std::size_t law_name_count = 12;

// How a law of spheres finds its radius on other bodies: law_map.h.
enum class LawMap { automatic, equivalent_radius, curvature, edge_radius, volume };

struct LawSpec {
  LawName name = LawName::hertz_mindlin;
  std::string normal, tangential, rolling, cohesion;  // in place of those of the combination; empty: its own
  LawMap map = LawMap::automatic;
  double edge_radius = 0;      // m, of map edge_radius
  bool rescale = true;         // shorten the tangential spring when the contact radius shrinks
  bool clip = true;            // contacts end at zero force, else at zero overlap
  bool deficit = false;        // mindlin_deresiewicz: remember the slip that an increment did not make
  bool ledger = false;         // book the work of every mechanism
  double reference_speed = 0;  // m/s: stiffness of linear laws from moduli, bodies and this, (9.22); 0: as given
  double surface_tension = 0;  // N/m, liquid bridges
  double bridge_volume = 0;    // m³, of one bridge
};

struct PartSpec {
  std::string shape;  // name of another one
  Vec3d position{};   // of its origin, m
  Quatd orientation{};
};

// sphere: radius. ellipsoid: semi_axes. box: extents. prism: sides, circumradius, height. tetrahedron … icosahedron:
// circumradius. clump: spheres, or spheres_file. union: parts. In the plane: disc: radius; ellipse: semi_axis_a,
// semi_axis_b; polygon: vertices in order, or pieces; regular_polygon: sides, circumradius. polyhedron: vertices, or
// half_spaces, or file (OFF, OBJ, STL); `diameter` > 0 rescales a polyhedron or clump so that its volume-equivalent
// sphere has this diameter. `rounding` > 0 rounds edges and corners of all flat-faced kinds of space: the body is every
// point within this distance of the polyhedron, `diameter` that of the whole. potential_particle: half_spaces, k, r, R
// (shapes/potential_particle.h), and `diameter`. generated, voronoi: `variants` grains by random numbers
// (shapes/generate.h), each of this diameter.
struct ShapeSpec {
  std::string name, kind;
  double radius = 0;
  Vec3d semi_axes{}, extents{};
  double semi_axis_a = 0, semi_axis_b = 0;
  int sides = 0;
  double circumradius = 0, height = 0;
  std::vector<Vec3d> vertices;
  std::vector<std::vector<Vec3d>> pieces;          // polygon: outlines that are welded into one
  std::vector<std::array<double, 4>> half_spaces;  // nx, ny, nz, offset
  std::string file;                                // resolved path
  double diameter = 0;                             // m
  double rounding = 0;                             // m, 0: sharp
  double k = 0, r = 0, R = 0;                      // potential_particle: –, m, m
  std::vector<std::array<double, 4>> spheres;      // clump: x, y, z, radius, m
  std::string spheres_file;                        // or a CSV file of them, resolved path
  std::vector<PartSpec> parts;                     // union
  std::string statistic, set;                      // generated: resolved path; rows of it, empty: all
  int variants = 64, relaxations = 0;              // generated, voronoi; voronoi
  Where where;
};

enum class WallMotion { fixed, translation, rotation, oscillation, table, servo };

// Kinds: plane; mesh from a file or from vertices and triangles; or a mesh made of a few numbers
// (shapes/mesh_generate.h): panel, box, cylinder, cone, drum, die, v_shell. A generated mesh stands in world
// coordinates: its origin is theirs.
struct WallSpec {
  std::string name, kind;
  std::string material;
  Vec3d point{}, normal{0, 0, 1};  // plane, line
  std::string file;                // mesh, resolved path; or vertices + triangles
  double scale = 1;
  std::vector<Vec3d> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  double depth = 0;                        // polyline: of the solid behind it, m
  bool closed = false;                     // polyline: its last vertex is joined to the first
  Vec3d corner{}, side_1{}, side_2{};      // panel: m
  Vec3d lower{}, upper{};                  // box, die: m
  std::vector<std::string> open;           // faces left out
  Vec3d base{}, top{};                     // cylinder, cone, drum: centres of the ends; v_shell: base is its centre, m
  double radius = 0;                       // cylinder, drum, v_shell: m
  double base_radius = 0, top_radius = 0;  // cone: m
  double flange = 0;                       // die: m
  double angle = 0, length = 0;            // v_shell: rad, m
  std::uint32_t segments = 48;             // facets around
  WallMotion motion = WallMotion::fixed;
  Vec3d velocity{};                                  // translation: m/s
  Vec3d axis{}, centre{};                            // rotation, table; servo: direction of the push
  double rate = 0;                                   // rotation: rad/s
  Vec3d amplitude{};                                 // oscillation: x = amplitude sin(2π f t + phase), m
  double frequency = 0, phase = 0;                   // Hz, rad
  std::vector<std::array<double, 4>> displacements;  // table: time since `start` (s), displacement (m)
  std::vector<std::array<double, 2>> turns;          // table: time since `start` (s), angle about the axis (rad)
  std::string table_file;                            // table: CSV in place of both
  double target_force = 0, target_pressure = 0;      // servo: N; Pa
  double area = 0;                                   // servo: m², 0 = of the mesh, seen along the axis
  double speed_limit = 0;                            // servo: m/s
  double gain = 1;                                   // servo
  double start = 0, stop = std::numeric_limits<double>::infinity();  // s, when it moves
  bool pressure_map = false;                                         // meshes, planes
  double map_cell = 0;                                               // plane: side of the squares of its map, m
  bool present = true;                                               // at the start; an event may insert or remove it
  double remove_at = std::numeric_limits<double>::infinity();        // s: the wall disappears (a gate)
  Where where;
};

struct BodySpec {
  std::string shape, material;
  std::string species{};  // empty: none
  double scale = 1;
  Vec3d position{}, velocity{}, spin{};
  Quatd orientation{};
  Where where;
};

// CSV or CSV.gz with a header line (after # comments): x, y, z and radius (spheres) or scale; optional qw qx qy qz vx
// vy vz wx wy wz shape material.
struct CsvSpec {
  std::string file;
  std::string shape, material;
  Where where;
};

struct DeformSpec {                  // how the periodic box deforms from a time on, until the next one
  double start = 0;                  // s
  Vec3d strain_rates{};              // 1/s, of the lengths over the lengths; negative compresses
  std::string stress_axes = "none";  // the letters of those axes whose rate follows the stress instead
  Vec3d target_stress{};             // Pa, compression positive
  double rate_limit = 0;             // 1/s
  double gain = 1;
  bool isotropic = false;  // one rate for all stress_axes, after the mean of their stresses
  Where where;
  bool follows(int axis) const { return stress_axes != "none" && stress_axes.find("xyz"[axis]) != std::string::npos; }
};

struct PeriodicSpec {         // a box whose opposite faces are one face
  std::string axes = "none";  // the letters of those axes
  Vec3d lower{}, upper{};     // its corners; only their components along `axes` count
  std::vector<DeformSpec> deform;
  Where where;
  bool along(int axis) const { return axes != "none" && axes.find("xyz"[axis]) != std::string::npos; }
};

struct DragSpec {            // of a given flow, which the bodies do not change
  std::string law = "none";  // or one of drag_laws (fields/drag.h)
  double density = 0;        // of the fluid, kg/m³
  double viscosity = 0;      // Pa s
  double drag_coefficient = 0;
  Vec3d velocity{};             // of the fluid at the origin, m/s
  std::vector<Vec3d> gradient;  // rows of dv_i/dx_j, 1/s; empty: uniform
};

// Two-dimensional bodies are prisms of the scene's thickness, or (discs only) spheres that move in a plane.
enum class DiscModel { prism, sphere };

struct Scene {
  std::string path;  // file it came from
  std::string title;
  RunSpec run;
  OutputSpec output;
  AnalysisSpec analysis;
  Vec3d gravity{};  // m/s²
  PeriodicSpec periodic;
  DragSpec drag;
  int dimension = 3;
  DiscModel disc_model = DiscModel::prism;
  double thickness = 0;  // m, of the prisms of a two-dimensional scene
  std::string method = "auto";
  double tolerance = 0;  // of the gap, over the smaller circumradius; 0: exact
  LawSpec law;
  std::vector<MaterialSpec> materials;
  std::vector<MaterialPairSpec> pairs;
  std::vector<ShapeSpec> shapes;
  std::vector<WallSpec> walls;
  std::vector<RegionSpec> regions;
  std::vector<SpeciesSpec> species;
  std::vector<FillSpec> fills;
  std::vector<RainSpec> rains;
  std::vector<BodySpec> bodies;
  std::vector<CsvSpec> csv;
  std::vector<OutletSpec> outlets;
  std::vector<EventSpec> events;
};

// Parses a scene file with `key=value` overrides (--set); throws InputError. Paths inside are relative to the file.
Scene load_scene(const std::string& path, const std::vector<std::string>& overrides = {});
// The scene as TOML that parses back to the same scene (17 digits); written into the run's folder.
std::string scene_to_toml(const Scene& scene);

}  // namespace dem
