#include "studies/measures/rank_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Values = std::vector<double>;

Matrix<double> inner_products(const std::vector<Values>& vectors) {
  Matrix<double> products(vectors.size(), vectors.size());
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    for (std::size_t j = 0; j < vectors.size(); ++j) {
      for (std::size_t d = 0; d < vectors[i].size(); ++d) {
        products(i, j) += vectors[i][d] * vectors[j][d];
      }
    }
  }
  return products;
}

// Up to sign and length.
void expect_along(const Values& found, const Values& expected) {
  ASSERT_EQ(found.size(), expected.size());
  double both = 0.0;
  double found_squares = 0.0;
  double expected_squares = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    both += found[i] * expected[i];
    found_squares += found[i] * found[i];
    expected_squares += expected[i] * expected[i];
  }
  EXPECT_NEAR(std::abs(both), std::sqrt(found_squares * expected_squares), 1e-9);
}

// On a line far from the origin, at 3, 0, 1 and 8 steps: 0, -3, -2, 5 from their mean.
TEST(PrincipalPositions, AreThoseOnALine) {
  const auto at = [](double steps) { return Values{100.0 + 3.0 * steps, -50.0 + 4.0 * steps}; };
  expect_along(principal_positions(inner_products({at(3), at(0), at(1), at(8)})), {0, -3, -2, 5});
}

// Wide along x, narrow along y: the positions are x.
TEST(PrincipalPositions, TakeTheWiderDirection) {
  expect_along(principal_positions(inner_products({{-3, 0}, {3, 0}, {0, 2.9}, {0, -2.9}})),
               {-3, 3, 0, 0});
  expect_along(principal_positions(inner_products({{-3, 0}, {3, 0}, {0, 3.1}, {0, -3.1}})),
               {0, 0, 1, -1});
}

// Rounding may leave small differences.
TEST(PrincipalPositions, AreNoneOfEqualVectors) {
  Random random(2);
  for (int problem = 0; problem < 50; ++problem) {
    const double first = random.normal();
    const double second = random.normal();
    const std::vector<Values> same(7, Values{first, second});
    EXPECT_EQ(principal_positions(inner_products(same)), Values(7, 0.0));
  }
}

// The slow way: a power iteration on the covariance of the vectors themselves.
TEST(PrincipalPositions, AgreeWithAPowerIteration) {
  Random random(5);
  for (int problem = 0; problem < 50; ++problem) {
    std::vector<Values> vectors(6, Values(4));
    Values mean(4, 0.0);
    for (Values& vector : vectors) {
      for (std::size_t d = 0; d < 4; ++d) {
        vector[d] = random.normal() * (d == 1 ? 4.0 : 1.0);
        mean[d] += vector[d] / 6.0;
      }
    }
    Values direction{1, 1, 1, 1};
    Values positions(6);
    for (int step = 0; step < 5000; ++step) {
      Values next(4, 0.0);
      for (std::size_t i = 0; i < 6; ++i) {
        positions[i] = 0.0;
        for (std::size_t d = 0; d < 4; ++d) {
          positions[i] += (vectors[i][d] - mean[d]) * direction[d];
        }
        for (std::size_t d = 0; d < 4; ++d) next[d] += (vectors[i][d] - mean[d]) * positions[i];
      }
      const double most = std::abs(*std::max_element(
          next.begin(), next.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }));
      for (std::size_t d = 0; d < 4; ++d) direction[d] = next[d] / most;
    }
    expect_along(principal_positions(inner_products(vectors)), positions);
  }
}

TEST(RankOrder, IsTheMeanOfTheGroupsWhateverTheirDirection) {
  const OrderedGroup rising{{1, 2, 3, 4, 5}, {0, 1, 2, 3, 4}};
  const OrderedGroup falling{{1, 2, 3, 4, 5}, {9, 7, 5, 3, 1}};
  const OrderedGroup nearly{{1, 2, 3, 4, 5}, {2, 1, 3, 5, 4}};
  EXPECT_DOUBLE_EQ(rank_order({rising, falling}, 0, 1).correlation, 1.0);
  EXPECT_DOUBLE_EQ(rank_order({rising, falling, nearly}, 0, 1).correlation, 2.8 / 3.0);
  EXPECT_THROW((void)rank_order({}, 0, 1), InvalidArgument);
}

// Two of the six orders of three have the absolute correlation 1, four have 1/2: 2/3 by chance,
// and one of three comes as high.
TEST(RankOrder, ComparesWithShuffledNumbers) {
  const RankOrder order = rank_order({{{1, 2, 3}, {4, 5, 6}}}, 20000, 7);
  EXPECT_DOUBLE_EQ(order.correlation, 1.0);
  EXPECT_NEAR(order.shuffled, 2.0 / 3.0, 0.01);
  EXPECT_NEAR(order.shuffled_share, 1.0 / 3.0, 0.015);
}

// Every order of three comes as high as 1/2.
TEST(RankOrder, CountsEqualsAsHigh) {
  const RankOrder order = rank_order({{{1, 2, 3}, {4, 6, 5}}}, 1000, 7);
  EXPECT_DOUBLE_EQ(order.correlation, 0.5);
  EXPECT_DOUBLE_EQ(order.shuffled_share, 1.0);
}

// Each group keeps its own numbers: a group of equal ones stays without an order.
TEST(RankOrder, ShufflesWithinGroups) {
  const RankOrder order = rank_order({{{1, 2, 3}, {4, 5, 6}}, {{9, 9, 9}, {1, 2, 3}}}, 5000, 3);
  EXPECT_DOUBLE_EQ(order.correlation, 0.5);
  EXPECT_NEAR(order.shuffled, 1.0 / 3.0, 0.01);
  EXPECT_NEAR(order.shuffled_share, 1.0 / 3.0, 0.03);
}

TEST(RankOrder, WithoutShufflesHasNoValueByChance) {
  const RankOrder order = rank_order({{{1, 2, 3}, {4, 5, 6}}}, 0, 7);
  EXPECT_EQ(order.shuffled, 0.0);
  EXPECT_EQ(order.shuffled_share, 1.0);
}

TEST(RankOrder, IsTheSameForASeed) {
  const std::vector<OrderedGroup> groups{{{1, 2, 3, 4}, {2, 4, 1, 3}}};
  EXPECT_EQ(rank_order(groups, 50, 1).shuffled, rank_order(groups, 50, 1).shuffled);
  EXPECT_NE(rank_order(groups, 50, 1).shuffled, rank_order(groups, 50, 2).shuffled);
}

}  // namespace
}  // namespace somato
