#include "studies/sweep/sobol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "somato/core/check.h"

namespace somato {
namespace {

// The bits of the number, mirrored at the point.
double van_der_corput_number(std::uint32_t index) {
  double number = 0.0;
  for (double weight = 0.5; index > 0; index /= 2, weight /= 2) number += weight * (index % 2);
  return number;
}

TEST(Sobol, TheFirstDimensionIsTheVanDerCorputSequence) {
  for (std::uint32_t i = 0; i < 5000; ++i) {
    EXPECT_EQ(sobol_point(i, 1)[0], van_der_corput_number(i));
  }
}

// By hand: point 2^(k-1) is m_k / 2^k, and the others are exclusive ors of these. Dimension 2 has
// m_k = 2 m_(k-1) ^ m_(k-1), so m = 1, 3, 5; dimension 3 has m_3 = 2 m_2 ^ 4 m_1 ^ m_1, so
// m = 1, 3, 3; the initial numbers of dimensions 4, 5 and 6 are 1, 3, 1; 1, 1, 1; and 1, 1, 3.
TEST(Sobol, TheFirstPointsAreThoseOfTheRecurrence) {
  const std::vector<std::vector<double>> expected{{0, 0, 0, 0, 0, 0},
                                                  {0.5, 0.5, 0.5, 0.5, 0.5, 0.5},
                                                  {0.25, 0.75, 0.75, 0.75, 0.25, 0.25},
                                                  {0.75, 0.25, 0.25, 0.25, 0.75, 0.75},
                                                  {0.125, 0.625, 0.375, 0.125, 0.125, 0.375},
                                                  {0.625, 0.125, 0.875, 0.625, 0.625, 0.875},
                                                  {0.375, 0.375, 0.625, 0.875, 0.375, 0.125},
                                                  {0.875, 0.875, 0.125, 0.375, 0.875, 0.625}};
  for (std::uint32_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(sobol_point(i, 6), expected[i]) << i;
  }
}

// Point 741 in 1024ths, as SciPy 1's qmc.Sobol (which orders the points by the Gray code) has it.
TEST(Sobol, PointsOfAllDimensionsAreThoseOfSciPy) {
  const std::vector<double> expected{669, 487, 431, 769, 723, 101, 299, 661, 733, 1011, 371,
                                     737, 369, 445, 703, 839, 469, 509, 339, 523, 363,  415,
                                     433, 965, 777, 301, 517, 359, 489, 681, 195, 97};
  std::vector<double> point = sobol_point(741, kSobolDimensions);
  for (double& number : point) number *= 1024;
  EXPECT_EQ(point, expected);
}

TEST(Sobol, EveryElementaryIntervalOfEveryDimensionHoldsOnePoint) {
  for (unsigned m = 0; m <= 10; ++m) {
    const std::uint32_t count = 1U << m;
    std::vector<std::set<std::uint32_t>> intervals(kSobolDimensions);
    // Any 2^m points that follow a multiple of 2^m.
    for (std::uint32_t i = 0; i < count; ++i) {
      const std::vector<double> point = sobol_point(3 * count + i, kSobolDimensions);
      for (std::size_t d = 0; d < kSobolDimensions; ++d) {
        ASSERT_GE(point[d], 0.0);
        ASSERT_LT(point[d], 1.0);
        intervals[d].insert(static_cast<std::uint32_t>(std::floor(point[d] * count)));
      }
    }
    for (std::size_t d = 0; d < kSobolDimensions; ++d) {
      EXPECT_EQ(intervals[d].size(), count) << d;
    }
  }
}

// Dimensions 1 and 2 are a (0, 2)-sequence: one point in each elementary rectangle of any shape.
TEST(Sobol, TheFirstTwoDimensionsFillEveryElementaryRectangle) {
  constexpr unsigned kPower = 8;
  for (unsigned first = 0; first <= kPower; ++first) {
    std::set<std::pair<double, double>> rectangles;
    for (std::uint32_t i = 0; i < (1U << kPower); ++i) {
      const std::vector<double> point = sobol_point(i, 2);
      rectangles.emplace(std::floor(std::ldexp(point[0], static_cast<int>(first))),
                         std::floor(std::ldexp(point[1], static_cast<int>(kPower - first))));
    }
    EXPECT_EQ(rectangles.size(), std::size_t{1} << kPower) << first;
  }
}

TEST(Sobol, MoreDimensionsThanThereAreAreRefused) {
  EXPECT_EQ(sobol_point(5, 0), std::vector<double>{});
  EXPECT_THROW(sobol_point(0, kSobolDimensions + 1), InvalidArgument);
}

}  // namespace
}  // namespace somato
