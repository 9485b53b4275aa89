#include "somato/maps/som_training.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>
#include <vector>

#include "base/core/elementary.h"
#include "base/support/instruction_sets.h"
#include "maps/support/random_maps.h"
#include "maps/support/som_comparison.h"
#include "maps/training/batch_training.h"
#include "maps/training/som_reference.h"
#include "somato/core/check.h"
#include "somato/maps/som_learner.h"

namespace somato {
namespace {

TEST(SomTraining, OneBatchEpochIsTheReferences) {
  Random random(52);
  int compared = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::size_t size = 1 + random.below(10);
    const Samples samples = testing::random_samples(40, size, random.below(2) == 0, random);
    SomParameters p = testing::random_resolved(random, 40, size);
    p.training = Training::kBatch;
    p.epochs = 0;
    Som som = train_som(p, samples).value();
    ReferenceSom reference(p, testing::widened(som));
    const auto inputs = reference.inputs(samples);
    bool unclear = false;
    for (const auto& input : inputs) {
      unclear |= som.neurons() > 1 && testing::ambiguous(reference, input, som.neurons());
    }
    if (unclear) continue;
    const double radius = 3.0 * random.uniform();
    batch_epoch(som, samples, radius, 1);
    reference.learn_batch(inputs, radius);
    // Sums of several samples may nearly cancel, hence the wider bound.
    testing::expect_weights(som, reference, 1e-4);
    ++compared;
  }
  EXPECT_GT(compared, 600);
}

TEST(SomTraining, ByInnerProductsIsPlainTrainingInDoublePrecision) {
  Random random(53);
  for (int i = 0; i < 300; ++i) {
    const std::size_t count = 2 + random.below(12);
    const std::size_t size = 20 + random.below(60);
    const Samples samples = testing::random_samples(count, size, random.below(2) == 0, random);
    SomParameters p =
        testing::random_resolved(random, count, size, testing::variants_by_products());
    p.iterations = 100 + random.below(400);
    if (p.neighbourhood != NeighbourhoodShape::kGaussian) {
      // Neurons that learn from the same samples, such as those of a bubble, become equal until
      // only rounding distinguishes them; with short training at a low rate the winner depends on
      // the data.
      p.iterations = 50;
      p.learning_rate_start *= 0.1;
      p.learning_rate_end *= 0.1;
    }
    p.radius_reached_at = *p.iterations;
    p.learning_rate_reached_at = *p.iterations;
    p.arithmetic = Arithmetic::kInnerProducts;
    // No ties to begin with; neurons of a small torus that start on a plane become equal, too.
    if (count < p.grid().size() || p.initial_weights == InitialWeights::kLinear) {
      p.initial_weights = InitialWeights::kRange;
    }
    const Som som = train_som(p, samples).value();
    SCOPED_TRACE(testing::name_of({p.lattice, p.topology, p.similarity, p.neighbourhood}));
    testing::expect_weights(som, ReferenceSom::trained(p, samples), 1e-6);
  }
}

TEST(SomTraining, ByInnerProductsSurvivesALearningRateOfOne) {
  Random random(54);
  const Samples samples = testing::random_samples(4, 30, false, random);
  for (const Similarity similarity : {Similarity::kEuclidean, Similarity::kDotProduct}) {
    SomParameters p;
    p.similarity = similarity;
    p.arithmetic = Arithmetic::kInnerProducts;
    p.learning_rate_start = 1.0;
    p.learning_rate_end = 1.0;
    p.radius_start = 0.0;
    p.radius_end = 0.0;
    p.iterations = 3000;
    p = resolve(p, 4, 30).value();
    testing::expect_weights(train_som(p, samples).value(), ReferenceSom::trained(p, samples), 1e-6);
  }
}

// Law: the order of the samples does not change a bit of batch training, however much their values
// differ in size.
TEST(SomTraining, BatchTrainingDoesNotDependOnTheOrderOfSamples) {
  Random random(56);
  Matrix<float> rows(60, 5);
  for (float& value : rows.values()) {
    value = static_cast<float>(random.normal() * power(10.0, 4.0 * random.uniform()));
  }
  const Samples samples(std::move(rows));
  std::vector<std::size_t> reversed(samples.count());
  std::iota(reversed.rbegin(), reversed.rend(), std::size_t{0});
  SomParameters p;
  p.training = Training::kBatch;
  p.epochs = 3;
  p.initial_weights = InitialWeights::kRange;
  p.arithmetic = Arithmetic::kPlain;
  EXPECT_TRUE(train_som(p, samples).value().weights() ==
              train_som(p, samples.subset(reversed)).value().weights());
}

TEST(SomTraining, KeepsDotProductWeightsAtLengthOne) {
  Random random(57);
  const Samples samples = testing::random_samples(10, 7, false, random);
  for (const Training training : {Training::kOnline, Training::kBatch}) {
    SomParameters p;
    p.training = training;
    p.similarity = Similarity::kDotProduct;
    const Som som = train_som(p, samples).value();
    for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
      std::vector<float> row(7);
      som.weights().copy_row(neuron, row);
      EXPECT_NEAR(inner_product(SignalView::dense(row), SignalView::dense(row)), 1.0, 1e-5);
    }
  }
}

struct Case {
  Training training;
  Arithmetic arithmetic;
};

TEST(SomTraining, GivesTheSameBitsForEveryNumberOfThreadsAndInstructionSet) {
  Random random(58);
  const Samples samples = testing::random_samples(23, 70, false, random);
  for (const Case& c : {Case{Training::kOnline, Arithmetic::kPlain},
                        Case{Training::kOnline, Arithmetic::kInnerProducts},
                        Case{Training::kBatch, Arithmetic::kPlain}}) {
    for (const auto& variant : testing::variants_in_pairs()) {
      if (c.arithmetic == Arithmetic::kInnerProducts && !follows_from_products(variant.similarity))
        continue;
      SomParameters p = testing::random_parameters(variant, random);
      p.training = c.training;
      p.arithmetic = c.arithmetic;
      p.iterations = 200;
      p.epochs = 4;
      const LaneMatrix<float> expected = train_som(p, samples).value().weights();
      testing::for_each_instruction_set([&](InstructionSet set) {
        for (const std::size_t threads : {1U, 2U, 4U}) {
          EXPECT_EQ(train_som(p, samples, {threads, {}}).value().weights(), expected)
              << testing::name_of(variant) << " " << name_of(set) << " " << threads;
        }
      });
    }
  }
}

TEST(SomTraining, StopsWhenTheProgressSaysSo) {
  Random random(59);
  const Samples samples = testing::random_samples(5, 40, false, random);
  for (const Case& c : {Case{Training::kOnline, Arithmetic::kPlain},
                        Case{Training::kOnline, Arithmetic::kInnerProducts},
                        Case{Training::kBatch, Arithmetic::kPlain}}) {
    SomParameters p;
    p.training = c.training;
    p.arithmetic = c.arithmetic;
    p.iterations = 5000;
    p.epochs = 50;
    std::uint64_t last = 0;
    const Progress progress = [&](std::uint64_t done, std::uint64_t total) {
      last = done;
      return done < total / 2;
    };
    const auto som = train_som(p, samples, {1, progress});
    ASSERT_FALSE(som);
    EXPECT_EQ(som.error().kind, ErrorKind::kInterrupted);
    EXPECT_LT(last, c.training == Training::kBatch ? 30U : 3000U);
  }
}

TEST(SomTraining, TakesRowsAsSamples) {
  Random random(60);
  Matrix<float> rows(5, 4);
  for (float& value : rows.values()) value = static_cast<float>(random.uniform());
  SomParameters p;
  p.iterations = 100;
  EXPECT_EQ(train_som(p, rows)->weights(), train_som(p, Samples(rows))->weights());
}

TEST(SomTraining, GivesTheSameBitsForAViewAsForACopy) {
  Random random(60);
  Matrix<float> rows(23, 70);
  for (float& value : rows.values()) value = static_cast<float>(random.uniform());
  for (const Case& c : {Case{Training::kOnline, Arithmetic::kPlain},
                        Case{Training::kOnline, Arithmetic::kInnerProducts},
                        Case{Training::kBatch, Arithmetic::kPlain}}) {
    SomParameters p;
    p.training = c.training;
    p.arithmetic = c.arithmetic;
    p.iterations = 200;
    p.epochs = 4;
    const Samples view = Samples::view_of(rows.values(), rows.columns());
    EXPECT_EQ(train_som(p, view)->weights(), train_som(p, Samples(rows))->weights());
  }
}

TEST(SomTraining, ShowsMomentsThatChangeNothing) {
  Random random(61);
  for (const Arithmetic arithmetic : {Arithmetic::kPlain, Arithmetic::kInnerProducts}) {
    for (const Training training : {Training::kOnline, Training::kBatch}) {
      const Samples samples = testing::random_samples(6, 30, random.below(2) == 0, random);
      SomParameters p;
      p.arithmetic = arithmetic;
      p.training = training;
      p.iterations = 250;
      p.epochs = 7;
      std::vector<std::uint64_t> steps;
      LaneMatrix<float> last;
      TrainingOptions options;
      options.observer = [&](const TrainingMoment& moment) {
        EXPECT_EQ(moment.steps, training == Training::kBatch ? 7U : 250U);
        EXPECT_EQ(moment.map().input_size(), 30U);
        EXPECT_GT(moment.weights, 0U);
        steps.push_back(moment.step);
        last = moment.map().weights();
        return true;
      };
      const Som som = train_som(p, samples, options).value();
      EXPECT_EQ(som.weights(), train_som(p, samples)->weights());
      EXPECT_EQ(last, som.weights());
      ASSERT_EQ(steps.size(), training == Training::kBatch ? 7U : 100U);
      EXPECT_EQ(steps.back(), training == Training::kBatch ? 7U : 250U);
      EXPECT_EQ(steps[1], training == Training::kBatch ? 2U : 5U);
    }
  }
}

TEST(SomTraining, ShowsTheMapOfEachMoment) {
  Random random(62);
  const Samples samples = testing::random_samples(6, 30, false, random);
  SomParameters p;
  p.iterations = 400;
  TrainingOptions options;
  options.observer = [&](const TrainingMoment& moment) {
    if (moment.step != 200) return true;
    SomParameters half = p;
    half.learning_rate_reached_at = 400;
    half.radius_reached_at = 400;
    half.iterations = 200;
    EXPECT_EQ(moment.map().weights(), train_som(half, samples)->weights());
    EXPECT_DOUBLE_EQ(moment.radius, resolve(p, 6, 30)->radius().at(199));
    return false;
  };
  p.learning_rate_reached_at = 400;
  p.radius_reached_at = 400;
  const auto stopped = train_som(p, samples, options);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::kInterrupted);
}

TEST(SomTraining, RefusesWhatCannotBeTrainedOn) {
  EXPECT_EQ(train_som({}, Samples()).error().kind, ErrorKind::kData);
  EXPECT_EQ(train_som({}, Samples(Matrix<float>(3, 0))).error().kind, ErrorKind::kData);
  SomParameters odd;
  odd.rows = 3;
  odd.lattice = Lattice::kHexagonal;
  odd.topology = Topology::kTorus;
  EXPECT_EQ(train_som(odd, Samples(Matrix<float>(3, 2))).error().kind, ErrorKind::kUsage);
}

TEST(SomTraining, RefusesSamplesBeyondSinglePrecision) {
  for (const float scale : {1e20F, 1e-20F}) {
    const auto som = train_som({}, Samples(Matrix<float>(3, 2, {0, scale, scale, 0, 0, 0})));
    ASSERT_FALSE(som) << scale;
    EXPECT_EQ(som.error().kind, ErrorKind::kData);
    EXPECT_NE(to_string(som.error()).find("scale or standardize"), std::string::npos);
  }
  EXPECT_TRUE(train_som({}, Samples(Matrix<float>(3, 2))));  // zeros are small, but alike
  EXPECT_TRUE(train_som({}, Samples(Matrix<float>(1, 2, {1e17F, 0}))));
}

TEST(DrawSequence, WithoutReplacementTakesEverySampleOnceARound) {
  DrawSequence draws(Draws::kWithoutReplacement, 10, 3);
  for (int round = 0; round < 3; ++round) {
    std::set<std::size_t> drawn;
    for (int i = 0; i < 10; ++i) drawn.insert(draws.next());
    EXPECT_EQ(drawn.size(), 10U);
  }
}

TEST(DrawSequence, WithReplacementDrawsAllAlike) {
  DrawSequence draws(Draws::kWithReplacement, 10, 3);
  std::vector<int> counts(10);
  for (int i = 0; i < 10000; ++i) ++counts[draws.next()];
  // Each count is binomial with mean 1000 and standard deviation 30.
  for (const int count : counts) EXPECT_NEAR(count, 1000, 150);
}

}  // namespace
}  // namespace somato
