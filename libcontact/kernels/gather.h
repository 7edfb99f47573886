// What the kernel sources of one set give to its list: inside the kernels only (compiled once per instruction set).
#pragma once

#include "libcontact/kernels/chunk.h"

namespace contact::kernels {
inline namespace KERNEL_SET {

void sphere_clearance(const Motion* motion, const Index* a, const Index* b, std::size_t count, Lane& out);
void gather_spheres(const Motion* motion, const Index* a, const Index* b, std::size_t count, SphereChunk& s,
                    LawChunk& c);
void periodic_clearance(const Motion* motion, const Index* a, const Index* b, std::size_t count, const Lattice& lattice,
                        Lane& out);
void periodic_gather(const Motion* motion, const Index* a, const Index* b, std::size_t count, const Lattice& lattice,
                     SphereChunk& s, LawChunk& c);
void load_history(const History* history, const Index* record, std::size_t count, LawChunk& c);
void store_history(const LawChunk& c, const Index* record, std::size_t count, History* history);
void store_slots(const LawChunk& c, const Index* record, std::size_t count, Slot* slot);
void store_double(const LawChunk& c, const Index* record, std::size_t count, Slot* slot);

SphereMeetings sphere_contacts_hertz(const SphereContacts& c);
SphereMeetings sphere_contacts_linear(const SphereContacts& c);
SphereMeetings plane_contacts_hertz(const PlaneContacts& c);
SphereMeetings plane_contacts_linear(const PlaneContacts& c);

bool sphere_pairs(const SphereRow* spheres, const Index* a, const Index* b, std::size_t count,
                  const SphereAnswers& out);
void ellipsoid_proofs(EllipsoidChunk& chunk, std::size_t count);
void ellipsoid_search(EllipsoidChunk& chunk, std::size_t count, bool stop_at_proof, double tolerance);
void ellipse_proofs(EllipseChunk& chunk, std::size_t count);
void ellipse_search(EllipseChunk& chunk, std::size_t count, double tolerance);

std::uint32_t polygon_sides(const Motion* motion, const Lattice* lattice, PolygonChunk& chunk, std::size_t count,
                            bool parts, LawChunk& law);

const StageSet& stage_set();
const OverlapKernels& overlap_set();
const SmoothSet& smooth_set();

}  // namespace KERNEL_SET
}  // namespace contact::kernels
