// Roses: how many contacts, and how much force, point each way. Both senses of a normal count, so roses are symmetric
// and their shares add up to 1.
//
//   r_i = nC_i / NC                        share of bin i by number; of 2 NC, with n and −n                    (9.48)
//   p_i = Σ_{k in i} Fn_k / Σ Fn_k         by force; contacts that pull count as 0                            (9.49)
//   density r_i / Δθ [1/rad], r_i / ΔΩ [1/sr]: does not depend on the number of bins; isotropic 1/2π, 1/4π
//   E(θ) = (1/2π)(1 + a2 cos 2(θ − θ2) + a4 cos 4(θ − θ4)),  a_m = 2 |<exp(i m θ)>|; φ1 − φ2 = a2/2
//
// Bins are centred on θ = 0, and on z and x in space: a lattice's directions are exact, so a direction that lies on an
// edge to 1e-9 goes to one bin, never to two by rounding. Each bin also has the mean direction of what is in it.
// In space a plane's rose is of the projected normals; those that stand across it (projection below 1e-6) are left out.
// Bins of equal solid angle: a cap about z and collars cut into sectors, over the half sphere, by the plan of Leopardi,
// Electron. Trans. Numer. Anal. 25 (2006) 309. Cost: O(contacts). Tests: tests/libdem/analysis_rose.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "libdem/analysis/pairs.h"
#include "libdem/analysis/settings.h"

namespace dem::analysis {

struct HarmonicFit {
  double a2 = 0, angle2 = 0;           // rad, in [0, π)
  double a4 = 0, angle4 = 0;           // rad, in [0, π/2)
  double density(double angle) const;  // E, 1/rad
};

struct Rose {                         // bin i about the angle i · 2π/bins, from u towards v
  std::vector<double> number, force;  // (9.48), (9.49); zeros without contacts, or without force
  std::vector<double> mean_angle;     // rad, of what is in the bin by number; its middle when empty
  std::size_t used = 0, across = 0;   // contacts in the rose; left out because they stand across the plane
  HarmonicFit number_fit, force_fit;
  double width() const;  // rad
};
// u, v: unit vectors that span the plane. bins: even, >= 2 (an odd number counts as the next one).
Rose rose_of(const std::vector<Pair>& pairs, const Vec3d& u, const Vec3d& v, int bins);

class HalfSphereBins {  // of equal solid angle 2π/size()
 public:
  explicit HalfSphereBins(std::size_t wanted);  // >= 1
  std::size_t size() const { return size_; }
  double solid_angle() const;               // sr
  std::size_t index(const Vec3d& n) const;  // of n or −n; unit
  Vec3d centre(std::size_t bin) const;      // unit
  static Vec3d folded(const Vec3d& n);      // of n and −n the one that the bins hold

 private:
  struct Collar {
    std::size_t first, sectors;
  };
  std::vector<Collar> collars_;  // the cap first
  std::size_t size_ = 0;
};

struct SphereRose {
  std::vector<double> number, force;  // per bin: shares of the half sphere
  std::vector<Vec3d> mean;            // unit, of the contacts in the bin; its centre when empty
};
SphereRose rose_of(const std::vector<Pair>& pairs, const HalfSphereBins& bins);

Result report_rose(const Snapshot& snapshot, const Settings& settings);

}  // namespace dem::analysis
