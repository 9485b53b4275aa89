#include "maps/analysis/rank_measures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "maps/support/random_maps.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

Som line_of(std::size_t neurons) {
  SomParameters p;
  p.rows = 1;
  p.columns = neurons;
  return Som(resolve(p, 1, 1).value(), Matrix<float>(neurons, 1));
}

Samples samples_at(std::vector<float> values) {
  const std::size_t count = values.size();
  return Samples(Matrix<float>(count, 1, std::move(values)));
}

using Order = std::vector<std::size_t>;

// The rank of every sample but i, from 1, with ties in the order of `priority`.
Order ranks_around(std::size_t i, const std::vector<double>& place, const Order& priority) {
  Order others;
  for (std::size_t j = 0; j < place.size(); ++j) {
    if (j != i) others.push_back(j);
  }
  std::sort(others.begin(), others.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(std::abs(place[a] - place[i]), priority[a]) <
           std::tuple(std::abs(place[b] - place[i]), priority[b]);
  });
  Order ranks(place.size());
  for (std::size_t r = 0; r < others.size(); ++r) ranks[others[r]] = r + 1;
  return ranks;
}

// The definitions of the papers, for one order of ties in each space.
RankMeasures ranks_by_definition(const std::vector<double>& input, const std::vector<double>& map,
                                 std::size_t k, const Order& of_input, const Order& of_map) {
  const std::size_t n = input.size();
  double trust = 0.0;
  double continuity = 0.0;
  double kept = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const Order in = ranks_around(i, input, of_input);
    const Order on = ranks_around(i, map, of_map);
    for (std::size_t j = 0; j < n; ++j) {
      if (j == i) continue;
      if (on[j] <= k && in[j] > k) trust += static_cast<double>(in[j] - k);
      if (in[j] <= k && on[j] > k) continuity += static_cast<double>(on[j] - k);
      if (in[j] <= k && on[j] <= k) kept += 1.0;
    }
  }
  const auto count = static_cast<double>(n);
  const auto near = static_cast<double>(k);
  const double scale = 2.0 / (count * near * (2.0 * count - 3.0 * near - 1.0));
  return {1.0 - scale * trust, 1.0 - scale * continuity, kept / (count * near)};
}

// The mean over all orders of ties.
RankMeasures mean_over_orders(const std::vector<double>& input, const std::vector<double>& map,
                              std::size_t k) {
  Order of_input(input.size());
  std::iota(of_input.begin(), of_input.end(), std::size_t{0});
  RankMeasures sum;
  double orders = 0.0;
  do {
    Order of_map(map.size());
    std::iota(of_map.begin(), of_map.end(), std::size_t{0});
    do {
      const RankMeasures one = ranks_by_definition(input, map, k, of_input, of_map);
      sum.trustworthiness += one.trustworthiness;
      sum.continuity += one.continuity;
      sum.neighbourhood_preservation += one.neighbourhood_preservation;
      orders += 1.0;
    } while (std::next_permutation(of_map.begin(), of_map.end()));
  } while (std::next_permutation(of_input.begin(), of_input.end()));
  return {sum.trustworthiness / orders, sum.continuity / orders,
          sum.neighbourhood_preservation / orders};
}

TEST(RankMeasures, AreTheMeanOverAllOrdersOfTies) {
  // Samples 0 and 3 are equal, 1 is as far from 4 as 2; 0, 2 and 4 share a neuron.
  const std::vector<float> values{0, 2, 6, 0, 4};
  const std::vector<std::size_t> winners{1, 2, 1, 4, 1};
  const std::vector<double> input(values.begin(), values.end());
  const std::vector<double> map(winners.begin(), winners.end());
  for (const std::size_t k : {1U, 2U}) {
    const RankMeasures expected = mean_over_orders(input, map, k);
    const RankMeasures found = measure_ranks(line_of(6), samples_at(values), winners, k, 1);
    EXPECT_NEAR(found.trustworthiness, expected.trustworthiness, 1e-12);
    EXPECT_NEAR(found.continuity, expected.continuity, 1e-12);
    EXPECT_NEAR(found.neighbourhood_preservation, expected.neighbourhood_preservation, 1e-12);
  }
}

TEST(RankMeasures, OfTheSameOrderAreOne) {
  const RankMeasures found =
      measure_ranks(line_of(32), samples_at({0, 1, 3, 7, 15, 31}), {0, 1, 3, 7, 15, 31}, 2, 3);
  EXPECT_DOUBLE_EQ(found.trustworthiness, 1.0);
  EXPECT_DOUBLE_EQ(found.continuity, 1.0);
  EXPECT_DOUBLE_EQ(found.neighbourhood_preservation, 1.0);
}

// All samples on one neuron: any order is as likely, so that chance decides.
TEST(RankMeasures, OfOneNeuronAreThoseOfRandomOrders) {
  const RankMeasures found =
      measure_ranks(line_of(1), samples_at({0, 1, 3, 7, 15, 31, 63}), Order(7, 0), 2, 1);
  EXPECT_DOUBLE_EQ(found.neighbourhood_preservation, 2.0 / 6.0);
  EXPECT_NEAR(found.trustworthiness, found.continuity, 1e-12);
}

TEST(RankMeasures, NeedMoreSamplesThanTwiceTheNeighbours) {
  EXPECT_TRUE(std::isnan(
      measure_ranks(line_of(2), samples_at({0, 1, 2, 3}), Order(4, 0), 2, 1).trustworthiness));
  EXPECT_TRUE(std::isnan(measure_ranks(line_of(2), samples_at({0}), {0}, 1, 1).continuity));
  EXPECT_THROW((void)measure_ranks(line_of(2), samples_at({0}), {}, 1, 1), InvalidArgument);
}

TEST(RankMeasures, OfSparseSamplesAreThoseOfDenseOnes) {
  Random random(5);
  const Samples sparse = testing::random_samples(30, 40, true, random);
  std::vector<Signal> dense;
  Order winners;
  for (std::size_t i = 0; i < 30; ++i) {
    dense.push_back(Signal::dense(Signal::copy_of(sparse[i]).to_dense()));
    winners.push_back(random.below(9));
  }
  SomParameters p;
  p.rows = 3;
  p.columns = 3;
  const Som som(resolve(p, 1, 40).value(), Matrix<float>(9, 40));
  const RankMeasures a = measure_ranks(som, sparse, winners, 3, 1);
  const RankMeasures b = measure_ranks(som, Samples::from_signals(dense), winners, 3, 2);
  EXPECT_EQ(a.trustworthiness, b.trustworthiness);
  EXPECT_EQ(a.continuity, b.continuity);
}

}  // namespace
}  // namespace somato
