// Memory of a world: what its structures hold now, and what they will hold when the bed is packed. Bytes.
#pragma once

#include <cstddef>

#include "libdem/world.h"

namespace dem::forecast {

struct Bytes {
  double bodies = 0, contacts = 0, geometry = 0;
  double rebuild = 0;  // the list made anew beside the old one, for a moment
  double total() const { return bodies + contacts + geometry + rebuild; }
};

// Of the structures as they stand: the capacity of every list. No rebuild.
Bytes bytes_of(const World& world);
// Of `bodies` bodies with `records` candidate contacts each, of which `wall_records` are with walls. `round`: spheres
// and discs only, which keep less. Within a few tens of percent of bytes_of such a world (tested: a factor of 2), with
// the peak of a rebuild besides; geometry is the world's own.
Bytes bytes_of_packed(const World& world, double bodies, double records, double wall_records, bool round);

// Largest memory that this process has held so far, and that of the machine; 0 when the system does not say.
double peak_of_process();
double memory_of_machine();

}  // namespace dem::forecast
