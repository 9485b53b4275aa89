// Learning one input after the other against the equations as they stand, in double precision.

#include "somato/maps/som_learner.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/support/instruction_sets.h"
#include "base/support/sanitized.h"
#include "maps/som/som_archive.h"
#include "maps/support/random_maps.h"
#include "maps/support/som_comparison.h"
#include "maps/training/som_reference.h"
#include "somato/core/check.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

// How much longer the two parts of a step, (1 - gain) w and gain x, are together than their sum:
// the factor by which the step amplifies rounding.
double cancellation(std::span<const double> w, std::span<const double> x, double gain) {
  std::vector<double> sum(w.size());
  for (std::size_t d = 0; d < w.size(); ++d) sum[d] = (1.0 - gain) * w[d] + gain * x[d];
  return ((1.0 - gain) * testing::length(w) + gain * testing::length(x)) /
         (testing::length(sum) + 1e-300);
}

// The input of a learner, and a map to begin with.
struct SampleStream {
  SomParameters parameters;
  Samples samples;
  Som som;
  std::vector<std::size_t> order;
  std::vector<LearningStep> steps;
  std::string name;

  std::size_t size() const { return order.size(); }
  SignalView input(std::size_t t) const { return samples[order[t]]; }
};

// Elements of sparse samples are 0 but for one in `emptiness`.
Samples thin_samples(std::size_t count, std::size_t size, std::size_t emptiness, Random& random) {
  std::vector<Signal> signals;
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<std::uint32_t> indices;
    std::vector<float> values;
    for (std::uint32_t d = 0; d < size; ++d) {
      if (random.below(emptiness) != 0) continue;
      indices.push_back(d);
      values.push_back(static_cast<float>(random.normal()));
    }
    signals.push_back(Signal::sparse({size}, indices, values));
  }
  return Samples::from_signals(signals);
}

LaneMatrix<float> random_weights(std::size_t neurons, std::size_t size, Random& random) {
  LaneMatrix<float> weights(neurons, size);
  for (std::size_t neuron = 0; neuron < neurons; ++neuron) {
    for (std::size_t d = 0; d < size; ++d) weights(neuron, d) = static_cast<float>(random.normal());
  }
  return weights;
}

SampleStream random_stream(const testing::Variant& variant, bool sparse, std::size_t length,
                           Random& random) {
  SampleStream stream;
  stream.name = testing::name_of(variant) + (sparse ? "_sparse" : "_dense");
  SomParameters p = testing::random_parameters(variant, random);
  if (random.below(3) == 0) p.normalize_input = random.below(2) == 0;
  const std::size_t size = sparse ? 300 + random.below(500) : 1 + random.below(600);
  const std::size_t count = 1 + random.below(12);
  stream.samples = sparse ? thin_samples(count, size, 50, random)
                          : testing::random_samples(count, size, random.below(4) == 0, random);
  stream.parameters = resolve(p, count, size).value();
  stream.som = Som(stream.parameters, random_weights(p.grid().size(), size, random));
  for (std::size_t t = 0; t < length; ++t) {
    stream.order.push_back(random.below(count));
    // Now and then nothing or all moves.
    const double rate =
        random.below(12) == 0 ? static_cast<double>(random.below(2)) : 0.5 * random.uniform();
    stream.steps.push_back({rate, 3.0 * random.uniform()});
  }
  return stream;
}

template <typename Work>
void for_each_stream(std::uint64_t seed, std::size_t rounds, std::size_t length, const Work& work) {
  Random random(seed);
  for (std::size_t round = 0; round < rounds; ++round) {
    for (const testing::Variant& variant : testing::variants_in_pairs()) {
      for (const bool sparse : {false, true}) {
        work(random_stream(variant, sparse, length, random), random);
      }
    }
  }
}

// The equations with the winners of the learner.
class Oracle {
 public:
  explicit Oracle(const SampleStream& stream)
      : stream_(stream),
        reference_(stream.parameters, testing::widened(stream.som)),
        inputs_(reference_.inputs(stream.samples)) {}

  void expect_best(std::size_t t, std::size_t winner) const {
    const auto& input = inputs_[stream_.order[t]];
    const double best = reference_.score(input, reference_.winner(input));
    double scale = testing::length(input);
    for (std::size_t n = 0; n < weights().rows(); ++n)
      scale = std::max(scale, testing::length(weights().row(n)));
    EXPECT_NEAR(reference_.score(input, winner), best, 2e-5 * scale * scale)
        << stream_.name << " " << t;
  }

  void learn(std::size_t t, std::size_t winner) {
    reference_.learn_at(winner, inputs_[stream_.order[t]], stream_.steps[t].learning_rate,
                        stream_.steps[t].radius);
  }

  void expect_weights(const Som& som, double tolerance, const std::string& what) const {
    const Matrix<double> learned = testing::widened(som);
    for (std::size_t n = 0; n < weights().rows(); ++n) {
      const auto row = weights().row(n);
      std::vector<double> difference(row.begin(), row.end());
      for (std::size_t d = 0; d < difference.size(); ++d) difference[d] -= learned(n, d);
      ASSERT_LE(testing::length(difference), tolerance * (testing::length(row) + 1e-15))
          << stream_.name << " " << what << " neuron " << n;
    }
  }

 private:
  const Matrix<double>& weights() const { return reference_.weights(); }

  const SampleStream& stream_;
  ReferenceSom reference_;
  std::vector<std::vector<double>> inputs_;
};

TEST(SomLearner, OneStepIsTheReferencesOnTenThousandProblems) {
  Random random(51);
  int compared = 0;
  for (int i = 0; i < testing::fewer_if_sanitized(10000); ++i) {
    const std::size_t size = 1 + random.below(20);
    const Samples samples = testing::random_samples(40, size, random.below(2) == 0, random);
    SomParameters p = testing::random_resolved(random, 40, size);
    p.iterations = 0;
    Som som = train_som(p, samples).value();
    const ReferenceSom before(p, testing::widened(som));
    const std::vector<double> input = before.inputs(samples)[0];
    const std::size_t winner = before.winner(input);
    if (som.neurons() > 1 && testing::ambiguous(before, input, som.neurons())) continue;
    const double radius = 3.0 * random.uniform();
    const double rate = random.uniform();
    EXPECT_EQ(SomLearner(som).learn(samples[0], rate, radius), winner);
    ReferenceSom after = before;
    after.learn(input, rate, radius);
    for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
      const double gain = rate * before.neighbourhood(winner, neuron, radius);
      const auto w = before.weights().row(neuron);
      // A gain below single precision moves nothing but a weight vector of zeros.
      if (gain < 0x1p-100 && testing::length(w) == 0.0) continue;
      if (cancellation(w, input, gain) < 10.0) testing::expect_row(som, after, neuron, 1e-5);
    }
    ++compared;
  }
  EXPECT_GT(compared, testing::fewer_if_sanitized(8000));
}

// Law: an update never makes a weight less similar to its sample, unless the neighbourhood is
// negative.
TEST(SomLearner, NeverMovesAWeightAwayFromItsSample) {
  Random random(55);
  for (int i = 0; i < 3000; ++i) {
    const std::size_t size = 1 + random.below(20);
    const Samples samples = testing::random_samples(2, size, false, random);
    SomParameters p = testing::random_resolved(random, 2, size);
    p.iterations = 0;
    Som som = train_som(p, samples).value();
    const ReferenceSom before(p, testing::widened(som));
    SomLearner(som).learn(samples[0], random.uniform(), 3.0 * random.uniform());
    const ReferenceSom after(p, testing::widened(som));
    const std::vector<double> input = before.inputs(samples)[0];
    for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
      const double was = before.score(input, neuron);
      const double is = after.score(input, neuron);
      if (p.similarity != Similarity::kDotProduct) {
        EXPECT_LE(is, was + 1e-6 * (1.0 + was));
      } else {
        EXPECT_GE(is, was - 1e-6);
      }
    }
  }
}

// A gain below single precision moves nothing but a weight vector of zeros, hence no zeros here.
TEST(SomLearner, FollowsTheEquations) {
  for_each_stream(81, 3, 60, [](SampleStream stream, Random& random) {
    Oracle oracle(stream);
    Som som = stream.som;
    SomLearner learner(som);
    for (std::size_t t = 0; t < stream.size(); ++t) {
      const std::size_t winner =
          learner.learn(stream.input(t), stream.steps[t].learning_rate, stream.steps[t].radius);
      oracle.expect_best(t, winner);
      oracle.learn(t, winner);
      if (random.below(20) != 0) continue;
      learner.settle();
      oracle.expect_weights(som, 5e-5, std::to_string(t));
    }
    learner.settle();
    oracle.expect_weights(som, 5e-5, "end");
  });
}

void learn_all(SomLearner& learner, const SampleStream& stream, std::size_t end) {
  for (std::size_t t = 0; t < end; ++t) {
    learner.learn(stream.input(t), stream.steps[t].learning_rate, stream.steps[t].radius);
  }
}

// Though updates are pending, it is the very neuron that the map finds once they are made.
TEST(SomLearner, FindsTheMapsWinner) {
  for_each_stream(82, 2, 40, [](const SampleStream& stream, Random& /*random*/) {
    if (stream.name.ends_with("_sparse")) return;
    for (std::size_t t = 0; t < stream.size(); ++t) {
      Som pending = stream.som;
      SomLearner learner(pending);
      learn_all(learner, stream, t);
      Som settled = stream.som;
      {
        SomLearner other(settled);
        learn_all(other, stream, t);
      }
      SomWorkspace workspace;
      EXPECT_EQ(learner.learn(stream.input(t), 0.1, 1.0),
                settled.winner(stream.input(t), workspace))
          << stream.name << " " << t;
    }
  });
}

// Neurons that begin alike, and stay alike within a bubble.
TEST(SomLearner, FindsTheFirstOfEquals) {
  Random random(83);
  for (const Similarity similarity : testing::all_similarities()) {
    SomParameters p;
    p.rows = 7;
    p.columns = 9;
    p.similarity = similarity;
    p.neighbourhood = NeighbourhoodShape::kBubble;
    const Samples samples = testing::random_samples(9, 300, false, random);
    p = resolve(p, 9, 300).value();
    const Matrix<float> row(1, 300, std::vector<float>(300, 0.25F));
    LaneMatrix<float> weights(63, 300);
    for (std::size_t neuron = 0; neuron < 63; ++neuron) weights.set_row(neuron, row.row(0));
    Som plain(p, weights);
    Som som = plain;
    SomLearner learner(som);
    SomWorkspace workspace;
    for (std::size_t t = 0; t < 100; ++t) {
      const SignalView input = samples[t % 9];
      const std::size_t winner = plain.winner(input, workspace);
      EXPECT_EQ(learner.learn(input, 0.1, 2.0), winner) << t;
      // The same updates, settled each time: other roundings, so the map is taken over.
      learner.settle();
      plain = som;
    }
  }
}

TEST(SomLearner, OneByOneGivesTheBitsOfTraining) {
  Random random(84);
  for (const testing::Variant& variant : testing::all_variants()) {
    for (const bool sparse : {false, true}) {
      SomParameters p = testing::random_parameters(variant, random);
      p.arithmetic = Arithmetic::kPlain;
      p.initial_weights = InitialWeights::kUniform;
      p.iterations = 1 + random.below(150);
      const Samples samples = sparse ? thin_samples(7, 500, 40, random)
                                     : testing::random_samples(7, 300, false, random);
      Som som = untrained_som(p, samples).value();
      const SomParameters& r = som.parameters();
      DrawSequence draws(r.draws, samples.count(), r.seed);
      {
        SomLearner learner(som);
        for (std::uint64_t t = 0; t < *r.iterations; ++t) {
          learner.learn(samples[draws.next()], r.learning_rate().at(t), r.radius().at(t));
        }
      }
      EXPECT_EQ(som.weights(), train_som(p, samples).value().weights())
          << testing::name_of(variant) << " " << sparse;
    }
  }
}

// Large enough for several threads to be used.
SampleStream large_stream(const testing::Variant& variant, bool sparse, Random& random) {
  SampleStream stream = random_stream(variant, sparse, 45, random);
  const std::size_t size = sparse ? 3000 : 1000;
  stream.samples =
      sparse ? thin_samples(5, size, 50, random) : testing::random_samples(5, size, false, random);
  for (std::size_t& number : stream.order) number %= 5;
  stream.parameters.rows = 8;
  stream.parameters.columns = 9;
  stream.som = Som(stream.parameters, random_weights(72, size, random));
  return stream;
}

std::vector<SignalView> inputs_of(const SampleStream& stream) {
  std::vector<SignalView> inputs;
  inputs.reserve(stream.size());
  for (std::size_t t = 0; t < stream.size(); ++t) inputs.push_back(stream.input(t));
  return inputs;
}

LaneMatrix<float> learned_ahead(const SampleStream& stream, std::size_t threads) {
  Som som = stream.som;
  SomLearner(som, threads).learn(inputs_of(stream), stream.steps);
  return som.weights();
}

LaneMatrix<float> learned_one_by_one(const SampleStream& stream, std::size_t threads) {
  Som som = stream.som;
  {
    SomLearner learner(som, threads);
    learn_all(learner, stream, stream.size());
  }
  return som.weights();
}

// With the winners found on the way.
std::pair<LaneMatrix<float>, std::vector<std::size_t>> learned_and_settled(
    const SampleStream& stream, std::size_t threads) {
  Som som = stream.som;
  SomLearner learner(som, threads);
  std::vector<std::size_t> winners;
  winners.reserve(stream.size());
  for (std::size_t t = 0; t < stream.size(); ++t) {
    winners.push_back(
        learner.learn(stream.input(t), stream.steps[t].learning_rate, stream.steps[t].radius));
    // Sparse inputs are learned by themselves only as long as that is seldom; others now after each
    // input, now after some.
    if (stream.input(t).sparse ? t == 20 : t < 5 || t % 7 == 0) learner.settle();
  }
  learner.settle();
  return {som.weights(), winners};
}

// A look shows what settling would, and what is learned afterwards has the bits as without it.
TEST(SomLearner, IsNotChangedByLooks) {
  Random random(91);
  for (const testing::Variant& variant : testing::variants_in_pairs()) {
    for (const bool sparse : {false, true}) {
      SampleStream stream = random_stream(variant, sparse, 60, random);
      const LaneMatrix<float> expected = learned_one_by_one(stream, 1);
      Som som = stream.som;
      SomLearner learner(som);
      for (std::size_t t = 0; t < stream.size(); ++t) {
        learner.learn(stream.input(t), stream.steps[t].learning_rate, stream.steps[t].radius);
        if (t % 7 != 0) continue;
        const Som seen = learner.look();
        Som settled = stream.som;
        {
          SomLearner again(settled);
          learn_all(again, stream, t + 1);
        }
        ASSERT_EQ(seen.weights(), settled.weights()) << stream.name << " " << t;
        ASSERT_EQ(seen.elements(), settled.elements());
      }
      learner.settle();
      EXPECT_EQ(som.weights(), expected) << stream.name;
    }
  }
}

// Over the streams, every instruction set meets every number of threads in each way of learning.
TEST(SomLearnerThreads, GiveTheSameBitsWithEveryInstructionSet) {
  Random random(85);
  constexpr std::size_t kThreads[] = {1, 2, 4};
  std::size_t turn = 0;
  for (const testing::Variant& variant : testing::all_variants()) {
    if (variant.lattice != Lattice::kRectangular || variant.topology != Topology::kPlane) continue;
    if (variant.similarity != Similarity::kEuclidean &&
        variant.neighbourhood != NeighbourhoodShape::kGaussian)
      continue;
    for (const bool sparse : {false, true}) {
      const SampleStream stream = large_stream(variant, sparse, random);
      const auto expected = learned_one_by_one(stream, 1);
      const auto settled = learned_and_settled(stream, 1);
      std::size_t threads_of_set = turn++ / 2;  // the same for dense and sparse inputs
      testing::for_each_instruction_set([&](InstructionSet set) {
        const std::size_t threads = kThreads[threads_of_set++ % 3];
        const std::string what = fmt::format("{} {} {}", stream.name, name_of(set), threads);
        EXPECT_EQ(learned_ahead(stream, threads), expected) << what;
        EXPECT_EQ(learned_one_by_one(stream, threads), expected) << what;
        EXPECT_EQ(learned_and_settled(stream, threads), settled) << what;
      });
    }
  }
}

// Rounding errors of single steps must not add up, and decayed weights must neither slow it down
// nor be lost.
TEST(SomLearner, StaysAccurateForLong) {
  Random random(86);
  constexpr auto kLong = static_cast<std::size_t>(testing::fewer_if_sanitized(20000));
  for (const bool sparse : {false, true}) {
    for (const Similarity similarity : testing::all_similarities()) {
      SampleStream stream = random_stream(
          {Lattice::kRectangular, Topology::kPlane, similarity, NeighbourhoodShape::kGaussian},
          sparse, kLong, random);
      const std::size_t size = sparse ? 200 : 40;
      stream.samples = sparse ? thin_samples(6, size, 50, random)
                              : testing::random_samples(6, size, false, random);
      stream.parameters.rows = 2;
      stream.parameters.columns = 3;
      stream.som = Som(stream.parameters, random_weights(6, size, random));
      for (std::size_t t = 0; t < stream.size(); ++t) {
        stream.order[t] = random.below(6);
        constexpr double kRates[] = {1e-30, 1e-9, 1e-3, 0.1, 0.9};
        stream.steps[t] = {kRates[random.below(5)], random.uniform()};
      }
      Oracle oracle(stream);
      Som som = stream.som;
      SomLearner learner(som);
      for (std::size_t t = 0; t < stream.size(); ++t) {
        const std::size_t winner =
            learner.learn(stream.input(t), stream.steps[t].learning_rate, stream.steps[t].radius);
        if (t % 50 == 0) oracle.expect_best(t, winner);
        oracle.learn(t, winner);
      }
      learner.settle();
      oracle.expect_weights(som, 1e-4, "end");
    }
  }
}

TEST(SomLearner, TakesZeroInputsZeroWeightsAndALearningRateOfOne) {
  for (const Similarity similarity : testing::all_similarities()) {
    for (const bool sparse : {false, true}) {
      SomParameters p;
      p.rows = 2;
      p.columns = 1;
      p.similarity = similarity;
      p = resolve(p, 1, 100).value();
      Som som(p, LaneMatrix<float>(2, 100));
      const Signal zero =
          sparse ? Signal::sparse({100}, {}, {}) : Signal::dense(std::vector<float>(100));
      std::vector<float> values(100);
      values[7] = 2.0F;
      const Signal one = sparse ? Signal::sparse({100}, {7}, {2.0F}) : Signal::dense(values);
      SomLearner learner(som);
      EXPECT_EQ(learner.learn(zero.view(), 1.0, 0.0), 0U);
      EXPECT_EQ(learner.learn(one.view(), 1.0, 0.0), 0U);
      learner.settle();
      const bool dot = similarity == Similarity::kDotProduct;
      EXPECT_EQ(som.weight(0, 7), dot ? 1.0F : 2.0F);
      EXPECT_EQ(som.weight(1, 7), 0.0F);
      EXPECT_EQ(learner.learn(one.view(), 1.0, 0.0), 0U);
      // The other one is nearer to zeros; to maps that compare directions zeros are all alike.
      const bool alike = dot || similarity == Similarity::kCosine;
      EXPECT_EQ(learner.learn(zero.view(), 1.0, 0.0), alike ? 0U : 1U);
      for (int i = 0; i < 200; ++i) learner.learn(zero.view(), 0.5, 10.0);
      learner.settle();
      // Lengths of a dot-product map stay; others have decayed to nothing.
      EXPECT_EQ(som.weight(0, 7), dot ? som.weight(0, 7) : 0.0F);
    }
  }
}

// Only what the inputs bring gets weights, as long as that is little and the map is seldom read.
TEST(SomLearner, GivesWeightsToTheElementsOfSparseInputs) {
  SomParameters p;
  p.rows = 2;
  p.columns = 2;
  p = resolve(p, 2, 1000).value();
  Som som(p, LaneMatrix<float>(4, 1), StoredElements(1000, {500}));
  SomLearner learner(som);
  const auto learn_often = [&](const Signal& input) {
    for (int i = 0; i < 10; ++i) learner.learn(input.view(), 0.5, 0.0);
    learner.settle();
  };
  const float learned = 1.0F - 0x1p-10F;  // by ten halvings of what is left
  learn_often(Signal::sparse({1000}, {3, 999}, {1.0F, 2.0F}));
  EXPECT_EQ(som.elements(), StoredElements(1000, {3, 500, 999}));
  EXPECT_EQ(som.weight(0, 3), learned);
  learn_often(Signal::sparse({1000}, {3, 4}, {1.0F, -2.0F}));
  EXPECT_EQ(som.elements(), StoredElements(1000, {3, 4, 500, 999}));
  EXPECT_EQ(som.weight(1, 4), -2.0F * learned);
  learn_often(Signal::dense(std::vector<float>(1000, -1.0F)));
  EXPECT_TRUE(som.elements().all());
  EXPECT_EQ(som.weight(2, 998), -learned);
  EXPECT_EQ(som.weight(0, 3), learned);
}

TEST(SomLearner, SettlesWhenItGoes) {
  Random random(87);
  const SampleStream stream = random_stream(testing::all_variants().front(), false, 5, random);
  Som som = stream.som;
  Som settled = stream.som;
  {
    SomLearner learner(som);
    learn_all(learner, stream, 5);
  }
  SomLearner learner(settled);
  learn_all(learner, stream, 5);
  EXPECT_NE(settled.weights(), som.weights());
  learner.settle();
  EXPECT_EQ(settled.weights(), som.weights());
}

TEST(SomLearner, ContinuesWithAMapThatWasSaved) {
  for_each_stream(88, 1, 30, [](const SampleStream& stream, Random& /*random*/) {
    Som som = stream.som;
    {
      SomLearner learner(som);
      learn_all(learner, stream, 30);
    }
    Archive archive("test");
    add_som(archive, "map", som);
    Som loaded = som_from(archive, "map", "here").value();
    for (Som* map : {&som, &loaded}) {
      SomLearner learner(*map);
      learn_all(learner, stream, 20);
    }
    EXPECT_EQ(loaded.weights(), som.weights()) << stream.name;
  });
}

TEST(SomLearner, RefusesInputsOfAnotherSize) {
  Som som = train_som({}, Samples(Matrix<float>(3, 5))).value();
  SomLearner learner(som);
  const Signal short_one = Signal::dense({1.0F, 2.0F});
  EXPECT_THROW(learner.learn(short_one.view(), 0.1, 1.0), InvalidArgument);
  const std::vector<SignalView> inputs{short_one.view()};
  EXPECT_THROW(learner.learn(inputs, {}), InvalidArgument);
  const std::vector<LearningStep> steps{{0.1, 1.0}};
  EXPECT_THROW(learner.learn(inputs, steps), InvalidArgument);
}

}  // namespace
}  // namespace somato
