#include "studies/measures/paper_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "base/core/rank_correlation.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;
using Values = std::vector<double>;
using Individuals = std::vector<MappedIndividual>;

constexpr std::uint64_t kMeasureSeed = 5;

// Class 0 is at 7 twice and at 3 once, class 1 at 3 once and at 7 once: the two at 7 share it.
TEST(SamplesSharingWithOwn, CountsThoseOfOneClassAtOneNeuron) {
  EXPECT_EQ(samples_sharing_within_class({7, 7, 3, 3, 7}, {0, 0, 0, 1, 1}), 2U);
  EXPECT_EQ(samples_sharing_within_class({7, 7, 3, 3, 3}, {0, 0, 1, 1, 1}), 5U);
  EXPECT_EQ(samples_sharing_within_class({1, 2, 3}, {0, 0, 0}), 0U);
  EXPECT_EQ(samples_sharing_within_class({1, 1}, {0, 1}), 0U);
}

TEST(SamplesSharingWithOwn, IsWhatALookAtAllPairsFinds) {
  Random random(kMeasureSeed);
  for (int round = 0; round < 50; ++round) {
    Numbers winners;
    Numbers classes;
    for (int i = 0; i < 20; ++i) {
      winners.push_back(random.below(6));
      classes.push_back(random.below(4));
    }
    std::size_t sharing = 0;
    for (std::size_t i = 0; i < winners.size(); ++i) {
      bool shares = false;
      for (std::size_t j = 0; j < winners.size(); ++j) {
        shares = shares || (i != j && winners[i] == winners[j] && classes[i] == classes[j]);
      }
      sharing += shares ? 1 : 0;
    }
    EXPECT_EQ(samples_sharing_within_class(winners, classes), sharing);
  }
}

TEST(SamplesSharingWithOwn, WantsAClassASample) {
  EXPECT_THROW((void)samples_sharing_within_class({1, 2}, {0}), InvalidArgument);
}

// Groups 0 and 1, each with a small individual (0 and 2) and a large one (1 and 3).
const std::vector<SizedThing> kSizedThings{{10, 0}, {20, 0}, {30, 1}, {40, 1}};
const Grid kSizeRow(1, 20, Lattice::kRectangular, Topology::kPlane);

//   neuron      0 0 1   10 10 11   19
//   individual  0 0 2    3  3  1    1
// 2 lies with 0 and the 1 at 11 with 3: both have their size and the wrong group. The 1 at 19 lies
// with the other 1.
TEST(SamplesWithSizeInOtherGroup, CountsTheRightSizeInTheWrongGroup) {
  const Numbers winners{0, 0, 1, 10, 10, 11, 19};
  EXPECT_EQ(
      samples_with_size_in_other_group(kSizeRow, winners, {0, 0, 2, 3, 3, 1, 1}, kSizedThings), 2U);
  // The wrong size in the wrong group, then the wrong size in the right one.
  EXPECT_EQ(
      samples_with_size_in_other_group(kSizeRow, winners, {0, 0, 3, 3, 3, 1, 1}, kSizedThings), 1U);
  EXPECT_EQ(
      samples_with_size_in_other_group(kSizeRow, winners, {0, 0, 1, 3, 3, 3, 3}, kSizedThings), 0U);
}

TEST(SamplesWithSizeInOtherGroup, RefusesWhatHasNoSize) {
  EXPECT_THROW((void)samples_with_size_in_other_group(kSizeRow, {0, 1}, {0, 4}, kSizedThings),
               InvalidArgument);
  EXPECT_THROW((void)samples_with_size_in_other_group(kSizeRow, {0}, {0, 1}, kSizedThings),
               InvalidArgument);
}

double along(const Individuals& individuals) {
  return order_along(individuals, 0, kMeasureSeed).correlation;
}

// On a slanting line the order is perfect either way; across it nothing counts.
TEST(OrderAlong, IsPerfectAlongALine) {
  EXPECT_DOUBLE_EQ(along({{1, 0, {0, 0}}, {2, 0, {3, 4}}, {3, 0, {6, 8}}}), 1.0);
  EXPECT_DOUBLE_EQ(along({{9, 0, {0, 0}}, {8, 0, {3, 4}}, {7, 0, {6, 8}}}), 1.0);
  EXPECT_DOUBLE_EQ(along({{1, 0, {0, 0}}, {2, 0, {5, 1}}, {3, 0, {10, -1}}, {4, 0, {15, 0}}}), 1.0);
}

// Places 1 to 4 of the numbers 1 3 2 4: 1 - 6 * 2 / 60.
TEST(OrderAlong, HasARankCorrelation) {
  EXPECT_DOUBLE_EQ(along({{1, 0, {0, 0}}, {3, 0, {1, 0}}, {2, 0, {2, 0}}, {4, 0, {3, 0}}}), 0.8);
}

// Group 0 lies along x in perfect order, group 1 along y as 1 3 2 4; two of group 2 count nothing.
TEST(OrderAlong, IsTheMeanOverGroupsEachAlongItsOwnLine) {
  EXPECT_DOUBLE_EQ(along({{1, 0, {0, 0}},
                          {2, 0, {4, 0}},
                          {3, 0, {8, 0}},
                          {1, 1, {9, 0}},
                          {3, 1, {9, 1}},
                          {2, 1, {9, 2}},
                          {4, 1, {9, 3}},
                          {1, 2, {5, 5}},
                          {2, 2, {6, 6}}}),
                   0.9);
}

// 2 and 3 stand side by side across the line: ranks 1, 2.5, 2.5, 4 against 1 2 3 4 give
// 4.5 / sqrt(5 * 4.5).
TEST(OrderAlong, SharesPlacesSideBySideDespiteRounding) {
  const Individuals straight{{1, 0, {0, 0}}, {2, 0, {5, 1}}, {3, 0, {5, -1}}, {4, 0, {10, 0}}};
  for (const double turned : {0.0, 0.3, 1.1, 2.6}) {
    Individuals individuals = straight;
    for (MappedIndividual& one : individuals) {
      const Position at = one.position;
      one.position.x = at.x * std::cos(turned) - at.y * std::sin(turned) + 0.7;
      one.position.y = at.x * std::sin(turned) + at.y * std::cos(turned) + 0.3;
    }
    EXPECT_DOUBLE_EQ(along(individuals), std::sqrt(0.9)) << turned;
  }
}

TEST(OrderAlong, IsNoneWithoutThreeNumbersOrAtOnePlace) {
  EXPECT_EQ(along({{1, 0, {0, 0}}, {2, 0, {1, 0}}, {2, 0, {2, 0}}}), 0.0);
  EXPECT_EQ(along({{1, 0, {2, 3}}, {2, 0, {2, 3}}, {3, 0, {2, 3}}}), 0.0);
  EXPECT_EQ(along({}), 0.0);
  EXPECT_EQ(order_along({}, 10, kMeasureSeed).shuffled, 0.0);
}

// Two of the six orders of three numbers are perfect; the other four have 1 - 6 * 6 / 24, absolute:
// 1/2.
TEST(OrderAlong, ByChanceIsTheMeanOfAllOrders) {
  const RankOrder order =
      order_along({{1, 0, {0, 0}}, {2, 0, {1, 0}}, {3, 0, {2, 0}}}, 20000, kMeasureSeed);
  EXPECT_NEAR(order.shuffled, (2 * 1.0 + 4 * 0.5) / 6, 0.01);
}

// The direction by trying out many, and the correlation of the places along it.
double along_by_trying(const Individuals& individuals) {
  constexpr int kDirections = 20000;
  Values numbers;
  for (const MappedIndividual& one : individuals) numbers.push_back(one.number);
  double widest = -1.0;
  Values best;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = std::numbers::pi * i / kDirections;
    Values places;
    double sum = 0.0;
    double squares = 0.0;
    for (const MappedIndividual& one : individuals) {
      places.push_back(one.position.x * std::cos(angle) + one.position.y * std::sin(angle));
      sum += places.back();
      squares += places.back() * places.back();
    }
    const double variance = squares - sum * sum / static_cast<double>(places.size());
    if (variance <= widest) continue;
    widest = variance;
    best = places;
  }
  return std::abs(rank_correlation(numbers, best));
}

TEST(OrderAlong, GoesTheWayOfTheGreatestVariance) {
  Random random(kMeasureSeed);
  for (int round = 0; round < 30; ++round) {
    Individuals individuals;
    for (int i = 0; i < 7; ++i) {
      individuals.push_back({random.normal(), 0, {4 * random.normal(), random.normal()}});
    }
    EXPECT_NEAR(along(individuals), along_by_trying(individuals), 1e-12) << round;
  }
}

// (1, 0) and (1, 1) are half a right angle apart, (0, 2) and (1, 1) too; (1, 0) and (0, 2) a whole.
TEST(CosineBetweenClasses, IsTheMeanOverPairs) {
  const Samples samples(Matrix<float>(3, 2, {1, 0, 0, 2, 1, 1}));
  EXPECT_NEAR(cosine_between_classes(samples, {0, 1, 2}), std::sqrt(2.0) / 3.0, 1e-15);
  EXPECT_NEAR(cosine_between_classes(samples, {0, 0, 1}), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(cosine_between_classes(samples, {5, 3}), 0.0, 1e-15);
}

TEST(CosineBetweenClasses, IsNoneWithWhatIsZeroAndNegativeBetweenOpposites) {
  EXPECT_NEAR(cosine_between_classes(Samples(Matrix<float>(3, 2, {3, 4, 0, 0, 6, 8})), {0, 1, 1}),
              0.5, 1e-15);
  EXPECT_NEAR(cosine_between_classes(Samples(Matrix<float>(2, 2, {3, 4, -3, -4})), {0, 1}), -1.0,
              1e-15);
}

TEST(CosineBetweenClasses, WantsTwoClassesAndTheirSamples) {
  const Samples samples(Matrix<float>(2, 1, {1, 2}));
  EXPECT_THROW((void)cosine_between_classes(samples, {4, 4}), InvalidArgument);
  EXPECT_THROW((void)cosine_between_classes(samples, {0, 1, 0}), InvalidArgument);
}

double cosine_of_pair(const Values& a, const Values& b) {
  double product = 0.0;
  double aa = 0.0;
  double bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    product += a[i] * b[i];
    aa += a[i] * a[i];
    bb += b[i] * b[i];
  }
  return product / std::sqrt(aa * bb);
}

double cosine_by_pairs(const std::vector<Values>& samples, const Numbers& classes) {
  double sum = 0.0;
  double pairs = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (classes[i] == classes[j]) continue;
      sum += cosine_of_pair(samples[i], samples[j]);
      pairs += 1.0;
    }
  }
  return sum / pairs;
}

// As many elements as the tensor chain has, few of them not 0.
TEST(CosineBetweenClasses, IsTheSameForSparseSamples) {
  constexpr std::size_t kElements = 270000;
  Random random(kMeasureSeed);
  std::vector<Signal> sparse;
  std::vector<Values> whole;
  Numbers classes;
  for (std::size_t sample = 0; sample < 8; ++sample) {
    std::map<std::uint32_t, float>
        stored;  // Half of them near the start, so that samples share some.
    for (int i = 0; i < 40; ++i) {
      const std::uint64_t place = random.below(i % 2 == 0 ? 50 : kElements);
      stored[static_cast<std::uint32_t>(place)] = static_cast<float>(random.normal());
    }
    std::vector<std::uint32_t> indices;
    std::vector<float> values;
    whole.emplace_back(kElements, 0.0);
    for (const auto& [index, value] : stored) {
      indices.push_back(index);
      values.push_back(value);
      whole.back()[index] = value;
    }
    sparse.push_back(Signal::sparse({kElements}, indices, values));
    classes.push_back(sample % 3);
  }
  EXPECT_NEAR(cosine_between_classes(Samples::from_signals(sparse), classes),
              cosine_by_pairs(whole, classes), 1e-12);
}

}  // namespace
}  // namespace somato
