// Steady parts, means with their errors, block means of numbers over time.
#include <gtest/gtest.h>

#include <cmath>

#include "libdem/analysis/series.h"
#include "libdem/random.h"

namespace {

using namespace dem::analysis;

double normal(dem::Random& random) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += random.uniform();
  return sum;
}

// x_i = memory · x_{i−1} + noise; variance 1.
std::vector<double> remembering(std::size_t count, double memory, std::uint64_t seed) {
  dem::Random random(seed, 0, 0);
  std::vector<double> x(count);
  double last = normal(random);
  for (double& v : x) v = last = memory * last + std::sqrt(1 - memory * memory) * normal(random);
  return x;
}

TEST(AnalysisSeries, ConstantIsSteadyWithoutError) {
  for (const std::size_t n : {16u, 49u, 50u, 1000u}) {
    const std::vector<double> x(n, 0.1);
    EXPECT_TRUE(steady_part(x).steady);
    EXPECT_EQ(steady_part(x).from, 0u);
    const MeanOverTime m = mean_over_time(x);
    EXPECT_EQ(m.mean, 0.1);
    EXPECT_EQ(m.error, 0.0);
    EXPECT_EQ(m.deviation, 0);
  }
}

TEST(AnalysisSeries, ADecayIsCutOffAndADriftIsNotSteady) {
  std::vector<double> x = remembering(1000, 0.3, 1);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += 50 * std::exp(-static_cast<double>(i) / 20);
  const SteadyPart part = steady_part(x);
  EXPECT_TRUE(part.steady);
  EXPECT_GT(part.from, 60u);  // the decay has come down to 50 exp(−3) = 2.5
  EXPECT_LT(part.from, 200u);
  EXPECT_EQ(part.from % 5, 0u);
  std::vector<double> ramp;
  for (int i = 0; i < 40; ++i) ramp.push_back(i);
  EXPECT_TRUE(steady_part(ramp).decided);
  EXPECT_FALSE(steady_part(ramp).steady);
  EXPECT_EQ(steady_part(ramp).from, 0u);
}

TEST(AnalysisSeries, ShortSeriesAreNotDecided) {
  EXPECT_FALSE(steady_part({}).decided);
  EXPECT_FALSE(steady_part(std::vector<double>(15, 1.0)).decided);
  EXPECT_EQ(mean_over_time({}).count, 0u);
  EXPECT_FALSE(mean_over_time({}).error);
  EXPECT_FALSE(mean_over_time(std::vector<double>{3}).error);
  EXPECT_EQ(mean_over_time(std::vector<double>{3}).mean, 3);
  const MeanOverTime two = mean_over_time(std::vector<double>{1, 3});
  EXPECT_EQ(two.mean, 2);
  EXPECT_NEAR(two.error.value_or(0), 1, 1e-15);
  EXPECT_FALSE(two.settled);
}

// The error of the mean of a first-order process is sqrt((1 + a)/(1 − a)/n); the mean itself lies within it as often as
// it must.
TEST(AnalysisSeries, ErrorOfAProcessWithMemory) {
  for (const double memory : {0.0, 0.8, 0.95}) {
    constexpr std::size_t n = 16384;
    const double exact = std::sqrt((1 + memory) / (1 - memory) / static_cast<double>(n));
    double sum = 0;
    int within = 0, settled = 0;
    constexpr int runs = 40;
    for (std::uint64_t seed = 0; seed < runs; ++seed) {
      const MeanOverTime m = mean_over_time(remembering(n, memory, 100 + seed));
      sum += *m.error;
      settled += m.settled ? 1 : 0;
      within += std::abs(m.mean) < 2 * *m.error ? 1 : 0;
    }
    EXPECT_NEAR(sum / runs / exact, 1, 0.15) << memory;
    EXPECT_GE(within, 34) << memory;  // 38 expected
    EXPECT_GE(settled, 36) << memory;
  }
}

TEST(AnalysisSeries, ALongMemoryIsSaid) {
  std::vector<double> ramp;
  for (int i = 0; i < 1024; ++i) ramp.push_back(i);
  const MeanOverTime m = mean_over_time(ramp);
  EXPECT_FALSE(m.settled);
  EXPECT_EQ(m.block, 128u);
}

TEST(AnalysisSeries, BlocksCoverTheSeries) {
  std::vector<double> x;
  for (int i = 0; i < 23; ++i) x.push_back(i);
  const auto blocks = block_means(x, 5);
  ASSERT_EQ(blocks.size(), 5u);
  std::size_t next = 0;
  for (const Block& b : blocks) {
    EXPECT_EQ(b.first, next);
    EXPECT_GE(b.count, 4u);
    EXPECT_DOUBLE_EQ(b.mean, static_cast<double>(b.first) + 0.5 * static_cast<double>(b.count - 1));
    next += b.count;
  }
  EXPECT_EQ(next, x.size());
  EXPECT_NEAR(block_means(x, 1)[0].error, std::sqrt(23.0 * 24 / 12 / 23), 1e-12);  // of 0 … n − 1: n (n + 1)/12
  EXPECT_EQ(block_means(x, 100).size(), 11u);
  EXPECT_TRUE(block_means(std::vector<double>{1}, 10).empty());
}

}  // namespace
