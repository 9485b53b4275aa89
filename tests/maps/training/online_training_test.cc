#include "maps/training/online_training.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "maps/support/som_comparison.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

SomParameters mexican_hat(Random& random, std::size_t samples, std::size_t size) {
  SomParameters p = testing::random_resolved(random, samples, size);
  p.neighbourhood = NeighbourhoodShape::kMexicanHat;
  p.initial_weights = InitialWeights::kRange;  // no ties to begin with
  p.iterations = 20 + random.below(40);
  p.radius_reached_at = *p.iterations;
  p.learning_rate_start *= 0.2;
  p.learning_rate_end *= 0.2;
  p.learning_rate_reached_at = *p.iterations;
  return p;
}

// Negative factors in dense, sparse and product arithmetic.
TEST(OnlineTraining, WithAMexicanHatIsThatOfTheReference) {
  Random random(61);
  for (int round = 0; round < 120; ++round) {
    const std::size_t count = 5 + random.below(12);
    const std::size_t size = 5 + random.below(70);
    const Samples samples = testing::random_samples(count, size, round % 2 == 0, random);
    SomParameters p = mexican_hat(random, count, size);
    const bool by_products = round % 3 == 0 && follows_from_products(p.similarity);
    p.arithmetic = by_products ? Arithmetic::kInnerProducts : Arithmetic::kPlain;
    const auto som = train_som(p, samples);
    ASSERT_TRUE(som) << to_string(som.error());
    testing::expect_weights(*som, ReferenceSom::trained(p, samples), 1e-4);
  }
}

TEST(OnlineTraining, WithAMexicanHatEndsBeforeWeightsAreInfinite) {
  Random random(62);
  const Samples samples = testing::random_samples(50, 5, false, random);
  SomParameters p;
  p.rows = 10;
  p.columns = 10;
  p.neighbourhood = NeighbourhoodShape::kMexicanHat;
  p.learning_rate_start = 1.0;
  p.learning_rate_end = 1.0;
  p.iterations = 20000;
  for (const auto arithmetic : {Arithmetic::kPlain, Arithmetic::kInnerProducts}) {
    p.arithmetic = arithmetic;
    const auto refused = train_som(p, samples);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kData);
    EXPECT_NE(refused.error().what.find("without limit"), std::string::npos);
    p.similarity = Similarity::kDotProduct;
    const Som som = train_som(p, samples).value();
    for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
      EXPECT_TRUE(std::isfinite(som.weight(neuron, 0)));
    }
    p.similarity = Similarity::kEuclidean;
  }
}

TEST(SomTraining, InBatchesHasNoMexicanHat) {
  SomParameters p;
  p.training = Training::kBatch;
  p.neighbourhood = NeighbourhoodShape::kMexicanHat;
  const auto refused = train_som(p, Samples(Matrix<float>(3, 2, {0, 1, 2, 3, 4, 5})));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
}

// Linear initial weights and batch training use no random numbers.
TEST(SomTraining, InBatchesFromLinearWeightsDoesNotDependOnTheSeed) {
  Random random(63);
  const Samples samples = testing::random_samples(40, 5, false, random);
  SomParameters p;
  p.training = Training::kBatch;
  p.initial_weights = InitialWeights::kLinear;
  const Som som = train_som(p, samples).value();
  p.seed = 12345;
  EXPECT_EQ(train_som(p, samples).value().weights(), som.weights());
}

TEST(SomTraining, FromLinearWeightsByProductsIsPlainTraining) {
  Random random(64);
  for (int round = 0; round < 60; ++round) {
    const std::size_t count = 2 + random.below(20);
    const Samples samples =
        testing::random_samples(count, 10 + random.below(50), round % 2 == 0, random);
    SomParameters p =
        testing::random_resolved(random, count, samples.size(), testing::variants_by_products());
    p.initial_weights = InitialWeights::kLinear;
    p.iterations = 0;
    p.arithmetic = Arithmetic::kInnerProducts;
    // A sample without elements and the opposite end of the plane can be 0, which has no direction.
    if (samples.is_sparse() && p.similarity == Similarity::kDotProduct) continue;
    const Som som = train_som(p, samples).value();
    testing::expect_weights(som, ReferenceSom::initial(p, samples), 1e-4);
    // Samples that are only known do not move the plane.
    TrainingOptions options;
    options.training = std::vector<std::size_t>{0, count - 1};
    const Som of_two = train_som(p, samples, options).value();
    // The centre of two opposite samples is 0 up to rounding.
    const auto initial = ReferenceSom::initial(p, samples.subset({0, count - 1}));
    for (std::size_t neuron = 0; neuron < of_two.neurons(); ++neuron) {
      for (std::size_t d = 0; d < samples.size(); ++d) {
        EXPECT_NEAR(of_two.weight(neuron, d), initial.weights()(neuron, d), 1e-5);
      }
    }
  }
}

TEST(SomTraining, FromLinearWeightsTakesOneSampleAndEqualOnes) {
  for (const std::size_t count : {1U, 4U}) {
    const Samples samples(Matrix<float>(count, 3, 0.7F));
    for (const auto arithmetic : {Arithmetic::kPlain, Arithmetic::kInnerProducts}) {
      for (const auto training : {Training::kBatch, Training::kOnline}) {
        SomParameters p;
        p.initial_weights = InitialWeights::kLinear;
        p.arithmetic = arithmetic;
        p.training = training;
        const Som som = train_som(p, samples).value();
        for (std::size_t n = 0; n < som.neurons(); ++n) EXPECT_NEAR(som.weight(n, 2), 0.7F, 1e-5);
      }
    }
  }
}

}  // namespace
}  // namespace somato
