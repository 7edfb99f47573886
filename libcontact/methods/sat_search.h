// The two halves of the separating-axis search: face axes with their pruning data, and edge–edge axes.
#pragma once

#include "libcontact/methods/difference_facet.h"

namespace contact {

// Faces of pair.self against pair.other, by cutting planes: any point v of the other body bounds the separation along
// every face's normal by its height over that face. The ball inside the other body gives the first bounds, the deepest
// vertex of each face that is evaluated gives better ones; a few evaluations settle all faces.
class FaceSearch {
 public:
  explicit FaceSearch(const PolyhedronPair& pair);

  struct Face {
    double value;            // separation along the face normal
    std::uint32_t on_other;  // the vertex of other that gives it
  };
  const PolyhedronPair& pair() const { return pair_; }
  Face separation(std::uint32_t face);  // remembered for the first `cap` faces

  // The best face whose separation exceeds `bar`; raises `bar` to it. Stops at the first one above `enough`.
  // Returns false when there is none.
  bool search(double& bar, double enough, std::uint32_t& best, Face& held);

  // Indices of edges first, first + 1, … that pass the bounds along their whole arc: whether the separation along some
  // direction between the two face normals can exceed `bar`. Dropping an edge is a proof. Looks at `count` edges at
  // most edge_block; returns how many it wrote.
  static constexpr std::size_t edge_block = 128;
  std::size_t edges_above(double bar, std::uint32_t first, std::size_t count, std::uint32_t* out);

 private:
  double height(std::uint32_t face, const Vec3d& x) const;
  double witness_height(std::uint32_t face) const {
    return face < known_ ? witness_height_[face] : height(face, witness_);
  }
  bool may_exceed(const shapes::Polyhedron::Edge& edge, double bar);
  void set_witness();

  static constexpr std::size_t cap = 256;
  const PolyhedronPair& pair_;
  Vec3d centre_;     // of the ball inside other
  double ball_;      // its radius
  Vec3d witness_{};  // other's vertex under the best face evaluated
  Face deepest_;
  bool has_witness_ = false;
  std::uint32_t known_;
  double bound_[cap], witness_height_[cap], value_[cap];
  std::uint32_t vertex_[cap];  // unset: not evaluated yet
};

// The best axis of all; `none` when nothing compares. Of axes that are equal to rounding a face wins over an edge pair
// and the lower index over the higher. Stops at the first one above `enough`.
DifferenceFacet search_all(const DifferencePair& pair, double enough);

}  // namespace contact
