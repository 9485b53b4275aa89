#include "maps/reading/sample_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include "base/support/instruction_sets.h"
#include "maps/support/random_maps.h"
#include "somato/core/check.h"
#include "somato/core/random.h"
#include "somato/maps/labels.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

using Places = std::vector<std::size_t>;

Places from_zero(std::size_t count) {
  Places places(count);
  std::iota(places.begin(), places.end(), std::size_t{0});
  return places;
}

SomParameters row_of_two() {
  SomParameters parameters;
  parameters.rows = 1;
  parameters.columns = 2;
  return parameters;
}

// About one of `of` neurons, at least one.
Places some_neurons(std::size_t neurons, std::size_t of, Random& random) {
  Places chosen;
  for (std::size_t neuron = 0; neuron < neurons; ++neuron) {
    if (random.below(of) == 0) chosen.push_back(neuron);
  }
  if (chosen.empty()) chosen.push_back(random.below(neurons));
  return chosen;
}

// The readings one by one, as the map gives them for a single sample.
void expect_single_readings(const SampleReadings& readings, const Som& som, const Samples& samples,
                            const Places& places, const Places& candidates,
                            const std::string& what) {
  ASSERT_EQ(readings.winners.size(), places.size()) << what;
  ASSERT_EQ(readings.distances.size(), places.size()) << what;
  ASSERT_EQ(readings.nearest.size(), places.size()) << what;
  SomWorkspace workspace;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Winners winners = som.winners(samples, places[i], workspace);
    EXPECT_EQ(readings.winners[i].first, winners.first) << what << ", sample " << places[i];
    EXPECT_EQ(readings.winners[i].second, winners.second) << what << ", sample " << places[i];
    EXPECT_EQ(readings.distances[i], som.distance(samples, places[i], winners.first, workspace))
        << what << ", sample " << places[i];
    EXPECT_EQ(readings.nearest[i], som.winner_among(candidates, samples, places[i], workspace))
        << what << ", sample " << places[i];
  }
}

void expect_single_readings(const Som& som, const Samples& samples, Random& random,
                            const std::string& what) {
  const Places all = from_zero(samples.count());
  const Places some = some_neurons(samples.count(), 3, random);
  for (const std::size_t of : {1U, 2U, 40U}) {
    const Places candidates = some_neurons(som.neurons(), of, random);
    for (const std::size_t threads : {1U, 3U}) {
      SampleReader reader(som, threads, candidates);
      if (!som.knows(samples)) {
        expect_single_readings(reader.read(samples, {true, true}), som, samples, all, candidates,
                               what);
      }
      expect_single_readings(reader.read(samples, some, {true, true}), som, samples, some,
                             candidates, what);
    }
  }
}

TEST(SampleReaderThreads, ReadsWhatIsReadFromSingleSamples) {
  Random random(3);
  for (const testing::Variant& variant : testing::all_variants()) {
    if (variant.neighbourhood != NeighbourhoodShape::kGaussian) continue;
    for (const bool sparse : {false, true}) {
      for (const bool normalize : {false, true}) {
        SomParameters parameters = testing::random_parameters(variant, random);
        parameters.normalize_input = normalize;
        parameters.iterations = 30;
        const std::size_t size = 1 + random.below(12);
        const Samples learned = testing::random_samples(20, size, sparse, random);
        const Som som = train_som(parameters, learned).value();
        const Samples others = testing::random_samples(30, size, sparse, random);
        expect_single_readings(som, others, random, testing::name_of(variant));
        expect_single_readings(som, learned, random, testing::name_of(variant) + ", learned");
      }
    }
  }
}

// So many neurons and samples that the fast search is worth it; some neurons are equal.
TEST(SampleReaderThreads, ReadsFromALargerMapInBlocks) {
  testing::for_each_instruction_set([](InstructionSet) {
    Random random(4);
    for (const Similarity similarity : {Similarity::kEuclidean, Similarity::kDotProduct}) {
      SomParameters parameters;
      parameters.rows = 20;
      parameters.columns = 30;
      parameters.similarity = similarity;
      parameters.normalize_input = false;
      const Samples samples = testing::random_samples(200, 5, false, random);
      Matrix<float> weights(600, 5);
      for (std::size_t k = 0; k < weights.rows(); ++k) {
        const auto row = samples[k % 150].values;
        std::copy(row.begin(), row.end(), weights.row(k).begin());
      }
      const Som som(parameters, weights);
      expect_single_readings(som, samples, random, choice_name(similarity));
    }
  });
}

// The weights of elements that no sample used are not stored; inputs that have values there are
// farther away.
TEST(SampleReader, ReadsFromListedElements) {
  Random random(6);
  std::vector<Signal> learned;
  std::vector<Signal> others;
  for (std::size_t i = 0; i < 90; ++i) {
    const auto value = static_cast<float>(random.normal());
    learned.push_back(
        Signal::sparse({50}, {3, 7 + static_cast<std::uint32_t>(i % 3)}, {1.0F, value}));
    others.push_back(Signal::sparse({50}, {3, 20}, {value, static_cast<float>(random.normal())}));
  }
  SomParameters parameters;
  parameters.rows = 6;
  parameters.columns = 7;
  parameters.initial_weights = InitialWeights::kSamples;
  parameters.training = Training::kBatch;
  parameters.epochs = 2;
  const Som som = train_som(parameters, Samples::from_signals(learned)).value();
  ASSERT_FALSE(som.elements().all());
  expect_single_readings(som, Samples::from_signals(others), random, "listed");
}

TEST(SampleReader, ReadsNothingFromNoSamples) {
  const Som som(row_of_two(), Matrix<float>(2, 1, {0, 1}));
  const Samples one(Matrix<float>(1, 1, 0.2F));
  EXPECT_TRUE(SampleReader(som).read(Samples()).winners.empty());
  EXPECT_TRUE(SampleReader(som).read(one, Places()).winners.empty());
  EXPECT_TRUE(SampleReader(som).read(one).nearest.empty());
  EXPECT_TRUE(SampleReader(som).read(one).distances.empty());
}

TEST(SampleReader, RefusesNeuronsAndSamplesThatDoNotFit) {
  const Som som(row_of_two(), Matrix<float>(2, 1, {0, 1}));
  EXPECT_THROW(SampleReader(som, 1, {2}), InvalidArgument);
  EXPECT_THROW(SampleReader(som).read(Samples(Matrix<float>(1, 2))), InvalidArgument);
}

TEST(SampleReaderThreads, LabelsAreThoseOfSingleSamples) {
  Random random(8);
  SomParameters parameters;
  parameters.rows = 9;
  parameters.columns = 9;
  const Samples samples = testing::random_samples(120, 4, false, random);
  const Som som(parameters, Matrix<float>(81, 4, [&] {
                  std::vector<float> values(81 * 4);
                  for (float& value : values) value = static_cast<float>(random.normal());
                  return values;
                }()));
  const NeuronLabels labels = NeuronLabels::by_majority({3, 10, 44, 45, 80}, {2, 0, 1, 1, 2}, 81);
  SomWorkspace workspace;
  for (const std::size_t threads : {1U, 2U}) {
    const auto classes = labels.classify(som, samples, threads);
    for (std::size_t i = 0; i < samples.count(); ++i) {
      EXPECT_EQ(classes[i], labels.classify(som, samples[i], workspace));
    }
  }
  EXPECT_THROW((void)NeuronLabels().classify(som, samples), InvalidArgument);
}

TEST(SampleReaderThreads, WritesTheActivityOfEverySample) {
  Random random(9);
  SomParameters parameters;
  parameters.rows = 5;
  parameters.columns = 7;
  parameters.iterations = 20;
  for (const bool sparse : {false, true}) {
    const Samples samples = testing::random_samples(11, 6, sparse, random);
    const Som som = train_som(parameters, samples).value();
    std::vector<float> written(11 * 35);
    std::vector<float> single(35);
    SomWorkspace workspace;
    for (const std::size_t threads : {1U, 3U}) {
      read_activity(som, samples, threads, written);
      for (std::size_t i = 0; i < samples.count(); ++i) {
        som.activity(samples[i], workspace, single);
        EXPECT_TRUE(std::equal(single.begin(), single.end(),
                               written.begin() + 35 * static_cast<std::ptrdiff_t>(i)));
      }
    }
    EXPECT_THROW(read_activity(som, samples, 1, std::span(written).first(35)), InvalidArgument);
  }
}

}  // namespace
}  // namespace somato
