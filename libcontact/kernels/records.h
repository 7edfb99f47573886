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

// What a contact gave this step; zero when not touching.
struct alignas(32) Slot {
  shapes::Vec3d force{};  // on a, N
  double unused_f{};
  shapes::Vec3d torque_a{};  // about a's centre, N m
  double unused_a{};
  shapes::Vec3d torque_b{};  // about b's centre, N m
  double unused_b{};
};
static_assert(sizeof(Slot) == 12 * sizeof(double) && sizeof(History) == 8 * sizeof(double));

}  // namespace contact
