// Patches: closed forms, Monte Carlo, continuity, and the plane.
#include <gtest/gtest.h>

#include "libcontact/methods/polyhedron_plane.h"
#include "libcontact/methods/sat.h"
#include "tests/libcontact/poly_reference.h"

namespace {

using namespace contact;
using namespace reference;

Quatd turn(const Vec3d& axis, double angle) {
  const double s = std::sin(angle / 2);
  return {std::cos(angle / 2), s * axis.x, s * axis.y, s * axis.z};
}

TEST(PolyPatch, BoxOnBoxIsCentredOnTheCommonRectangle) {
  const Polyhedron box = shapes::make_box({1, 1, 1});
  const double depth = 1e-3;
  const Contact c = Sat::query(place(box, 1, {}), place(box, 1, {}), {0.25, -0.5, 1 - depth}, {}, nullptr);
  EXPECT_NEAR(c.gap, -depth, 1e-14);
  EXPECT_NEAR(norm(c.patch.centre - Vec3d{0.125, -0.25, 0.5 - depth / 2}), 0, 1e-13);
  EXPECT_NEAR(c.patch.spread[0], 0.75 * 0.75 / 12, 1e-13);
  EXPECT_NEAR(c.patch.spread[1], 0.5 * 0.5 / 12, 1e-13);
  for (int i = 2; i < 6; ++i) EXPECT_NEAR(c.patch.spread[i], 0, 1e-13);
}

// A face tilted by θ about y at mean depth δ: h = δ + θ x over the face, so the centre moves by θ I/(A δ) = θ/(12 δ).
TEST(PolyPatch, TiltMovesTheCentreByTheSecondMoment) {
  const Polyhedron box = shapes::make_box({1, 1, 1});
  const double depth = 1e-3;
  for (const double tilt : {1e-8, 1e-6, 1e-5, 1e-4}) {
    const Quatd q = turn({0, 1, 0}, tilt);
    for (const bool on_plane : {false, true}) {
      const Vec3d d = on_plane ? Vec3d{0, 0, -(0.5 - depth)} : Vec3d{0, 0, -(1 - depth)};
      const Contact c = on_plane
                            ? PolyhedronPlane::query(place(box, 1, q), {{0, 0, 1}}, d, {}, nullptr)
                            : Sat::query(place(box, 1, q), place(shapes::make_box({1, 1, 1}), 1, {}), d, {}, nullptr);
      // To first order in the tilt; the side depends on the sense of the turn.
      // q.
      EXPECT_NEAR(std::abs(c.patch.centre.x), tilt / (12 * depth), 2e-3 * tilt / depth + 2 * tilt) << tilt << on_plane;
      EXPECT_NEAR(c.patch.centre.y, 0, 1e-12);
      EXPECT_NEAR(c.patch.spread[1], 1.0 / 12, 1e-4);
    }
  }
}

// Depth-weighted moments by sampling columns of the overlap along the normal of a face axis.
TEST(PolyPatch, AgreesWithMonteCarlo) {
  const Polyhedron grains[2] = {grain("cement140_02.off"), grain("cement140_05.off")};
  Draw draw(4);
  int compared = 0;
  for (int i = 0; i < 40 && compared < 8; ++i) {
    const Quatd qa = draw.orientation(), qb = draw.orientation();
    const double sa = 1 / grains[0].circumradius, sb = 1 / grains[1].circumradius;
    const auto a = place(grains[0], sa, qa), b = place(grains[1], sb, qb);
    const Vec3d d = draw.direction() * draw.between(1.0, 1.4);
    const Contact c = Sat::query(a, b, d, {}, nullptr);
    if (c.status != Status::overlapping || c.patch.spread[0] + c.patch.spread[1] + c.patch.spread[2] == 0) continue;
    // The reference face: of A when its normal is the contact's, otherwise of B.
    const auto plane_of = [&](const Placed<Polyhedron>& p, const Vec3d& n, const Vec3d& at,
                              const Polyhedron::Face** face) {
      for (const auto& f : p.shape->faces)
        if (norm(p.rotation * f.normal - n) < 1e-12) {
          *face = &f;
          return p.scale * f.offset + dot(n, at);
        }
      return 0.0;
    };
    const Polyhedron::Face* face = nullptr;
    Vec3d n = c.normal;
    double plane = plane_of(a, n, {}, &face);
    const bool of_a = face != nullptr;
    if (!of_a) n = -n, plane = plane_of(b, n, d, &face);
    ASSERT_NE(face, nullptr);
    const auto& reference = of_a ? a : b;
    const auto& incident = of_a ? b : a;
    const Vec3d reference_at = of_a ? Vec3d{} : d, incident_at = of_a ? d : Vec3d{};
    Vec3d t1, t2;
    tangent_frame(n, t1, t2);
    double w = 0, wu = 0, wv = 0, wuu = 0, wvv = 0, wuv = 0;
    Vec3d low{1e9, 1e9, 0}, high{-1e9, -1e9, 0};
    std::vector<Vec3d> loop;
    for (std::uint32_t k = 0; k < face->count; ++k) {
      const Vec3d x = reference_at +
                      reference.rotation * (reference.scale *
                                            reference.shape->vertices[reference.shape->face_vertices[face->first + k]]);
      loop.push_back({dot(t1, x), dot(t2, x), 0});
      for (int j = 0; j < 2; ++j)
        low[j] = std::min(low[j], loop.back()[j]), high[j] = std::max(high[j], loop.back()[j]);
    }
    for (int k = 0; k < 300000; ++k) {
      const double u = draw.between(low.x, high.x), v = draw.between(low.y, high.y);
      bool inside = true;
      for (std::size_t j = 0; j < loop.size(); ++j) {
        const Vec3d p = loop[j], q = loop[(j + 1) % loop.size()];
        inside = inside && (q.x - p.x) * (v - p.y) - (q.y - p.y) * (u - p.x) >= 0;
      }
      if (!inside) continue;
      // The incident body's lower end along n over (u, v).
      const Vec3d base = t1 * u + t2 * v - incident_at;
      double bottom = -1e9, top = 1e9;
      for (const auto& f : incident.shape->faces) {
        const Vec3d m = incident.rotation * f.normal;
        const double slope = dot(m, n), rest = incident.scale * f.offset - dot(m, base);
        if (slope < 0)
          bottom = std::max(bottom, rest / slope);
        else if (slope > 0)
          top = std::min(top, rest / slope);
      }
      const double h = plane - bottom;
      if (bottom > top || h <= 0) continue;
      w += h, wu += h * u, wv += h * v, wuu += h * u * u, wvv += h * v * v, wuv += h * u * v;
    }
    if (w == 0) continue;
    ++compared;
    const double cu = wu / w, cv = wv / w, su = wuu / w - cu * cu, sv = wvv / w - cv * cv;
    const double reach = std::sqrt(su + sv);
    EXPECT_NEAR(dot(c.patch.centre, t1), cu, 0.05 * reach);
    EXPECT_NEAR(dot(c.patch.centre, t2), cv, 0.05 * reach);
    const double* s = c.patch.spread;
    EXPECT_NEAR(s[0] + s[1] + s[2], su + sv, 0.05 * (su + sv));
    const Mat3d m{{{s[0], s[3], s[4]}, {s[3], s[1], s[5]}, {s[4], s[5], s[2]}}};
    EXPECT_NEAR(dot(t1, m * t1), su, 0.05 * (su + sv));
    EXPECT_NEAR(dot(t1, m * t2), wuv / w - cu * cv, 0.05 * (su + sv));
    EXPECT_NEAR(dot(n, m * n), 0, 1e-12 * (su + sv));
  }
  EXPECT_GE(compared, 5);
}

// A point that enters the patch brings no weight with it: the centre moves less and less as the step shrinks.
TEST(PolyPatch, ContinuousInThePose) {
  const Polyhedron box = shapes::make_box({1, 1, 1});
  const double step = 1e-7;
  Vec3d previous{};
  for (int i = 0; i < 4000; ++i) {
    const Quatd q = turn({0, 1, 0}, (i - 2000) * step);
    const Contact c = PolyhedronPlane::query(place(box, 1, q), {{0, 0, 1}}, {0, 0, -0.49999}, {}, nullptr);
    if (i > 0) {
      EXPECT_LE(norm(c.patch.centre - previous), 0.02);
    }
    previous = c.patch.centre;
  }
}

TEST(PolyPatch, PlaneAgainstFiftyDigits) {
  const Polyhedron solids[2] = {shapes::make_box({1, 0.5, 0.2}), grain("cement140_04.off")};
  Draw draw(17);
  for (int i = 0; i < 2000; ++i) {
    const Polyhedron& p = solids[i % 2];
    const double scale = std::exp2(draw.between(-9, 9));
    const Quatd q = draw.orientation();
    const Vec3d n = draw.direction(), d = draw.direction() * (scale * p.circumradius * draw.between(0, 3));
    const Contact c = PolyhedronPlane::query(place(p, scale, q), {n}, d, {}, nullptr);
    const Solid<Wide> solid(p, scale, q, {});
    const Wide exact = -solid.highest(widen<Wide>(-n)) - dot(widen<Wide>(n), widen<Wide>(d));
    const double allowed = 64 * epsilon * (norm(d) + scale * p.circumradius);
    ASSERT_LE(std::abs(static_cast<double>(Wide(c.gap) - exact)), allowed);
    ASSERT_LE(Wide(c.gap_lower), exact);
    ASSERT_GE(Wide(c.gap_upper), exact);
    ASSERT_LE(c.gap_upper - c.gap_lower, 4 * allowed);
    ASSERT_EQ(c.normal, -n);
  }
}

}  // namespace
