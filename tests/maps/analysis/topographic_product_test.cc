#include "maps/analysis/topographic_product.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "maps/support/random_maps.h"
#include "somato/core/random.h"

namespace somato {
namespace {

// The distance of two neurons' weights by the similarity of the map.
double weight_gap(const Som& som, std::size_t a, std::size_t b) {
  double squares = 0.0;
  double sum = 0.0;
  double most = 0.0;
  double product = 0.0;
  double of_a = 0.0;
  double of_b = 0.0;
  for (std::size_t d = 0; d < som.input_size(); ++d) {
    const double left = som.weight(a, d);
    const double right = som.weight(b, d);
    squares += (left - right) * (left - right);
    sum += std::fabs(left - right);
    most = std::max(most, std::fabs(left - right));
    product += left * right;
    of_a += left * left;
    of_b += right * right;
  }
  switch (som.parameters().similarity) {
    case Similarity::kManhattan:
      return sum;
    case Similarity::kChebyshev:
      return most;
    case Similarity::kCosine:
      return 1.0 - product / std::sqrt(of_a * of_b);
    default:
      return std::sqrt(squares);
  }
}

std::vector<std::size_t> nearest_by(const std::vector<double>& gaps, std::size_t own) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (i != own) order.emplace_back(gaps[i], i);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> numbers;
  for (const auto& [gap, number] : order) numbers.push_back(number);
  return numbers;
}

// Equations 11 to 15 of Bauer and Pawelzik (1992), with products and roots.
double product_by_definition(const Som& som) {
  const std::size_t n = som.neurons();
  double sum = 0.0;
  for (std::size_t j = 0; j < n; ++j) {
    std::vector<double> in;
    std::vector<double> on;
    for (std::size_t other = 0; other < n; ++other) {
      in.push_back(weight_gap(som, j, other));
      on.push_back(std::round(som.grid().squared_distance(j, other)));
    }
    const auto near_in = nearest_by(in, j);
    const auto near_on = nearest_by(on, j);
    for (std::size_t k = 1; k < n; ++k) {
      double product = 1.0;
      for (std::size_t l = 0; l < k; ++l) {
        product *= in[near_on[l]] / in[near_in[l]];
        product *= std::sqrt(on[near_on[l]]) / std::sqrt(on[near_in[l]]);
      }
      sum += std::log(std::pow(product, 1.0 / (2.0 * static_cast<double>(k))));
    }
  }
  return sum / static_cast<double>(n * (n - 1));
}

TEST(TopographicProduct, IsAsDefinedForAllKindsOfMaps) {
  Random random(11);
  for (const testing::Variant& variant : testing::all_variants()) {
    SomParameters p = testing::random_parameters(variant, random);
    p.rows = 4;
    p.columns = 3;
    Matrix<float> weights(12, 3);
    for (float& value : weights.values()) value = static_cast<float>(random.normal());
    const Som som(resolve(p, 10, 3).value(), weights);
    EXPECT_NEAR(topographic_product(som, 2), product_by_definition(som), 1e-10)
        << testing::name_of(variant);
    EXPECT_EQ(topographic_product(som, 1), topographic_product(som, 3));
  }
}

Som line_with(std::vector<float> weights) {
  SomParameters p;
  p.rows = 1;
  p.columns = weights.size();
  return Som(resolve(p, 1, 1).value(), Matrix<float>(*p.columns, 1, std::move(weights)));
}

TEST(TopographicProduct, OfALineOnALineIsZero) {
  EXPECT_NEAR(topographic_product(line_with({0, 1, 2, 3, 4}), 1), 0.0, 1e-15);
}

// A folded line has too few dimensions.
TEST(TopographicProduct, OfAFoldedLineIsNegative) {
  SomParameters p;
  p.rows = 1;
  p.columns = 6;
  const Matrix<float> weights(6, 2, {0, 0, 1, 0, 2, 0, 2, 0.5F, 1, 0.5F, 0, 0.5F});
  EXPECT_LT(topographic_product(Som(resolve(p, 1, 2).value(), weights), 1), -0.01);
}

TEST(TopographicProduct, IsNotDefinedForEqualWeightsOneNeuronAndSeparateParts) {
  EXPECT_TRUE(std::isnan(topographic_product(line_with({0, 1, 1}), 1)));
  EXPECT_TRUE(std::isnan(topographic_product(line_with({0}), 1)));
  SomParameters p;
  p.rows = 1;
  p.columns = 3;
  const auto graph = std::make_shared<const NeuronGraph>(3, std::vector<NeuronGraph::Edge>{{0, 1}});
  const Som som(resolve(p, 1, 1).value(), Matrix<float>(3, 1, {0, 1, 3}), graph);
  EXPECT_TRUE(std::isnan(topographic_product(som, 1)));
}

}  // namespace
}  // namespace somato
