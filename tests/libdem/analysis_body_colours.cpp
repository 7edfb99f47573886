// Colours of bodies: bands go with the bodies, fields are those of known motions, every word has an answer.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "libdem/analysis/body_colours.h"
#include "libdem/analysis/displacement.h"
#include "libdem/scene/where.h"
#include "tests/libdem/analysis_sets.h"

namespace dem::analysis {
namespace {

TEST(AnalysisBodyColours, BandsGoWithTheBodies) {
  const Snapshot before = sets::thrown(300, false, 4);
  Snapshot now = before;
  for (Vec3d& x : now.position) x = {x.z, 1 - x.y, x.x};  // turned over
  sets::add_body(now, {0.5, 0.5, 0.5}, 0.05);             // a new one
  for (const char* word : {"layers", "layers_x", "layers_y", "layers_z", "position", "density", "sizes"}) {
    const BodyColours then = body_colours(before, word, &before), here = body_colours(now, word, &before);
    EXPECT_EQ(here.names, then.names) << word;
    ASSERT_EQ(here.values.size(), 301u);
    for (std::size_t i = 0; i < 300; ++i) ASSERT_EQ(here.values[i], then.values[i]) << word;
    EXPECT_TRUE(std::isnan(here.values.back())) << word;
    EXPECT_FALSE(here.names.empty());
  }
  const BodyColours along_x = body_colours(now, "layers_x", &before);
  double low = 1, high = 0;
  for (const Vec3d& x : before.position) {
    low = std::min(low, x.x);
    high = std::max(high, x.x);
  }
  for (std::size_t i = 0; i < 300; ++i) {
    const double share = (before.position[i].x - low) / (high - low);
    EXPECT_EQ(along_x.values[i], std::min(std::floor(8 * share), 7.0));
  }
}

TEST(AnalysisBodyColours, FieldsOfKnownMotion) {
  const Snapshot before = sets::thrown(300, false, 4);
  Snapshot now = before;
  const double turn = 0.2, c = std::cos(turn), s = std::sin(turn), shear = 3;
  for (std::size_t i = 0; i < now.count(); ++i) {
    const Vec3d x = before.position[i];
    now.position[i] = {c * x.x - s * x.y, s * x.x + c * x.y, x.z};
    now.velocity[i] = {shear * now.position[i].z, 0, 0};
  }
  const auto expect_all = [&](const char* word, double value, double within = 1e-9) {
    const BodyColours colours = body_colours(now, word, &before);
    EXPECT_TRUE(colours.names.empty());
    std::size_t known = 0;
    for (const double v : colours.values) {
      if (std::isnan(v)) continue;
      ++known;
      ASSERT_NEAR(v, value, within) << word;
    }
    EXPECT_GT(known, 290u) << word;
  };
  expect_all("strain", 0);  // a rigid turn has none
  expect_all("volume_change", 0);
  expect_all("non_affine", 0, 1e-7);  // the root of what rounding leaves
  expect_all("rotation", 2 * s);      // |∇ × u| of a finite turn
  expect_all("vorticity", shear);
  // Shear rate: the deviator of a simple shear's symmetric part, as of one gradient.
  Mat3d simple{};
  simple.row[0][2] = simple.row[2][0] = 0.5 * shear;
  expect_all("shear_rate", deviator(simple, 3));
  const BodyColours way = body_colours(now, "displacement", &before);
  for (std::size_t i = 0; i < now.count(); ++i)
    EXPECT_NEAR(way.values[i], norm(now.position[i] - before.position[i]), 1e-12);
  const BodyColours contacts = body_colours(now, "contacts", nullptr);
  double sum = 0;
  for (const double v : contacts.values) sum += v;
  EXPECT_EQ(sum, 2.0 * static_cast<double>(now.contacts.size()));
}

TEST(AnalysisBodyColours, EveryWordOfEverySet) {
  Snapshot one;
  sets::add_body(one, {}, 1);
  const Snapshot plane = sets::hexagonal(4);
  for (const std::string& word : body_colour_words())
    for (const Snapshot* s : std::initializer_list<const Snapshot*>{&one, &plane}) {
      const BodyColours colours = body_colours(*s, word, nullptr);
      ASSERT_EQ(colours.values.size(), s->count()) << word;
      for (const double v : colours.values)
        if (!colours.names.empty()) {
          ASSERT_GE(v, 0);
          ASSERT_LT(v, static_cast<double>(colours.names.size()));
        }
      EXPECT_FALSE(colours.label.empty());
      EXPECT_TRUE(body_colours(Snapshot{}, word, nullptr).values.empty());
    }
  EXPECT_THROW(body_colours(one, "layer", nullptr), InputError);
  EXPECT_FALSE(needs_reference("vorticity"));
  EXPECT_TRUE(needs_reference("layers"));
}

}  // namespace
}  // namespace dem::analysis
