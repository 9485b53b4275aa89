#include "somato/maps/som_measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "maps/support/random_maps.h"
#include "somato/core/check.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

std::vector<SomMeasure> every_measure() {
  std::vector<SomMeasure> all;
  for (const auto& choice : Choices<SomMeasure>::all()) all.push_back(choice.first);
  return all;
}

Som som_on(const Samples& samples, std::size_t rows, std::size_t columns,
           Training training = Training::kBatch) {
  SomParameters p;
  p.rows = rows;
  p.columns = columns;
  p.training = training;
  p.epochs = 5;
  return train_som(p, samples).value();
}

// The definition, with exp of the standard library.
double distortion_by_definition(const Som& som, const Samples& samples, double radius) {
  double sum = 0.0;
  SomWorkspace workspace;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    const std::size_t winner = som.winner(samples[i], workspace);
    for (std::size_t j = 0; j < som.neurons(); ++j) {
      const double h = std::exp(-som.grid().squared_distance(winner, j) / (2 * radius * radius));
      sum += h * std::pow(som.distance(samples[i], j, workspace), 2);
    }
  }
  return sum / static_cast<double>(samples.count());
}

TEST(SomMeasures, OfAllKindsOfMapsAreAsDefined) {
  Random random(3);
  for (const testing::Variant& variant : testing::all_variants()) {
    if (variant.neighbourhood != NeighbourhoodShape::kGaussian) continue;
    SomParameters p = testing::random_parameters(variant, random);
    p.radius_end = 0.75;
    p.radius_start = 2.0;
    p.iterations = 50;
    const Samples samples = testing::random_samples(40, 5, false, random);
    const Som som = train_som(p, samples).value();
    const SomMeasures found = measure_som(som, samples, every_measure());
    const SomQuality quality = measure_quality(som, samples);
    EXPECT_EQ(found.values.at(SomMeasure::kQuantizationError), quality.quantization_error);
    EXPECT_EQ(found.values.at(SomMeasure::kTopographicError), quality.topographic_error);
    EXPECT_EQ(found.winners, quality.winners);
    EXPECT_NEAR(found.values.at(SomMeasure::kDistortion),
                distortion_by_definition(som, samples, 0.75), 1e-6)
        << testing::name_of(variant);
  }
}

TEST(SomMeasures, DoNotDependOnPartsAndThreads) {
  Random random(4);
  const Samples samples = testing::random_samples(101, 4, false, random);
  const Som som = som_on(samples, 4, 5);
  MeasureParameters parameters;
  parameters.ranked_samples = 50;
  const SomMeasures whole = measure_som(som, samples, every_measure(), parameters);
  EXPECT_EQ(whole.ranked_samples, 50U);
  SomMeasurement measurement(som, 101, every_measure(), parameters, 3);
  for (std::size_t first = 0; first < 101; first += 30) {
    std::vector<std::size_t> part;
    for (std::size_t i = first; i < std::min<std::size_t>(101, first + 30); ++i) part.push_back(i);
    measurement.add(samples.subset(part));
  }
  EXPECT_EQ(measurement.measures().values, whole.values);
  parameters.seed = 2;  // other samples represent all
  EXPECT_NE(measure_som(som, samples, every_measure(), parameters).values, whole.values);
}

// Neurons at 0, 10 and 20 on a line.
Som three_neurons() {
  SomParameters p;
  p.rows = 1;
  p.columns = 3;
  return Som(resolve(p, 5, 1).value(), Matrix<float>(3, 1, {0, 10, 20}));
}

TEST(SomMeasures, OfNeuronsAndClassesAreAsByHand) {
  const Samples samples(Matrix<float>(5, 1, {1, 3, 9, 11, -1}));
  const SomMeasures found = measure_som(three_neurons(), samples, {}, {}, {0, 1, 0, 0, 1});
  ASSERT_EQ(found.neurons.size(), 3U);
  EXPECT_EQ(found.neurons[0].samples, 3U);
  EXPECT_DOUBLE_EQ(found.neurons[0].share, 0.6);
  EXPECT_DOUBLE_EQ(found.neurons[0].mean_distance, 5.0 / 3);
  EXPECT_DOUBLE_EQ(found.neurons[0].greatest_distance, 3.0);
  EXPECT_TRUE(std::isnan(found.neurons[2].mean_distance));
  EXPECT_EQ(found.neurons[2].share, 0.0);
  ASSERT_EQ(found.classes.size(), 2U);
  EXPECT_EQ(found.classes[0].samples, 3U);
  EXPECT_EQ(found.classes[0].neurons, 2U);
  EXPECT_DOUBLE_EQ(found.classes[0].quantization_error, 1.0);
  EXPECT_DOUBLE_EQ(found.classes[0].purity, (1.0 / 3 + 1 + 1) / 3);
  EXPECT_NEAR(found.classes[0].entropy, std::log2(3.0) - 2.0 / 3, 1e-12);
  EXPECT_EQ(found.classes[1].entropy, 0.0);
  EXPECT_DOUBLE_EQ(found.classes[1].purity, 2.0 / 3);
  EXPECT_TRUE(found.values.empty());
}

TEST(SomMeasures, MayHaveMoreClassesThanNeuronsAndEmptyClasses) {
  const Samples samples(Matrix<float>(4, 1, {1, 2, 3, 4}));
  const SomMeasures found = measure_som(three_neurons(), samples, {}, {}, {0, 5, 2, 3});
  EXPECT_EQ(found.classes.size(), 6U);
  EXPECT_TRUE(std::isnan(found.classes[1].purity));
  EXPECT_DOUBLE_EQ(found.classes[5].purity, 0.25);
}

TEST(SomMeasures, OfConstantDataAndOneNeuronAreNotANumberWhereTheyAreNotDefined) {
  SomParameters p;
  p.rows = 1;
  p.columns = 1;
  const Som som(resolve(p, 1, 2).value(), Matrix<float>(1, 2, 3.0F));
  const SomMeasures found = measure_som(som, Samples(Matrix<float>(1, 2, 3.0F)), every_measure());
  EXPECT_EQ(found.values.at(SomMeasure::kQuantizationError), 0.0);
  EXPECT_EQ(found.values.at(SomMeasure::kDistortion), 0.0);
  for (const SomMeasure measure : {SomMeasure::kTopographicProduct, SomMeasure::kTrustworthiness,
                                   SomMeasure::kExplainedVariance}) {
    EXPECT_TRUE(std::isnan(found.values.at(measure))) << choice_name(measure);
  }
}

TEST(SomMeasures, RefuseMissingSamplesAndClasses) {
  const Samples samples(Matrix<float>(2, 1, 1.0F));
  EXPECT_THROW((void)measure_som(three_neurons(), samples, {}, {}, {0}), InvalidArgument);
  const Som som = three_neurons();
  SomMeasurement measurement(som, 3, {}, {});
  measurement.add(samples);
  EXPECT_THROW((void)measurement.measures(), InvalidArgument);
  EXPECT_THROW(measurement.add(samples), InvalidArgument);
}

TEST(ShuffledFeatures, KeepTheValuesOfEachFeature) {
  Random random(8);
  for (const bool sparse : {false, true}) {
    const Samples samples = testing::random_samples(50, 6, sparse, random);
    const Samples shuffled = with_shuffled_features(samples, 1);
    std::size_t moved = 0;
    for (std::size_t d = 0; d < 6; ++d) {
      std::multiset<float> before;
      std::multiset<float> after;
      for (std::size_t i = 0; i < 50; ++i) {
        before.insert(Signal::copy_of(samples[i]).to_dense()[d]);
        after.insert(Signal::copy_of(shuffled[i]).to_dense()[d]);
        moved += before != after;
      }
      EXPECT_EQ(before, after);
    }
    EXPECT_GT(moved, 100U);
    EXPECT_EQ(shuffled.is_sparse(), sparse);
  }
}

// Samples on a line in four dimensions: shuffled, they fill the space.
TEST(ShuffledMeasures, AreWorseThanThoseOfRelatedFeatures) {
  Matrix<float> rows(60, 4);
  for (std::size_t i = 0; i < 60; ++i) {
    for (float& value : rows.row(i)) value = static_cast<float>(i);
  }
  const Samples samples(rows);
  const Som som = som_on(samples, 1, 12);
  MeasureParameters parameters;
  parameters.shuffles = 2;
  const std::vector<SomMeasure> chosen{SomMeasure::kTrustworthiness,
                                       SomMeasure::kExplainedVariance};
  const SomMeasures found = measure_som(som, samples, chosen, parameters);
  const auto shuffled = measure_shuffled(som, samples, chosen, parameters);
  ASSERT_EQ(shuffled.value().size(), 2U);
  for (const SomMeasures& one : *shuffled) {
    for (const SomMeasure measure : chosen) {
      EXPECT_LT(one.values.at(measure), found.values.at(measure) - 0.1);
    }
  }
  EXPECT_NE((*shuffled)[0].values, (*shuffled)[1].values);
  parameters.shuffles = 1;
  parameters.seed = 2;
  EXPECT_EQ(measure_shuffled(som, samples, chosen, parameters).value()[0].values,
            (*shuffled)[1].values);
}

TEST(ShuffledMeasures, StopAndRefuseMapsThatGrow) {
  const Samples samples(Matrix<float>(4, 1, {1, 2, 3, 4}));
  const Som som = som_on(samples, 1, 2);
  MeasureParameters parameters;
  parameters.shuffles = 1;
  const auto stopped = measure_shuffled(som, samples, {}, parameters, {}, 1,
                                        [](std::uint64_t, std::uint64_t) { return false; });
  EXPECT_EQ(stopped.error().kind, ErrorKind::kInterrupted);
  const auto graph = std::make_shared<const NeuronGraph>(2, std::vector<NeuronGraph::Edge>{{0, 1}});
  const Som grown(som.parameters(), Matrix<float>(2, 1, {1, 2}), graph);
  EXPECT_EQ(measure_shuffled(grown, samples, {}, parameters).error().kind, ErrorKind::kUsage);
  // Shuffled maps would be measured by another distance.
  Som weighted = som;
  weighted.set_relevances({1.0});
  EXPECT_EQ(measure_shuffled(weighted, samples, {}, parameters).error().kind, ErrorKind::kUsage);
}

}  // namespace
}  // namespace somato
