#include "maps/online/product_learner.h"

#include <gtest/gtest.h>

#include <cmath>

#include "maps/support/random_maps.h"
#include "maps/training/som_start.h"
#include "somato/core/check.h"
#include "somato/maps/som_learner.h"

namespace somato {
namespace {

SomParameters random_problem(const testing::Variant& variant, Random& random) {
  SomParameters p = testing::random_parameters(variant, random);
  p.neighbourhood = NeighbourhoodShape::kGaussian;  // see docs/mathematics/inner-products.md
  p.radius_start = 0.5 + 2.0 * random.uniform();
  p.initial_weights = random.below(2) == 0 ? InitialWeights::kRange : InitialWeights::kUniform;
  p.softmax = random.below(2) == 0 ? Softmax::kPower : Softmax::kExponential;
  p.activity_norm = random.below(2) == 0 ? ActivityNorm::kSum : ActivityNorm::kMaximum;
  if (random.below(2) == 0) p.normalize_input = random.below(2) == 0;
  return p;
}

// Whether rounding decides the winner.
bool is_close(const Som& som, const SignalView& input, SomWorkspace& workspace) {
  if (som.neurons() == 1) return false;
  std::vector<float> similarities(som.neurons());
  som.similarities(input, workspace, similarities);
  const Winners winners = som.winners(input, workspace);
  return similarities[winners.first] - similarities[winners.second] < 2e-5F;
}

// A map that has learned nothing and knows the samples by inner products.
Som untrained_for_products(SomParameters p, const Samples& samples) {
  p.arithmetic = Arithmetic::kInnerProducts;
  return start_som(p, samples, {}).value().som;
}

TEST(ProductLearner, LearnsAndAnswersAsPlainArithmetic) {
  Random random(81);
  int steps = 0;
  for (int round = 0; round < 6; ++round) {
    for (const testing::Variant& variant : testing::variants_by_products()) {
      const Samples samples =
          testing::random_samples(5, 30 + random.below(30), random.below(2) == 0, random);
      SomParameters p = random_problem(variant, random);
      p.arithmetic = Arithmetic::kPlain;
      Som plain = untrained_som(p, samples).value();
      SomLearner by_plain(plain);
      Som product = untrained_for_products(p, samples);
      SomLearner by_products(product);
      SomWorkspace workspace;
      std::vector<float> expected(plain.neurons());
      std::vector<float> activity(plain.neurons());
      for (int step = 0; step < 100; ++step) {
        const std::size_t sum = random.below(5);
        by_plain.settle();
        plain.activity(samples[sum], workspace, expected);
        by_products.activity(samples, sum, activity);
        for (std::size_t n = 0; n < expected.size(); ++n) {
          ASSERT_NEAR(activity[n], expected[n], 1e-4 * (1.0 + expected[n]))
              << testing::name_of(variant) << " step " << step;
        }
        const std::size_t sample = random.below(5);
        if (is_close(plain, samples[sample], workspace)) break;
        const double rate = 0.3 * random.uniform();
        const double radius = 0.3 + *p.radius_start * random.uniform();
        const LearningStep one{rate, radius};
        by_products.learn(samples, {&sample, 1}, {&one, 1});
        by_plain.learn(samples[sample], rate, radius);
        ++steps;
      }
      by_plain.settle();
      const Som som = by_products.look();
      EXPECT_TRUE(som.knows(samples));
      for (std::size_t n = 0; n < som.neurons(); ++n) {
        for (std::size_t d = 0; d < som.input_size(); ++d) {
          ASSERT_NEAR(som.weight(n, d), plain.weight(n, d), 1e-4) << testing::name_of(variant);
        }
      }
    }
  }
  EXPECT_GT(steps, 5000);
}

TEST(ProductLearner, FormsTheMapThatTrainingByInnerProductsGives) {
  Random random(82);
  const Samples samples = testing::random_samples(6, 40, true, random);
  SomParameters p;
  p.iterations = 300;
  p.arithmetic = Arithmetic::kInnerProducts;
  Som som = untrained_for_products(p, samples);
  const SomParameters r = som.parameters();
  DrawSequence draws(r.draws, 6, r.seed);
  SomLearner learner(som);
  for (std::uint64_t t = 0; t < 300; ++t) {
    const std::size_t drawn = draws.next();
    const LearningStep step{r.learning_rate().at(t), r.radius().at(t)};
    learner.learn(samples, {&drawn, 1}, {&step, 1});
    if (t % 50 == 0) learner.settle();
  }
  learner.settle();
  const Som expected = train_som(p, samples).value();
  EXPECT_EQ(som.weights(), expected.weights());
  EXPECT_EQ(som.elements(), expected.elements());
}

// Inputs that it does not know by products are learned by plain arithmetic from then on.
TEST(ProductLearner, GivesWayToWeightsForOtherInputs) {
  Random random(83);
  const Samples samples = testing::random_samples(6, 40, false, random);
  Som product = untrained_for_products({}, samples);
  Som plain(product.parameters(), product.weights());
  const std::size_t first = 0;
  const LearningStep step{0.3, 1.0};
  SomLearner by_products(product);
  SomLearner by_plain(plain);
  by_products.learn(samples, {&first, 1}, {&step, 1});
  by_plain.learn(samples[0], 0.3, 1.0);
  const Samples other = testing::random_samples(1, 40, false, random);
  EXPECT_EQ(by_products.learn(other[0], 0.3, 1.0), by_plain.learn(other[0], 0.3, 1.0));
  by_products.settle();
  by_plain.settle();
  EXPECT_FALSE(product.knows(samples));
  for (std::size_t n = 0; n < product.neurons(); ++n) {
    for (std::size_t d = 0; d < 40; ++d) {
      EXPECT_NEAR(product.weight(n, d), plain.weight(n, d), 1e-5);
    }
  }
}

TEST(ProductLearner, RefusesSamplesThatAreNotThere) {
  Random random(84);
  const Samples samples = testing::random_samples(6, 12, false, random);
  Som som = untrained_for_products({}, samples);
  SomLearner learner(som);
  std::vector<float> activity(som.neurons());
  const std::size_t none = 6;
  const LearningStep step{0.1, 1.0};
  EXPECT_THROW(learner.learn(samples, {&none, 1}, {&step, 1}), InvalidArgument);
  EXPECT_THROW(learner.activity(samples, 6, activity), InvalidArgument);
  activity.pop_back();
  EXPECT_THROW(learner.activity(samples, 0, activity), InvalidArgument);
}

}  // namespace
}  // namespace somato
