// Candidates of bodies of parts: pairs of parts whose bounding spheres are nearer than their bodies' allowances. Parts
// move with the turns of their body, so the list also grows old by turning.
#pragma once

#include <span>

#include "libdem/broad_phase/candidate.h"
#include "libdem/world.h"

namespace dem {

// Any body with parts?
bool has_compounds(const World& world);
// Records of particles i and j, id of i lower, in order of key.
void part_pairs(const World& world, std::uint32_t i, std::uint32_t j, std::vector<Candidate>& row);
// Records of particle i and wall w, in order of key. `frame` is the wall's rotation, `facets` those of a mesh to try.
void part_walls(const World& world, std::uint32_t i, std::uint32_t w, const Mat3d& frame,
                std::span<const std::uint32_t> facets, std::vector<Candidate>& row);
// The groups of the list and what answers their records; the share of every record is set to 1.
void fill_groups(World& world);
// Whether a part of some body may have moved by the body's allowance since the last rebuild.
bool parts_moved(const World& world);

}  // namespace dem
