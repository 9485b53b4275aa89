#include "maps/t_mpsom/t_mpsom_neighbourhood.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "base/support/instruction_sets.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Shape = std::vector<std::size_t>;

std::vector<std::size_t> places_of(std::size_t place, const Shape& shape) {
  Shape places(shape.size());
  for (std::size_t axis = shape.size(); axis-- > 0;) {
    places[axis] = place % shape[axis];
    place /= shape[axis];
  }
  return places;
}

// All pairs, by the mathematics library.
std::vector<double> spread_by_pairs(const std::vector<double>& values, const Shape& shape,
                                    double sigma) {
  std::vector<double> spread(values.size(), 0.0);
  for (std::size_t p = 0; p < values.size(); ++p) {
    for (std::size_t q = 0; q < values.size(); ++q) {
      double squared = 0.0;
      for (std::size_t axis = 0; axis < shape.size(); ++axis) {
        const double apart = static_cast<double>(places_of(p, shape)[axis]) -
                             static_cast<double>(places_of(q, shape)[axis]);
        squared += apart * apart;
      }
      spread[p] += values[q] * std::exp(-squared / (2.0 * sigma * sigma));
    }
  }
  return spread;
}

std::vector<double> random_values(Random& random, const Shape& shape) {
  std::size_t count = 1;
  for (const std::size_t extent : shape) count *= extent;
  std::vector<double> values(count);
  for (double& value : values) value = random.uniform();
  return values;
}

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> shapes{{1},       {7},       {1, 5},       {5, 1},  {4, 9},
                                         {2, 3, 4}, {3, 1, 5}, {2, 2, 3, 2}, {23, 11}};
  return shapes;
}

TEST(GridGaussian, SpreadsAsTheSumOverAllPairs) {
  Random random(1);
  for (const Shape& shape : shapes()) {
    for (const double sigma : {0.4, 1.0, 3.5}) {
      const GridGaussian gaussian(shape, sigma);
      GridGaussian::Workspace workspace = gaussian.make_workspace();
      std::vector<double> values = random_values(random, shape);
      const std::vector<double> expected = spread_by_pairs(values, shape, sigma);
      gaussian.spread(values, workspace);
      for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_NEAR(values[i], expected[i], 1e-13 * expected[i]);
      }
    }
  }
}

// The cut-off parts: values between 0 and 1 over many orders, so that far places matter where
// near ones are small. The bound is the one of the class comment, and rounding.
TEST(GridGaussian, IsWithinItsBoundOfTheSumOverAllPairs) {
  Random random(3);
  for (const Shape& shape : {Shape{46, 23}, Shape{60}, Shape{3, 25, 4}}) {
    for (const double sigma : {0.3, 1.0, 2.0}) {
      const GridGaussian gaussian(shape, sigma);
      GridGaussian::Workspace workspace = gaussian.make_workspace();
      std::vector<double> values = random_values(random, shape);
      for (double& value : values) value = std::pow(10.0, -60.0 * value);
      const std::vector<double> expected = spread_by_pairs(values, shape, sigma);
      const double total = std::accumulate(values.begin(), values.end(), 0.0);
      gaussian.spread(values, workspace);
      for (std::size_t i = 0; i < values.size(); ++i) {
        EXPECT_NEAR(values[i], expected[i], 1e-13 * expected[i] + 1e-18 * total);
      }
    }
  }
}

// One value: what comes of it is the Gaussian, up to where it is below 1e-18 (sqrt(2 * 18 ln 10),
// or 9.1 sigma).
TEST(GridGaussian, EndsWhereItIsNegligible) {
  const GridGaussian gaussian({41}, 1.0);
  GridGaussian::Workspace workspace = gaussian.make_workspace();
  std::vector<double> values(41);
  values[20] = 1.0;
  gaussian.spread(values, workspace);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double distance = std::fabs(static_cast<double>(i) - 20.0);
    const double expected = distance <= 9.0 ? std::exp(-distance * distance / 2.0) : 0.0;
    EXPECT_NEAR(values[i], expected, 1e-14 * expected) << i;
  }
}

TEST(GridGaussian, GivesTheSameBitsOnEveryInstructionSet) {
  Random random(2);
  const GridGaussian gaussian({23, 11}, 2.0);
  GridGaussian::Workspace workspace = gaussian.make_workspace();
  const std::vector<double> values = random_values(random, {23, 11});
  std::vector<double> expected;
  testing::for_each_instruction_set([&](InstructionSet set) {
    std::vector<double> spread = values;
    gaussian.spread(spread, workspace);
    if (expected.empty()) expected = spread;
    EXPECT_EQ(spread, expected) << name_of(set);
  });
}

TEST(GridGaussian, RefusesWhatDoesNotFit) {
  EXPECT_THROW(GridGaussian({2, 2}, 0.0), InvalidArgument);
  EXPECT_THROW(GridGaussian({2, 0}, 1.0), InvalidArgument);
  const GridGaussian line({6}, 1.0);
  const GridGaussian square({2, 3}, 1.0);
  GridGaussian::Workspace workspace = square.make_workspace();
  std::vector<double> values(5);
  EXPECT_THROW(square.spread(values, workspace), InvalidArgument);
  values.resize(6);
  EXPECT_THROW(line.spread(values, workspace), InvalidArgument);
}

}  // namespace
}  // namespace somato
