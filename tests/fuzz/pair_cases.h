// Random and adversarial pairs of bodies of any two kinds in the catalogue: aspect ratios to 1e6, size ratios to 1e9,
// scales to 2^±300, equal and nearly equal poses, coincident centres, gaps from 0 and 1e-16 of the size on, far pairs.
#pragma once

#include <string>

#include "libcontact/dispatch.h"
#include "shapes/math/quat.h"
#include "tests/fuzz/pair_source.h"

namespace pair_fuzz {

using contact::Body;
using contact::Contact;
using contact::MethodInfo;
using shapes::Kind;
using shapes::Quatd;
using shapes::Vec3d;

struct Posed {
  Body body;
  Quatd orientation{1, 0, 0, 0};  // bodies of space
  double angle = 0;               // bodies of the plane, rad
};

struct PairCase {
  Posed a, b;
  Vec3d offset{};
  double extent() const { return norm(offset) + circumradius(a.body) + circumradius(b.body); }
};

PairCase draw_pair(const MethodInfo& method, Source& source);

// The pair as a case file that `dem contact` replays; empty for kinds that such files do not know (mesh facets,
// potential particles): those are replayed by their seed.
std::string case_file(const PairCase& pair, const std::string& id);

}  // namespace pair_fuzz
