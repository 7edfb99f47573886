// Profiles of a known flow, what leaves and comes, how long bodies stay.
#include <gtest/gtest.h>

#include "libdem/analysis/flow.h"
#include "libdem/analysis/settings.h"
#include "tests/libdem/analysis_result.h"
#include "tests/libdem/analysis_sets.h"

namespace dem::analysis {
namespace {

Snapshot of_ids(double time, const std::vector<std::uint64_t>& ids) {
  Snapshot s;
  s.time = time;
  for (const std::uint64_t id : ids) {
    sets::add_body(s, {static_cast<double>(id), 0, 0}, 0.5);
    s.id.back() = id;
    s.mass.back() = 1 + static_cast<double>(id);
  }
  return s;
}

TEST(AnalysisFlow, ProfileOfShear) {
  Snapshot s = sets::simple_cubic(8);
  Random random(3, 0, 0);
  for (std::size_t i = 0; i < s.count(); ++i) {
    const bool even = std::lround(s.position[i].y) % 2 == 0;
    s.velocity[i] = {0.5 * s.position[i].z, 0, even ? 0.1 : -0.1};
    s.spin[i] = {0, 0.25, 0};
  }
  const auto along_z = flow_profile(s, domain_of(s), 2, 8);
  ASSERT_EQ(along_z.size(), 8u);
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_NEAR(along_z[k].middle, static_cast<double>(k) + 0.5, 1e-12);
    EXPECT_EQ(along_z[k].bodies, 64);
    EXPECT_NEAR(along_z[k].velocity.x, 0.5 * static_cast<double>(k), 1e-12);
    EXPECT_NEAR(along_z[k].velocity.z, 0, 1e-12);
    EXPECT_NEAR(along_z[k].temperature, 0.01 / 3, 1e-12);
    EXPECT_NEAR(along_z[k].spin.y, 0.25, 1e-12);
  }
  const auto along_x = flow_profile(s, domain_of(s), 0, 2);
  EXPECT_NEAR(along_x[0].velocity.x, 0.5 * 3.5, 1e-12);
  EXPECT_NEAR(along_x[0].mass_flux, s.mass[0] * 0.5 * 3.5, 1e-9);  // one body per cubic metre
}

TEST(AnalysisFlow, WhatLeavesAndComes) {
  const Snapshot before = of_ids(2, {1, 4, 6, 9}), now = of_ids(4, {4, 9, 12});
  const Exchange e = exchange_between(before, now);
  EXPECT_EQ(e.left, (std::vector<std::uint32_t>{0, 2}));
  EXPECT_EQ(e.came, (std::vector<std::uint32_t>{2}));
  const Snapshot reference = of_ids(1, {1, 4, 9});
  Settings settings;
  settings.before = &before;
  settings.reference = &reference;
  const Result r = report_flow(now, settings);
  EXPECT_EQ(scalar(r, "discharge_rate"), (2.0 + 7.0) / 2);
  EXPECT_EQ(scalar(r, "discharge_rate_bodies"), 1);
  EXPECT_EQ(scalar(r, "inflow_rate"), 13.0 / 2);
  EXPECT_EQ(scalar(r, "left_since_reference"), 1);
  EXPECT_EQ(scalar(r, "residence_since_reference"), 2);
}

TEST(AnalysisFlow, StaysOverASeries) {
  Residence residence;
  residence.add(of_ids(0, {1, 2, 3}));
  residence.add(of_ids(1, {2, 3, 4}));
  residence.add(of_ids(2, {3, 4, 5}));
  residence.add(of_ids(4, {5}));
  const auto& stays = residence.stays();
  ASSERT_EQ(stays.size(), 4u);
  const std::uint64_t ids[] = {1, 2, 3, 4};
  const double entered[] = {0, 0, 0, 1}, left[] = {0.5, 1.5, 3, 3};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(stays[k].id, ids[k]);
    EXPECT_EQ(stays[k].entered, entered[k]);
    EXPECT_EQ(stays[k].left, left[k]);
    EXPECT_EQ(stays[k].from_start, k < 3);
  }
}

TEST(AnalysisFlow, EmptyAndFirstFrames) {
  EXPECT_EQ(report_flow(Snapshot{}, {}).notes.size(), 2u);
  Snapshot s = of_ids(1, {1});
  const Result r = report_flow(s, {});
  for (const Table& t : r.tables)
    for (const Column& c : t.columns)
      for (const double v : c.values) EXPECT_TRUE(std::isfinite(v));
  Settings settings;
  settings.before = &s;  // of the same time
  EXPECT_EQ(report_flow(s, settings).scalars.size(), 2u);
}

}  // namespace
}  // namespace dem::analysis
