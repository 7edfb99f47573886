// Smooth bodies feel no tangential force, whatever they remember.
#include <limits>

#include "libcontact/laws/tangential/frictionless.h"
#include "tests/libcontact/tangential_path.h"

namespace contact::tests {
namespace {

TEST(Frictionless, GivesNothingAndKeepsNothing) {
  for (const double friction : {0.0, 0.3, std::numeric_limits<double>::infinity()}) {
    Path<Frictionless> path;
    path.pair.friction = friction;
    path.damping_t = 10;
    path.state.force = {1, 2, 0};
    const auto out = path.step(1e-5, {3e-6, 4e-6, 0});
    EXPECT_EQ(shapes::norm(out.force), 0);
    EXPECT_EQ(out.energy, 0);
    EXPECT_EQ(shapes::norm(path.state.force), 0);
  }
}

TEST(Frictionless, LanesAreScalars) { expect_lanes_are_scalars<Frictionless>(1, sheet_pair<double>()); }

}  // namespace
}  // namespace contact::tests
