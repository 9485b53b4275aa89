#include "studies/codes/mutual_prediction.h"

#include <gtest/gtest.h>

#include "somato/core/random.h"
#include "studies/codes/neighbours.h"

namespace somato {
namespace {

constexpr std::size_t kCount = 30;

Matrix<float> random_distances(std::uint64_t seed) {
  Random random(seed);
  Matrix<float> values(kCount, 2);
  for (float& value : values.values()) value = static_cast<float>(random.normal());
  return squared_distances(Samples(values), 1);
}

// Different distances in every view.
Part random_part(std::vector<std::size_t> senses, std::uint64_t seed) {
  Part part{std::move(senses), {}};
  for (const View view : kAllViews) {
    part.distances[view] = random_distances(seed * 100 + static_cast<std::uint64_t>(view));
  }
  return part;
}

Neighbourhoods ranks_of(const Part& part) {
  Neighbourhoods ranks;
  for (const View view : kAllViews) {
    ranks.ranks[view] = Matrix<float>(kCount, kCount);
    add_ranks(part.distances[view], 1, ranks.ranks[view]);
  }
  return ranks;
}

double imbalance(const Matrix<float>& from, const Matrix<float>& ranks) {
  return information_imbalance(nearest_others(from), ranks);
}

TEST(MutualPrediction, AnotherSenseIsPredictedFromWholeExplorations) {
  const Part part = random_part({0}, 1);
  const std::vector<Neighbourhoods> senses{ranks_of(part), ranks_of(random_part({1}, 2))};
  const std::vector<WeightedPart> parts{{&part, 1.0}};
  EXPECT_DOUBLE_EQ(imbalances(parts, senses)[1],
                   imbalance(part.distances[View::kWhole], senses[1].ranks[View::kWhole]));
}

TEST(MutualPrediction, TheSameSenseIsPredictedFromTheOtherHalf) {
  const Part part = random_part({0}, 1);
  const std::vector<Neighbourhoods> senses{ranks_of(random_part({0}, 3))};
  const std::vector<WeightedPart> parts{{&part, 1.0}};
  double sum = 0.0;
  for (const Split& split : kSplits) {
    sum += imbalance(part.distances[split.from], senses[0].ranks[split.to]);
  }
  EXPECT_DOUBLE_EQ(imbalances(parts, senses)[0], sum / 4.0);
}

TEST(MutualPrediction, PartsOfOtherSensesAreWholeInACombination) {
  const Part a = random_part({0}, 1);
  const Part b = random_part({1}, 2);
  const std::vector<Neighbourhoods> senses{ranks_of(a), ranks_of(b)};
  const std::vector<WeightedPart> parts{{&a, 2.0}, {&b, 0.5}};
  double sum = 0.0;
  for (const Split& split : kSplits) {
    Matrix<float> both = a.distances[split.from];
    for (std::size_t i = 0; i < both.values().size(); ++i) {
      both.values()[i] = 4.0F * both.values()[i] + 0.25F * b.distances[View::kWhole].values()[i];
    }
    sum += imbalance(both, senses[0].ranks[split.to]);
  }
  EXPECT_DOUBLE_EQ(imbalances(parts, senses)[0], sum / 4.0);
}

TEST(MutualPrediction, ASenseWithoutHalvesPredictsItselfUpToALimit) {
  const Part a = random_part({0}, 1);
  const Part b = random_part({1}, 2);
  std::vector<Neighbourhoods> senses{ranks_of(a), ranks_of(b)};
  senses[0].has_halves = false;
  const std::vector<WeightedPart> itself{{&a, 1.0}};
  const std::vector<WeightedPart> other{{&b, 1.0}};
  EXPECT_DOUBLE_EQ(imbalances(itself, senses)[0], 2.0 / kCount);
  const double from_other = imbalances(other, senses)[0];
  senses[0].least = 0.25;
  EXPECT_EQ(imbalances(itself, senses)[0], 0.25);
  EXPECT_EQ(imbalances(other, senses)[0], from_other);
}

TEST(MutualPrediction, OnePartGivesTheImbalancesOfItsNeighbours) {
  const Part part = random_part({1}, 4);
  const std::vector<Neighbourhoods> senses{ranks_of(random_part({0}, 5)), ranks_of(part)};
  PerView<std::vector<std::uint32_t>> nearest;
  for (const View view : kAllViews) nearest[view] = nearest_others(part.distances[view]);
  const std::vector<WeightedPart> parts{{&part, 3.0}};
  const std::vector<std::size_t> used{1};
  EXPECT_EQ(imbalances(parts, senses), imbalances(nearest, used, senses));
}

TEST(MutualPrediction, TheScoreIsTheMean) {
  EXPECT_DOUBLE_EQ(score_of(std::vector<double>{0.5, 1.0, 0.0}), 0.5);
}

TEST(MutualPrediction, TheScoreIsTheMeanErrorIfAllSensesAreUsed) {
  const Part a = random_part({0}, 1);
  const Part b = random_part({1}, 2);
  const std::vector<Neighbourhoods> senses{ranks_of(random_part({0}, 3)), ranks_of(b)};
  const std::vector<WeightedPart> parts{{&a, 0.5}, {&b, 2.0}};
  const std::vector<double> errors = errors_of(parts, senses);
  ASSERT_EQ(errors.size(), kCount);
  EXPECT_NEAR(score_of(errors), score_of(imbalances(parts, senses)), 1e-12);
}

// Unlike imbalances(), for which the ranks of whole explorations are easier to predict.
TEST(MutualPrediction, ErrorsOfASenseThatIsNotUsedAreThoseOfItsHalves) {
  const Part a = random_part({1}, 1);
  const std::vector<Neighbourhoods> senses{ranks_of(random_part({0}, 2))};
  const std::vector<WeightedPart> parts{{&a, 1.0}};
  const auto nearest = nearest_others(a.distances[View::kWhole]);
  std::vector<double> expected(kCount, 0.0);
  for (const Split& split : kSplits) {
    for (std::size_t i = 0; i < kCount; ++i) {
      expected[i] += 2.0 / kCount * double{senses[0].ranks[split.to](i, nearest[i])} / 4.0;
    }
  }
  const std::vector<double> errors = errors_of(parts, senses);
  for (std::size_t i = 0; i < kCount; ++i) EXPECT_NEAR(errors[i], expected[i], 1e-12);
}

// The weight is a factor of the vectors, and so of their Manhattan distances.
TEST(MutualPrediction, ManhattanDistancesAreAddedWithTheirWeights) {
  Part a = random_part({1}, 1);
  Part b = random_part({2}, 2);
  a.similarity = b.similarity = Similarity::kManhattan;
  const std::vector<Neighbourhoods> senses{ranks_of(random_part({0}, 3))};
  Part both{{1, 2}, a.distances};
  for (const View view : kAllViews) {
    for (std::size_t i = 0; i < kCount * kCount; ++i) {
      both.distances[view].values()[i] =
          2.0F * a.distances[view].values()[i] + 0.5F * b.distances[view].values()[i];
    }
  }
  const std::vector<WeightedPart> parts{{&a, 2.0}, {&b, 0.5}};
  const std::vector<WeightedPart> sum{{&both, 1.0}};
  EXPECT_EQ(imbalances(parts, senses), imbalances(sum, senses));
}

}  // namespace
}  // namespace somato
