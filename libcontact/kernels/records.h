// What the loop keeps of bodies and contacts, laid out in rows of four doubles: the kernels turn four records at a time
// into lanes and back. Vectors take three of the four; the fourth is a companion, or nothing.
#pragma once

#include "libcontact/laws/law.h"
#include "shapes/math/vec.h"

namespace contact {

// A body as contact kernels see it: one and a half cache lines.
struct alignas(32) Motion {
  shapes::Vec3d position{};    // m
  double bounding_radius{};    // m
  shapes::Vec3d velocity{};    // m/s; at half steps between kick and drift, else at the time of the position
  double inverse_mass{};       // 1/kg
  shapes::Vec3d spin{};        // rad/s, world axes
  double equivalent_radius{};  // m, of the sphere of equal volume
};
static_assert(sizeof(Motion) == 12 * sizeof(double));

// What a contact gave this step, one cache line: on a the force and, about its centre, the torque lever_a · couple; on
// b minus the force and the torque lever_b · couple. Of round bodies the couple is n × force. Where the two torques
// have no couple in common a contact has two slots: the first is a's (levers 1 and 0), the second b's (0 and 1).
struct alignas(64) Slot {
  shapes::Vec3d force{};   // on a, N
  double lever_a{};        // m, or 1
  shapes::Vec3d couple{};  // N, or N m
  double lever_b{};        // m, or 1
};
static_assert(sizeof(Slot) == 8 * sizeof(double) && sizeof(History) == 8 * sizeof(double));

}  // namespace contact
