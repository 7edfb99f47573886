// The world: everything that a step reads and writes, and that a checkpoint holds.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "libcontact/contact.h"
#include "libcontact/laws/ledger.h"
#include "libcontact/laws/model.h"
#include "libdem/accumulator.h"
#include "libdem/cell.h"
#include "libdem/contacts.h"
#include "libdem/events/condition.h"
#include "libdem/particles.h"
#include "libdem/profile.h"
#include "libdem/scene/scene.h"
#include "libdem/wall_load.h"

namespace dem {

struct ShapeEntry {  // a named shape of the scene, at scale 1
  std::string name;
  std::string family;  // the shape of the scene; its variants have names of their own
  shapes::Kind kind = shapes::Kind::sphere;
  std::shared_ptr<const shapes::Polyhedron> polyhedron;        // of polyhedra; of rounded ones the core
  std::shared_ptr<const shapes::Polygon> polygon;              // kind polygon only; its centroid is the origin
  std::shared_ptr<const shapes::PotentialParticle> potential;  // kind potential_particle only
  std::shared_ptr<const shapes::Polyhedron> drawing;           // of rounded bodies and polygons: what pictures show
  std::shared_ptr<const shapes::Compound> compound;            // kind compound only
  // Sphere (r, r, r), ellipsoid semi-axes, rounded polyhedron (1, rounding, 0), others (1, 1, 1).
  Vec3d size{};
  double volume = 0;                              // m³; of a prism: area times thickness
  int mass_power = 3;                             // mass grows as scale^3, that of a prism as scale^2
  double equivalent_radius = 0;                   // m, of the sphere of equal volume; of a prism: disc of equal area
  Vec3d inertia{};                                // principal, per unit density, m⁵
  double circumradius = 0, inscribed_radius = 0;  // m
  double overlap_radius = 0;                      // m, by which overlaps at the start are judged
  const void* geometry() const {                  // as contact::Body holds it
    if (potential) return potential.get();
    return polygon ? static_cast<const void*>(polygon.get()) : polyhedron.get();
  }
  // What is drawn, to be scaled by the first component of a body's size; null: round.
  const shapes::Polyhedron* drawn() const { return drawing ? drawing.get() : polyhedron.get(); }
  bool meets_in_regions() const { return polygon && !polygon->convex; }
};

struct Wall {
  std::string name;
  shapes::Kind kind = shapes::Kind::plane;
  std::uint32_t material = 0;
  std::shared_ptr<const shapes::Mesh> mesh;        // kind mesh; of a polygon: its area, for files and pictures
  std::shared_ptr<const shapes::Polygon> polygon;  // kind polygon: its centroid is the origin
  WallSpec motion;                                 // prescribed motion
  Vec3d position{};                                // of its origin, m (mesh: body frame origin; plane: a point on it)
  Quatd orientation{};                             // body -> world
  Vec3d velocity{}, spin{};                        // of its origin, m/s; rad/s
  Vec3d reference{};                               // position at t = 0
  Quatd reference_orientation{};
  bool present = true;
  bool unchecked = false;  // inserted by an event, not yet tried against the bodies
  double extent = 0;       // m, largest distance of a mesh vertex from the origin
  double allowance = 0;    // m, as Contacts::allowance
  Vec3d list_position{};   // at the last rebuild of the list
  Quatd list_orientation{};
  Vec3d force{}, torque{};  // of the particles on the wall, this step: N, N m about its origin
  WallLoad load;            // summed over time
  Vec3d push{};             // servo: unit, along which it pushes
  double target = 0;        // servo: N
  double resistance = 0;    // servo: N s/m, of the bodies that it last touched; see walls.cpp
  double travel = 0;        // as Contacts::travel; infinite of half-spaces that turn
  Vec3d seen_position{};    // up to where `travel` goes
  Quatd seen_orientation{};
  bool meets_in_regions() const { return polygon && !polygon->convex; }
};

struct Counters {
  std::uint64_t rebuilds = 0, candidates = 0, queries = 0, contact_steps = 0, not_converged = 0, uncertified = 0,
                handed_over = 0;
  std::uint64_t deleted = 0, inserted = 0;
};

struct Balance {                                 // momentum and energy book-keeping over the whole run
  std::array<Accumulator, 3> impulse;            // ∫(external forces) dt: gravity and walls, N s
  std::array<Accumulator, 3> removed_momentum;   // carried out by deleted and recycled bodies, kg m/s
  std::array<Accumulator, 3> inserted_momentum;  // brought in by rain and recycled bodies, kg m/s
  std::array<double, 3> initial_momentum{};
  Accumulator present;                                           // mass of the bodies present, kg
  double removed_mass = 0, inserted_mass = 0, initial_mass = 0;  // kg; recycling neither removes nor inserts mass
  std::uint64_t inserted_count = 0;
  // Work of the contacts that are over, by mechanism, J; of law.ledger.
  std::array<Accumulator, contact::mechanism_count> lost{};
};

struct OutletRecord {
  std::string name;
  std::uint64_t count = 0;
  double mass = 0;                        // kg
  std::vector<std::uint64_t> by_species;  // counts; first: of none
  std::uint64_t tries = 0, waits = 0;     // recycling: positions tried; steps that a body waited for one
};

struct DischargePoint {
  double time;
  std::uint64_t count;  // by all outlets, as is the mass
  double mass;
  std::uint32_t outlet = 0, species = 0;  // of the body that left
};

struct RainRecord {
  std::string name;
  std::uint64_t active = 1, count = 0, tries = 0;
  std::uint64_t waits = 0;  // steps at which a body found no free place
  double mass = 0;          // kg
  double since = 0;         // s, when it was last started, and what it had made by then
  std::uint64_t count_before = 0;
  double mass_before = 0;
};

struct EventRecord {
  std::string name;
  std::uint64_t met = 0, done = 0;  // steps at which its condition held and it happened; 0: not yet
};

struct PhaseTimes {                  // wall seconds
  std::uint64_t particle_steps = 0;  // in that time
  double broad = 0, query = 0, integrate = 0, walls = 0, output = 0, loop = 0;
};

struct TimeStep {          // how dt was found
  double dt = 0;           // s
  double limit = 0;        // s, the smallest stability limit
  std::string limited_by;  // one clause: which pair of kinds and which mode
};

struct ListLife {           // of the list of candidates, where the skin is tuned; see allowance.h
  double steps = 16;        // that the list is to last
  std::uint64_t since = 0;  // the step at which it was made
};

struct World {
  Scene scene;
  std::vector<ShapeEntry> shapes;
  std::vector<Material> materials;
  std::vector<PairParameters> pairs;  // materials², row-major: how i meets j
  contact::LawModel law;
  contact::LawOptions law_options;
  Particles particles;
  std::vector<Wall> walls;
  Contacts contacts;
  Cell cell;
  TimeStep time_step;
  double skin = 0;                                                  // m; where it is tuned, of bodies at rest
  ListLife list_life;                                               // not part of the state
  double tightest_limit = std::numeric_limits<double>::infinity();  // s, seen by the monitor of the time step
  std::uint64_t step = 0;
  std::uint64_t next_id = 0;
  Counters counters;
  Balance balance;
  Vec3d drag_force{};  // on all bodies together, this step, N
  std::vector<OutletRecord> outlets;
  std::vector<DischargePoint> discharge;  // one entry for each body that left
  std::vector<RainRecord> rains;
  std::vector<EventRecord> events;
  std::vector<Condition> conditions;  // of the events; not part of the state
  Condition until;
  std::uint64_t ended_by = 0;  // 0: not yet; 1: run.until; 2 + i: event i
  bool ahead = false;          // the bodies stand where the next step's drift has taken them; see advance()
  PhaseTimes times;            // not part of the state, nor is the next
  Profile profile;
  double time() const { return static_cast<double>(step) * time_step.dt; }
};

// Builds the world of a scene: shapes, masses, bodies, walls, dt. Throws InputError (bad mesh, initial overlap, …).
World build_world(const Scene& scene);
// An interval of time as whole steps, so that a resumed run meets the same steps; 0: never.
std::uint64_t steps_between(double interval, double dt);
// The number of steps that run.time or run.steps asks for.
std::uint64_t total_steps(const World& world);
// Whether the run has come to its end: these steps, run.until, or an event that stops it; and which of the latter two.
bool finished(const World& world);
std::string ended_by(const World& world);
// Advances by one step. threads >= 1; `more`: another step follows before anything looks at the bodies, whose poses and
// velocities may then be those of that step already. Throws RunError when a monitored bound is passed or a value is not
// finite.
void advance(World& world, int threads, bool more = false);

struct RunError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A touching contact as output sees it.
struct ContactReport {
  std::uint64_t a, b;  // ids; b = wall index when wall
  bool wall;
  std::uint32_t part, part_a;  // as in Key
  double overlap;              // m
  Vec3d normal, point;         // point in world coordinates, m
  Vec3d force;                 // on a, N
  Vec3d tangential;            // its tangential part, N
};
std::vector<ContactReport> touching_contacts(const World& world);

// "none" for 0.
const std::string& species_name(const World& world, std::uint32_t species);
// Storage indices of the particles in order of id.
std::vector<std::uint32_t> order_by_id(const World& world);

struct Energies {  // J
  double translational = 0, rotational = 0, potential = 0;
  double elastic = 0;  // of the contacts, adhesive included (< 0)
};
Energies energies(const World& world);
// What contacts have lost up to now, J, by mechanism; zeros without law.ledger.
std::array<double, contact::mechanism_count> dissipated(const World& world);
Vec3d momentum(const World& world);                // kg m/s
double contacts_per_particle(const World& world);  // touching pairs without walls, divided by particles
std::uint64_t state_hash(const World& world);

// Everything that a resume needs, as bytes, in pieces or at once; load_state goes into a world freshly built from the
// same scene.
using Sink = std::function<void(std::span<const std::uint8_t>)>;
void save_state(const World& world, const Sink& sink);
std::vector<std::uint8_t> save_state(const World& world);
void load_state(World& world, const std::vector<std::uint8_t>& bytes);

}  // namespace dem
