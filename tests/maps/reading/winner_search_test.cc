#include "maps/reading/winner_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "base/support/instruction_sets.h"
#include "maps/support/random_maps.h"
#include "maps/support/som_comparison.h"
#include "maps/training/batch_training.h"
#include "maps/training/som_reference.h"
#include "somato/core/random.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

Matrix<float> noise(std::size_t rows, std::size_t columns, double scale, Random& random) {
  Matrix<float> values(rows, columns);
  for (float& value : values.values()) value = static_cast<float>(scale * random.uniform());
  return values;
}

// Samples around few points, so that most of the map is far from each.
Matrix<float> clusters(std::size_t rows, std::size_t columns, Random& random) {
  const Matrix<float> centres = noise(7, columns, 10.0, random);
  Matrix<float> values(rows, columns);
  for (std::size_t i = 0; i < rows; ++i) {
    const auto centre = centres.row(random.below(centres.rows()));
    for (std::size_t d = 0; d < columns; ++d) {
      values(i, d) = centre[d] + static_cast<float>(0.1 * random.normal());
    }
  }
  return values;
}

constexpr Similarity kDistances[] = {Similarity::kEuclidean, Similarity::kManhattan,
                                     Similarity::kCosine, Similarity::kChebyshev};

SomParameters parameters_of(std::size_t rows, std::size_t columns, Similarity similarity) {
  SomParameters parameters;
  parameters.rows = rows;
  parameters.columns = columns;
  parameters.similarity = similarity;
  parameters.normalize_input = false;
  return parameters;
}

// The two best of each sample by plain loops in double precision.
std::vector<Winners> obvious_winners(const Som& som, const Samples& samples) {
  const ReferenceSom reference(som.parameters(), testing::widened(som));
  const double sign = som.parameters().similarity == Similarity::kDotProduct ? -1.0 : 1.0;
  std::vector<Winners> winners;
  std::vector<float> dense(samples.size());
  for (std::size_t i = 0; i < samples.count(); ++i) {
    write_dense(samples[i], dense);
    const std::vector<double> input(dense.begin(), dense.end());
    std::pair<double, std::size_t> best{std::numeric_limits<double>::infinity(), 0};
    std::pair<double, std::size_t> second = best;
    for (std::size_t k = 0; k < som.neurons(); ++k) {
      const std::pair score(sign * reference.score(input, k), k);
      second = std::min(second, std::max(best, score));
      best = std::min(best, score);
    }
    winners.push_back({best.second, second.second});
  }
  return winners;
}

// One and two winners, on every instruction set and on one and three threads.
void expect_obvious_winners(const Som& som, const Samples& samples, const std::string& what) {
  const std::vector<Winners> expected = obvious_winners(som, samples);
  testing::for_each_instruction_set([&](InstructionSet /*set*/) {
    SomWorkspace workspace;
    for (const std::size_t threads : {1U, 3U}) {
      const auto one = WinnerSearch::find_all(som, samples, false, threads);
      const auto two = WinnerSearch::find_all(som, samples, true, threads);
      for (std::size_t i = 0; i < samples.count(); ++i) {
        ASSERT_EQ(one[i].first, expected[i].first) << what << ", sample " << i;
        ASSERT_EQ(two[i].first, expected[i].first) << what << ", sample " << i;
        ASSERT_EQ(two[i].second, expected[i].second) << what << ", sample " << i;
      }
    }
    for (std::size_t i = 0; i < samples.count(); i += 10) {
      const Winners single = som.winners(samples[i], workspace);
      ASSERT_EQ(single.first, expected[i].first) << what << ", sample " << i;
      ASSERT_EQ(single.second, expected[i].second) << what << ", sample " << i;
    }
  });
}

TEST(WinnerSearchThreads, FindsTheTrueWinnersOfNoise) {
  Random random(1);
  for (const Similarity similarity : testing::all_similarities()) {
    for (const std::size_t columns : {1U, 2U, 31U, 64U, 300U}) {
      Matrix<float> weights = noise(15 * 13, columns, 1.0, random);
      if (similarity == Similarity::kDotProduct) {
        for (std::size_t k = 0; k < weights.rows(); ++k) normalize_length(weights.row(k));
      }
      const Som som(parameters_of(15, 13, similarity), weights);
      expect_obvious_winners(som, Samples(noise(150, columns, 1.0, random)),
                             choice_name(similarity) + " of " + std::to_string(columns));
    }
  }
}

// A smooth map, as training makes it: neighbours are nearly the same.
TEST(WinnerSearchThreads, FindsTheTrueWinnersAmongNeighboursThatAreNearlyTheSame) {
  Random random(2);
  Matrix<float> weights(20 * 20, 12);
  for (std::size_t k = 0; k < weights.rows(); ++k) {
    for (std::size_t d = 0; d < weights.columns(); ++d) {
      weights(k, d) = 0.5F + 1e-5F * static_cast<float>(k % 20 * d + k / 20 * (12 - d)) +
                      1e-7F * static_cast<float>(random.uniform());
    }
  }
  const Samples samples(noise(200, 12, 1.0, random));
  for (const Similarity similarity : kDistances) {
    expect_obvious_winners(Som(parameters_of(20, 20, similarity), weights), samples,
                           "a smooth map by " + choice_name(similarity));
  }
}

// All neurons have nearly the same distance from each sample, so that integers cannot distinguish
// them.
TEST(WinnerSearchThreads, FindsTheTrueWinnersAmongNeuronsThatAreNearlyAsFar) {
  Random random(8);
  constexpr std::size_t kColumns = 20;
  Matrix<float> weights(10 * 10, kColumns);
  for (std::size_t k = 0; k < weights.rows(); ++k) {
    for (float& value : weights.row(k)) value = static_cast<float>(random.normal());
    normalize_length(weights.row(k));
    for (float& value : weights.row(k))
      value *= 1.0F + 1e-5F * static_cast<float>(random.uniform());
  }
  const Samples samples(noise(100, kColumns, 1e-4, random));
  for (const Similarity similarity : kDistances) {
    expect_obvious_winners(Som(parameters_of(10, 10, similarity), weights), samples,
                           "a sphere by " + choice_name(similarity));
  }
}

TEST(WinnerSearchThreads, FindsTheTrueWinnersOfClustersWhileBlocksAreLeftOut) {
  Random random(3);
  const Samples samples(clusters(700, 9, random));
  SomParameters parameters = parameters_of(30, 30, Similarity::kEuclidean);
  parameters.training = Training::kBatch;
  parameters.epochs = 4;
  parameters.radius_start = 8.0;
  const Som som = train_som(parameters, samples).value();
  expect_obvious_winners(som, samples, "clusters");
  expect_obvious_winners(som, Samples(clusters(100, 9, random)), "other clusters");
}

TEST(WinnerSearchThreads, TakesTheFirstOfEquals) {
  Random random(4);
  const Matrix<float> few = noise(3, 6, 1.0, random);
  Matrix<float> weights(24 * 24, 6);
  for (std::size_t k = 0; k < weights.rows(); ++k) {
    const auto row = few.row(random.below(few.rows()));
    std::copy(row.begin(), row.end(), weights.row(k).begin());
  }
  const Samples samples(noise(70, 6, 1.0, random));
  const Matrix<float> alike(24 * 24, 6, 0.25F);
  for (const Similarity similarity : kDistances) {
    expect_obvious_winners(Som(parameters_of(24, 24, similarity), weights), samples,
                           "three kinds of neurons by " + choice_name(similarity));
    expect_obvious_winners(Som(parameters_of(24, 24, similarity), alike), samples,
                           "one kind of neuron by " + choice_name(similarity));
  }
}

TEST(WinnerSearchThreads, FindsTheTrueWinnersAtAnyScaleAndDistance) {
  Random random(5);
  for (const double scale : {1e-14, 1e-3, 1e6, 1e15}) {
    for (const Similarity similarity : kDistances) {
      const Som som(parameters_of(10, 10, similarity), noise(100, 8, scale, random));
      const std::string by = " by " + choice_name(similarity);
      expect_obvious_winners(som, Samples(noise(80, 8, scale, random)), "scale" + by);
      expect_obvious_winners(som, Samples(noise(80, 8, 1000.0 * scale, random)), "far" + by);
      expect_obvious_winners(som, Samples(noise(80, 8, 0.001 * scale, random)), "near 0" + by);
    }
  }
}

TEST(WinnerSearchThreads, OneOutlierDoesNotHideTheOthers) {
  Random random(6);
  Matrix<float> weights = noise(12 * 12, 10, 1.0, random);
  for (float& value : weights.row(77)) value = 1e7F;
  Matrix<float> samples = noise(100, 10, 1.0, random);
  for (float& value : samples.row(5)) value = -1e7F;
  for (const Similarity similarity : kDistances) {
    expect_obvious_winners(Som(parameters_of(12, 12, similarity), weights), Samples(samples),
                           "outliers by " + choice_name(similarity));
  }
}

// Lengths whose squares, or whose products with a sample, leave the range of single precision.
TEST(WinnerSearchThreads, FindsTheTrueWinnersByCosineOfWeightsOfAnyLength) {
  Random random(9);
  Matrix<float> weights = noise(10 * 10, 7, 1.0, random);
  for (std::size_t k = 0; k < weights.rows(); ++k) {
    constexpr float kLengths[] = {1e-24F, 1e-12F, 1.0F, 1e12F, 1e24F, 0.0F};
    for (float& value : weights.row(k)) value *= kLengths[k % 6];
  }
  const Som som(parameters_of(10, 10, Similarity::kCosine), weights);
  for (const double scale : {1e-24, 1e-9, 1.0, 1e9, 1e24, 0.0}) {
    expect_obvious_winners(som, Samples(noise(70, 7, scale, random)), "lengths");
  }
}

// Sparse samples have many elements without weights; a dense map with all of them finds the same.
TEST(WinnerSearch, FindsTheWinnersOfSparseSamplesAmongStoredElements) {
  Random random(10);
  for (const Similarity similarity : kDistances) {
    const SomParameters parameters = parameters_of(6, 6, similarity);
    LaneMatrix<float> weights(36, 3);
    for (std::size_t k = 0; k < 36; ++k) {
      for (std::size_t d = 0; d < 3; ++d) weights(k, d) = static_cast<float>(random.normal());
    }
    const Som some(parameters, weights, StoredElements(40, {3, 17, 39}));
    const Samples samples = testing::random_samples(90, 40, true, random);
    const auto winners = winners_of(some, samples, 2);
    const std::vector<Winners> expected = obvious_winners(some, samples);
    SomWorkspace workspace;
    for (std::size_t i = 0; i < samples.count(); ++i) {
      EXPECT_EQ(winners[i], expected[i].first) << choice_name(similarity);
      EXPECT_EQ(some.winners(samples[i], workspace).second, expected[i].second);
    }
  }
}

TEST(WinnerSearch, SeesSamplesAsTheMapDoes) {
  Random random(7);
  SomParameters parameters = parameters_of(6, 6, Similarity::kEuclidean);
  parameters.normalize_input = true;
  const Som som(parameters, noise(36, 5, 1.0, random));
  const Samples samples(noise(80, 5, 3.0, random));
  const auto winners = winners_of(som, samples, 2);
  SomWorkspace workspace;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    EXPECT_EQ(winners[i], som.winner(samples[i], workspace));
  }
}

}  // namespace
}  // namespace somato
