#include "maps/products/product_weights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <vector>

#include "base/support/instruction_sets.h"
#include "maps/support/random_maps.h"
#include "maps/support/som_comparison.h"
#include "maps/training/som_reference.h"
#include "somato/core/check.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

struct WeightsProblem {
  SomParameters parameters;
  Samples samples;
  std::vector<std::size_t> training;
  std::string name;
};

// Some of the samples held out; those of sparse problems have elements of their own.
WeightsProblem random_product_problem(const testing::Variant& variant, Random& random) {
  WeightsProblem problem;
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
    for (const testing::Variant& variant : testing::variants_by_products()) {
      const WeightsProblem problem = random_product_problem(variant, random);
      SCOPED_TRACE(problem.name);
      work(problem, random);
    }
  }
}

Som trained(const WeightsProblem& problem, std::size_t threads = 1) {
  return train_som(problem.parameters, problem.samples, {threads, {}, {}, problem.training})
      .value();
}

TEST(ProductWeights, FormsTheMapThatTrainingOnItsSamplesGives) {
  for_each_product_problem(101, 6, [](const WeightsProblem& problem, Random& /*random*/) {
    const Som expected =
        train_som(problem.parameters, problem.samples.subset(problem.training)).value();
    const Som som = trained(problem);
    EXPECT_TRUE(som.knows(problem.samples));
    EXPECT_EQ(som.weights(), expected.weights());
    EXPECT_EQ(som.elements(), expected.elements());
    EXPECT_EQ(parameters_to_toml(som.parameters()), parameters_to_toml(expected.parameters()));
  });
}

TEST(ProductWeights, StartsAsPlainArithmeticDoes) {
  for_each_product_problem(102, 4, [](WeightsProblem problem, Random& /*random*/) {
    problem.parameters.iterations = 0;
    problem.parameters.epochs = 0;
    const Samples samples = problem.samples.subset(problem.training);
    const Som som = trained(problem);
    problem.parameters.arithmetic = Arithmetic::kPlain;
    const Som expected = train_som(problem.parameters, samples).value();
    // Linear weights are combinations of samples, which are rounded differently.
    if (problem.parameters.initial_weights != InitialWeights::kLinear) {
      EXPECT_EQ(som.weights(), expected.weights());
    } else {
      testing::expect_weights(som, ReferenceSom(expected.parameters(), testing::widened(expected)),
                              1e-5);
    }
  });
}

// How far the first of two scores is from the second, where rounding may decide between them.
bool close(double a, double b) {
  return std::fabs(a - b) < 1e-5 * (1.0 + std::fabs(a));
}

TEST(ProductWeights, AnswersAsTheMapThatItForms) {
  int compared = 0;
  for_each_product_problem(103, 6, [&](const WeightsProblem& problem, Random& random) {
    const Som som = trained(problem);
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
      similarities(som.products()->reading(sample), actual);
      for (std::size_t n = 0; n < expected.size(); ++n) {
        const double distance = som.distance(x, n, workspace);
        EXPECT_NEAR(som.distance(problem.samples, sample, n, workspace), distance,
                    1e-4 * (1 + distance));
        EXPECT_NEAR(actual[n], expected[n], 1e-4 * (1.0 + std::fabs(expected[n])));
      }
      const Winners winners = som.winners(problem.samples, sample, workspace);
      som.activity(x, workspace, expected);
      activity(som.products()->reading(sample), som.parameters(), actual);
      for (std::size_t n = 0; n < expected.size(); ++n) EXPECT_NEAR(actual[n], expected[n], 2e-3);
      som.similarities(x, workspace, expected);
      std::vector<float> sorted = expected;
      std::sort(sorted.rbegin(), sorted.rend());
      if (sorted.size() < 3 || close(sorted[0], sorted[1]) || close(sorted[1], sorted[2])) continue;
      const Winners theirs = som.winners(x, workspace);
      EXPECT_EQ(winners.first, theirs.first);
      EXPECT_EQ(winners.second, theirs.second);
      const std::size_t among = som.winner_among(candidates, problem.samples, sample, workspace);
      const std::size_t expected_among = som.winner_among(candidates, x, workspace);
      EXPECT_TRUE(among == expected_among || close(expected[among], expected[expected_among]));
      ++compared;
    }
  });
  EXPECT_GT(compared, 500);
}

TEST(ProductWeights, IsTheSameBitsOnEveryInstructionSetAndThreadCount) {
  for_each_product_problem(104, 2, [](const WeightsProblem& problem, Random& /*random*/) {
    const Som som = trained(problem);
    SomWorkspace workspace;
    testing::for_each_instruction_set([&](InstructionSet /*set*/) {
      for (const std::size_t threads : {1U, 2U, 4U}) {
        const Som map = trained(problem, threads);
        EXPECT_EQ(map.weights(), som.weights());
        for (std::size_t sample = 0; sample < problem.samples.count(); ++sample) {
          EXPECT_EQ(map.distance(problem.samples, sample, 0, workspace),
                    som.distance(problem.samples, sample, 0, workspace));
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
TEST(ProductWeights, BatchTrainingIsTheReferences) {
  int compared = 0;
  for_each_product_problem(105, 12, [&](WeightsProblem problem, Random& /*random*/) {
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
    EXPECT_LE(relative_difference(trained(problem), reference.weights()), 1e-5);
    ++compared;
  });
  EXPECT_GT(compared, 100);
}

// More samples and neurons than fit into registers or one strip.
TEST(ProductWeights, TrainsALargerMapAsTheReferenceDoes) {
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

Som trained_on(SomParameters parameters, const Samples& samples,
               const std::vector<std::size_t>& training) {
  return train_som(parameters, samples, {1, {}, {}, training}).value();
}

TEST(ProductWeights, AreNotForWhatIsTrainedByPlainArithmetic) {
  Random random(107);
  SomParameters p;
  const Samples narrow = testing::random_samples(6, 7, false, random);
  EXPECT_FALSE(trained_on(p, narrow, {0, 1, 2, 3, 4, 5}).knows(narrow));
  // Held-out samples do not count.
  EXPECT_TRUE(trained_on(p, narrow, {0, 2, 4}).knows(narrow));
  p.arithmetic = Arithmetic::kPlain;
  const Som plain = trained_on(p, narrow, {0, 2, 4});
  EXPECT_FALSE(plain.knows(narrow));
  EXPECT_EQ(plain.weights(), train_som(p, narrow.subset({0, 2, 4}))->weights());
}

TEST(ProductWeights, KnowOnlyTheSamplesThatTheyWereGiven) {
  Random random(108);
  const Samples samples = testing::random_samples(6, 20, true, random);
  const Som som = trained_on({}, samples, {1, 3});
  EXPECT_TRUE(som.knows(Samples(samples)));
  EXPECT_FALSE(som.knows(samples.subset({0, 1, 2, 3, 4, 5})));
  SomWorkspace workspace;
  const Samples others = testing::random_samples(2, 20, false, random);
  EXPECT_EQ(som.winners(others, 1, workspace).first, som.winner(others[1], workspace));
  EXPECT_EQ(som.distance(others, 1, 3, workspace), som.distance(others[1], 3, workspace));
}

TEST(ProductWeights, RefuseSamplesThatDoNotExist) {
  Random random(108);
  const Samples samples = testing::random_samples(6, 20, true, random);
  const auto refused = [](const SomParameters& p, const Samples& all,
                          const std::vector<std::size_t>& training) {
    return train_som(p, all, {1, {}, {}, training}).error().kind;
  };
  EXPECT_EQ(refused({}, samples, {}), ErrorKind::kData);
  EXPECT_EQ(refused({}, Samples(), {}), ErrorKind::kData);
  EXPECT_THROW((void)trained_on({}, samples, {6}), InvalidArgument);
  SomParameters p;
  p.arithmetic = Arithmetic::kInnerProducts;
  const Samples tiny(Matrix<float>(2, 2, {0.0F, 1e-20F, 1e-20F, 0.0F}));
  EXPECT_EQ(refused(p, tiny, {0, 1}), ErrorKind::kData);
  const Som som = trained_on({}, samples, {1, 3});
  SomWorkspace workspace;
  EXPECT_THROW((void)som.winners(samples, 6, workspace), InvalidArgument);
  EXPECT_THROW((void)som.distance(samples, 0, som.neurons(), workspace), InvalidArgument);
  EXPECT_THROW((void)som.winner_among({}, samples, 0, workspace), InvalidArgument);
  std::vector<float> out(som.neurons() - 1);
  EXPECT_THROW(similarities(som.products()->reading(0), out), InvalidArgument);
}

// Maps that scale their inputs and maps that do not.
TEST(ProductWeights, ShareTheSamplesProductsOnSeveralThreads) {
  Random random(109);
  const Samples samples = testing::random_samples(6, 200, true, random);
  const std::vector<std::size_t> training{0, 1, 2, 4};
  std::vector<SomParameters> parameters(4);
  for (std::size_t i = 0; i < 4; ++i) {
    parameters[i].iterations = 50;
    parameters[i].normalize_input = i % 2 == 1;
  }
  std::vector<Som> soms(4);
  {
    std::vector<std::jthread> threads;
    threads.reserve(soms.size());
    for (std::size_t i = 0; i < 4; ++i) {
      threads.emplace_back([&, i] { soms[i] = trained_on(parameters[i], samples, training); });
    }
  }
  const auto shared_products = [&](std::size_t i) {
    return &soms[i].products()->state().problem().known();
  };
  EXPECT_EQ(shared_products(0), shared_products(2));
  EXPECT_EQ(shared_products(1), shared_products(3));
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(soms[i].weights(), train_som(parameters[i], samples.subset(training))->weights());
  }
}

TEST(ProductWeights, AreFormedOnceForAllCopiesAndThreads) {
  Random random(110);
  const Samples samples = testing::random_samples(6, 300, true, random);
  const Som som = train_som({}, samples).value();
  std::vector<const float*> found(4);
  {
    std::vector<std::jthread> threads;
    threads.reserve(found.size());
    for (std::size_t i = 0; i < 4; ++i) {
      threads.emplace_back([&, i, copy = som] { found[i] = copy.weights().data(); });
    }
  }
  EXPECT_EQ(found, std::vector<const float*>(4, som.weights().data()));
}

}  // namespace
}  // namespace somato
