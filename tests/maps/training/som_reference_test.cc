#include "maps/training/som_reference.h"

#include <gtest/gtest.h>

#include <cmath>

// Every number here is worked out by hand; the steps stand in comments.

namespace somato {
namespace {

SomParameters two_neurons(Similarity similarity) {
  SomParameters p;
  p.rows = 1;
  p.columns = 2;
  p.similarity = similarity;
  return resolve(p, 1, 2).value();
}

void expect_row(const ReferenceSom& som, std::size_t neuron, double first, double second) {
  EXPECT_NEAR(som.weights()(neuron, 0), first, 1e-9);
  EXPECT_NEAR(som.weights()(neuron, 1), second, 1e-9);
}

TEST(ReferenceSom, LearnsOneEuclideanStepAsByHand) {
  ReferenceSom som(two_neurons(Similarity::kEuclidean), Matrix<double>(2, 2, {0, 0, 1, 0}));
  const std::vector<double> x{1, 1};
  // |x - w0|^2 = 2, |x - w1|^2 = 1: neuron 1 wins.
  EXPECT_EQ(som.winner(x), 1U);
  // Gains: 0.5 for the winner, 0.5 exp(-1/2) = 0.5 * 0.6065306597 for the other at distance 1.
  som.learn(x, 0.5, 1.0);
  expect_row(som, 1, 1.0, 0.5);
  expect_row(som, 0, 0.30326532985, 0.30326532985);
}

TEST(ReferenceSom, LearnsOneDotProductStepAsByHand) {
  ReferenceSom som(two_neurons(Similarity::kDotProduct), Matrix<double>(2, 2, {1, 0, 0, 1}));
  const std::vector<double> x{0.6, 0.8};
  EXPECT_EQ(som.winner(x), 1U);  // 0.6 against 0.8
  // w1 = (0, 1) + 0.5 (0.6, -0.2) = (0.3, 0.9), of length sqrt(0.9) = 0.9486832981.
  // w0 = (1, 0) + 0.5 * 0.6065306597 (-0.4, 0.8) = (0.8786938681, 0.2426122639), of squared
  // length 0.7721029138 + 0.0588607106 = 0.8309636244 and length 0.9115720621.
  som.learn(x, 0.5, 1.0);
  expect_row(som, 1, 0.3162277660, 0.9486832981);
  expect_row(som, 0, 0.8786938681 / 0.9115720621, 0.2426122639 / 0.9115720621);
}

TEST(ReferenceSom, LearnsOneBatchEpochAsByHand) {
  ReferenceSom som(two_neurons(Similarity::kEuclidean), Matrix<double>(2, 2, {0, 0, 4, 0}));
  // Winners: (1, 0) and (0, 2) go to neuron 0, (5, 1) to neuron 1. With h = exp(-1/2) between:
  // w0 = ((1,0) + (0,2) + h (5,1)) / (2 + h), w1 = (h (1,0) + h (0,2) + (5,1)) / (2 h + 1).
  const double h = 0.6065306597126334;
  som.learn_batch({{1, 0}, {0, 2}, {5, 1}}, 1.0);
  expect_row(som, 0, (1 + 5 * h) / (2 + h), (2 + h) / (2 + h));
  expect_row(som, 1, (h + 5) / (2 * h + 1), (2 * h + 1) / (2 * h + 1));
}

TEST(ReferenceSom, KeepsWeightsThatNoWinnerReaches) {
  SomParameters p = two_neurons(Similarity::kEuclidean);
  p.neighbourhood = NeighbourhoodShape::kBubble;
  ReferenceSom som(p, Matrix<double>(2, 2, {0, 0, 9, 9}));
  som.learn_batch({{1, 0}, {3, 0}}, 0.0);
  expect_row(som, 0, 2, 0);
  expect_row(som, 1, 9, 9);
}

TEST(ReferenceSom, HasTheActivityAsByHand) {
  SomParameters p = two_neurons(Similarity::kDotProduct);
  p.softmax_exponent = 2.0;
  const Matrix<double> weights(2, 2, {1, 0, 0, 1});
  // Similarities 0.6 and 0.8: squares 0.36 and 0.64.
  EXPECT_NEAR(ReferenceSom(p, weights).activity({{0.6, 0.8}})[0], 0.36 / 0.64, 1e-12);
  p.activity_norm = ActivityNorm::kSum;
  EXPECT_NEAR(ReferenceSom(p, weights).activity({{0.6, 0.8}})[0], 0.36, 1e-12);
  // A negative similarity counts as 0, though its square would be the greater one.
  EXPECT_EQ(ReferenceSom(p, weights).activity({{-0.9, 0.1}})[0], 0.0);
  // exp(2 * 0.6) / (exp(1.2) + exp(1.6)) = 1 / (1 + exp(0.4)) = 0.401312339888.
  p.softmax = Softmax::kExponential;
  EXPECT_NEAR(ReferenceSom(p, weights).activity({{0.6, 0.8}})[0], 0.401312339888, 1e-12);
}

TEST(ReferenceSom, HasTheEuclideanActivityAsByHand) {
  SomParameters p = two_neurons(Similarity::kEuclidean);
  p.softmax_exponent = 1.0;
  // Distances 3 and 1: similarities 1/4 and 1/2.
  const ReferenceSom som(p, Matrix<double>(2, 2, {3, 0, 1, 0}));
  EXPECT_NEAR(som.activity({{0, 0}})[0], 0.5, 1e-12);
  EXPECT_NEAR(som.activity({{0, 0}})[1], 1.0, 1e-12);
}

}  // namespace
}  // namespace somato
