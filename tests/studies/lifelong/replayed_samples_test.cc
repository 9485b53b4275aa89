#include "studies/lifelong/replayed_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

// Sample 0 belongs to another object. The mean of the others is 4.
const Samples kReplayedSamples(Matrix<float>(6, 1, {100, 9, 0, 5, 4, 2}));
const Numbers kObject{1, 2, 3, 4, 5};

Numbers chosen(ReplayChoice choice, std::size_t count, std::uint64_t seed = 1) {
  Random random(seed);
  return choose_samples(choice, count, kReplayedSamples, kObject, random);
}

TEST(Replay, KeepsTheFirst) {
  EXPECT_EQ(chosen(ReplayChoice::kFirst, 2), (Numbers{1, 2}));
}

TEST(Replay, KeepsThoseNearestToTheMean) {
  EXPECT_EQ(chosen(ReplayChoice::kNearestToMean, 2), (Numbers{3, 4}));
}

// 4 is nearest to the mean; 9 is 5 away from it, 0 is 4; then 0; then 2, which is 2 away from both
// 0 and 4, where 5 is 1 away.
TEST(Replay, KeepsThoseMostDistantFromEachOther) {
  EXPECT_EQ(chosen(ReplayChoice::kMostDistant, 1), (Numbers{4}));
  EXPECT_EQ(chosen(ReplayChoice::kMostDistant, 2), (Numbers{1, 4}));
  EXPECT_EQ(chosen(ReplayChoice::kMostDistant, 3), (Numbers{1, 2, 4}));
  EXPECT_EQ(chosen(ReplayChoice::kMostDistant, 4), (Numbers{1, 2, 4, 5}));
}

TEST(Replay, DrawsDifferentOnesAtRandom) {
  std::set<Numbers> drawn;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Numbers two = chosen(ReplayChoice::kRandom, 2, seed);
    ASSERT_EQ(two.size(), 2U);
    EXPECT_LT(two[0], two[1]);
    EXPECT_GE(two[0], 1U);
    drawn.insert(two);
  }
  EXPECT_EQ(drawn.size(), 10U);  // all pairs of five: one is missed with a probability of 0.02
}

TEST(Replay, KeepsAllWhereThereAreFewer) {
  for (const auto& [choice, name] : Choices<ReplayChoice>::all()) {
    EXPECT_EQ(chosen(choice, 9), kObject) << name;
    EXPECT_EQ(chosen(choice, 0), Numbers{}) << name;
  }
  Random random(1);
  EXPECT_EQ(choose_samples(ReplayChoice::kMostDistant, 2, kReplayedSamples, {}, random), Numbers{});
}

// Equal samples are all 0 apart; each is chosen once.
TEST(Replay, ChoosesEqualSamplesOnce) {
  const Samples equal(Matrix<float>(4, 2, 3.0F));
  Random random(1);
  EXPECT_EQ(choose_samples(ReplayChoice::kMostDistant, 3, equal, {0, 1, 2, 3}, random),
            (Numbers{0, 1, 2}));
}

Som three_neurons() {
  SomParameters p;
  p.rows = 1;
  p.columns = 3;
  return {resolve(p, 1, 1).value(), Matrix<float>(3, 1, {0, 10, 50})};
}

// Neuron 0 has three votes for class 1, neuron 2 one; neuron 1 has the name of class 0 in spite of
// a vote for class 1. Nearest others are 10 and 40 away.
TEST(Replay, GeneratesVectorsAroundTheNeuronsOfAClass) {
  NeuronVotes votes(3);
  votes.add(0, 1, 3);
  votes.add(1, 0, 2);
  votes.add(1, 1, 1);
  votes.add(2, 1, 1);
  Random random(4);
  const Matrix<float> exact = generated_vectors(400, 0.0, three_neurons(), votes, 1, random);
  double at_first = 0.0;
  for (std::size_t i = 0; i < 400; ++i) {
    ASSERT_TRUE(exact(i, 0) == 0.0F || exact(i, 0) == 50.0F);
    at_first += exact(i, 0) == 0.0F ? 1.0 : 0.0;
  }
  EXPECT_NEAR(at_first / 400.0, 0.75, 0.11);  // five standard deviations
  const Matrix<float> spread = generated_vectors(2000, 0.1, three_neurons(), votes, 1, random);
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < 2000; ++i) {
    if (std::abs(spread(i, 0)) > 20.0F) continue;  // of neuron 2, whose deviation is 4
    squares += double{spread(i, 0)} * double{spread(i, 0)};
    count += 1.0;
  }
  EXPECT_NEAR(std::sqrt(squares / count), 1.0, 0.1);
  EXPECT_EQ(generated_vectors(5, 0.1, three_neurons(), votes, 7, random).rows(), 0U);
}

}  // namespace
}  // namespace somato
