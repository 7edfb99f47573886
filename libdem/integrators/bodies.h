// What a step does with bodies alone, lanes across bodies: sums of what acts on them, the kick that ends a step, the
// kick and the drift that begin one. In the order of `libdem/step.cpp`; any of the three parts may be left out.
//   sum    F, T of a body: of its slots in the order of its list
//   end    v += ½ dt (F/m + g), L += ½ dt T, ω of it; in a cell that deforms v is slowed by the flow before
//   begin  the same kick, slowed after it; x += dt v, q turns freely (rotation.h), ∫ω dt; x into the periodic cell
// Every instruction set gives the same bits, those of one body at a time.
// Cost: bench/README.md. Tests: tests/libdem/bodies.cpp
#pragma once

#include <cstddef>
#include <cstdint>

#include "libcontact/kernels/lattice.h"
#include "libcontact/kernels/records.h"
#include "shapes/math/quat.h"

namespace dem {

struct CellStep {                 // of a cell that deforms, over one step; deformation.h (1)
  shapes::Vec3d slowed{1, 1, 1};  // factor on velocities, in half a step
  shapes::Vec3d scale{1, 1, 1};   // of the box
};

// The arrays of Particles (particles.h), by place.
struct BodyArrays {
  const std::uint8_t* kind;  // shapes::Kind
  contact::Motion* motion;
  shapes::Quatd* orientation;
  shapes::Vec3d *rotation, *angular_momentum;
  const shapes::Vec3d* inertia;
  shapes::Vec3d *force, *torque;
  double* travel;  // null: not kept; as Contacts::travel
};

// Slots that are written, read once, and then left: `size` of them from `first` on stand in mask + 1 places, those that
// come later over those that have been read (sweep.h).
struct SlotRing {
  std::uint32_t first = 0, size = 0, mask = ~std::uint32_t(0);
  [[gnu::always_inline]] std::uint32_t place(std::uint32_t slot) const {
    const std::uint32_t at = slot - first;
    return at < size ? first + (at & mask) : slot;
  }
};

// What acts on bodies: each the sum of its slots in the order of its list.
struct SumLists {
  const contact::Slot* slot;
  const std::uint32_t* active;         // entry = slot · 2 + (1 when the body is b)
  const std::uint32_t *start, *count;  // of the list of each body
  bool far = false;                    // slots are too many for the caches near the core: fetch them ahead
  SlotRing ring{};
};

struct BodyStep {
  bool sum = false, end = false, begin = false;
  bool keep = true;  // the sums go into force and torque; else they act in this call alone
  bool deforms = false;
  double dt = 0;  // s
  shapes::Vec3d gravity{};
  std::uint64_t uniform = 0;  // bit k: bodies of kind k keep their spin along their angular momentum (particles.h)
  std::uint64_t still = 0;    // bit k: bodies of kind k keep their orientation and ∫ω dt (run.turn_spheres)
  bool periodic = false;
  shapes::Vec3d lower{}, centre{};  // of the cell (cell.h), m
  contact::Lattice lattice{};
  CellStep flow{};
};

struct BodyTally {
  double farthest = 0;                // m: way of the farthest body in `begin`; without `travel` its square
  std::size_t bad = ~std::size_t(0);  // the first body whose position or velocity is not finite
};

// Bodies first … last.
using BodyKernel = void (*)(const BodyArrays& bodies, const SumLists& lists, const BodyStep& step, std::size_t first,
                            std::size_t last, BodyTally& tally);
// Of a set by its name (KernelSet::name); without one, of the set that the program runs.
BodyKernel body_kernel(const char* set);
BodyKernel body_kernel();

}  // namespace dem
