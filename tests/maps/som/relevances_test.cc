#include "maps/som/relevances.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "maps/som/fill_from_winner.h"
#include "maps/som/som_archive.h"
#include "maps/support/random_maps.h"
#include "maps/support/saved_maps.h"
#include "somato/core/check.h"
#include "somato/maps/contributions.h"
#include "somato/maps/som_learner.h"
#include "somato/maps/som_quality.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

constexpr float kLeftOutValue = std::numeric_limits<float>::quiet_NaN();

struct WeightedProblem {
  Som som;
  Matrix<float> rows;
  std::vector<double> relevances;

  // By the definition, in the unit of the input. Missing elements are left out.
  double distance(std::size_t sample, std::size_t neuron) const {
    const bool is_manhattan = som.parameters().similarity == Similarity::kManhattan;
    double sum = 0.0;
    for (std::size_t d = 0; d < rows.columns(); ++d) {
      if (std::isnan(rows(sample, d))) continue;
      const double apart = std::fabs(double{rows(sample, d)} - double{som.weight(neuron, d)});
      sum += relevances[d] * (is_manhattan ? apart : apart * apart);
    }
    return is_manhattan ? sum : std::sqrt(sum);
  }

  std::size_t winner(std::size_t sample) const {
    std::size_t best = 0;
    for (std::size_t n = 1; n < som.neurons(); ++n) {
      if (distance(sample, n) < distance(sample, best)) best = n;
    }
    return best;
  }
};

WeightedProblem weighted_problem(Random& random, std::size_t samples = 20) {
  const std::size_t size = 1 + random.below(8);
  SomParameters p;
  p.rows = 1 + random.below(8);
  p.columns = 1 + random.below(8);
  p.similarity = random.below(2) == 0 ? Similarity::kEuclidean : Similarity::kManhattan;
  Matrix<float> weights(*p.rows * *p.columns, size);
  for (float& value : weights.values()) value = static_cast<float>(random.normal());
  WeightedProblem problem{
      Som(resolve(p, samples, size).value(), weights), Matrix<float>(samples, size), {}};
  for (float& value : problem.rows.values()) value = static_cast<float>(random.normal());
  for (std::size_t d = 0; d < size; ++d) {
    problem.relevances.push_back(random.below(4) == 0 ? 1e-6 : 4.0 * random.uniform() + 0.01);
  }
  return problem;
}

TEST(Relevances, WeighTheDistanceOfTheInput) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const WeightedProblem problem = weighted_problem(random);
    Som som = problem.som;
    som.set_relevances(problem.relevances);
    SomWorkspace workspace;
    const Samples samples(problem.rows);
    for (std::size_t s = 0; s < samples.count(); ++s) {
      EXPECT_EQ(som.winner(samples[s], workspace), problem.winner(s));
      for (std::size_t n = 0; n < som.neurons(); ++n) {
        EXPECT_NEAR(som.distance(samples[s], n, workspace), problem.distance(s, n), 1e-5);
      }
    }
  }
}

// Many samples are searched together, with screening or in runs, by any number of threads.
TEST(Relevances, ManySamplesHaveTheSameWinners) {
  Random random(2);
  for (int i = 0; i < 20; ++i) {
    const WeightedProblem problem = weighted_problem(random, 100);
    Som som = problem.som;
    som.set_relevances(problem.relevances);
    double sum = 0.0;
    for (std::size_t s = 0; s < 100; ++s) sum += problem.distance(s, problem.winner(s));
    for (const std::size_t threads : {1U, 3U}) {
      const SomQuality quality = measure_quality(som, Samples(problem.rows), threads);
      EXPECT_NEAR(quality.quantization_error, sum / 100.0, 1e-5);
    }
  }
}

TEST(Relevances, KeepWeightsInTheUnitOfTheInput) {
  Random random(3);
  const WeightedProblem problem = weighted_problem(random);
  Som som = problem.som;
  som.set_relevances(problem.relevances);
  som.set_relevances(std::vector<double>(problem.relevances.size(), 2.5));
  som.set_relevances(problem.relevances);
  for (std::size_t n = 0; n < som.neurons(); ++n) {
    for (std::size_t d = 0; d < problem.relevances.size(); ++d) {
      const double before = problem.som.weight(n, d);
      EXPECT_NEAR(som.weight(n, d), before, 1e-6 * std::fabs(before) + 1e-12);
    }
  }
}

TEST(Relevances, OfOneChangeNoBit) {
  Random random(4);
  const WeightedProblem problem = weighted_problem(random);
  Som som = problem.som;
  som.set_relevances(std::vector<double>(problem.relevances.size(), 1.0));
  EXPECT_EQ(som.weights(), problem.som.weights());
}

TEST(Relevances, SparseInputsAreLikeDenseOnes) {
  Random random(5);
  SomParameters p;
  p.rows = 3;
  p.columns = 3;
  const Samples sparse = testing::random_samples(30, 40, true, random);
  Som som = train_som(p, sparse).value();  // stores few elements
  som.set_relevances(std::vector<double>(40, 0.3));
  EXPECT_TRUE(som.elements().all());
  Matrix<float> rows(30, 40);
  for (std::size_t i = 0; i < 30; ++i) write_dense(sparse[i], rows.row(i));
  EXPECT_EQ(measure_quality(som, sparse).quantization_error,
            measure_quality(som, Samples(rows)).quantization_error);
}

TEST(Relevances, MissingElementsAreFilledInTheUnitOfTheInput) {
  Random random(6);
  for (int i = 0; i < 50; ++i) {
    WeightedProblem problem = weighted_problem(random);
    problem.rows(0, 0) = kLeftOutValue;
    Som som = problem.som;
    som.set_relevances(problem.relevances);
    const Samples filled = filled_from_winners(som, Samples(problem.rows));
    EXPECT_EQ(filled[0].values[0], som.weight(problem.winner(0), 0));
    EXPECT_EQ(filled[1].values[0], problem.rows(1, 0));
  }
}

TEST(Relevances, ContributionsSumToTheDifferenceOfTheDistances) {
  Random random(7);
  for (int i = 0; i < 50; ++i) {
    const WeightedProblem problem = weighted_problem(random);
    Som som = problem.som;
    som.set_relevances(problem.relevances);
    const std::size_t a = random.below(som.neurons());
    const std::size_t b = random.below(som.neurons());
    const Samples samples(problem.rows);
    const Contributions found = contributions(som, samples[0], {a, b});
    double sum = 0.0;
    for (const double one : found.values) sum += one;
    EXPECT_NEAR(sum, problem.distance(0, b) - problem.distance(0, a), 1e-5);
    EXPECT_NEAR(found.of_nearest, problem.distance(0, a), 1e-5);
  }
}

TEST(Relevances, AreSavedBitByBit) {
  Random random(8);
  const WeightedProblem problem = weighted_problem(random);
  Som som = problem.som;
  som.set_relevances(problem.relevances);
  Archive archive("test");
  add_som(archive, "map.", som);
  const Som again = som_from(archive, "map.", "here").value();
  EXPECT_EQ(again.parameters().relevances, problem.relevances);
  EXPECT_EQ(again.weights(), som.weights());
  EXPECT_EQ(again.weight(0, 0), som.weight(0, 0));
}

TEST(Relevances, DamagedOnesAreRefused) {
  SomParameters p;
  p.rows = 1;
  p.columns = 2;
  const Som som(resolve(p, 2, 2).value(), Matrix<float>(2, 2, {0, 1, 2, 3}));
  for (const std::vector<double>& wrong : {std::vector<double>{1.0},
                                           {1.0, 0.0},
                                           {1.0, -1.0},
                                           {1.0, double{kLeftOutValue}},
                                           {1.0, 1e13}}) {
    Archive archive("test");
    add_som(archive, "map.", som);
    archive.add("map.relevances", Array<double>{{wrong.size()}, wrong});
    const auto read = som_from(archive, "map.", "here");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().kind, ErrorKind::kData);
    Som changing = som;
    EXPECT_THROW(changing.set_relevances(wrong), InvalidArgument);
  }
}

TEST(Relevances, OtherDistancesAndFurtherLearningAreRefused) {
  SomParameters p;
  p.rows = 1;
  p.columns = 2;
  p.similarity = Similarity::kCosine;
  const Matrix<float> weights(2, 2, {0, 1, 2, 3});
  Som cosine(resolve(p, 2, 2).value(), weights);
  EXPECT_THROW(cosine.set_relevances({1.0, 1.0}), InvalidArgument);
  p.similarity = Similarity::kEuclidean;
  Som som(resolve(p, 2, 2).value(), weights);
  som.set_relevances({1.5, 0.5});
  EXPECT_THROW(SomLearner{som}, InvalidArgument);
  TrainingOptions options;
  options.start = &som;
  EXPECT_FALSE(train_som(p, weights, options));
}

}  // namespace
}  // namespace somato
