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
void sum_slots(const SumLists& lists, std::size_t first, std::size_t last, bool far, shapes::Vec3d* force,
               shapes::Vec3d* torque);

bool sphere_pairs(const SphereRow* spheres, const Index* a, const Index* b, std::size_t count,
                  const SphereAnswers& out);
void ellipsoid_proofs(EllipsoidChunk& chunk, std::size_t count);
void ellipsoid_search(EllipsoidChunk& chunk, std::size_t count, bool stop_at_proof, double tolerance);
void ellipse_proofs(EllipseChunk& chunk, std::size_t count);
void ellipse_search(EllipseChunk& chunk, std::size_t count, double tolerance);

const StageSet& stage_set();
const SmoothSet& smooth_set();

}  // namespace KERNEL_SET
}  // namespace contact::kernels
