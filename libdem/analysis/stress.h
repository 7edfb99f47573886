// Stress of the bodies, after Love and Weber, with its kinetic part; compression positive:
//   V σ = − Σ_c f_c ⊗ d_c + Σ_i m_i (v_i − v̄) ⊗ (v_i − v̄)                                                          (1)
// f: force on a; d: from the centre of a to that of b, of a wall to the contact's point. Row: the force, column: the
// face. Per box a contact counts with the share of d that lies in the box, so that the boxes add to the whole; a body
// with its centre; v̄ is the mean over the mass in the box. Bodies that spin up have an antisymmetric part, whose moment
// is Σ d × f: at rest, without couples in the contacts, it is zero.
//
// Source: A. E. H. Love, Mathematical Theory of Elasticity, note B; J. Weber, Bull. Liaison Ponts Chaussees 20 (1966)
// 3-1; shares of the branch: J. Cormier, J. M. Rickman, T. J. Delph, J. Appl. Phys. 89 (2001) 99. Validity: exact as a
// mean over the volume where bodies are at rest; in flow as a mean over times long beside a collision. Weight does not
// enter but through the contacts. Cost: linear in contacts and in the faces that they cross. Accuracy: round-off.
// Tests: tests/libdem/analysis_stress.cpp.
#pragma once

#include <vector>

#include "libdem/analysis/grid.h"
#include "libdem/analysis/result.h"
#include "libdem/analysis/settings.h"
#include "shapes/math/vec.h"

namespace dem::analysis {

using shapes::Mat3d;

struct Stress {  // Pa
  Mat3d contacts{}, kinetic{};
  double mass = 0;         // of the bodies whose centres are in it, kg
  std::size_t bodies = 0;  // their number
  Mat3d total() const;
};

// One entry per box of the grid. `open`: the outer boxes take what lies beyond them too, as where the grid spans all
// bodies and only their surfaces stick out; else what lies outside is left out.
std::vector<Stress> stress_in_boxes(const Snapshot& snapshot, const Grid& grid, bool open);
// Of the settings' region, or of everything.
Stress stress_of(const Snapshot& snapshot, const Settings& settings);

Mat3d symmetric_part(const Mat3d& m);
Mat3d antisymmetric_part(const Mat3d& m);

Result report_stress(const Snapshot& snapshot, const Settings& settings);

}  // namespace dem::analysis
