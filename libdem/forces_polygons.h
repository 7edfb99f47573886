// Polygons that met by a corner behind a side in the step before: most of a bed's contacts, lanes across them.
//
// What a pair, or each of its regions, met by is in its caches: a proof of the answer that a kernel checks anew
// (libcontact/kernels/polygon_side.h). A pair of regions is answered so while its other parts are known to be apart
// (coherence.h). All others go the way of every pair; the bits are the same on either.
#pragma once

#include "libcontact/methods/polygon_regions.h"
#include "libdem/force_pass.h"

namespace dem {

class PolygonPass : public ForcePass {
 public:
  PolygonPass(World& world, double dt);

  // Whether pairs of a bin may be answered here.
  bool takes(const Bin& bin) const;
  // Of `count` pairs in question, given by their places in the bin, those that are left over, into `rest`: how many.
  // May be the same list.
  std::size_t answer(const Bin& bin, const std::uint32_t* places, std::size_t count, std::uint32_t* rest, Scratch& s,
                     Tally& t) const;

 private:
  struct Lanes;
  void fetch(const Bin& bin, std::size_t r) const;
  bool add(const Bin& bin, std::size_t r, Lanes& lanes) const;
  void fill(std::size_t i, std::size_t k, const contact::PartSide& side, Lanes& lanes) const;
  bool continues(const Lanes& lanes, std::size_t first, std::size_t last, std::uint32_t found) const;
  std::size_t flush(const Bin& bin, Lanes& lanes, std::uint32_t* rest, std::size_t left, Scratch& s, Tally& t) const;

  bool depths_ = false;  // the law acts on what this answers
  contact::ChunkQuery query_;
};

}  // namespace dem
