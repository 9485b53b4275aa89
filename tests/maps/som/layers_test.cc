#include "somato/maps/layers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/support/instruction_sets.h"
#include "maps/reading/winner_search.h"
#include "maps/som/som_archive.h"
#include "maps/training/batch_training.h"
#include "maps/training/som_reference.h"
#include "somato/core/random.h"
#include "somato/maps/som_quality.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

constexpr Similarity kOfLayers[] = {Similarity::kEuclidean, Similarity::kManhattan,
                                    Similarity::kCosine, Similarity::kChebyshev};

Matrix<float> normal_rows(std::size_t rows, std::size_t columns, Random& random) {
  Matrix<float> matrix(rows, columns);
  for (float& value : matrix.values()) value = static_cast<float>(random.normal());
  return matrix;
}

// One to four layers of random distances, weights and scales.
std::vector<Layer> random_layers(Random& random) {
  std::vector<Layer> layers;
  std::size_t first = 0;
  const std::size_t count = 1 + random.below(4);
  for (std::size_t l = 0; l < count; ++l) {
    const std::size_t columns = 1 + random.below(20);
    layers.push_back({"layer" + std::to_string(l), first, columns, kOfLayers[random.below(4)],
                      0.1 + random.uniform(), 0.1 + random.uniform()});
    first += columns;
  }
  return layers;
}

std::size_t columns_of(const std::vector<Layer>& layers) {
  return layers.back().first + layers.back().count;
}

// The definition in plain loops; `left_out` does not count.
double layered(const std::vector<Layer>& layers, std::span<const float> x, std::span<const float> w,
               const std::string& left_out = {}) {
  double total = 0.0;
  for (const Layer& layer : layers) {
    double sum = 0.0, squares = 0.0, most = 0.0, product = 0.0, of_x = 0.0, of_w = 0.0;
    for (std::size_t d = layer.first; d < layer.first + layer.count; ++d) {
      const double a = x[d];
      const double b = w[d];
      sum += std::fabs(a - b);
      squares += (a - b) * (a - b);
      most = std::max(most, std::fabs(a - b));
      product += a * b;
      of_x += a * a;
      of_w += b * b;
    }
    double distance = std::sqrt(squares);
    if (layer.similarity == Similarity::kManhattan) distance = sum;
    if (layer.similarity == Similarity::kChebyshev) distance = most;
    if (layer.similarity == Similarity::kCosine) {
      distance = of_x * of_w > 0.0 ? 1.0 - product / std::sqrt(of_x) / std::sqrt(of_w) : 1.0;
    }
    if (layer.name != left_out) total += layer.weight * distance / *layer.scale;
  }
  return total;
}

Som layered_map(const std::vector<Layer>& layers, const Matrix<float>& weights, std::size_t rows) {
  SomParameters p;
  p.rows = rows;
  p.columns = weights.rows() / rows;
  p.layers = layers;
  return {resolve(p, 1, weights.columns()).value(), weights};
}

TEST(LayersThreads, ChooseTheTrueWinnersByTheSumOfTheirDistances) {
  Random random(1);
  for (int i = 0; i < 60; ++i) {
    const std::vector<Layer> layers = random_layers(random);
    const Matrix<float> weights = normal_rows(6 * 7, columns_of(layers), random);
    const Som som = layered_map(layers, weights, 6);
    const Matrix<float> rows = normal_rows(70, columns_of(layers), random);
    const Samples samples(rows);
    const auto distance = [&](std::size_t s, std::size_t n) {
      return layered(layers, rows.row(s), weights.row(n));
    };
    SomWorkspace workspace;
    std::vector<std::size_t> winners(rows.rows(), 0);
    for (std::size_t s = 0; s < rows.rows(); ++s) {
      for (std::size_t n = 0; n < som.neurons(); ++n) {
        if (distance(s, n) < distance(s, winners[s])) winners[s] = n;
        ASSERT_NEAR(som.distance(samples[s], n, workspace), distance(s, n),
                    1e-12 * (1 + distance(s, n)));
      }
    }
    testing::for_each_instruction_set([&](InstructionSet /*set*/) {
      ASSERT_EQ(winners_of(som, samples, 3), winners);
      std::vector<float> similarities(som.neurons());
      for (std::size_t s = 0; s < rows.rows(); ++s) {
        som.similarities(samples[s], workspace, similarities);
        ASSERT_NEAR(similarities[3], 1.0 / (1.0 + distance(s, 3)), 1e-5);
      }
    });
  }
}

TEST(LayersThreads, PredictALayerFromTheOthers) {
  Random random(2);
  for (int i = 0; i < 40; ++i) {
    const std::vector<Layer> layers = random_layers(random);
    const Matrix<float> weights = normal_rows(5 * 8, columns_of(layers), random);
    const Som som = layered_map(layers, weights, 5);
    Matrix<float> rows = normal_rows(30, columns_of(layers), random);
    const Layer& layer = layers[random.below(layers.size())];
    for (std::size_t s = 0; s < rows.rows(); ++s) rows(s, layer.first) = 1e30F;  // not read
    const Matrix<float> predicted = predict_layer(som, layer, Samples(rows), 3);
    for (std::size_t s = 0; s < rows.rows(); ++s) {
      std::size_t best = 0;
      for (std::size_t n = 0; n < som.neurons(); ++n) {
        const double distance = layered(layers, rows.row(s), weights.row(n), layer.name);
        if (distance < layered(layers, rows.row(s), weights.row(best), layer.name)) best = n;
      }
      for (std::size_t d = 0; d < layer.count; ++d) {
        ASSERT_EQ(predicted(s, d), weights(best, layer.first + d));
      }
    }
  }
}

// Law: one layer of weight and scale 1 finds the winners, and trains to the bits, of a plain map
// with its distance; a Euclidean one finds them by the root.
TEST(Layers, OfOneLayerAreAPlainMap) {
  Random random(3);
  for (const Similarity similarity : {Similarity::kManhattan, Similarity::kChebyshev}) {
    for (const Training training : {Training::kOnline, Training::kBatch}) {
      const Samples samples(normal_rows(40, 9, random));
      SomParameters plain;
      plain.similarity = similarity;
      plain.training = training;
      plain.rows = plain.columns = 5;
      SomParameters one = plain;
      one.similarity = Similarity::kEuclidean;
      one.layers = {{"all", 0, 9, similarity, 1.0, 1.0}};
      EXPECT_EQ(train_som(one, samples)->weights(), train_som(plain, samples)->weights());
    }
  }
}

// The mean distance of all pairs, by hand: |0 - 3|, |0 - 6| and |3 - 6| in the first column.
TEST(Layers, HaveTheMeanDistanceOfSamplesAsScale) {
  SomParameters p;
  p.rows = 2;
  p.columns = 2;
  p.layers = {{"a", 0, 1, Similarity::kManhattan, 1.0, {}}, {"b", 1, 2, {}, 2.0, 7.0}};
  const Samples samples(Matrix<float>(3, 3, {0, 1, 1, 3, 2, 5, 6, 0, 2}));
  const Som som = train_som(p, samples).value();
  EXPECT_DOUBLE_EQ(som.parameters().layers[0].scale.value(), 4.0);
  EXPECT_DOUBLE_EQ(som.parameters().layers[1].scale.value(), 7.0);
}

TEST(Layers, AreSavedWithTheMap) {
  Random random(4);
  SomParameters p;
  p.rows = p.columns = 3;
  p.layers = {{"mass, \"g\"", 0, 2, Similarity::kCosine, 0.3, {}}, {"b", 2, 1, {}, 1.0, 0.1}};
  const Som som = train_som(p, Samples(normal_rows(20, 3, random))).value();
  Archive archive("test");
  add_som(archive, "map.", som);
  const Som loaded = som_from(archive, "map.", "here").value();
  EXPECT_EQ(loaded.parameters().layers, som.parameters().layers);
  EXPECT_EQ(loaded.weights(), som.weights());
}

TEST(LayersThreads, TrainToTheSameBitsEverywhere) {
  Random random(5);
  SomParameters p;
  p.rows = p.columns = 6;
  p.layers = random_layers(random);
  const Samples samples(normal_rows(30, columns_of(p.layers), random));
  for (const Training training : {Training::kOnline, Training::kBatch}) {
    p.training = training;
    p.iterations = 200;
    p.epochs = 4;
    const auto expected = train_som(p, samples)->weights();
    testing::for_each_instruction_set([&](InstructionSet /*set*/) {
      for (const std::size_t threads : {1U, 3U}) {
        EXPECT_EQ(train_som(p, samples, {threads, {}})->weights(), expected);
      }
    });
  }
}

// A layer that is missing as a whole does not count; neither does its cosine.
TEST(Layers, LearnFromSamplesThatLackALayer) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  SomParameters p;
  p.rows = 1;
  p.columns = 1;
  p.training = Training::kBatch;
  p.layers = {{"a", 0, 1, {}, 1.0, {}}, {"b", 1, 2, Similarity::kManhattan, 1.0, {}}};
  const Samples incomplete(Matrix<float>(3, 3, {1, 2, 3, 3, kNone, kNone, 5, 6, 5}));
  const Samples filled(Matrix<float>(3, 3, {1, 2, 3, 3, 4, 4, 5, 6, 5}));
  TrainingOptions options;
  options.incomplete = &incomplete;
  const Som som = train_som(p, filled, options).value();
  EXPECT_EQ(som.weights().to_matrix(), Matrix<float>(1, 3, {3, 4, 4}));
}

TEST(Layers, AreRefusedWhereTheyDoNotFit) {
  const Samples samples(Matrix<float>(3, 2, {1, 5, 2, 5, 3, 5}));
  const auto kind_for = [&](const std::vector<Layer>& layers, SomParameters p = {}) {
    p.layers = layers;
    return train_som(p, samples).error().kind;
  };
  const Layer a{"a", 0, 1, {}, 1.0, {}};
  const Layer b{"b", 1, 1, {}, 1.0, 1.0};
  EXPECT_EQ(kind_for({a}), ErrorKind::kUsage);
  EXPECT_EQ(kind_for({b}), ErrorKind::kUsage);
  EXPECT_EQ(kind_for({a, {"a", 1, 1, {}, 1.0, {}}}), ErrorKind::kUsage);
  EXPECT_EQ(kind_for({a, {"b", 1, 2, {}, 1.0, {}}}), ErrorKind::kUsage);
  EXPECT_EQ(kind_for({a, {"", 1, 1, {}, 1.0, 1.0}}), ErrorKind::kUsage);
  EXPECT_EQ(kind_for({a, {"b", 1, 1, Similarity::kDotProduct, 1.0, 1.0}}), ErrorKind::kUsage);
  EXPECT_EQ(kind_for({a, {"b", 1, 1, {}, 0.0, 1.0}}), ErrorKind::kUsage);
  EXPECT_EQ(kind_for({a, {"b", 1, 1, {}, 1.0, {}}}), ErrorKind::kData);  // all are 5
  SomParameters p;
  p.similarity = Similarity::kManhattan;
  EXPECT_EQ(kind_for({a, b}, p), ErrorKind::kUsage);
  p = {};
  p.arithmetic = Arithmetic::kInnerProducts;
  EXPECT_EQ(kind_for({a, b}, p), ErrorKind::kUsage);
  p = {};
  p.normalize_input = true;
  EXPECT_EQ(kind_for({a, b}, p), ErrorKind::kUsage);
  SamplesInMemory source(samples);
  p = {};
  p.training = Training::kBatch;
  p.layers = {a, b};
  EXPECT_EQ(train_som(p, source).error().kind, ErrorKind::kUsage);  // no scale
  EXPECT_EQ(layer_named(p, "c").error().kind, ErrorKind::kUsage);
}

}  // namespace
}  // namespace somato
