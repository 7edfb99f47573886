// Pairs of smooth bodies that touched a step ago, in lanes from the bodies to what a law takes of them and from its
// force to the torques. Plain arrays of doubles: included by sources compiled per instruction set.
//
// The search begins at the normal of the contact's history: its answer is another one within the interval of a cold
// search, and the same for every instruction set.
#pragma once

#include "libcontact/kernels/chunk.h"
#include "shapes/math/quat.h"

namespace contact::kernels {

// Arrays over all bodies.
struct SmoothBodies {
  const Motion* motion;
  const shapes::Quatd* orientation;  // body -> world
  const shapes::Vec3d* size;         // ellipsoid: semi-axes; ellipse: (a, b, -), m
  const shapes::Vec3d* inertia;      // principal, kg m²
};

// Of ellipses what lies in the plane of motion alone: of turns w and z, of inertia and spin z, of the others x and y.
struct SmoothChunk {
  struct Body {
    Lane turn[4];  // orientation: w, x, y, z
    Lane3 size, inertia, spin;
    Lane3 arm;  // answer: from its centre to the contact, m
  };
  Body a, b;
  Lane3 offset;       // centre of b less that of a, m
  Lane inverse_mass;  // 1/m_a + 1/m_b, 1/kg
};

struct SmoothMeetings {
  std::uint32_t overlapping = 0;  // bit i: the pair in lane i is solved, and overlaps
  bool turned = false;            // a normal has turned by more than a right angle since that of its history
};

struct SmoothKernels {
  // Into `pairs`; R*, the relative velocity of the centres and the relative spin into `chunk`. Lists as those of
  // GatherKernel; `lattice`: null without periods.
  void (*gather)(const SmoothBodies& bodies, const Index* a, const Index* b, std::size_t count, const Lattice* lattice,
                 SmoothChunk& pairs, LawChunk& chunk);
  // Overlap, normal, velocity, turn and effective mass of the pairs of a chunk that has its histories. `tolerance` as
  // in Options; a pair whose interval is wider counts as not solved. What is not solved or does not overlap means
  // nothing.
  SmoothMeetings (*meet)(SmoothChunk& pairs, LawChunk& chunk, std::size_t count, double tolerance);
  // The couples of the forces, on a and on b; `moment`: with the couple on a that the law gave.
  void (*torques)(const SmoothChunk& pairs, LawChunk& chunk, std::size_t count, bool moment);
};
struct SmoothSet {
  SmoothKernels ellipsoids, ellipses;
};

}  // namespace contact::kernels
