#include "somato/studies/next_grasp.h"

#include <gtest/gtest.h>

#include <cmath>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Values = std::vector<double>;

Values random_shares(std::size_t count, Random& random) {
  Values shares(count);
  double sum = 0.0;
  for (double& share : shares) sum += share = random.below(4) == 0 ? 0.0 : random.uniform();
  shares.front() += 0.01;
  for (double& share : shares) share /= sum + 0.01;
  return shares;
}

ReadingProbabilities random_grasp(std::size_t classes, std::size_t readings, Random& random) {
  ReadingProbabilities grasp;
  for (std::size_t i = 0; i < classes; ++i) grasp.push_back(random_shares(readings, random));
  return grasp;
}

double entropy_of(const Values& probabilities) {
  double entropy = 0.0;
  for (const double p : probabilities) entropy -= p > 0.0 ? p * std::log(p) : 0.0;
  return entropy;
}

// H(class | reading) = H(class, reading) - H(reading), from the table of all pairs.
double plain_expected_entropy(const Values& belief, const ReadingProbabilities& grasp) {
  Values pairs;
  Values readings(grasp.front().size(), 0.0);
  for (std::size_t c = 0; c < belief.size(); ++c) {
    for (std::size_t r = 0; r < readings.size(); ++r) {
      pairs.push_back(belief[c] * grasp[c][r]);
      readings[r] += pairs.back();
    }
  }
  return entropy_of(pairs) - entropy_of(readings);
}

TEST(NextGrasp, ExpectedEntropyIsThatOfTheTableOfAllPairs) {
  Random random(2);
  for (std::size_t trial = 0; trial < 50; ++trial) {
    const std::size_t classes = 1 + random.below(5);
    const Values belief = random_shares(classes, random);
    const ReadingProbabilities grasp = random_grasp(classes, 1 + random.below(4), random);
    EXPECT_NEAR(expected_entropy(belief, grasp), plain_expected_entropy(belief, grasp), 1e-12);
    EXPECT_LE(expected_entropy(belief, grasp), entropy_of(belief) + 1e-12) << "a grasp informs";
  }
}

TEST(NextGrasp, IsTheOneWithTheLeastExpectedEntropy) {
  Random random(3);
  for (std::size_t trial = 0; trial < 50; ++trial) {
    const std::size_t classes = 2 + random.below(4);
    const Values belief = random_shares(classes, random);
    std::vector<ReadingProbabilities> grasps;
    for (std::size_t i = 0; i < 6; ++i) grasps.push_back(random_grasp(classes, 3, random));
    const std::vector<std::size_t> left{1, 3, 4};
    const std::size_t next = next_grasp(belief, grasps, left);
    for (const std::size_t other : left) {
      EXPECT_LE(plain_expected_entropy(belief, grasps[next]),
                plain_expected_entropy(belief, grasps[other]) + 1e-12);
    }
    EXPECT_TRUE(next == 1 || next == 3 || next == 4);
  }
}

// The first grasp separates a from b, the second c from the others, the third nothing.
TEST(NextGrasp, DependsOnWhatIsLeftToBeKnown) {
  const std::vector<ReadingProbabilities> grasps{
      {{1, 0}, {0, 1}, {0.5, 0.5}}, {{1, 0}, {1, 0}, {0, 1}}, {{0.5, 0.5}, {0.5, 0.5}, {0.5, 0.5}}};
  EXPECT_EQ(next_grasp({0.5, 0.5, 0.0}, grasps, {1, 0, 2}), 0U);
  EXPECT_EQ(next_grasp({0.5, 0.0, 0.5}, grasps, {2, 0, 1}), 1U);
  EXPECT_EQ(next_grasp({1.0, 0.0, 0.0}, grasps, {2, 1}), 2U) << "the first in a tie";
}

TEST(NextGrasp, BeliefsFollowBayesRule) {
  const ReadingProbabilities grasp{{0.75, 0.25}, {0.25, 0.75}};
  EXPECT_EQ(updated_belief({0.5, 0.5}, grasp, 0), (Values{0.75, 0.25}));
  EXPECT_EQ(updated_belief({0.25, 0.75}, grasp, 0), (Values{0.5, 0.5}));
}

TEST(NextGrasp, RefusesWhatDoesNotFit) {
  const ReadingProbabilities grasp{{1, 0}, {1, 0}};
  EXPECT_THROW((void)updated_belief({1}, grasp, 0), InvalidArgument);
  EXPECT_THROW((void)updated_belief({0.5, 0.5}, grasp, 2), InvalidArgument);
  EXPECT_THROW((void)updated_belief({0.5, 0.5}, grasp, 1), InvalidArgument) << "impossible";
  EXPECT_THROW((void)expected_entropy({}, {}), InvalidArgument);
  EXPECT_THROW((void)next_grasp({0.5, 0.5}, {grasp}, {}), InvalidArgument);
}

}  // namespace
}  // namespace somato
