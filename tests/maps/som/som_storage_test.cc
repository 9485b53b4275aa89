// Maps with weights for some elements against the same maps with weights for all.

#include <gtest/gtest.h>

#include <cmath>

#include "maps/som/som_archive.h"
#include "maps/support/random_maps.h"
#include "maps/training/batch_training.h"
#include "somato/core/check.h"
#include "somato/maps/som_learner.h"
#include "somato/maps/som_quality.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

// Sparse samples that use about `used` of `size` elements.
Samples narrow_samples(std::size_t count, std::size_t size, std::size_t used, Random& random) {
  std::vector<std::uint32_t> places(used);
  for (std::size_t k = 0; k < used; ++k) {
    places[k] = static_cast<std::uint32_t>(k * (size / used) + random.below(size / used));
  }
  std::vector<Signal> signals;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::uint32_t> indices;
    std::vector<float> values;
    for (const std::uint32_t place : places) {
      if (random.below(3) == 0) continue;
      indices.push_back(place);
      values.push_back(static_cast<float>(random.normal()));
    }
    signals.push_back(Signal::sparse({size}, indices, values));
  }
  return Samples::from_signals(signals);
}

Samples dense_rows(const Samples& samples) {
  Matrix<float> rows(samples.count(), samples.size());
  for (std::size_t i = 0; i < samples.count(); ++i) write_dense(samples[i], rows.row(i));
  return Samples(std::move(rows));
}

// The same bits where weights are stored, and exactly 0 elsewhere.
void expect_same_weights(const Som& some, const Som& all, const std::string& name) {
  ASSERT_TRUE(all.elements().all());
  ASSERT_EQ(some.input_size(), all.input_size());
  for (std::size_t neuron = 0; neuron < all.neurons(); ++neuron) {
    for (std::size_t d = 0; d < all.input_size(); ++d) {
      ASSERT_EQ(some.weight(neuron, d), all.weights()(neuron, d)) << name << " " << d;
      const bool stored = some.elements().place_of(d).has_value();
      ASSERT_TRUE(stored || all.weights()(neuron, d) == 0.0F) << name << " " << d;
    }
  }
}

struct StoredProblem {
  SomParameters parameters;
  Samples samples;
  std::string name;
};

StoredProblem random_stored_problem(const testing::Variant& variant, Random& random) {
  StoredProblem problem{testing::random_parameters(variant, random), {}, testing::name_of(variant)};
  SomParameters& p = problem.parameters;
  problem.samples = narrow_samples(3 + random.below(6), 40 + random.below(40), 12, random);
  p.training = random.below(4) == 0 ? Training::kBatch : Training::kOnline;
  p.arithmetic = Arithmetic::kPlain;
  p.initial_weights = random.below(2) == 0 ? InitialWeights::kRange : InitialWeights::kSamples;
  if (random.below(2) == 0) p.normalize_input = random.below(2) == 0;
  p.iterations = 1 + random.below(150);
  p.epochs = 3;
  return problem;
}

template <typename Work>
void for_each_stored_problem(std::uint64_t seed, const Work& work) {
  Random random(seed);
  for (int round = 0; round < 6; ++round) {
    for (const testing::Variant& variant : testing::all_variants()) {
      work(random_stored_problem(variant, random), random);
    }
  }
}

TEST(SomStoredElements, TrainToTheSameBitsAsAllElements) {
  for_each_stored_problem(71, [](const StoredProblem& problem, Random& /*random*/) {
    const Som some = train_som(problem.parameters, problem.samples).value();
    const Som all = train_som(problem.parameters, dense_rows(problem.samples)).value();
    // The greatest difference may be that of an element without a weight.
    const bool chebyshev = problem.parameters.similarity == Similarity::kChebyshev;
    EXPECT_EQ(some.elements().all(), chebyshev) << problem.name;
    if (!chebyshev) {
      EXPECT_LE(some.weights().columns(), 12U);
    }
    expect_same_weights(some, all, problem.name);
    expect_same_weights(untrained_som(problem.parameters, problem.samples).value(),
                        untrained_som(problem.parameters, dense_rows(problem.samples)).value(),
                        problem.name);
  });
}

// The products of dense samples are summed in the same order.
TEST(SomStoredElements, TrainByInnerProductsToTheSameBits) {
  for_each_stored_problem(72, [](StoredProblem problem, Random& /*random*/) {
    if (!follows_from_products(problem.parameters.similarity)) return;
    problem.parameters.training = Training::kOnline;
    problem.parameters.arithmetic = Arithmetic::kInnerProducts;
    const Som some = train_som(problem.parameters, problem.samples).value();
    EXPECT_FALSE(some.elements().all());
    expect_same_weights(some, train_som(problem.parameters, dense_rows(problem.samples)).value(),
                        problem.name);
  });
}

TEST(SomStoredElements, AreAllWhereWeightsStartUniform) {
  Random random(73);
  SomParameters p;
  p.initial_weights = InitialWeights::kUniform;
  p.iterations = 3;
  const Som som = train_som(p, narrow_samples(3, 60, 10, random)).value();
  EXPECT_TRUE(som.elements().all());
  EXPECT_GT(som.weights()(0, 0) + som.weights()(0, 1) + som.weights()(0, 2), 0.0F);
}

Som stored_everywhere(Som som) {
  som.store_all();
  return som;
}

// The law: one neuron has the input as weights and is the most similar to it; all others remain.
TEST(SomStoredElements, MoveOneNeuronToAnInput) {
  for_each_stored_problem(75, [](const StoredProblem& problem, Random& random) {
    const Som before = train_som(problem.parameters, problem.samples).value();
    const Samples inputs =
        testing::random_samples(1, before.input_size(), random.below(2) == 0, random);
    const std::size_t moved = random.below(before.neurons());
    const Som after = before.with_neuron_at(moved, inputs[0]);
    expect_same_weights(after, stored_everywhere(before).with_neuron_at(moved, inputs[0]),
                        problem.name);
    std::vector<float> input(before.input_size());
    write_dense(inputs[0], input);
    const bool is_unit = problem.parameters.similarity == Similarity::kDotProduct;
    if (is_unit || before.parameters().normalize_input.value()) normalize_length(input);
    for (std::size_t d = 0; d < before.input_size(); ++d) {
      ASSERT_NEAR(after.weight(moved, d), input[d], 1e-6) << problem.name;
      for (std::size_t neuron = 0; neuron < before.neurons(); ++neuron) {
        if (neuron == moved) continue;
        ASSERT_EQ(after.weight(neuron, d), before.weight(neuron, d)) << problem.name;
      }
    }
    SomWorkspace workspace;
    EXPECT_EQ(after.winner(inputs[0], workspace), moved) << problem.name;
  });
}

TEST(SomStoredElements, AnswerAsAllElements) {
  for_each_stored_problem(74, [](const StoredProblem& problem, Random& random) {
    const Som some = train_som(problem.parameters, problem.samples).value();
    const Som all = stored_everywhere(some);
    expect_same_weights(some, all, problem.name);
    // The inputs have all elements, so that some of them have no weights; sparse or not.
    const Samples inputs =
        testing::random_samples(6, some.input_size(), random.below(2) == 0, random);
    SomWorkspace workspace;
    std::vector<float> a(some.neurons());
    std::vector<float> b(some.neurons());
    for (std::size_t i = 0; i < inputs.count(); ++i) {
      some.similarities(inputs[i], workspace, a);
      all.similarities(inputs[i], workspace, b);
      const std::size_t winner = some.winner(inputs[i], workspace);
      for (std::size_t n = 0; n < a.size(); ++n) {
        EXPECT_NEAR(a[n], b[n], 1e-5) << problem.name;
        EXPECT_NEAR(some.distance(inputs[i], n, workspace), all.distance(inputs[i], n, workspace),
                    1e-9 * (1.0 + all.distance(inputs[i], n, workspace)))
            << problem.name;
        EXPECT_LE(b[n], b[winner] + 1e-5) << problem.name;
      }
      some.activity(inputs[i], workspace, a);
      all.activity(inputs[i], workspace, b);
      for (std::size_t n = 0; n < a.size(); ++n) EXPECT_NEAR(a[n], b[n], 1e-4) << problem.name;
    }
    EXPECT_EQ(u_matrix(some), u_matrix(all));
    for (std::size_t d = 0; d < some.input_size(); ++d) {
      EXPECT_EQ(component_plane(some, d), component_plane(all, d));
    }
  });
}

TEST(SomStoredElements, BecomeAllWhenAnInputNeedsOneMore) {
  for_each_stored_problem(75, [](const StoredProblem& problem, Random& random) {
    Som some = train_som(problem.parameters, problem.samples).value();
    Som all = stored_everywhere(some);
    const Samples inputs =
        testing::random_samples(3, some.input_size(), random.below(2) == 0, random);
    if (problem.parameters.training == Training::kBatch) {
      EXPECT_EQ(batch_epoch(some, inputs, 1.0, 1), batch_epoch(all, inputs, 1.0, 1));
    } else {
      EXPECT_EQ(SomLearner(some).learn(inputs[0], 0.5, 1.0),
                SomLearner(all).learn(inputs[0], 0.5, 1.0));
    }
    EXPECT_TRUE(some.elements().all());
    expect_same_weights(some, all, problem.name);
  });
}

TEST(SomStoredElements, NeedAColumnOfWeightsEach) {
  SomParameters p;
  p.rows = 1;
  p.columns = 2;
  EXPECT_NO_THROW(Som(p, LaneMatrix<float>(2, 2), StoredElements(9, {1, 5})));
  EXPECT_THROW(Som(p, LaneMatrix<float>(2, 3), StoredElements(9, {1, 5})), InvalidArgument);
  EXPECT_THROW(Som(p, LaneMatrix<float>(2, 2), StoredElements(9)), InvalidArgument);
}

// As with all elements this map would take a thousand times the memory there is.
TEST(SomStoredElements, MakeHugeInputsPossible) {
  constexpr std::size_t kSize = std::size_t{1} << 32;
  const auto samples = [](std::uint32_t place) {
    return Samples::from_signals({Signal::sparse({kSize}, {3, 4'000'000'000}, {1.0F, 2.0F}),
                                  Signal::sparse({kSize}, {place}, {1.0F})});
  };
  SomParameters p;
  p.rows = 1000;
  p.columns = 2;
  p.iterations = 5;
  const Som som = train_som(p, samples(3)).value();
  EXPECT_EQ(som.input_size(), kSize);
  EXPECT_EQ(som.elements(), StoredElements(kSize, {3, 4'000'000'000}));
}

}  // namespace
}  // namespace somato
