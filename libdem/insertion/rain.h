// Rain: bodies created at a rate in a region. Body n of a rain and the k-th position tried for it are functions of
// (seed, rain, n) and (seed, rain, k), so threads and a resume change nothing.
#pragma once

#include "libdem/insertion/drafts.h"

namespace dem {

// Records of the scene's rains at t = 0; those that an event starts wait for it.
void prepare_rain(World& world);
void start_rain(World& world, const std::string& name);
// What it still owed is dropped.
void stop_rain(World& world, const std::string& name);
// Creates the bodies that are due at world.time(), after the drift of a step. One that finds no free place stays due.
void insert_rain(World& world);

// The smallest bodies of every rain: the time step and the skin allow for them.
std::vector<Draft> coming_bodies(const World& world);

}  // namespace dem
