#include "studies/codes/neighbours.h"

#include <gtest/gtest.h>

#include <cmath>

#include "somato/core/random.h"

namespace somato {
namespace {

// On a line at 0, 1, 3, 3.
Samples on_a_line() {
  return Samples(Matrix<float>(4, 1, {0, 1, 3, 3}));
}

TEST(Neighbours, DistancesAreSquaredAndSymmetric) {
  const Matrix<float> expected(4, 4, {0, 1, 9, 9, 1, 0, 4, 4, 9, 4, 0, 0, 9, 4, 0, 0});
  EXPECT_EQ(squared_distances(on_a_line(), 1), expected);
}

TEST(Neighbours, DistancesDoNotDependOnThreads) {
  Random random(3);
  Matrix<float> values(40, 7);
  for (float& value : values.values()) value = static_cast<float>(random.normal());
  const Samples samples(values);
  EXPECT_EQ(squared_distances(samples, 1), squared_distances(samples, 4));
}

TEST(Neighbours, SparseSamplesHaveTheDistancesOfDenseOnes) {
  const Samples sparse =
      Samples::from_signals({Signal::sparse({5}, {1}, {2}), Signal::sparse({5}, {1, 4}, {2, 3}),
                             Signal::sparse({5}, {}, {})});
  EXPECT_EQ(squared_distances(sparse, 1), Matrix<float>(3, 3, {0, 9, 4, 9, 0, 13, 4, 13, 0}));
}

TEST(Neighbours, ManhattanDistancesAreSumsOfMagnitudes) {
  const Samples dense(Matrix<float>(3, 2, {0, 0, 3, -4, -1, 2}));
  EXPECT_EQ(manhattan_distances(dense, 2), Matrix<float>(3, 3, {0, 7, 3, 7, 0, 10, 3, 10, 0}));
}

TEST(Neighbours, SparseSamplesHaveTheManhattanDistancesOfDenseOnes) {
  const Samples sparse = Samples::from_signals({Signal::sparse({5}, {1, 3}, {2, -1}),
                                                Signal::sparse({5}, {0, 1, 4}, {1, -2, 3}),
                                                Signal::sparse({5}, {}, {})});
  // 1 + 4 + 1 + 3, then the sums of the magnitudes
  EXPECT_EQ(manhattan_distances(sparse, 1), Matrix<float>(3, 3, {0, 9, 3, 9, 0, 6, 3, 6, 0}));
}

// The mean is 7 / 4; the squared distances from it add up to 0 + 1 + 9 + 9 - 49 / 4 = 27 / 4.
TEST(Neighbours, SpreadIsTheMeanSquaredDistanceFromTheMean) {
  EXPECT_DOUBLE_EQ(spread_of(squared_distances(on_a_line(), 1)), 27.0 / 16.0);
}

TEST(Neighbours, TheNearestOtherIsTheFirstInATie) {
  EXPECT_EQ(nearest_others(squared_distances(on_a_line(), 1)),
            (std::vector<std::uint32_t>{1, 0, 3, 2}));
  EXPECT_EQ(nearest_others(Matrix<float>(3, 3)), (std::vector<std::uint32_t>{1, 0, 0}));
}

TEST(Neighbours, TiedSamplesShareTheirMeanRank) {
  Matrix<float> ranks(4, 4);
  add_ranks(squared_distances(on_a_line(), 1), 2, ranks);
  EXPECT_EQ(ranks, Matrix<float>(4, 4, {0, 1, 2.5, 2.5, 1, 0, 2.5, 2.5, 3, 2, 0, 1, 3, 2, 1, 0}));
  add_ranks(squared_distances(on_a_line(), 1), 1, ranks);
  EXPECT_EQ(ranks(0, 2), 5.0F);
}

TEST(Neighbours, ImbalanceIsTwoByTheCountForEqualNeighbours) {
  Matrix<float> ranks(4, 4);
  const Matrix<float> distances = squared_distances(on_a_line(), 1);
  add_ranks(distances, 1, ranks);
  EXPECT_DOUBLE_EQ(information_imbalance(nearest_others(distances), ranks), 0.5);
}

// The mean of N uniform ranks from 1 to N - 1 is N / 2, with a standard deviation of about
// sqrt(N / 12), so that the imbalance is 1 with one of 1 / sqrt(3 N).
TEST(Neighbours, ImbalanceIsOneByChance) {
  constexpr std::size_t kRows = 300;
  Random random(5);
  Matrix<float> a(kRows, 3);
  Matrix<float> b(kRows, 3);
  for (float& value : a.values()) value = static_cast<float>(random.normal());
  for (float& value : b.values()) value = static_cast<float>(random.normal());
  Matrix<float> ranks(kRows, kRows);
  add_ranks(squared_distances(Samples(b), 1), 1, ranks);
  const auto nearest = nearest_others(squared_distances(Samples(a), 1));
  EXPECT_NEAR(information_imbalance(nearest, ranks), 1.0, 4.0 / std::sqrt(3.0 * kRows));
}

}  // namespace
}  // namespace somato
