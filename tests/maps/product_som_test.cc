#include "somato/maps/product_som.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "somato/core/check.h"
#include "somato/maps/som_reference.h"
#include "support/instruction_sets.h"
#include "support/random_maps.h"

namespace somato {
namespace {

struct ProductProblem {
  SomParameters parameters;
  Samples samples;
  std::vector<std::size_t> training;
  std::string name;
};

// Some of the samples held out; those of sparse problems have elements of their own.
ProductProblem random_product_problem(const testing::Variant& variant, Random& random) {
  ProductProblem problem;
  problem.name = testing::name_of(variant);
  SomParameters& p = problem.parameters;
  p = testing::random_parameters(variant, random);
  p.arithmetic = Arithmetic::kInnerProducts;
  p.training = random.below(3) == 0 ? Training::kBatch : Training::kOnline;
  const auto& starts = Choices<InitialWeights>::all();
  p.initial_weights = starts[random.below(starts.size())].first;
  p.iterations = random.below(200);
  p.epochs = random.below(6);
  p.radius_start = 0.5 + 2.0 * random.uniform();
  if (random.below(2) == 0) p.normalize_input = random.below(2) == 0;
  const std::size_t count = 3 + random.below(25);
  problem.samples =
      testing::random_samples(count, 20 + random.below(60), random.below(2) == 0, random);
  for (std::size_t i = 0; i < count; ++i) {
    if (problem.training.empty() || random.below(3) != 0) problem.training.push_back(i);
  }
  problem.name += " " + choice_name(p.training) + " " + choice_name(p.initial_weights);
  return problem;
}

template <typename Work>
void for_each_product_problem(std::uint64_t seed, int rounds, const Work& work) {
  Random random(seed);
  for (int round = 0; round < rounds; ++round) {
    for (const testing::Variant& variant : testing::all_variants()) {
      const ProductProblem problem = random_product_problem(variant, random);
      SCOPED_TRACE(problem.name);
      work(problem, random);
    }
  }
}

ProductSom trained(const ProductProblem& problem, std::size_t threads = 1) {
  const KnownSamples known(problem.samples);
  return **train_product_som(problem.parameters, known, problem.training, {threads, {}});
}

TEST(ProductSom, FormsTheMapThatTrainingOnItsSamplesGives) {
  for_each_product_problem(101, 6, [](const ProductProblem& problem, Random& /*random*/) {
    const Som expected =
        train_som(problem.parameters, problem.samples.subset(problem.training)).value();
    const Som som = trained(problem).form_som();
    EXPECT_EQ(som.weights(), expected.weights());
    EXPECT_EQ(som.elements(), expected.elements());
    EXPECT_EQ(parameters_to_toml(som.parameters()), parameters_to_toml(expected.parameters()));
  });
}

TEST(ProductSom, StartsAsPlainArithmeticDoes) {
  for_each_product_problem(102, 4, [](ProductProblem problem, Random& /*random*/) {
    problem.parameters.iterations = 0;
    problem.parameters.epochs = 0;
    const Samples samples = problem.samples.subset(problem.training);
    const Som som = trained(problem).form_som();
    problem.parameters.arithmetic = Arithmetic::kPlain;
    const Som expected = train_som(problem.parameters, samples).value();
    EXPECT_EQ(som.weights(), expected.weights());
  });
}

// How far the first of two scores is from the second, where rounding may decide between them.
bool close(double a, double b) {
  return std::fabs(a - b) < 1e-5 * (1.0 + std::fabs(a));
}

TEST(ProductSom, AnswersAsTheMapThatItForms) {
  int compared = 0;
  for_each_product_problem(103, 6, [&](const ProductProblem& problem, Random& random) {
    const ProductSom map = trained(problem);
    const Som som = map.form_som();
    SomWorkspace workspace;
    std::vector<float> expected(som.neurons());
    std::vector<float> actual(som.neurons());
    std::vector<std::size_t> candidates;
    for (std::size_t n = 0; n < som.neurons(); ++n) {
      if (candidates.empty() || random.below(2) == 0) candidates.push_back(n);
    }
    for (std::size_t sample = 0; sample < problem.samples.count(); ++sample) {
      const SignalView x = problem.samples[sample];
      som.similarities(x, workspace, expected);
      map.similarities(sample, actual);
      for (std::size_t n = 0; n < expected.size(); ++n) {
        const double distance = som.distance(x, n, workspace);
        EXPECT_NEAR(std::sqrt(map.squared_distance(sample, n)), distance, 1e-4 * (1 + distance));
        EXPECT_NEAR(actual[n], expected[n], 1e-4 * (1.0 + std::fabs(expected[n])));
      }
      const Winners winners = map.winners(sample);
      EXPECT_EQ(map.winner(sample), winners.first);
      som.activity(x, workspace, expected);
      map.activity(sample, actual);
      for (std::size_t n = 0; n < expected.size(); ++n) EXPECT_NEAR(actual[n], expected[n], 2e-3);
      som.similarities(x, workspace, expected);
      std::vector<float> sorted = expected;
      std::sort(sorted.rbegin(), sorted.rend());
      if (sorted.size() < 3 || close(sorted[0], sorted[1]) || close(sorted[1], sorted[2])) continue;
      const Winners theirs = som.winners(x, workspace);
      EXPECT_EQ(winners.first, theirs.first);
      EXPECT_EQ(winners.second, theirs.second);
      const std::size_t among = map.winner_among(candidates, sample);
      const std::size_t expected_among = som.winner_among(candidates, x, workspace);
      EXPECT_TRUE(among == expected_among || close(expected[among], expected[expected_among]));
      ++compared;
    }
  });
  EXPECT_GT(compared, 500);
}

TEST(ProductSom, IsTheSameBitsOnEveryInstructionSetAndThreadCount) {
  for_each_product_problem(104, 2, [](const ProductProblem& problem, Random& /*random*/) {
    const ProductSom expected = trained(problem);
    const Som som = expected.form_som();
    testing::for_each_instruction_set([&](InstructionSet /*set*/) {
      for (const std::size_t threads : {1U, 2U, 4U}) {
        const ProductSom map = trained(problem, threads);
        EXPECT_EQ(map.form_som(threads).weights(), som.weights());
        for (std::size_t sample = 0; sample < problem.samples.count(); ++sample) {
          EXPECT_EQ(map.squared_distance(sample, 0), expected.squared_distance(sample, 0));
        }
      }
    });
  });
}

// Whether rounding decides a winner.
bool unclear(const ReferenceSom& reference, const std::vector<std::vector<double>>& inputs) {
  for (const auto& input : inputs) {
    const std::size_t winner = reference.winner(input);
    const double best = reference.score(input, winner);
    for (std::size_t n = 0; n < reference.weights().rows(); ++n) {
      if (n != winner && std::fabs(reference.score(input, n) - best) < 1e-6) return true;
    }
  }
  return false;
}

double relative_difference(const Som& som, const Matrix<double>& expected) {
  double error = 0.0;
  double length = 1e-30;
  for (std::size_t n = 0; n < expected.rows(); ++n) {
    for (std::size_t d = 0; d < expected.columns(); ++d) {
      error += std::pow(double{som.weight(n, d)} - expected(n, d), 2);
      length += expected(n, d) * expected(n, d);
    }
  }
  return std::sqrt(error / length);
}

// Batch training by products is batch training.
TEST(ProductSom, BatchTrainingIsTheReferences) {
  int compared = 0;
  for_each_product_problem(105, 12, [&](ProductProblem problem, Random& /*random*/) {
    SomParameters& p = problem.parameters;
    p.training = Training::kBatch;
    p.initial_weights = InitialWeights::kRange;
    p.epochs = 3;
    const Samples samples = problem.samples.subset(problem.training);
    p = resolve(p, samples.count(), samples.size()).value();
    ReferenceSom reference = ReferenceSom::initial(p, samples);
    const auto inputs = reference.inputs(samples);
    for (std::uint64_t epoch = 0; epoch < p.epochs; ++epoch) {
      if (unclear(reference, inputs)) return;
      reference.learn_batch(inputs, p.radius().at(epoch));
    }
    EXPECT_LE(relative_difference(trained(problem).form_som(), reference.weights()), 1e-5);
    ++compared;
  });
  EXPECT_GT(compared, 100);
}

// More samples and neurons than fit into registers or one strip.
TEST(ProductSom, TrainsALargerMapAsTheReferenceDoes) {
  Random random(106);
  for (const bool sparse : {false, true}) {
    for (const Training training : {Training::kOnline, Training::kBatch}) {
      const Samples samples = testing::random_samples(45, 400, sparse, random);
      SomParameters p;
      p.rows = 13;
      p.columns = 14;
      p.arithmetic = Arithmetic::kInnerProducts;
      p.training = training;
      p.iterations = 400;
      p.epochs = 4;
      p = resolve(p, 45, 400).value();
      const Som som = train_som(p, samples).value();
      const ReferenceSom reference = ReferenceSom::trained(p, samples);
      for (std::size_t n = 0; n < som.neurons(); ++n) {
        for (std::size_t d = 0; d < 400; ++d) {
          ASSERT_NEAR(som.weight(n, d), reference.weights()(n, d), 1e-6);
        }
      }
    }
  }
}

TEST(ProductSom, IsNotForWhatIsTrainedByPlainArithmetic) {
  Random random(107);
  SomParameters p;
  const KnownSamples narrow(testing::random_samples(6, 7, false, random));
  EXPECT_FALSE(train_product_som(p, narrow, {0, 1, 2, 3, 4, 5}).value());
  // What is held out does not count.
  EXPECT_TRUE(train_product_som(p, narrow, {0, 2, 4}).value());
  p.arithmetic = Arithmetic::kPlain;
  EXPECT_FALSE(train_product_som(p, narrow, {0, 2, 4}).value());
}

TEST(ProductSom, RefusesWhatCannotBeTrainedOnOrAsked) {
  Random random(108);
  const KnownSamples known(testing::random_samples(6, 20, true, random));
  EXPECT_EQ(train_product_som({}, known, {}).error().kind, ErrorKind::kData);
  EXPECT_EQ(train_product_som({}, KnownSamples(), {}).error().kind, ErrorKind::kData);
  EXPECT_THROW((void)train_product_som({}, known, {6}), InvalidArgument);
  SomParameters p;
  p.arithmetic = Arithmetic::kInnerProducts;
  const KnownSamples tiny(Samples(Matrix<float>(2, 2, {0.0F, 1e-20F, 1e-20F, 0.0F})));
  EXPECT_EQ(train_product_som(p, tiny, {0, 1}).error().kind, ErrorKind::kData);
  const ProductSom map = **train_product_som({}, known, {1, 3});
  std::vector<float> out(map.neurons());
  EXPECT_THROW((void)map.winner(6), InvalidArgument);
  EXPECT_THROW((void)map.squared_distance(0, map.neurons()), InvalidArgument);
  EXPECT_THROW((void)map.winner_among({}, 0), InvalidArgument);
  EXPECT_THROW(map.similarities(6, out), InvalidArgument);
  out.pop_back();
  EXPECT_THROW(map.activity(0, out), InvalidArgument);
}

}  // namespace
}  // namespace somato
