#include "maps/reading/weight_plane.h"

#include <gtest/gtest.h>

#include <cmath>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

Som map_of(std::size_t rows, std::size_t columns, std::size_t size, std::vector<float> weights) {
  SomParameters p;
  p.rows = rows;
  p.columns = columns;
  return Som(resolve(p, size, 2).value(), Matrix<float>(rows * columns, size, std::move(weights)));
}

// Neurons along (3, 4) / 5 at -5, 0, 5 and 10, around their mean.
TEST(WeightPlane, OfALineIsTheLine) {
  const WeightPlane plane(map_of(1, 4, 2, {-3, -4, 0, 0, 3, 4, 6, 8}));
  EXPECT_NEAR(plane.axes()[0][0], 0.6, 1e-12);
  EXPECT_NEAR(plane.axes()[0][1], 0.8, 1e-12);
  EXPECT_EQ(plane.axes()[1], (std::vector<double>{0, 0}));
  EXPECT_NEAR(plane.shares()[0], 1.0, 1e-12);
  EXPECT_EQ(plane.shares()[1], 0.0);
  const double expected[] = {-7.5, -2.5, 2.5, 7.5};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(plane.neurons()[i].x, expected[i], 1e-9);
    EXPECT_NEAR(plane.neurons()[i].y, 0.0, 1e-9);
  }
}

TEST(WeightPlane, OfEqualNeuronsAndOfOneIsAPoint) {
  for (const std::size_t columns : {1U, 3U}) {
    const WeightPlane plane(map_of(1, columns, 2, std::vector<float>(2 * columns, 7.0F)));
    for (const Position& at : plane.neurons()) {
      EXPECT_EQ(at.x, 0.0);
      EXPECT_EQ(at.y, 0.0);
    }
    EXPECT_EQ(plane.shares()[0], 0.0);
  }
}

// C v = lambda v with the covariance in its slow, obvious form, and no direction with a greater
// variance in the space that is left.
TEST(WeightPlane, AxesAreEigenvectorsOfTheGreatestVariances) {
  Random random(3);
  for (const std::size_t size : {1U, 2U, 5U, 12U, 40U}) {
    constexpr std::size_t kNeuronsOfMap = 30;
    std::vector<float> weights;
    for (std::size_t i = 0; i < kNeuronsOfMap * size; ++i) {
      const auto scale = static_cast<double>(1 + i % size);
      weights.push_back(static_cast<float>(scale * random.normal() + 100));
    }
    const Som som = map_of(5, 6, size, weights);
    const WeightPlane plane(som);
    std::vector<double> mean(size, 0.0);
    for (std::size_t i = 0; i < weights.size(); ++i) mean[i % size] += weights[i] / 30.0;
    const auto scatter = [&](const std::vector<double>& v) {
      std::vector<double> out(size, 0.0);
      for (std::size_t n = 0; n < kNeuronsOfMap; ++n) {
        double along = 0.0;
        for (std::size_t d = 0; d < size; ++d) along += v[d] * (weights[n * size + d] - mean[d]);
        for (std::size_t d = 0; d < size; ++d) out[d] += along * (weights[n * size + d] - mean[d]);
      }
      return out;
    };
    const auto dot_of = [](const std::vector<double>& a, const std::vector<double>& b) {
      double sum = 0.0;
      for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
      return sum;
    };
    for (std::size_t axis = 0; axis < std::min<std::size_t>(2, size); ++axis) {
      const std::vector<double>& v = plane.axes()[axis];
      EXPECT_NEAR(dot_of(v, v), 1.0, 1e-9);
      const std::vector<double> image = scatter(v);
      const double value = dot_of(v, image);
      for (std::size_t d = 0; d < size; ++d) EXPECT_NEAR(image[d], value * v[d], 1e-4 * value);
      EXPECT_GT(*std::max_element(v.begin(), v.end()), 0.0);
      for (int trial = 0; trial < 50; ++trial) {
        std::vector<double> other(size);
        for (double& part : other) part = random.normal();
        for (std::size_t before = 0; before < axis; ++before) {
          const double along = dot_of(other, plane.axes()[before]);
          for (std::size_t d = 0; d < size; ++d) other[d] -= along * plane.axes()[before][d];
        }
        EXPECT_LE(dot_of(other, scatter(other)), value * dot_of(other, other) * (1 + 1e-9));
      }
    }
  }
}

// A neuron's weights as a sample are at the place of the neuron, dense and sparse.
TEST(WeightPlane, SamplesLieWhereTheNeuronsDo) {
  Random random(5);
  std::vector<float> weights;
  for (int i = 0; i < 12 * 4; ++i) weights.push_back(static_cast<float>(random.normal()));
  const Som som = map_of(3, 4, 4, weights);
  const WeightPlane plane(som);
  const auto at = plane.positions_of(som, Samples(Matrix<float>(12, 4, weights)));
  std::vector<Signal> sparse;
  for (std::size_t n = 0; n < 12; ++n) {
    const auto row = weights.begin() + static_cast<std::ptrdiff_t>(4 * n);
    sparse.push_back(Signal::sparse({4}, {0, 1, 2, 3}, {row, row + 4}));
  }
  const auto at_sparse = plane.positions_of(som, Samples::from_signals(sparse));
  for (std::size_t n = 0; n < 12; ++n) {
    EXPECT_NEAR(at[n].x, plane.neurons()[n].x, 1e-9);
    EXPECT_NEAR(at[n].y, plane.neurons()[n].y, 1e-9);
    EXPECT_NEAR(at_sparse[n].x, plane.neurons()[n].x, 1e-9);
  }
  EXPECT_THROW(plane.positions_of(som, Samples(Matrix<float>(1, 3, {1, 2, 3}))), InvalidArgument);
}

}  // namespace
}  // namespace somato
