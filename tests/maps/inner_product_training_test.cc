#include "maps/inner_product_training.h"

#include <gtest/gtest.h>

#include <cmath>

#include "somato/core/check.h"
#include "somato/maps/som_learner.h"
#include "support/random_maps.h"

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

std::unique_ptr<InnerProductLearner> learner_of(SomParameters p, const Samples& samples) {
  p.arithmetic = Arithmetic::kInnerProducts;
  return std::move(InnerProductLearner::start(p, samples).value());
}

TEST(InnerProductLearner, LearnsAndAnswersAsPlainArithmetic) {
  Random random(81);
  int steps = 0;
  for (int round = 0; round < 6; ++round) {
    for (const testing::Variant& variant : testing::all_variants()) {
      const Samples samples =
          testing::random_samples(5, 30 + random.below(30), random.below(2) == 0, random);
      SomParameters p = random_problem(variant, random);
      p.arithmetic = Arithmetic::kPlain;
      Som plain = untrained_som(p, samples).value();
      SomLearner by_plain(plain);
      const auto by_products = learner_of(p, samples);
      SomWorkspace workspace;
      std::vector<float> expected(plain.neurons());
      std::vector<float> activity(plain.neurons());
      for (int step = 0; step < 100; ++step) {
        const std::size_t heard = random.below(5);
        by_plain.settle();
        plain.activity(samples[heard], workspace, expected);
        by_products->activity(heard, activity);
        for (std::size_t n = 0; n < expected.size(); ++n) {
          ASSERT_NEAR(activity[n], expected[n], 1e-4 * (1.0 + expected[n]))
              << testing::name_of(variant) << " step " << step;
        }
        const std::size_t sample = random.below(5);
        if (is_close(plain, samples[sample], workspace)) break;
        const double rate = 0.3 * random.uniform();
        const double radius = 0.3 + *p.radius_start * random.uniform();
        ASSERT_EQ(by_products->learn(sample, rate, radius),
                  by_plain.learn(samples[sample], rate, radius))
            << testing::name_of(variant) << " step " << step;
        ++steps;
      }
      by_plain.settle();
      const Som som = by_products->form_som();
      for (std::size_t n = 0; n < som.neurons(); ++n) {
        for (std::size_t d = 0; d < som.input_size(); ++d) {
          ASSERT_NEAR(som.weight(n, d), plain.weight(n, d), 1e-4) << testing::name_of(variant);
        }
      }
    }
  }
  EXPECT_GT(steps, 5000);
}

TEST(InnerProductLearner, FormsTheMapThatTrainingByInnerProductsGives) {
  Random random(82);
  const Samples samples = testing::random_samples(6, 40, true, random);
  SomParameters p;
  p.iterations = 300;
  p.arithmetic = Arithmetic::kInnerProducts;
  const auto learner = learner_of(p, samples);
  const SomParameters& r = learner->parameters();
  DrawSequence draws(r.draws, 6, r.seed);
  for (std::uint64_t t = 0; t < 300; ++t) {
    learner->learn(draws.next(), r.learning_rate().at(t), r.radius().at(t));
  }
  const Som expected = train_som(p, samples).value();
  EXPECT_EQ(learner->form_som().weights(), expected.weights());
  EXPECT_EQ(learner->form_som().elements(), expected.elements());
}

TEST(InnerProductLearner, IsNotForWhatIsLearnedByPlainArithmetic) {
  Random random(83);
  SomParameters p;
  EXPECT_EQ(*InnerProductLearner::start(p, testing::random_samples(6, 3, false, random)), nullptr);
  EXPECT_NE(*InnerProductLearner::start(p, testing::random_samples(6, 12, false, random)), nullptr);
  p.arithmetic = Arithmetic::kPlain;
  EXPECT_EQ(*InnerProductLearner::start(p, testing::random_samples(6, 12, false, random)), nullptr);
  EXPECT_EQ(InnerProductLearner::start(p, Samples()).error().kind, ErrorKind::kData);
}

TEST(InnerProductLearner, RefusesSamplesThatAreNotThere) {
  Random random(84);
  const auto learner = learner_of({}, testing::random_samples(6, 12, false, random));
  std::vector<float> activity(learner->parameters().grid().size());
  EXPECT_THROW(learner->learn(6, 0.1, 1.0), InvalidArgument);
  EXPECT_THROW(learner->activity(6, activity), InvalidArgument);
  activity.pop_back();
  EXPECT_THROW(learner->activity(0, activity), InvalidArgument);
}

}  // namespace
}  // namespace somato
