// What an analysis sees: bodies, contacts and walls at one time, from a frame of a record, a running world, or the
// output of another code. Every quantity is a pure function of it.
//
//   order      bodies in order of id; contacts in order of the ids of a, then b, walls last, then part
//   contacts   one entry per record: bodies that meet in several places (regions, parts, facets) have several. a is the
//              body of lower id; `branch` and `normal` point from a to b, `force` acts on a
//   plane      z of every vector is 0; volumes are areas times `thickness`, stresses are over it
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libdem/world.h"

namespace dem::analysis {

struct SnapshotContact {
  std::uint32_t a = 0, b = 0;  // places of bodies; b the place of a wall when `wall`
  bool wall = false;
  std::uint32_t part = 0;  // as in Key
  Vec3d normal{};          // unit, from a to b
  Vec3d point{};           // world, m; next to a where the cell is periodic
  Vec3d branch{};          // from a's centre to b's nearest image, m; of a wall to the point
  Vec3d force{};           // on a, N
  double overlap = 0;      // m
  double pressing() const { return -dot(force, normal); }  // normal force, N, >= 0 where the bodies push
};

struct SnapshotWall {
  std::string name;
  shapes::Kind kind = shapes::Kind::plane;
  std::shared_ptr<const shapes::Mesh> mesh;        // of kind mesh; of a polygon: its area
  std::shared_ptr<const shapes::Polygon> polygon;  // kind polygon
  Vec3d position{}, velocity{}, spin{};
  Quatd orientation{};
  bool present = true;
  Vec3d normal() const;  // of a plane or a line, into the free half-space
};

struct Snapshot {
  std::uint64_t step = 0;
  double time = 0;       // s
  int dimension = 3;     // 2: everything in z = 0
  double thickness = 1;  // m, of the prisms of the plane
  Vec3d gravity{};       // m/s²

  // Of the bodies, all of one length.
  std::vector<std::uint64_t> id;
  std::vector<std::uint32_t> shape;     // place in `shapes`
  std::vector<std::uint32_t> material;  // place in `materials`
  std::vector<std::uint32_t> species;   // 0: none; else 1 + place in `species_names`
  std::vector<Vec3d> size;  // as Particles::size: sphere (r, r, r), ellipsoid semi-axes, others the scale first
  std::vector<Vec3d> position, velocity, spin;
  std::vector<Vec3d> rotation;  // accumulated, ∫ω dt, rad
  std::vector<Quatd> orientation;
  std::vector<double> mass, volume;     // kg; m³
  std::vector<double> radius;           // m, of the sphere (prism: disc) of equal volume
  std::vector<double> bounding_radius;  // m

  std::vector<ShapeEntry> shapes;  // at scale 1
  std::vector<std::string> materials, species_names;
  std::vector<SnapshotContact> contacts;
  std::vector<SnapshotWall> walls;

  std::array<bool, 3> periodic{};  // axes
  Vec3d lower{}, length{};         // of the cell along the periodic axes, m

  // Of a running world or a frame of its record, J: stored in contacts. Of the former alone, with law.ledger, lost up
  // to now by contact::Mechanism; else empty.
  std::optional<double> elastic;
  std::vector<double> dissipated;

  bool has_contacts = true;  // false: read from a file without contacts
  bool has_forces = true;    // false: contacts were found from positions and sizes, `force` is zero
  bool has_velocity = true, has_mass = true;
  bool has_rotation = true;        // false: `rotation` is not known and zero; so of velocity and spin, mass
  std::vector<std::string> notes;  // what the source does not say, or what was assumed for it
  std::size_t count() const { return id.size(); }
  const ShapeEntry& shape_of(std::size_t i) const { return shapes[shape[i]]; }
  // From x to the nearest image of y.
  Vec3d between(const Vec3d& x, const Vec3d& y) const;
};

// Of a world as it stands: running, or filled by io::load_frame (whose walls have no velocity, it is not in records).
// Of a layer of spheres in the plane (disc_model "sphere") `volume` is that of the discs, as all else of the plane.
Snapshot snapshot_of(const World& world);

// Region that bodies may be in: the cell along periodic axes, else the box of all bodies and their bounding radii, cut
// by present walls: planes and lines along an axis; and the box around a mesh or polygon wall, at each of its sides
// that all centres of bodies lie beyond or within. No bodies: an empty box.
struct Domain {
  Vec3d lower{}, upper{};                  // m; in the plane z is 0
  double volume(const Snapshot& s) const;  // m³; of the plane: area times thickness
  bool holds(const Vec3d& x) const;        // lower <= x < upper; in the plane of x and y alone
};
Domain domain_of(const Snapshot& snapshot);

}  // namespace dem::analysis
