#include "maps/reading/screened_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/support/instruction_sets.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using kernels::kBlockNeurons;
using kernels::kTileSamples;

Matrix<float> noise(std::size_t rows, std::size_t columns, Random& random) {
  Matrix<float> values(rows, columns);
  for (float& value : values.values()) value = static_cast<float>(random.normal());
  return values;
}

Som map_of(std::size_t rows, std::size_t columns, const Matrix<float>& weights,
           Similarity similarity = Similarity::kEuclidean) {
  SomParameters parameters;
  parameters.rows = rows;
  parameters.columns = columns;
  parameters.similarity = similarity;
  return {parameters, weights};
}

TEST(ScreenedMap, HasEveryNeuronOnceAndBlocksOfNeighbours) {
  Random random(1);
  const Som som = map_of(8, 24, noise(8 * 24, 3, random));
  const ScreenedMap map(som, 2);
  std::vector<std::size_t> neurons;
  for (std::size_t place = 0; place < som.neurons(); ++place) {
    neurons.push_back(map.neuron_at(place));
    const std::size_t first = map.neuron_at(place / kBlockNeurons * kBlockNeurons);
    EXPECT_LE(som.grid().squared_distance(first, neurons.back()), 3.0 * 3.0 + 3.0 * 3.0);
    std::vector<float> row(3);
    som.weights().copy_row(neurons.back(), row);
    EXPECT_TRUE(std::equal(row.begin(), row.end(), map.weights_at(place).begin()));
  }
  std::sort(neurons.begin(), neurons.end());
  for (std::size_t k = 0; k < neurons.size(); ++k) EXPECT_EQ(neurons[k], k);
}

// The score in units, by the definition in double precision.
double exact_score(const ScreenedMap& map, std::span<const float> x, std::span<const float> w,
                   bool euclidean) {
  double score = 0.0;
  for (std::size_t d = 0; d < x.size(); ++d) {
    const double c = double{map.centre()[d]};
    const double from_centre = double{x[d]} - c;
    const double apart = double{x[d]} - double{w[d]};
    score += euclidean ? 0.5 * (apart * apart - from_centre * from_centre)
                       : double{x[d]} * c - double{x[d]} * double{w[d]};
  }
  return score / (map.unit() * map.unit());
}

TEST(ScreenedMap, ScoresAreWithinTheirErrorAndItIsSmall) {
  for (const Similarity similarity : {Similarity::kEuclidean, Similarity::kDotProduct}) {
    Random random(2);
    constexpr std::size_t kColumns = 50;
    Matrix<float> weights = noise(9 * 7, kColumns, random);
    if (similarity == Similarity::kDotProduct) {
      for (std::size_t k = 0; k < weights.rows(); ++k) normalize_length(weights.row(k));
    }
    const bool euclidean = similarity == Similarity::kEuclidean;
    const Som som = map_of(9, 7, weights, similarity);
    const Matrix<float> samples = noise(kTileSamples, kColumns, random);
    testing::for_each_instruction_set([&](InstructionSet /*set*/) {
      const ScreenedMap map(som, 1);
      AlignedVector<std::int16_t> rows(kTileSamples * 2 * map.pairs());
      std::vector<float> factors;
      std::vector<double> errors;
      for (std::size_t s = 0; s < kTileSamples; ++s) {
        const double length = std::sqrt(kernels::batch_table().squared_distance(
            samples.row(s).data(), map.centre().data(), kColumns));
        const float rounded_off = kernels::batch_table().to_integers(
            samples.row(s).data(), map.centre().data(), ScreenedMap::integer_factor(length),
            kColumns, rows.data() + s * 2 * map.pairs());
        factors.push_back(map.score_factor(length));
        errors.push_back(map.score_error(length / map.unit(), rounded_off));
      }
      const kernels::ScreenedTile tile{rows.data(), factors.data(), nullptr, false};
      AlignedVector<float> scores(kTileSamples * map.blocks() * kBlockNeurons);
      kernels::batch_table().score(map.neurons(), map.blocks(), tile, scores.data());
      double farthest_off = 0.0;
      for (std::size_t s = 0; s < kTileSamples; ++s) {
        for (std::size_t place = 0; place < som.neurons(); ++place) {
          const double off =
              std::fabs(double{scores[s * map.blocks() * kBlockNeurons + place]} -
                        exact_score(map, samples.row(s), map.weights_at(place), euclidean));
          farthest_off = std::max(farthest_off, off / errors[s]);
        }
        EXPECT_LT(errors[s], 1e-2);
      }
      EXPECT_LE(farthest_off, 1.0);
      EXPECT_GT(farthest_off, 0.01);  // a bound that says something
    });
  }
}

TEST(ScreenedMap, MeansOfBlocksHaveAllTheirNeuronsWithinTheirRadii) {
  Random random(3);
  const Som som = map_of(6, 10, noise(60, 8, random));
  const ScreenedMap map(som, 1);
  for (std::size_t block = 0; block < map.blocks(); ++block) {
    std::vector<double> mean(8);
    const std::size_t first = block * kBlockNeurons;
    const std::size_t count = std::min(kBlockNeurons, som.neurons() - first);
    for (std::size_t place = first; place < first + count; ++place) {
      for (std::size_t d = 0; d < 8; ++d) {
        mean[d] += double{map.weights_at(place)[d]} / static_cast<double>(count);
      }
    }
    double farthest = 0.0;
    for (std::size_t place = first; place < first + count; ++place) {
      double squared = 0.0;
      for (std::size_t d = 0; d < 8; ++d) {
        squared += std::pow(double{map.weights_at(place)[d]} - mean[d], 2.0);
      }
      farthest = std::max(farthest, std::sqrt(squared));
    }
    EXPECT_NEAR(map.radii()[block] * map.unit(), farthest, 1e-6 * farthest);
  }
}

TEST(ScreenedMap, ReportsWhenAllWeightsAreEqual) {
  EXPECT_TRUE(ScreenedMap(map_of(5, 5, Matrix<float>(25, 3, 0.5F)), 1).all_alike());
}

}  // namespace
}  // namespace somato
