// Contacts of one pair of bodies, part by part, as one: what belongs together shares one stiffness and one history.
//
// Where two parts join, both touch the same thing. With δ the overlap of each contact, w its weight, φ its cover and
// c_ij in [0, 1] how far i and j are one contact:
//   share   λ_i = φ_i w_i / (Σ_j c_ij φ_j w_j + (1 − κ_i)(1 − φ_i) w_i),   κ_i = max over j ≠ i of c_ij             (1)
//   overlap Δ_i = max over j of c_ij δ_j                                                                           (2)
//   centre  C_i = Σ_j c_ij φ_j w_j x_j / Σ_j c_ij φ_j w_j: where the effective mass is taken                        (3)
//   c_ij = b_ij / min(δ_i, δ_j),  b_ij = the depth of the shallowest place on the deepest way from i to j (4)
// One contact of many parts then acts as that of one body: the forces λ_i F(Δ) add to F(Δ) at their common centre,
// while contacts that lie apart (the ends of a dumbbell) keep a stiffness each. A part that begins to touch does so
// with weight 0; places grow together as the neck between them goes under: nothing jumps.
//   history: what j remembers of tangential force goes to i by the share c_ij λ_i / max(1, Σ_k c_kj λ_k); the rest (5)
//   stays with j. Nothing is lost as a contact passes on from one part to the next.
//   cover φ: 0 where the surface lies inside the body, or where another part is nearer to what lies before it; see
//   forces_compound.cpp.
#pragma once

#include <span>
#include <vector>

#include "libdem/world.h"

namespace dem {

struct PartContact {
  // in
  double overlap = 0;  // δ, m
  double weight = 0;   // w, m³
  double cover = 1;    // φ
  Vec3d centre{};      // x, relative to a's centre, m
  // out
  double share = 0;           // λ
  double common_overlap = 0;  // Δ, m
  Vec3d common_centre{};      // C, m
};

// `depth` is a square matrix of contacts.size() rows: in, how deep the places lie in which i and j join directly (0:
// they do not join); out, c_ij. Sums run in the order of the contacts.
void share_stiffness(std::span<PartContact> contacts, std::vector<double>& depth);

// (5), on the histories of the contacts; `same` is c_ij as share_stiffness leaves it. A contact that is new goes on
// where those that it is one with were.
void pool_histories(std::span<const PartContact> contacts, const std::vector<double>& same,
                    std::span<contact::History> histories);

}  // namespace dem
