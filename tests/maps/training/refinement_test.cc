#include "somato/maps/refinement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "base/support/instruction_sets.h"
#include "maps/reading/sample_reader.h"
#include "maps/support/random_maps.h"
#include "somato/core/check.h"
#include "somato/maps/labels.h"
#include "somato/maps/som_quality.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

using SampleClasses = std::vector<std::optional<std::size_t>>;
constexpr float kNotKnown = std::numeric_limits<float>::quiet_NaN();

RefinementParameters glvq_parameters() {
  RefinementParameters parameters;
  parameters.refine = Refinement::kGlvq;
  parameters.refine_passes = 4;
  return parameters;
}

// The method in plain loops, for dense samples, in double precision except for the weights.
class SlowGlvq {
 public:
  SlowGlvq(const Som& som, const Matrix<float>& samples, SampleClasses classes)
      : grid_(som.grid()),
        manhattan_(som.parameters().similarity == Similarity::kManhattan),
        weights_(som.weights().to_matrix()),
        samples_(samples),
        classes_(std::move(classes)),
        relevances_(samples.columns(), 1.0),
        changes_(samples.columns()) {
    name_neurons();
  }

  void run(const RefinementParameters& p, std::uint64_t seed) {
    std::vector<std::size_t> labelled;
    for (std::size_t i = 0; i < classes_.size(); ++i) {
      if (classes_[i]) labelled.push_back(i);
    }
    const auto total = static_cast<double>(p.refine_passes * labelled.size());
    DrawSequence draws(Draws::kWithoutReplacement, labelled.size(), seed);
    for (double done = 0; done < total; ++done) {
      const double part = done / total;
      relevance_rate_ =
          p.refine == Refinement::kGrlvq ? p.refine_relevance_rate * (1.0 - part) : 0.0;
      const double steepness =
          p.refine_steepness_start + part * (p.refine_steepness_end - p.refine_steepness_start);
      learn(labelled[draws.next()], p.refine_learning_rate * (1.0 - part), steepness,
            p.refine_neighbours);
      if (std::fmod(done + 1.0, 64.0) == 0.0 || done + 1.0 == total) change_relevances();
    }
  }

  const std::vector<double>& relevances() const { return relevances_; }

  const Matrix<float>& weights() const { return weights_; }

 private:
  double distance(std::size_t sample, std::size_t neuron) const {
    double sum = 0.0;
    for (std::size_t d = 0; d < samples_.columns(); ++d) {
      if (std::isnan(samples_(sample, d))) continue;
      const double apart = double{samples_(sample, d)} - double{weights_(neuron, d)};
      sum += relevances_[d] * (manhattan_ ? std::fabs(apart) : apart * apart);
    }
    return sum;
  }

  // By the logarithms of the relevances: those of the relative distance difference.
  void add_changes(std::size_t sample, std::size_t right, std::size_t wrong, double slope) {
    const double near = distance(sample, right);
    const double far = distance(sample, wrong);
    const auto size = static_cast<double>(relevances_.size());
    for (std::size_t d = 0; d < relevances_.size(); ++d) {
      if (std::isnan(samples_(sample, d))) continue;
      const double of_right = std::fabs(double{samples_(sample, d)} - double{weights_(right, d)});
      const double of_wrong = std::fabs(double{samples_(sample, d)} - double{weights_(wrong, d)});
      const double power = manhattan_ ? 1.0 : 2.0;
      const double derivative =
          2.0 * relevances_[d] *
          (far * std::pow(of_right, power) - near * std::pow(of_wrong, power)) /
          ((near + far) * (near + far));
      changes_[d] -= relevance_rate_ * slope * size * derivative;
    }
  }

  void change_relevances() {
    double sum = 0.0;
    for (std::size_t d = 0; d < relevances_.size(); ++d) {
      relevances_[d] *= std::exp(std::min(1.0, std::max(-1.0, changes_[d])));
      changes_[d] = 0.0;
      sum += relevances_[d];
    }
    for (double& one : relevances_) {
      one = std::max(1e-6, one * static_cast<double>(relevances_.size()) / sum);
    }
  }

  void name_neurons() {
    std::vector<std::map<std::size_t, int>> votes(weights_.rows());
    for (std::size_t i = 0; i < classes_.size(); ++i) {
      if (!classes_[i]) continue;
      std::size_t winner = 0;
      for (std::size_t n = 1; n < weights_.rows(); ++n) {
        if (distance(i, n) < distance(i, winner)) winner = n;
      }
      ++votes[winner][*classes_[i]];
    }
    for (std::size_t n = 0; n < weights_.rows(); ++n) named_.push_back(name_of(votes[n], n));
  }

  std::size_t name_of(const std::map<std::size_t, int>& votes, std::size_t neuron) const {
    std::optional<std::size_t> best;
    for (const auto& [one, count] : votes) {
      if (!best || count > votes.at(*best)) best = one;
    }
    if (best) return *best;
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < classes_.size(); ++i) {
      if (!classes_[i]) continue;
      if (!nearest || distance(i, neuron) < distance(*nearest, neuron)) nearest = i;
    }
    return *classes_[*nearest];
  }

  void learn(std::size_t sample, double rate, double steepness, double neighbours) {
    std::optional<std::size_t> right;
    std::optional<std::size_t> wrong;
    for (std::size_t n = 0; n < weights_.rows(); ++n) {
      auto& best = named_[n] == *classes_[sample] ? right : wrong;
      if (!best || distance(sample, n) < distance(sample, *best)) best = n;
    }
    if (!right || !wrong) return;
    const double near = distance(sample, *right);
    const double far = distance(sample, *wrong);
    if (near + far == 0.0) return;
    const double sigmoid = 1.0 / (1.0 + std::exp(-steepness * (near - far) / (near + far)));
    const double slope = 4.0 * sigmoid * (1.0 - sigmoid);
    if (relevance_rate_ > 0.0) add_changes(sample, *right, *wrong, slope);
    const double gain = 2.0 * rate * slope * far / (near + far);
    move(sample, *right, gain);
    move(sample, *wrong, -2.0 * rate * slope * near / (near + far));
    for (std::size_t n = 0; n < weights_.rows(); ++n) {
      const bool follows = named_[n] == *classes_[sample] && grid_.adjacent(n, *right);
      if (follows) move(sample, n, neighbours * gain);
    }
  }

  void move(std::size_t sample, std::size_t neuron, double gain) {
    for (std::size_t d = 0; d < samples_.columns(); ++d) {
      if (std::isnan(samples_(sample, d))) continue;
      float& weight = weights_(neuron, d);
      weight = static_cast<float>(double{weight} +
                                  gain * (double{samples_(sample, d)} - double{weight}));
    }
  }

  Grid grid_;
  bool manhattan_;
  Matrix<float> weights_;
  const Matrix<float>& samples_;
  SampleClasses classes_;
  std::vector<double> relevances_;
  std::vector<double> changes_;
  double relevance_rate_ = 0.0;
  std::vector<std::size_t> named_;
};

struct RefinementProblem {
  Som som;
  Matrix<float> samples;
  SampleClasses classes;
};

// Some samples have no class, and there are often more neurons than samples.
RefinementProblem refinement_problem(Random& random, bool incomplete) {
  SomParameters p;
  p.lattice = random.below(2) == 0 ? Lattice::kRectangular : Lattice::kHexagonal;
  p.topology = random.below(2) == 0 ? Topology::kPlane : Topology::kTorus;
  p.similarity = random.below(2) == 0 ? Similarity::kEuclidean : Similarity::kManhattan;
  p.rows = 2 * (1 + random.below(2));
  p.columns = 1 + random.below(6);
  p.iterations = 50;
  p.seed = random.next();
  const std::size_t count = 4 + random.below(20);
  const std::size_t size = 1 + random.below(8);
  Matrix<float> samples(count, size);
  for (float& value : samples.values()) value = static_cast<float>(random.normal());
  RefinementProblem problem{train_som(p, samples).value(), std::move(samples), {0, 1}};
  while (problem.classes.size() < count) {
    problem.classes.push_back(random.below(4) == 0 ? std::nullopt
                                                   : std::optional<std::size_t>(random.below(4)));
  }
  if (!incomplete) return problem;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t d = 0; d < size; ++d) {
      if (d != i % size && random.below(4) == 0) problem.samples(i, d) = kNotKnown;
    }
  }
  return problem;
}

// Two classes that alternate along a line, and a map with a neuron for each group.
RefinementProblem alternating_problem() {
  RefinementProblem problem;
  Random random(5);
  problem.samples = Matrix<float>(200, 2);
  for (std::size_t i = 0; i < 200; ++i) {
    const std::size_t group = i % 4;
    problem.samples(i, 0) = static_cast<float>(static_cast<double>(group) + 0.3 * random.normal());
    problem.samples(i, 1) = static_cast<float>(3.0 * random.normal());
    problem.classes.emplace_back(group % 2);
  }
  SomParameters p;
  p.rows = 4;
  p.columns = 4;
  problem.som = train_som(p, problem.samples).value();
  return problem;
}

double share_right(const Som& som, const RefinementProblem& problem) {
  const Samples samples(problem.samples);
  std::vector<std::size_t> classes;
  for (const auto& one : problem.classes) classes.push_back(*one);
  const auto winners = first_winners(SampleReader(som).read(samples));
  const auto labels = NeuronLabels::by_majority(winners, classes, som.neurons());
  const auto named = labels.classify(som, samples);
  std::size_t right = 0;
  for (std::size_t i = 0; i < named.size(); ++i) right += named[i] == classes[i] ? 1 : 0;
  return static_cast<double>(right) / static_cast<double>(named.size());
}

TEST(Refinement, IsThePlainLoops) {
  Random random(92);
  for (int i = 0; i < 200; ++i) {
    const RefinementProblem problem = refinement_problem(random, i % 2 == 1);
    RefinementParameters parameters = glvq_parameters();
    parameters.refine_learning_rate = 0.5 * random.uniform();
    parameters.refine_neighbours = random.uniform();
    if (i % 4 >= 2) parameters.refine = Refinement::kGrlvq;
    parameters.refine_relevance_rate = 0.2 * random.uniform();
    const std::uint64_t seed = random.next();
    SlowGlvq slow(problem.som, problem.samples, problem.classes);
    slow.run(parameters, seed);
    const auto refined = refine_som(problem.som, Samples(problem.samples), problem.classes,
                                    parameters, {seed, 1, {}});
    ASSERT_TRUE(refined) << to_string(refined.error());
    for (std::size_t n = 0; n < problem.som.neurons(); ++n) {
      for (std::size_t d = 0; d < problem.samples.columns(); ++d) {
        ASSERT_NEAR(refined->som.weight(n, d), slow.weights()(n, d), 1e-4) << i;
      }
    }
    const std::vector<double>& relevances = refined->som.parameters().relevances;
    ASSERT_EQ(relevances.empty(), parameters.refine == Refinement::kGlvq);
    for (std::size_t d = 0; d < relevances.size(); ++d) {
      ASSERT_NEAR(relevances[d], slow.relevances()[d], 1e-4) << i;
    }
  }
}

TEST(Refinement, HasTheSameBitsForAllThreadsAndInstructionSets) {
  const RefinementProblem problem = alternating_problem();
  const Samples samples(problem.samples);
  const auto refined =
      refine_som(problem.som, samples, problem.classes, glvq_parameters(), {7, 1, {}});
  testing::for_each_instruction_set([&](InstructionSet) {
    const auto again =
        refine_som(problem.som, samples, problem.classes, glvq_parameters(), {7, 3, {}});
    EXPECT_EQ(again->som.weights(), refined->som.weights());
    EXPECT_EQ(again->order.after.trustworthiness, refined->order.after.trustworthiness);
  });
  const auto other =
      refine_som(problem.som, samples, problem.classes, glvq_parameters(), {8, 1, {}});
  EXPECT_NE(other->som.weights(), refined->som.weights());
}

RefinementParameters grlvq_parameters() {
  RefinementParameters parameters = glvq_parameters();
  parameters.refine = Refinement::kGrlvq;
  return parameters;
}

TEST(Refinement, RelevancesHaveTheSameBitsForAllThreadsAndInstructionSets) {
  const RefinementProblem problem = alternating_problem();
  const Samples samples(problem.samples);
  const auto refined =
      refine_som(problem.som, samples, problem.classes, grlvq_parameters(), {7, 1, {}});
  testing::for_each_instruction_set([&](InstructionSet) {
    const auto again =
        refine_som(problem.som, samples, problem.classes, grlvq_parameters(), {7, 3, {}});
    EXPECT_EQ(again->som.weights(), refined->som.weights());
    EXPECT_EQ(again->som.parameters().relevances, refined->som.parameters().relevances);
  });
}

TEST(Refinement, WithoutARateRelevancesAreAllOneAndTheMapThatOfGlvq) {
  Random random(96);
  for (int i = 0; i < 40; ++i) {
    const RefinementProblem problem = refinement_problem(random, i % 2 == 1);
    const Samples samples(problem.samples);
    RefinementParameters parameters = grlvq_parameters();
    parameters.refine_relevance_rate = 0.0;
    const auto with = refine_som(problem.som, samples, problem.classes, parameters);
    const auto without = refine_som(problem.som, samples, problem.classes, glvq_parameters());
    ASSERT_TRUE(with && without);
    EXPECT_EQ(with->som.weights(), without->som.weights());
    EXPECT_EQ(with->som.parameters().relevances,
              std::vector<double>(problem.samples.columns(), 1.0));
    EXPECT_EQ(with->order.after.quantization_error, without->order.after.quantization_error);
    EXPECT_EQ(with->order.after.topographic_error, without->order.after.topographic_error);
  }
}

// The first of two columns has the classes; the second is wider and has none; the third is
// constant.
TEST(Refinement, AColumnThatSeparatesClassesBecomesRelevant) {
  for (const Similarity similarity : {Similarity::kEuclidean, Similarity::kManhattan}) {
    const RefinementProblem problem = alternating_problem();
    Matrix<float> rows(problem.samples.rows(), 3);
    for (std::size_t i = 0; i < rows.rows(); ++i) {
      rows(i, 0) = problem.samples(i, 0);
      rows(i, 1) = problem.samples(i, 1);
      rows(i, 2) = 5.0F;
    }
    SomParameters p;
    p.rows = 4;
    p.columns = 4;
    p.similarity = similarity;
    const Som som = train_som(p, rows).value();
    const auto refined = refine_som(som, Samples(rows), problem.classes, grlvq_parameters());
    ASSERT_TRUE(refined);
    const std::vector<double>& relevances = refined->som.parameters().relevances;
    EXPECT_GT(relevances[0], 1.2 * relevances[1]);
    EXPECT_NEAR(relevances[0] + relevances[1] + relevances[2], 3.0, 1e-9);
  }
}

Matrix<float> with_column(const Matrix<float>& rows, float value) {
  Matrix<float> wider(rows.rows(), rows.columns() + 1);
  for (std::size_t i = 0; i < rows.rows(); ++i) {
    std::ranges::copy(rows.row(i), wider.row(i).begin());
    wider(i, rows.columns()) = value;
  }
  return wider;
}

TEST(Refinement, AConstantColumnChangesNothing) {
  Random random(99);
  for (int i = 0; i < 20; ++i) {
    const RefinementProblem problem = refinement_problem(random, i % 2 == 1);
    const Matrix<float> weights = problem.som.weights().to_matrix();
    const Som wider(problem.som.parameters(), with_column(weights, 7.3F));
    const auto expected =
        refine_som(problem.som, Samples(problem.samples), problem.classes, grlvq_parameters());
    const auto refined = refine_som(wider, Samples(with_column(problem.samples, 7.3F)),
                                    problem.classes, grlvq_parameters());
    ASSERT_TRUE(expected && refined);
    std::vector<double> relevances = expected->som.parameters().relevances;
    relevances.push_back(1.0);
    EXPECT_EQ(refined->som.parameters().relevances, relevances) << i;
    EXPECT_EQ(refined->som.weights().to_matrix(),
              with_column(expected->som.weights().to_matrix(), 7.3F))
        << i;
  }
}

TEST(Refinement, SamplesThatDoNotDifferLeaveRelevancesAtOne) {
  SomParameters p;
  p.rows = 2;
  p.columns = 2;
  const Matrix<float> rows(4, 3, std::vector<float>(12, 2.0F));
  const auto refined =
      refine_som(train_som(p, rows).value(), Samples(rows), {0, 1, 0, 1}, grlvq_parameters());
  ASSERT_TRUE(refined);
  EXPECT_EQ(refined->som.parameters().relevances, std::vector<double>(3, 1.0));
}

TEST(Refinement, RelevancesStandMoreClassesThanNeuronsAndOneSampleOfEach) {
  SomParameters p;
  p.rows = 1;
  p.columns = 2;
  const Matrix<float> rows(4, 2, {0, 0, 1, 0, 0, 1, 1, 1});
  const auto refined =
      refine_som(train_som(p, rows).value(), Samples(rows), {0, 1, 2, 3}, grlvq_parameters());
  ASSERT_TRUE(refined);
  EXPECT_GE(refined->order.classes_without_neuron, 2U);
  for (const double one : refined->som.parameters().relevances) EXPECT_GT(one, 0.0);
}

// One column decides everything; a step is limited, and no relevance becomes 0.
TEST(Refinement, AStepOfARelevanceIsLimited) {
  SomParameters p;
  p.rows = 1;
  p.columns = 2;
  Matrix<float> rows(40, 30);
  SampleClasses classes;
  Random random(98);
  for (std::size_t i = 0; i < 40; ++i) {
    rows(i, 0) = static_cast<float>(i % 2);
    for (std::size_t d = 1; d < 30; ++d) rows(i, d) = static_cast<float>(20.0 * random.normal());
    classes.emplace_back(i % 2);
  }
  RefinementParameters parameters = grlvq_parameters();
  parameters.refine_relevance_rate = 1.0;
  parameters.refine_passes = 100;
  const auto refined = refine_som(train_som(p, rows).value(), Samples(rows), classes, parameters);
  ASSERT_TRUE(refined);
  for (const double one : refined->som.parameters().relevances) {
    EXPECT_GE(one, 1e-6);
    EXPECT_LE(one, 30.0);
  }
}

TEST(Refinement, AMapWithRelevancesIsNotRefinedAgain) {
  const RefinementProblem problem = alternating_problem();
  const Samples samples(problem.samples);
  const auto refined = refine_som(problem.som, samples, problem.classes, grlvq_parameters());
  const auto again = refine_som(refined->som, samples, problem.classes, glvq_parameters());
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().kind, ErrorKind::kUsage);
  EXPECT_NE(again.error().what.find("relevances"), std::string::npos);
  EXPECT_FALSE(train_som(refined->som.parameters(), samples));
}

TEST(Refinement, RecognizesMoreSamplesAndMeasuresTheOrder) {
  const RefinementProblem problem = alternating_problem();
  RefinementParameters parameters;
  parameters.refine = Refinement::kGlvq;
  const auto refined =
      refine_som(problem.som, Samples(problem.samples), problem.classes, parameters);
  ASSERT_TRUE(refined);
  EXPECT_GT(share_right(refined->som, problem), share_right(problem.som, problem) + 0.1);
  const SomQuality before = measure_quality(problem.som, Samples(problem.samples));
  const SomQuality after = measure_quality(refined->som, Samples(problem.samples));
  EXPECT_EQ(refined->order.before.topographic_error, before.topographic_error);
  EXPECT_EQ(refined->order.after.topographic_error, after.topographic_error);
  EXPECT_DOUBLE_EQ(refined->order.after.quantization_error, after.quantization_error);
  EXPECT_GT(refined->order.after.trustworthiness, 0.5);
  EXPECT_GT(refined->order.after.continuity, 0.5);
}

// A power of 2 leaves all digits as they are.
TEST(Refinement, DoesNotDependOnTheUnit) {
  Random random(93);
  for (int i = 0; i < 20; ++i) {
    const RefinementProblem problem = refinement_problem(random, false);
    Matrix<float> samples = problem.samples;
    Matrix<float> weights = problem.som.weights().to_matrix();
    for (float& value : samples.values()) value *= 1024.0F;
    for (float& value : weights.values()) value *= 1024.0F;
    const auto refined =
        refine_som(problem.som, Samples(problem.samples), problem.classes, glvq_parameters());
    const auto scaled = refine_som(Som(problem.som.parameters(), weights), Samples(samples),
                                   problem.classes, glvq_parameters());
    Matrix<float> expected = refined->som.weights().to_matrix();
    for (float& value : expected.values()) value *= 1024.0F;
    EXPECT_EQ(scaled->som.weights().to_matrix(), expected);
  }
}

TEST(Refinement, SamplesWithoutAClassHaveNoEffect) {
  Random random(94);
  for (int i = 0; i < 20; ++i) {
    const RefinementProblem problem = refinement_problem(random, i % 2 == 0);
    std::vector<std::size_t> labelled;
    SampleClasses classes;
    for (std::size_t j = 0; j < problem.classes.size(); ++j) {
      if (!problem.classes[j]) continue;
      labelled.push_back(j);
      classes.push_back(problem.classes[j]);
    }
    const Samples samples(problem.samples);
    const auto all = refine_som(problem.som, samples, problem.classes, glvq_parameters());
    const auto some = refine_som(problem.som, samples.subset(labelled), classes, glvq_parameters());
    EXPECT_EQ(all->som.weights(), some->som.weights());
  }
}

TEST(Refinement, SparseSamplesAreLikeDenseOnes) {
  Random random(95);
  const Samples sparse = testing::random_samples(30, 40, true, random);
  Matrix<float> rows(30, 40);
  SampleClasses classes;
  for (std::size_t i = 0; i < 30; ++i) {
    write_dense(sparse[i], rows.row(i));
    classes.emplace_back(i % 3);
  }
  SomParameters p;
  p.rows = 3;
  p.columns = 3;
  p.normalize_input = true;
  const Som som = train_som(p, Samples(rows)).value();
  const auto of_sparse = refine_som(som, sparse, classes, glvq_parameters());
  const auto of_dense = refine_som(som, Samples(rows), classes, glvq_parameters());
  ASSERT_TRUE(of_sparse && of_dense);
  EXPECT_EQ(of_sparse->som.weights(), of_dense->som.weights());
}

// A map that stores two of five elements gets weights for a third one that samples use.
TEST(Refinement, AMapOfFewElementsLearnsOthers) {
  SomParameters p;
  p.rows = 1;
  p.columns = 2;
  const Som narrow(resolve(p, 2, 5).value(), LaneMatrix<float>(Matrix<float>(2, 2, {1, 0, 0, 1})),
                   StoredElements(5, {0, 1}));
  const Samples samples(Matrix<float>(2, 5, {1, 0, 0, 2, 0, 0, 1, 0, 0, 0}));
  const auto refined = refine_som(narrow, samples, {0, 1}, glvq_parameters());
  ASSERT_TRUE(refined);
  EXPECT_GT(refined->som.weight(0, 3), 0.0F);
}

// Sparse samples of four million elements: weights for all of them need four terabytes.
TEST(Refinement, RefusesMapsThatNeedMoreMemoryThanThereIs) {
  constexpr std::size_t kSide = 512;
  constexpr std::size_t kSize = 4'000'000;
  SomParameters p;
  p.rows = kSide;
  p.columns = kSide;
  const Som narrow(resolve(p, 2, kSize).value(), LaneMatrix<float>(kSide * kSide, 1),
                   StoredElements(kSize, {0}));
  const std::vector<Signal> signals{Signal::sparse({kSize}, {0}, {1}),
                                    Signal::sparse({kSize}, {7}, {1})};
  const auto refined =
      refine_som(narrow, Samples::from_signals(signals), {0, 1}, glvq_parameters());
  ASSERT_FALSE(refined);
  EXPECT_EQ(refined.error().kind, ErrorKind::kSystem);
  EXPECT_NE(refined.error().what.find("of memory"), std::string::npos) << refined.error().what;
}

TEST(Refinement, OneNeuronStays) {
  SomParameters p;
  p.rows = 1;
  p.columns = 1;
  const Matrix<float> rows(3, 1, {0, 1, 5});
  const Som som = train_som(p, rows).value();
  const auto refined = refine_som(som, Samples(rows), {0, 1, 1}, glvq_parameters());
  ASSERT_TRUE(refined);
  EXPECT_EQ(refined->som.weights(), som.weights());
  // The neuron has class 1, which no other neuron is compared with; class 0 has none.
  EXPECT_EQ(refined->order.classes_without_neuron, 1U);
  EXPECT_EQ(refined->order.named_by_nearest, 0U);
  EXPECT_TRUE(std::isnan(refined->order.after.trustworthiness));
}

TEST(Refinement, NoneIsTheMapItself) {
  const RefinementProblem problem = alternating_problem();
  const auto same = refine_som(problem.som, Samples(problem.samples), problem.classes, {});
  ASSERT_TRUE(same);
  EXPECT_EQ(same->som.weights(), problem.som.weights());
  EXPECT_EQ(same->order.before.topographic_error, same->order.after.topographic_error);
}

TEST(Refinement, RefusesFewerThanTwoClasses) {
  const RefinementProblem problem = alternating_problem();
  const Samples samples(problem.samples);
  for (const auto& one : {std::optional<std::size_t>(3), std::optional<std::size_t>()}) {
    const auto refined =
        refine_som(problem.som, samples, SampleClasses(200, one), glvq_parameters());
    ASSERT_FALSE(refined);
    EXPECT_EQ(refined.error().kind, ErrorKind::kData);
    EXPECT_NE(refined.error().what.find("at least two classes"), std::string::npos);
  }
}

TEST(Refinement, RefusesMapsOfOtherDistances) {
  SomParameters p;
  for (const auto& [similarity, name] : Choices<Similarity>::all()) {
    p.similarity = similarity;
    const bool takes = similarity == Similarity::kEuclidean || similarity == Similarity::kManhattan;
    const auto checked = check_refinement(glvq_parameters(), p);
    EXPECT_EQ(checked.has_value(), takes) << name;
    if (!takes) {
      EXPECT_NE(checked.error().what.find(name), std::string::npos);
    }
    EXPECT_TRUE(check_refinement({}, p));
  }
  p.similarity = Similarity::kEuclidean;
  p.layers = {{"a", 0, 1}, {"b", 1, 1}};
  EXPECT_EQ(check_refinement(glvq_parameters(), p).error().kind, ErrorKind::kUsage);
}

TEST(Refinement, RefusesMissingElementsOfInputsOfLengthOne) {
  RefinementProblem problem = alternating_problem();
  problem.samples(0, 0) = kNotKnown;
  SomParameters p = problem.som.parameters();
  p.normalize_input = true;
  const Som som(p, problem.som.weights());
  const auto refined =
      refine_som(som, Samples(problem.samples), problem.classes, glvq_parameters());
  ASSERT_FALSE(refined);
  EXPECT_EQ(refined.error().kind, ErrorKind::kUsage);
}

TEST(Refinement, RefusesWhatCannotBe) {
  const RefinementProblem problem = alternating_problem();
  const Samples samples(problem.samples);
  EXPECT_THROW(refine_som(problem.som, samples, {0, 1}, glvq_parameters()), InvalidArgument);
  EXPECT_THROW(
      refine_som(problem.som, Samples(Matrix<float>(200, 3)), problem.classes, glvq_parameters()),
      InvalidArgument);
  RefinementParameters parameters = glvq_parameters();
  parameters.refine_learning_rate = 0.6;
  EXPECT_THROW(refine_som(problem.som, samples, problem.classes, parameters), InvalidArgument);
  Matrix<float> huge = problem.samples;
  huge(0, 0) = 1e30F;
  EXPECT_EQ(refine_som(problem.som, Samples(huge), problem.classes, glvq_parameters()).error().kind,
            ErrorKind::kData);
}

TEST(Refinement, CanBeStopped) {
  const RefinementProblem problem = alternating_problem();
  std::uint64_t last = 0;
  std::uint64_t total = 0;
  const auto stopped =
      refine_som(problem.som, Samples(problem.samples), problem.classes, glvq_parameters(),
                 {1, 1, [&](std::uint64_t done, std::uint64_t all) {
                    last = done;
                    total = all;
                    return done < 300;
                  }});
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::kInterrupted);
  EXPECT_EQ(total, 800U);
  EXPECT_GE(last, 300U);
  EXPECT_LT(last, 400U);
}

TEST(Refinement, ParametersOfNoRefinementHaveNoEffect) {
  const RefinementParameters none;
  EXPECT_EQ(reason_without_effect(none, "refine_passes"), "refine is none");
  EXPECT_EQ(reason_without_effect(none, "refine"), "");
  EXPECT_EQ(reason_without_effect(none, "rows"), "");
  EXPECT_EQ(reason_without_effect(glvq_parameters(), "refine_passes"), "");
  EXPECT_EQ(reason_without_effect(glvq_parameters(), "refine_relevance_rate"), "refine is glvq");
  EXPECT_EQ(reason_without_effect(grlvq_parameters(), "refine_relevance_rate"), "");
}

}  // namespace
}  // namespace somato
