#include "libcontact/methods/facet_depth.h"

#include "libcontact/methods/overlap_forms.h"

namespace contact {

namespace {

Patch patch_of(const DepthSlope& s, const Mat3d& rotation, const Vec3d& position) {
  const Vec3d t = rotation * s.t, u = rotation * s.u;
  const auto moment = [&](int i, int j) {
    return s.tt * t[i] * t[j] + s.uu * u[i] * u[j] + s.tu * (t[i] * u[j] + u[i] * t[j]);
  };
  return {rotation * s.centroid + position,
          {moment(0, 0), moment(1, 1), moment(2, 2), moment(0, 1), moment(0, 2), moment(1, 2)},
          s.volume};
}

// The slope of d where the body whose vertex lies under a face of the other is self.
bool under_face(const PolyhedronPair& pair, std::uint32_t face, std::uint32_t vertex, double reach, double size,
                DepthSlope& out) {
  if (CornerOverlap c; corner_alone(pair, face, vertex, reach, c))
    return corner_slope({c.corner, c.count}, c.n, c.depth, size, out);
  return depth_slope(overlap_under_face(pair, face, vertex), size, out);
}
bool of_edges(const PolyhedronPair& pair, std::uint32_t edge_of_self, std::uint32_t edge_of_other, const Vec3d& n,
              double depth, double size, DepthSlope& out) {
  const EdgesMeeting meeting(pair, edge_of_self, edge_of_other);
  if (EdgesOverlap e; edges_alone(pair, meeting, edge_of_self, edge_of_other, e))
    return edges_slope(e.corner, e.normal, size, out);
  return depth_slope(overlap_of_edges(pair, meeting, edge_of_self, edge_of_other, n, depth), size, out);
}

}  // namespace

bool facet_depth(const PolyhedronPair& pair, const DifferenceFacet& facet, const FacetAxis& axis,
                 const PairPlaces& places, OverlapDepth& out, Patch& patch) {
  const bool turned = facet.kind == DifferenceFacet::face_of_a;
  DepthSlope slope;
  const bool found = turned ? under_face(pair.swapped(), facet.a, facet.b, axis.reach, places.size, slope)
                     : facet.kind == DifferenceFacet::face_of_b
                         ? under_face(pair, facet.b, facet.a, axis.reach, places.size, slope)
                         : of_edges(pair, facet.a, facet.b, axis.normal, -axis.value, places.size, slope);
  if (!found) return false;
  const Mat3d& rotation = turned ? places.rotation_b : places.rotation_a;
  const Vec3d position = turned ? places.offset : Vec3d{};
  out = rotated(line_of_action(slope), rotation);
  out.point += position;
  if (turned) out.normal = -out.normal;
  patch = facet.kind == DifferenceFacet::edges ? Patch{} : patch_of(slope, rotation, position);
  return true;
}

}  // namespace contact
