#include "maps/online/growing_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "maps/support/growing_problems.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using testing::Values;

// The rules one after the other, on a table of rows of neurons.
class SlowGrid {
 public:
  SlowGrid(const GrowingGridParameters& parameters, const std::vector<Values>& start)
      : p_(parameters), w_{{start[0], start[1]}, {start[2], start[3]}}, count_(2, {0, 0}) {}

  void learn(const Values& x) {
    const bool grows = rows() * columns() + std::max(rows(), columns()) <= p_.growth.most_neurons;
    const double end = static_cast<double>(p_.tuning_inputs * rows() * columns());
    double rate = p_.learning_rate_start;
    if (!grows) {
      if (static_cast<double>(tuned_) >= end) return;
      rate *= std::pow(p_.learning_rate_end / p_.learning_rate_start,
                       static_cast<double>(tuned_++) / end);
    }
    std::size_t row = 0;
    std::size_t column = 0;
    for (std::size_t r = 0; r < rows(); ++r) {
      for (std::size_t c = 0; c < columns(); ++c) {
        if (testing::distance(w_[r][c], x) < testing::distance(w_[row][column], x)) {
          row = r;
          column = c;
        }
      }
    }
    for (std::size_t r = 0; r < rows(); ++r) {
      for (std::size_t c = 0; c < columns(); ++c) {
        const double d = std::fabs(static_cast<double>(r) - static_cast<double>(row)) +
                         std::fabs(static_cast<double>(c) - static_cast<double>(column));
        testing::move(w_[r][c], x, rate * std::exp(-d * d / (2 * p_.radius * p_.radius)));
      }
    }
    ++count_[row][column];
    if (grows && ++inputs_ == p_.growth_inputs * rows() * columns()) insert();
  }

  std::vector<Values> weights() const {
    std::vector<Values> all;
    for (const auto& row : w_) all.insert(all.end(), row.begin(), row.end());
    return all;
  }
  std::size_t rows() const { return w_.size(); }
  std::size_t columns() const { return w_.front().size(); }

 private:
  void insert() {
    std::size_t row = 0;
    std::size_t column = 0;
    for (std::size_t r = 0; r < rows(); ++r) {
      for (std::size_t c = 0; c < columns(); ++c) {
        if (count_[r][c] > count_[row][column]) {
          row = r;
          column = c;
        }
      }
    }
    double most = -1.0;
    int direction = 0;  // 0 above, 1 left, 2 right, 3 below
    const auto consider = [&](bool possible, int at, std::size_t r, std::size_t c) {
      if (!possible || testing::distance(w_[row][column], w_[r][c]) <= most) return;
      most = testing::distance(w_[row][column], w_[r][c]);
      direction = at;
    };
    consider(row > 0, 0, row - 1, column);
    consider(column > 0, 1, row, column - 1);
    consider(column + 1 < columns(), 2, row, column + 1);
    consider(row + 1 < rows(), 3, row + 1, column);
    if (direction == 0 || direction == 3) {
      const std::size_t above = direction == 0 ? row - 1 : row;
      std::vector<Values> between;
      for (std::size_t c = 0; c < columns(); ++c) {
        between.push_back(testing::mean(w_[above][c], w_[above + 1][c]));
      }
      w_.insert(w_.begin() + static_cast<std::ptrdiff_t>(above) + 1, between);
    } else {
      const std::size_t left = direction == 1 ? column - 1 : column;
      for (auto& points : w_) {
        points.insert(points.begin() + static_cast<std::ptrdiff_t>(left) + 1,
                      testing::mean(points[left], points[left + 1]));
      }
    }
    count_.assign(rows(), std::vector<std::uint64_t>(columns(), 0));
    inputs_ = 0;
  }

  GrowingGridParameters p_;
  std::vector<std::vector<Values>> w_;
  std::vector<std::vector<std::uint64_t>> count_;
  std::uint64_t inputs_ = 0;
  std::uint64_t tuned_ = 0;
};

GrowingGridParameters small_grid() {
  GrowingGridParameters parameters;
  parameters.growth.most_neurons = 30;
  parameters.growth_inputs = 5;
  parameters.tuning_inputs = 5;
  return parameters;
}

TEST(GrowingGrid, IsTheSlowGrid) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Samples samples = testing::clustered_samples(50, 1 + seed % 3, seed);
    GrowingGridParameters parameters = small_grid();
    parameters.growth.seed = seed;
    GrowingGrid map(parameters, samples);
    SlowGrid slow(parameters, testing::points_of(map.map()));
    Random random(seed);
    std::vector<float> input(samples.size());
    for (int t = 0; t < 800; ++t) {
      const std::size_t sample = random.below(samples.count());
      write_dense(samples[sample], input);
      map.learn(input);
      slow.learn(testing::point_of(samples, sample));
    }
    const Som som = map.map();
    EXPECT_TRUE(map.is_complete());
    EXPECT_EQ(som.grid().rows(), slow.rows()) << seed;
    EXPECT_EQ(som.grid().columns(), slow.columns()) << seed;
    EXPECT_LT(testing::difference(testing::points_of(som), slow.weights()), 1e-4) << seed;
  }
}

// Points along a line: more columns than rows, or the other way round, do not fit a square.
TEST(GrowingGrid, GrowsAlongALine) {
  Matrix<float> points(50, 2, 0.0F);
  for (std::size_t i = 0; i < 50; ++i) points(i, 0) = static_cast<float>(i);
  const Samples samples(std::move(points));
  GrowingGridParameters parameters = small_grid();
  parameters.growth.iterations = 10'000;
  parameters.growth_inputs = 30;
  GrowingGrid map(parameters, samples);
  ASSERT_TRUE(grow(map, parameters.growth, {samples}, {}, {}));
  const Som som = map.map();
  EXPECT_GE(std::max(som.grid().rows(), som.grid().columns()),
            3 * std::min(som.grid().rows(), som.grid().columns()));
  EXPECT_LE(som.neurons(), 30U);
}

TEST(GrowingGrid, ChangesNothingOnceItIsComplete) {
  const Samples samples = testing::clustered_samples(20, 2, 1);
  GrowingGridParameters parameters = small_grid();
  parameters.growth.iterations = 10'000;
  GrowingGrid map(parameters, samples);
  ASSERT_TRUE(grow(map, parameters.growth, {samples}, {}, {}));
  ASSERT_TRUE(map.is_complete());
  const Som before = map.map();
  map.learn(std::vector<float>{100, 100});
  EXPECT_EQ(map.map().weights(), before.weights());
}

}  // namespace
}  // namespace somato
