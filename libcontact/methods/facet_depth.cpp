#include "libcontact/methods/facet_depth.h"

#include "libcontact/methods/overlap_moments.h"

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

}  // namespace

bool facet_depth(const PolyhedronPair& pair, const DifferenceFacet& facet, const Vec3d& n, double depth,
                 const PairPlaces& places, OverlapDepth& out, Patch& patch) {
  // The body whose vertex lies under a face of the other is the one that is cut.
  const bool turned = facet.kind == DifferenceFacet::face_of_a;
  const OverlapBody& body = turned ? overlap_under_face(pair.swapped(), facet.a, facet.b)
                            : facet.kind == DifferenceFacet::face_of_b
                                ? overlap_under_face(pair, facet.b, facet.a)
                                : overlap_of_edges(pair, facet.a, facet.b, n, depth);
  DepthSlope slope;
  if (!depth_slope(body, places.size, slope)) return false;
  const Mat3d& rotation = turned ? places.rotation_b : places.rotation_a;
  const Vec3d position = turned ? places.offset : Vec3d{};
  out = rotated(line_of_action(slope), rotation);
  out.point += position;
  if (turned) out.normal = -out.normal;
  patch = patch_of(slope, rotation, position);
  return true;
}

}  // namespace contact
