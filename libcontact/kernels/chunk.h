// Chunks of contacts as structures of arrays: what flows from the gather through the law kernels and back.
// Plain arrays of doubles, no Eigen type: these headers are included by sources compiled per instruction set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "libcontact/export.h"
#include "libcontact/kernels/extreme.h"
#include "libcontact/kernels/lattice.h"
#include "libcontact/kernels/pair_chunks.h"
#include "libcontact/kernels/polygon_chunk.h"
#include "libcontact/kernels/records.h"
#include "libcontact/laws/law.h"

namespace contact::kernels {

inline constexpr std::size_t chunk_size = 32;  // contacts; a multiple of every pack width

using Index = std::uint32_t;

struct alignas(64) Lane {
  double v[chunk_size] = {};
  double& operator[](std::size_t i) { return v[i]; }
  double operator[](std::size_t i) const { return v[i]; }
};
struct Lane3 {
  Lane x, y, z;
};

// Sphere pairs as gathered; `spheres` fills overlap, normal, velocity, turn, R* and m* of a LawChunk from it.
struct SphereChunk {
  Lane3 offset;             // x_b − x_a, m
  Lane inverse_mass;        // the sum of both, 1/kg
  Lane radius_a, radius_b;  // m
  Lane3 spin_a, spin_b;     // rad/s
};

struct LawChunk {
  // geometry and motion
  Lane overlap;    // m
  Lane3 normal;    // a → b
  Lane3 velocity;  // of a relative to b at the centre of contact, m/s (spheres: in: of the centres)
  Lane turn;       // ½(ω_a + ω_b)·n, rad/s
  Lane radius_eff, mass_eff;
  PairOf<Lane> pair;
  // history, in and out; overlap > 0 once a contact touches, < 0 when it is bonded across a gap
  Lane3 history_force, history_normal;
  Lane history_overlap, history_twist;
  // patch: second moments about its centre and the relative spin ω_a − ω_b
  Lane spread_xx, spread_yy, spread_zz, spread_xy, spread_xz, spread_yz;
  Lane3 relative_spin;
  // answers
  Lane3 force;            // on a, N
  Lane3 couple;           // on a, N m (patch), or for spheres n × force, N
  Lane3 couple_b;         // on b, N m, where it is not that of a
  Lane lever_a, lever_b;  // of spheres: their torques are lever · couple, m
};

using LawKernel = void (*)(LawChunk& chunk, std::size_t count, double dt, const LawOptions& options);
struct SphereMeetings {        // bit i: of the pair in lane i; those past `count` mean nothing
  std::uint32_t touching = 0;  // it overlaps
  std::uint32_t turned = 0;    // its normal has turned by more than a right angle since that of its history
};
using SphereKernel = SphereMeetings (*)(const SphereChunk& in, LawChunk& chunk, std::size_t count);
// All of it for pairs of spheres whose law is one of the two below: bodies and histories are read, histories and slots
// written, one slot a pair. The lists are filled up to a whole chunk.
struct SphereContacts {
  const Motion* motion;  // bounding and equivalent radius are one
  const Index *a, *b, *seat;
  std::size_t count;
  const Lattice* lattice;  // null: bodies have no images
  const PairOf<Lane>* pair;
  double dt;  // s
  const LawOptions* options;
  History* history;  // by seat, as the next
  Slot* slot;
  Lane* overlap_before;  // out: of the histories, m
};
using SphereContactKernel = SphereMeetings (*)(const SphereContacts& contacts);
// The same for spheres with planes, two slots a pair. A plane: its origin and motion, the outward unit normal.
struct alignas(32) PlaneRows {
  shapes::Vec3d position{};  // m
  double none_position{};
  shapes::Vec3d velocity{};  // m/s
  double none_velocity{};
  shapes::Vec3d spin{};  // rad/s
  double none_spin{};
  shapes::Vec3d normal{};
  double none_normal{};
};
struct PlaneContacts {
  const Motion* motion;
  const PlaneRows* plane;
  const Index *a, *b, *seat;  // filled up to a multiple of eight
  std::size_t count;
  const PairOf<Lane>* pair;
  double dt;  // s
  const LawOptions* options;
  History* history;
  Slot* slot;  // 2 seat and 2 seat + 1
  Lane* overlap_before;
};
using PlaneContactKernel = SphereMeetings (*)(const PlaneContacts& contacts);
using SphereTorqueKernel = void (*)(const SphereChunk& in, LawChunk& chunk, std::size_t count);

// Index lists hold a multiple of four entries at least (padded with any valid index); `count` says how many are meant.
// Squared distance of the centres minus the squared sum of the radii: negative when the spheres overlap.
using ClearanceKernel = void (*)(const Motion* motion, const Index* a, const Index* b, std::size_t count, Lane& out);
using GatherKernel = void (*)(const Motion* motion, const Index* a, const Index* b, std::size_t count, SphereChunk& out,
                              LawChunk& chunk);
// The same with the nearest image of b; the velocities are relative to the flow of the lattice.
using PeriodicClearanceKernel = void (*)(const Motion* motion, const Index* a, const Index* b, std::size_t count,
                                         const Lattice& lattice, Lane& out);
using PeriodicGatherKernel = void (*)(const Motion* motion, const Index* a, const Index* b, std::size_t count,
                                      const Lattice& lattice, SphereChunk& out, LawChunk& chunk);
using LoadHistoryKernel = void (*)(const History* history, const Index* record, std::size_t count, LawChunk& chunk);
using StoreHistoryKernel = void (*)(const LawChunk& chunk, const Index* record, std::size_t count, History* history);
// One slot of each: force, couple and levers; or two: force with couple, force with couple_b.
using StoreSlotsKernel = void (*)(const LawChunk& chunk, const Index* record, std::size_t count, Slot* slot);

struct StageSet;        // stages.h: any law of each family
struct SmoothSet;       // smooth.h: contacts of ellipsoids and of ellipses
struct OverlapKernels;  // overlap_sums.h: sums over the overlap of two polyhedra

struct KernelSet {
  const char* name;                   // sse2, avx2, avx512
  SphereKernel spheres;               // before the law
  SphereTorqueKernel sphere_torques;  // after it
  SphereContactKernel sphere_contacts_hertz, sphere_contacts_linear;
  PlaneContactKernel plane_contacts_hertz, plane_contacts_linear;
  LawKernel hertz_mindlin, spring_dashpot;              // point contacts
  LawKernel hertz_mindlin_patch, spring_dashpot_patch;  // contacts over a patch
  const StageSet* stages;
  ClearanceKernel sphere_clearance;
  GatherKernel gather_spheres;
  PeriodicClearanceKernel periodic_clearance;
  PeriodicGatherKernel periodic_gather;
  LoadHistoryKernel load_history;
  StoreHistoryKernel store_history;
  StoreSlotsKernel store_slots;   // entry i of `record` is a slot
  StoreSlotsKernel store_double;  // entry i stands for slots 2 i and 2 i + 1
  PairKernels pairs;
  SearchKernels search;
  PolygonSideKernel polygon_sides;
  const SmoothSet* smooth;
  const OverlapKernels* overlaps;
};

// The best set this processor runs; the environment variable DEM_SIMD (sse2 | avx2 | avx512) asks for another. Every
// set gives the same bits. Chosen once.
CONTACT_API const KernelSet& kernels();
// Every set that this processor runs, narrowest first.
CONTACT_API std::span<const KernelSet* const> kernel_sets();

}  // namespace contact::kernels
