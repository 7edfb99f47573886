// How two materials meet: effective moduli, friction and damping of a pair. Set-up only.
#pragma once

#include "libcontact/laws/law.h"

namespace contact {

// Restitution of a spring with a dashpot of ratio β >= 0 whose contact ends at zero force:
//   e(β) = exp(−2β acos(β)/sqrt(1−β²)), β < 1;  exp(−2), β = 1;  exp(−2β acosh(β)/sqrt(β²−1)), β > 1.
// The same for the linear spring and for Hertz with Tsuji's dashpot. Relative error about 1e-15.
double clipped_restitution(double beta);
// Its inverse for 0 < e <= 1 (bracketed root, relative error 1e-14 in β).
double clipped_damping(double restitution);

// E* (8.6), G* (8.25), kn in series, kt/kn = 1/κ with κ = E*/(4G*), friction = the smaller one, restitution = the
// smaller one. A rigid partner is left out of both moduli; two rigid materials never meet (refused by the caller).
PairParameters mix(const Material& a, const Material& b);

}  // namespace contact
