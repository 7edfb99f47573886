// Potential particles to test with: box, tetrahedron, an irregular one, a plate, one that its sphere cuts, nearly a
// ball.
#pragma once

#include <vector>

#include "shapes/potential_build.h"

namespace shape_tests {

inline std::vector<shapes::HalfSpace> planes_of_faces(const shapes::Polyhedron& p, double inset = 0) {
  std::vector<shapes::HalfSpace> planes;
  for (const auto& face : p.faces) planes.push_back({face.normal, face.offset - inset});
  return planes;
}

// Without symmetry.
inline std::vector<shapes::HalfSpace> irregular_planes() {
  return {{{1, 0.2, 0.1}, 0.6},   {{-1, 0.3, 0}, 0.5},   {{0.2, 1, -0.3}, 0.4},  {{0, -1, 0.2}, 0.5},
          {{0.3, -0.2, 1}, 0.45}, {{0.1, 0.1, -1}, 0.5}, {{0.7, 0.7, 0.7}, 0.6}, {{-0.7, -0.6, 0.5}, 0.55}};
}

inline const std::vector<shapes::PotentialParticle>& potential_particles() {
  static const std::vector<shapes::PotentialParticle> list = [] {
    using shapes::Frame;
    constexpr double rough = 1e-5;  // of their mass properties: quickly made
    const auto box = planes_of_faces(shapes::make_box({1, 1.5, 2}));
    const auto tetrahedron = planes_of_faces(shapes::make_platonic(shapes::Platonic::tetrahedron, 1));
    const auto plate = planes_of_faces(shapes::make_prism(6, 1, 0.2));
    return std::vector<shapes::PotentialParticle>{
        shapes::make_potential_particle(box, 0.1, 0.3, 1.5, Frame::principal, rough),
        shapes::make_potential_particle(tetrahedron, 0.05, 0.2, 1.2, Frame::principal, rough),
        shapes::make_potential_particle(irregular_planes(), 0.01, 0.1, 1, Frame::principal, rough),
        shapes::make_potential_particle(plate, 0.02, 0.05, 1.2, Frame::principal, rough),
        shapes::make_potential_particle(box, 0.5, 0.4, 0.75, Frame::principal, rough),
        shapes::make_potential_particle(box, 0.95, 0.5, 0.8, Frame::principal, rough)};
  }();
  return list;
}

}  // namespace shape_tests
