#include "studies/measures/sample_distances.h"

#include <gtest/gtest.h>

#include "maps/support/random_maps.h"
#include "somato/core/check.h"
#include "somato/core/random.h"
#include "studies/measures/nearest_neighbour.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

// Four points of a line: 0, 1, 3, 10.
Matrix<double> line() {
  return distances_between(Samples(Matrix<float>(4, 1, {0, 1, 3, 10})), 1);
}

TEST(DistancesBetween, AreEuclidean) {
  const Samples samples(Matrix<float>(3, 2, {0, 0, 3, 4, 3, 0}));
  const Matrix<double> expected(3, 3, {0, 5, 3, 5, 0, 4, 3, 4, 0});
  EXPECT_EQ(distances_between(samples, 1), expected);
}

TEST(DistancesBetween, AreTheSameForSparseSamples) {
  const Samples samples = Samples::from_signals({Signal::sparse({1000}, {}, {}),
                                                 Signal::sparse({1000}, {7, 900}, {3, 4}),
                                                 Signal::sparse({1000}, {7}, {3})});
  ASSERT_TRUE(samples.is_sparse());
  const Matrix<double> expected(3, 3, {0, 5, 3, 5, 0, 4, 3, 4, 0});
  EXPECT_EQ(distances_between(samples, 1), expected);
}

TEST(DistancesBetween, DoNotDependOnThreads) {
  Random random(3);
  const Samples samples = testing::random_samples(17, 5, true, random);
  EXPECT_EQ(distances_between(samples, 3), distances_between(samples, 1));
}

// 0 -> 1 right, 1 -> 0 right, 3 -> 1 wrong, 10 -> 3 right: 3 of 4. By chance one of three each.
TEST(NeighbourAccuracy, LeavesEachSampleOut) {
  const NeighbourAccuracy found = neighbour_accuracy(line(), {0, 0, 1, 1}, {0, 1, 2, 3});
  EXPECT_DOUBLE_EQ(found.accuracy, 0.75);
  EXPECT_DOUBLE_EQ(found.chance, 1.0 / 3.0);
}

// In class 0 are 0, 1 and 10, and 0 and 1 are one thing. Left of it for both: 3 and 10, and 3 is
// nearer: wrong, wrong. The neighbour of 3 is 1: wrong. That of 10 is 3: wrong; by chance 2 of 3.
TEST(NeighbourAccuracy, LeavesTheSamplesOfAGroupOut) {
  const NeighbourAccuracy found = neighbour_accuracy(line(), {0, 0, 1, 0}, {0, 0, 1, 2});
  EXPECT_DOUBLE_EQ(found.accuracy, 0.0);
  EXPECT_DOUBLE_EQ(found.chance, (0.5 + 0.5 + 0.0 + 2.0 / 3.0) / 4.0);
}

TEST(NeighbourAccuracy, TakesTheFirstOfEquals) {
  const Matrix<double> distances = distances_between(Samples(Matrix<float>(3, 1, {2, 0, 1})), 1);
  EXPECT_DOUBLE_EQ(neighbour_accuracy(distances, {0, 1, 0}, {0, 1, 2}).accuracy, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(neighbour_accuracy(distances, {1, 0, 0}, {0, 1, 2}).accuracy, 1.0 / 3.0);
}

TEST(NeighbourAccuracy, AgreesWithTheBaselineOfStudies) {
  Random random(11);
  for (int problem = 0; problem < 100; ++problem) {
    const std::size_t count = 3 + random.below(10);
    const Samples samples = testing::random_samples(count, 6, problem % 2 == 0, random);
    Numbers classes(count);
    Numbers groups(count);
    for (std::size_t i = 0; i < count; ++i) {
      classes[i] = random.below(3);
      groups[i] = i < 2 ? i : random.below(4);
    }
    std::size_t right = 0;
    for (std::size_t test = 0; test < count; ++test) {
      Numbers training;
      for (std::size_t i = 0; i < count; ++i) {
        if (groups[i] != groups[test]) training.push_back(i);
      }
      right += classes[nearest_neighbour(samples, training, test)] == classes[test] ? 1 : 0;
    }
    const double expected = static_cast<double>(right) / static_cast<double>(count);
    ASSERT_EQ(neighbour_accuracy(distances_between(samples, 1), classes, groups).accuracy,
              expected);
  }
}

TEST(NeighbourAccuracy, NeedsTwoGroups) {
  EXPECT_THROW((void)neighbour_accuracy(line(), {0, 0, 1, 1}, {5, 5, 5, 5}), InvalidArgument);
  EXPECT_THROW((void)neighbour_accuracy(line(), {0, 0, 1}, {0, 1, 2}), InvalidArgument);
}

// Within: 1 and 7, mean 4. Between: 3, 10, 2, 9, mean 6.
TEST(BetweenToWithin, DividesTheMeans) {
  EXPECT_DOUBLE_EQ(between_to_within(line(), {0, 0, 1, 1}).value(), 1.5);
}

TEST(BetweenToWithin, IsNothingWithoutBothKindsOfPairs) {
  EXPECT_FALSE(between_to_within(line(), {0, 0, 0, 0}).has_value());
  EXPECT_FALSE(between_to_within(line(), {0, 1, 2, 3}).has_value());
}

TEST(BetweenToWithin, IsNothingWhenClassesArePoints) {
  const Matrix<double> distances = distances_between(Samples(Matrix<float>(4, 1, {2, 2, 5, 5})), 1);
  EXPECT_FALSE(between_to_within(distances, {0, 0, 1, 1}).has_value());
}

}  // namespace
}  // namespace somato
