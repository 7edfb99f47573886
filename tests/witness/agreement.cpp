// FCL 0.7 and libccd 2.1 as witnesses: what they say of a pair never contradicts the certified interval, and where they
// are accurate the gaps agree.
//
// FCL's signed distance is good to its tolerance 1e-6 on polyhedra; on curved bodies its penetration is right to about
// 1e-3 of the size (Drake publishes 5e-4 on bodies of 20 cm). libccd's EPA stops at 1e-4 and is off by more where its
// first simplex lies badly; its MPR measures the depth along its own direction, which is not the least one.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/witness/compare.h"
#include "tests/witness/random_pairs.h"

namespace witness {
namespace {

constexpr Query queries[] = {Query::fcl, Query::epa, Query::mpr};

contact::Contact ours(const Pair& pair) { return contact::query(pair.a.placed(), pair.b.placed(), pair.offset); }

Tally compare(Query query, const std::vector<Pair>& pairs, const std::vector<contact::Contact>& contacts,
              const std::string& name) {
  const std::vector<Answer> answers = ask(query, pairs);
  Tally tally;
  for (std::size_t i = 0; i < pairs.size(); ++i) tally.add(pairs[i], contacts[i], answers[i]);
  const std::string line = tally.line(name + ", " + name_of(query));
  std::printf("%s\n", line.c_str());
  for (const std::string& failure : tally.failures) ADD_FAILURE() << name << ", " << name_of(query) << ", " << failure;
  return tally;
}

std::vector<contact::Contact> certified(const std::vector<Pair>& pairs) {
  std::vector<contact::Contact> contacts;
  for (const Pair& pair : pairs) {
    contacts.push_back(ours(pair));
    EXPECT_TRUE(contacts.back().certified) << pair.name;
  }
  return contacts;
}

void skip_without_peers() {
#ifndef TEST_HAS_FCL
  GTEST_SKIP() << "built without FCL and libccd";
#endif
}

double share(int part, int whole) { return whole == 0 ? 1 : static_cast<double>(part) / whole; }

struct Kinds {
  const char* name;
  Family a, b;
  bool flat;  // both polyhedra: FCL ends on a feature of the Minkowski difference, exact to rounding
};

const Kinds all_kinds[] = {{"box_box", Family::box, Family::box, true},
                           {"polyhedron_polyhedron", Family::grain, Family::grain, true},
                           {"ellipsoid_ellipsoid", Family::ellipsoid, Family::ellipsoid, false},
                           {"sphere_box", Family::sphere, Family::box, false},
                           {"ellipsoid_box", Family::ellipsoid, Family::box, false},
                           {"sphere_ellipsoid", Family::sphere, Family::ellipsoid, false}};

class Witnesses : public testing::TestWithParam<Kinds> {
 protected:
  void SetUp() override { skip_without_peers(); }
};

// Shares of gaps within 1e-3 L that the peers manage on bodies of moderate shape and overlap: FCL and MPR 98 % and more
// here, EPA two thirds (on harder pairs 95 %, 80 % and 69 %).
TEST_P(Witnesses, DoNotContradictTheCertifiedInterval) {
  const Kinds kinds = GetParam();
  const std::vector<Pair> pairs = random_pairs(kinds.a, kinds.b, 400, 1);
  const std::vector<contact::Contact> contacts = certified(pairs);
  for (const Query query : queries) {
    const Tally tally = compare(query, pairs, contacts, kinds.name);
    EXPECT_GE(share(tally.answered(), tally.pairs), 0.95);
    EXPECT_LE(share(tally.refuted, tally.yes_no), 0.01);
    EXPECT_GE(share(tally.within_3, tally.gaps), query == Query::epa ? 0.6 : 0.9);
    if (query != Query::fcl) continue;
    EXPECT_GE(share(tally.points - tally.points_off, tally.points), 0.75);
    if (kinds.flat) {
      EXPECT_GE(share(tally.within_6, tally.gaps), 0.9);
    }
  }
}

// An answer that is off by 1e-3 L must not pass. Separated: both ways. Overlapping: a gap that is too low is refuted by
// the support separation along FCL's normal; too high only where its points leave room for balls.
TEST_P(Witnesses, RefuteAnAnswerThatIsOff) {
  const Kinds kinds = GetParam();
  const std::vector<Pair> pairs = random_pairs(kinds.a, kinds.b, 200, 2);
  const std::vector<contact::Contact> contacts = certified(pairs);
  const std::vector<Answer> answers = ask(Query::fcl, pairs);
  int refuted[2][2] = {}, asked[2][2] = {};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (answers[i].end != Answer::End::answered) continue;
    const Proof proof = witness::proof(pairs[i], answers[i]);
    const contact::Contact& c = contacts[i];
    for (const int up : {0, 1}) {
      const double shift = (up ? 1e-3 : -1e-3) * pairs[i].size();
      const int overlap = c.gap < 0;
      if (up && !overlap && std::isinf(proof.above)) continue;  // its points are off the bodies
      ++asked[overlap][up];
      refuted[overlap][up] += !contradiction(pairs[i], proof, c.gap_lower + shift, c.gap_upper + shift).empty();
    }
  }
  std::printf(
      "%s, refuted: separated %d of %d too low, %d of %d too high; overlapping %d of %d too low, %d of %d too high\n",
      kinds.name, refuted[0][0], asked[0][0], refuted[0][1], asked[0][1], refuted[1][0], asked[1][0], refuted[1][1],
      asked[1][1]);
  EXPECT_GE(share(refuted[0][0], asked[0][0]), 0.9);
  EXPECT_GE(share(refuted[0][1], asked[0][1]), 0.9);
  EXPECT_GE(share(refuted[1][0], asked[1][0]), 0.9);
  for (const int overlap : {0, 1}) EXPECT_GE(asked[overlap][0], 90);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Witnesses, testing::ValuesIn(all_kinds),
                         [](const auto& info) { return std::string(info.param.name); });

// The pairs that peers were seen to fail on: thin, nested, touching, far off. Here EPA sees 2 overlaps wrongly.
TEST(WitnessesOfTheCaseFile, DoNotContradictTheCertifiedInterval) {
  skip_without_peers();
  if (IsSkipped()) return;
  const std::vector<Pair> pairs = case_file_pairs();
  EXPECT_EQ(pairs.size(), 65u);
  const std::vector<contact::Contact> contacts = certified(pairs);
  for (const Query query : queries) {
    const Tally tally = compare(query, pairs, contacts, "cases");
    EXPECT_GE(share(tally.answered(), tally.pairs), 0.95);
    EXPECT_LE(share(tally.refuted, tally.yes_no), 0.05);
    EXPECT_GE(share(tally.within_3, tally.gaps), query == Query::fcl ? 0.9 : (query == Query::epa ? 0.65 : 0.75));
  }
}

// FCL does not come back from two coincident spheres: that pair is lost, the ones about it are not.
TEST(WitnessesOfTheCaseFile, AHangLosesOnePair) {
  skip_without_peers();
  if (IsSkipped()) return;
  Pair pair;
  pair.a.size = pair.b.size = {1, 1, 1};
  std::vector<Pair> pairs(3, pair);
  pairs[0].offset = pairs[2].offset = {3, 0, 0};
  const std::vector<Answer> answers = ask(Query::fcl, pairs);
  EXPECT_EQ(answers[1].end, Answer::End::hung);
  for (const std::size_t i : {std::size_t{0}, std::size_t{2}}) {
    EXPECT_EQ(answers[i].end, Answer::End::answered);
    EXPECT_NEAR(answers[i].gap, 1, 1e-5);
  }
}

}  // namespace
}  // namespace witness
