// Sphere pairs in bulk: the bits of the scalar closed form, for every length and kernel set, and nothing written
// beyond.
#include "libcontact/sphere_pairs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "libcontact/kernels/chunk.h"
#include "libcontact/methods/analytic.h"
#include "shapes/math/random.h"
#include "tests/libcontact/same_bits.h"

namespace contact {
namespace {

using Ball = Placed<shapes::Sphere>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();

struct Pairs {
  std::vector<SphereRow> spheres;
  std::vector<std::uint32_t> a, b;
};

Pairs plain(std::uint64_t seed, std::size_t count) {
  Pairs p;
  const std::size_t bodies = 50;
  for (std::size_t i = 0; i < bodies; ++i) {
    shapes::Random draw(seed, 1, i);
    const double away = 3 * draw.uniform();
    p.spheres.push_back({away * draw.direction(), std::pow(1e3, -draw.uniform())});
  }
  for (std::size_t i = 0; i < count; ++i) {
    shapes::Random draw(seed, 2, i);
    const auto a = static_cast<std::uint32_t>(draw.uniform() * bodies);
    p.a.push_back(a);
    p.b.push_back((a + 1 + static_cast<std::uint32_t>(draw.uniform() * (bodies - 1))) % bodies);
  }
  return p;
}

struct Answers {
  static constexpr double untouched = -12345;
  std::vector<double> v;
  std::size_t stride;
  explicit Answers(std::size_t count) : v(7 * (count + 1), untouched), stride(count + 1) {}
  SphereAnswers out() {
    double* const r = v.data();
    return {r, {r + stride, r + 2 * stride, r + 3 * stride}, {r + 4 * stride, r + 5 * stride, r + 6 * stride}};
  }
};

Contact scalar(const Pairs& p, std::size_t i) {
  const SphereRow &a = p.spheres[p.a[i]], &b = p.spheres[p.b[i]];
  return Analytic::query(Ball{a.radius}, Ball{b.radius}, b.centre - a.centre, {}, nullptr);
}

void expect_scalar(const Pairs& p, std::size_t count, Answers& answers) {
  const SphereAnswers out = answers.out();
  for (std::size_t i = 0; i < count; ++i) {
    const Contact c = scalar(p, i);
    EXPECT_TRUE(same_bits(out.gap[i], c.gap)) << count << " " << i << " " << out.gap[i] << " " << c.gap;
    for (int k = 0; k < 3; ++k) {
      EXPECT_TRUE(same_bits(out.normal[k][i], c.normal[k])) << count << " " << i << " " << k;
      EXPECT_TRUE(same_bits(out.point[k][i], c.patch.centre[k])) << count << " " << i << " " << k;
    }
  }
  for (int array = 0; array < 7; ++array)
    EXPECT_EQ(answers.v[static_cast<std::size_t>(array) * answers.stride + count], Answers::untouched) << count;
}

TEST(SpherePairs, have_the_bits_of_the_closed_form_at_every_length) {
  for (std::size_t count = 0; count <= 70; ++count) {
    const Pairs p = plain(count, count);
    Answers answers(count);
    sphere_pairs(p.spheres.data(), p.a.data(), p.b.data(), count, answers.out());
    expect_scalar(p, count, answers);
  }
}

TEST(SpherePairs, have_the_same_bits_in_every_kernel_set) {
  for (const kernels::KernelSet* set : kernels::kernel_sets())
    for (std::size_t count = 1; count <= 70; ++count) {
      const Pairs p = plain(100 + count, count);
      Answers answers(count);
      EXPECT_TRUE(set->pairs.sphere_pairs(p.spheres.data(), p.a.data(), p.b.data(), count, answers.out())) << set->name;
      expect_scalar(p, count, answers);
    }
}

// One odd pair at a time among plain ones, in every place of a list: it answers as the scalar query does, the others
// too.
TEST(SpherePairs, odd_pairs_answer_as_the_closed_form) {
  const double odd[][3] = {// distance, radius of a, radius of b
                           {0, 1, 1},
                           {1, 0, 1},
                           {1, 1, -1},
                           {1, nan, 1},
                           {nan, 1, 1},
                           {inf, 1, 1},
                           {1, inf, 1},
                           {1, 1, 0x1p950},
                           {0x1p500, 1, 1},
                           {0x1p-500, 1, 1},
                           {0x1p-500, 0x1p-500, 0x1p-501},
                           {0x1p500, 0x1p500, 0x1p499},
                           {0x1p970, 1, 1},
                           {0x1p-1000, 0x1p-1010, 0x1p-1010}};
  int refused = 0, answered = 0;
  for (const auto& [distance, ra, rb] : odd)
    for (std::size_t place = 0; place < 45; place += 4) {
      Pairs p = plain(7, 45);
      p.a[place] = static_cast<std::uint32_t>(p.spheres.size());
      p.b[place] = p.a[place] + 1;
      p.spheres.push_back({{}, ra});
      p.spheres.push_back({{0.6 * distance, 0, -0.8 * distance}, rb});
      Answers answers(45);
      sphere_pairs(p.spheres.data(), p.a.data(), p.b.data(), 45, answers.out());
      expect_scalar(p, 45, answers);
      (scalar(p, place).status == Status::refused ? refused : answered) += 1;
    }
  EXPECT_GT(refused, 50);
  EXPECT_GT(answered, 50);
}

}  // namespace
}  // namespace contact
