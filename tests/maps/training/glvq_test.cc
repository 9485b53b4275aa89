#include "maps/training/glvq.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "maps/support/random_maps.h"
#include "somato/maps/som.h"
#include "somato/maps/som_parameters.h"

namespace somato {
namespace {

constexpr GlvqStep kStrongStep{0.25, 4.0};

Som som_of_rows(std::size_t rows, std::size_t columns, Similarity similarity,
                const Matrix<float>& weights) {
  SomParameters parameters;
  parameters.rows = rows;
  parameters.columns = columns;
  parameters.similarity = similarity;
  return Som(resolve(parameters, 2, weights.columns()).value(), weights);
}

Matrix<float> random_rows(std::size_t rows, std::size_t columns, Random& random) {
  Matrix<float> matrix(rows, columns);
  for (float& value : matrix.values()) value = static_cast<float>(random.normal());
  return matrix;
}

std::vector<double> distances_of(const Som& som, const Matrix<float>& sample) {
  const Samples samples(sample);
  SomWorkspace workspace;
  std::vector<double> distances;
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    distances.push_back(som.distance(samples[0], neuron, workspace));
  }
  return distances;
}

TEST(Glvq, AStepMovesTheRightNeuronNearerAndTheWrongOneFarther) {
  Random random(91);
  for (int i = 0; i < 200; ++i) {
    const Similarity similarity = i % 2 == 0 ? Similarity::kEuclidean : Similarity::kManhattan;
    const std::size_t neurons = 2 + random.below(20);
    const std::size_t size = 1 + random.below(9);
    Som som = som_of_rows(1, neurons, similarity, random_rows(neurons, size, random));
    std::vector<std::size_t> classes{0, 1};
    while (classes.size() < neurons) classes.push_back(random.below(2));
    const Matrix<float> sample = random_rows(1, size, random);
    const std::vector<double> before = distances_of(som, sample);
    Glvq(som, classes, 0.0).learn(sample.row(0), 1, kStrongStep);
    const std::vector<double> after = distances_of(som, sample);
    std::vector<std::size_t> nearest(2, neurons);  // of the other class, and of its own
    for (std::size_t neuron = 0; neuron < neurons; ++neuron) {
      std::size_t& best = nearest[classes[neuron]];
      if (best == neurons || before[neuron] < before[best]) best = neuron;
    }
    for (std::size_t neuron = 0; neuron < neurons; ++neuron) {
      if (neuron == nearest[1]) {
        EXPECT_LT(after[neuron], before[neuron]);
      } else if (neuron == nearest[0]) {
        EXPECT_GT(after[neuron], before[neuron]);
      } else {
        EXPECT_EQ(after[neuron], before[neuron]);
      }
    }
  }
}

// d+ = 1 and d- = 9 (squared), so mu = -0.8; with steepness s, the relative slope is 4 f (1 - f).
TEST(Glvq, AStepByHand) {
  Som som = som_of_rows(1, 2, Similarity::kEuclidean, Matrix<float>(2, 1, {1.0F, -3.0F}));
  const std::vector<float> sample{0.0F};
  Glvq(som, {0, 1}, 0.0).learn(sample, 0, {0.25, 5.0});
  const double sigmoid = 1.0 / (1.0 + std::exp(5.0 * 0.8));
  const double rate = 2.0 * 0.25 * 4.0 * sigmoid * (1.0 - sigmoid);
  EXPECT_NEAR(som.weight(0, 0), 1.0 - rate * 0.9, 1e-6);
  EXPECT_NEAR(som.weight(1, 0), -3.0 - rate * 0.1 * 3.0, 1e-6);
}

// The same with |x - w|: d+ = 1, d- = 3, mu = -0.5.
TEST(Glvq, AStepByHandOfAManhattanMap) {
  Som som = som_of_rows(1, 2, Similarity::kManhattan, Matrix<float>(2, 1, {1.0F, -3.0F}));
  const std::vector<float> sample{0.0F};
  Glvq(som, {0, 1}, 0.0).learn(sample, 0, {0.25, 5.0});
  const double sigmoid = 1.0 / (1.0 + std::exp(5.0 * 0.5));
  const double rate = 2.0 * 0.25 * 4.0 * sigmoid * (1.0 - sigmoid);
  EXPECT_NEAR(som.weight(0, 0), 1.0 - rate * 0.75, 1e-6);
  EXPECT_NEAR(som.weight(1, 0), -3.0 - rate * 0.25 * 3.0, 1e-6);
}

// Neurons of a row with the classes 0 0 1 1: the nearest one is neuron 1, and 0 follows.
TEST(Glvq, AdjacentNeuronsOfTheClassFollow) {
  Som single = som_of_rows(1, 4, Similarity::kEuclidean, Matrix<float>(4, 1, {5, 1, 3, 7}));
  Som together = single;
  const std::vector<float> sample{0.0F};
  Glvq(single, {0, 0, 1, 1}, 0.0).learn(sample, 0, kStrongStep);
  Glvq(together, {0, 0, 1, 1}, 0.5).learn(sample, 0, kStrongStep);
  EXPECT_EQ(single.weight(0, 0), 5.0F);
  const double gain = 1.0 - double{single.weight(1, 0)};
  EXPECT_NEAR(together.weight(0, 0), 5.0 * (1.0 - 0.5 * gain), 1e-5);
  for (std::size_t neuron = 1; neuron < 4; ++neuron) {
    EXPECT_EQ(together.weight(neuron, 0), single.weight(neuron, 0));
  }
}

// Two neurons, relevances and a sample, for which the cost f(mu) of GLVQ is known from distances.
struct CostProblem {
  Som som;
  std::vector<double> relevances;
  Matrix<float> sample;

  double mu() const {
    Som weighted = som;
    weighted.set_relevances(relevances);
    std::vector<double> distances = distances_of(weighted, sample);
    if (som.parameters().similarity == Similarity::kEuclidean) {
      for (double& one : distances) one *= one;
    }
    return (distances[0] - distances[1]) / (distances[0] + distances[1]);
  }

  double cost(double steepness) const { return 1.0 / (1.0 + std::exp(-steepness * mu())); }
};

CostProblem cost_problem(Similarity similarity, Random& random) {
  const std::size_t size = 1 + random.below(6);
  CostProblem problem{som_of_rows(1, 2, similarity, random_rows(2, size, random)),
                      {},
                      random_rows(1, size, random)};
  for (std::size_t d = 0; d < size; ++d) problem.relevances.push_back(0.2 + 3.0 * random.uniform());
  return problem;
}

// Steps of the logarithms of relevances are those of the cost's derivative by them, times the
// number of elements and 4 / steepness; the normalization adds the same number to all.
TEST(Glvq, RelevancesFollowTheDerivativeOfTheCost) {
  Random random(97);
  for (int i = 0; i < 200; ++i) {
    const Similarity similarity = i % 2 == 0 ? Similarity::kEuclidean : Similarity::kManhattan;
    const CostProblem problem = cost_problem(similarity, random);
    constexpr double kSteepness = 3.0;
    constexpr double kRate = 0.05;
    Som som = problem.som;
    som.set_relevances(problem.relevances);
    std::vector<float> seen(problem.sample.row(0).begin(), problem.sample.row(0).end());
    for (std::size_t d = 0; d < seen.size(); ++d) seen[d] *= som.input_scales()[d];
    Glvq glvq(som, {0, 1}, 0.0);
    glvq.learn(seen, 0, {0.0, kSteepness, kRate});
    glvq.update_relevances();
    std::vector<double> rest;  // of the steps
    double sum = 0.0;
    for (std::size_t d = 0; d < seen.size(); ++d) {
      constexpr double kStep = 1e-3;
      CostProblem more = problem;
      CostProblem less = problem;
      more.relevances[d] *= std::exp(kStep);
      less.relevances[d] *= std::exp(-kStep);
      const double derivative = (more.cost(kSteepness) - less.cost(kSteepness)) / (2.0 * kStep);
      const double expected =
          -kRate * static_cast<double>(seen.size()) * 4.0 / kSteepness * derivative;
      const double found = std::log(som.parameters().relevances[d] / problem.relevances[d]);
      rest.push_back(found - expected);
      sum += som.parameters().relevances[d];
    }
    for (const double one : rest) EXPECT_NEAR(one, rest[0], 2e-4) << i;
    EXPECT_NEAR(sum, static_cast<double>(seen.size()), 1e-9);
  }
}

// Weights of a Euclidean map move along the cost's derivative, divided by the relevance of the
// element, and those of a Manhattan map in its sense.
TEST(Glvq, WeightsFollowTheDerivativeOfTheCostWithRelevances) {
  Random random(98);
  for (int i = 0; i < 200; ++i) {
    const Similarity similarity = i % 2 == 0 ? Similarity::kEuclidean : Similarity::kManhattan;
    const CostProblem problem = cost_problem(similarity, random);
    constexpr double kSteepness = 3.0;
    Som som = problem.som;
    som.set_relevances(problem.relevances);
    std::vector<double> distances = distances_of(som, problem.sample);
    std::vector<float> seen(problem.sample.row(0).begin(), problem.sample.row(0).end());
    for (std::size_t d = 0; d < seen.size(); ++d) seen[d] *= som.input_scales()[d];
    Glvq(som, {0, 1}, 0.0).learn(seen, 0, {0.1, kSteepness});
    const double sum = distances[0] * distances[0] + distances[1] * distances[1];
    for (std::size_t neuron = 0; neuron < 2; ++neuron) {
      for (std::size_t d = 0; d < seen.size(); ++d) {
        constexpr float kStep = 2e-3F;
        const double apart =
            std::fabs(double{problem.sample(0, d)} - double{problem.som.weight(neuron, d)});
        if (similarity == Similarity::kManhattan && apart < 0.01) continue;
        Matrix<float> weights = problem.som.weights().to_matrix();
        weights(neuron, d) += kStep;
        const CostProblem more{Som(problem.som.parameters(), weights), problem.relevances,
                               problem.sample};
        weights(neuron, d) -= 2.0F * kStep;
        const CostProblem less{Som(problem.som.parameters(), weights), problem.relevances,
                               problem.sample};
        const double derivative =
            (more.cost(kSteepness) - less.cost(kSteepness)) / (2.0 * double{kStep});
        const double moved = double{som.weight(neuron, d)} - double{problem.som.weight(neuron, d)};
        if (similarity == Similarity::kManhattan) {
          EXPECT_LE(moved * derivative, 1e-9) << i;
        } else {
          EXPECT_NEAR(moved, -2.0 * 0.1 * sum / kSteepness * derivative / problem.relevances[d],
                      2e-4 * (1.0 + std::fabs(moved)))
              << i;
        }
      }
    }
  }
}

TEST(Glvq, WithoutANeuronOfBothSidesNothingMoves) {
  const Som before = som_of_rows(1, 2, Similarity::kEuclidean, Matrix<float>(2, 1, {1, 2}));
  Som som = before;
  const std::vector<float> sample{0.0F};
  Glvq only(som, {0, 0}, 0.5);
  only.learn(sample, 0, kStrongStep);  // no other class
  only.learn(sample, 1, kStrongStep);  // no neuron of the class
  only.learn(sample, 7, kStrongStep);
  Glvq(som, {0, 1}, 0.5).learn(std::vector<float>{1.0F}, 0, {0.0, 1.0});  // no rate
  EXPECT_EQ(som.weights(), before.weights());
}

TEST(Glvq, NeuronsWhereTheSampleIsStay) {
  Som som = som_of_rows(1, 2, Similarity::kManhattan, Matrix<float>(2, 1, {1, 1}));
  Glvq(som, {0, 1}, 0.5).learn(std::vector<float>{1.0F}, 0, kStrongStep);
  EXPECT_EQ(som.weight(0, 0), 1.0F);
  EXPECT_EQ(som.weight(1, 0), 1.0F);
}

// Neuron 0 wins two samples of class 1 and one of class 0; neuron 2 wins the sample at 9; neuron 1
// wins none, and the nearest sample is that at 2.
TEST(Glvq, ANeuronWithoutSamplesHasTheClassOfTheNearest) {
  const Som som = som_of_rows(1, 3, Similarity::kEuclidean, Matrix<float>(3, 1, {1, 5, 8}));
  const Samples samples(Matrix<float>(4, 1, {0, 1, 2, 9}));
  const NeuronClasses found = classes_of_neurons(som, samples, {1, 0, 1, 4});
  EXPECT_EQ(found.of_neuron, (std::vector<std::size_t>{1, 1, 4}));
  EXPECT_EQ(found.named_by_nearest, 1U);
}

}  // namespace
}  // namespace somato
