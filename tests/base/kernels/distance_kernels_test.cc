#include "base/kernels/distance_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/core/lanes.h"
#include "base/kernels/batch_kernels.h"
#include "base/support/instruction_sets.h"
#include "somato/core/random.h"

namespace somato {
namespace {

// A kernel, the term that it takes of each column, and whether it takes their sum or maximum.
struct Distance {
  void (*kernels::DistanceTable::*kernel)(kernels::Lanes<const float>, const float* const*,
                                          std::size_t, float* const*);
  double (*term)(double w, double x);
  bool greatest;
};

const Distance kAllDistances[] = {
    {&kernels::DistanceTable::absolute, [](double w, double x) { return std::fabs(x - w); }, false},
    {&kernels::DistanceTable::greatest, [](double w, double x) { return std::fabs(x - w); }, true},
    {&kernels::DistanceTable::squares, [](double w, double x) { return (x - w) * (x - w); }, false},
    {&kernels::DistanceTable::products, [](double w, double x) { return x * w; }, false}};

LaneMatrix<float> normal_rows(std::size_t rows, std::size_t columns, Random& random) {
  LaneMatrix<float> matrix(rows, columns);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t d = 0; d < columns; ++d) matrix(row, d) = static_cast<float>(random.normal());
  }
  return matrix;
}

// The columns first, first + 1, ... of `weights` against several inputs.
std::vector<AlignedVector<float>> written(const Distance& distance,
                                          const LaneMatrix<float>& weights, std::size_t first,
                                          const Matrix<float>& inputs) {
  std::vector<AlignedVector<float>> out(inputs.rows(), AlignedVector<float>(weights.padded_rows()));
  std::vector<const float*> from;
  std::vector<float*> to;
  for (std::size_t i = 0; i < inputs.rows(); ++i) {
    from.push_back(inputs.row(i).data());
    to.push_back(out[i].data());
  }
  const kernels::Lanes<const float> range{weights.data() + first * kFloatLanes, weights.blocks(),
                                          inputs.columns(), weights.columns()};
  (kernels::distance_table().*distance.kernel)(range, from.data(), inputs.rows(), to.data());
  return out;
}

TEST(DistanceKernels, CompareARangeOfColumnsWithSeveralInputs) {
  Random random(1);
  for (int round = 0; round < 40; ++round) {
    const std::size_t columns = 1 + random.below(600);
    const LaneMatrix<float> weights = normal_rows(1 + random.below(120), columns, random);
    const std::size_t first = random.below(columns);
    Matrix<float> inputs(1 + random.below(kernels::kInputsTogether), columns - first);
    for (float& value : inputs.values()) value = static_cast<float>(random.normal());
    for (const Distance& distance : kAllDistances) {
      const auto found = written(distance, weights, first, inputs);
      for (std::size_t i = 0; i < inputs.rows(); ++i) {
        for (std::size_t row = 0; row < weights.rows(); ++row) {
          double expected = 0.0;
          double magnitude = 0.0;
          for (std::size_t d = 0; d < inputs.columns(); ++d) {
            const double term = distance.term(weights(row, first + d), inputs(i, d));
            expected = distance.greatest ? std::max(expected, term) : expected + term;
            magnitude += std::fabs(term);
          }
          ASSERT_NEAR(found[i][row], expected, 300.0 * 0x1p-24 * magnitude);
        }
      }
      testing::for_each_instruction_set([&](InstructionSet set) {
        EXPECT_EQ(written(distance, weights, first, inputs), found) << name_of(set);
      });
    }
  }
}

TEST(DistanceKernels, AnInputHasTheSameBitsWithAndWithoutOthers) {
  Random random(2);
  const LaneMatrix<float> weights = normal_rows(75, 300, random);
  Matrix<float> inputs(kernels::kInputsTogether, 300);
  for (float& value : inputs.values()) value = static_cast<float>(random.normal());
  for (const Distance& distance : kAllDistances) {
    const auto together = written(distance, weights, 0, inputs);
    for (std::size_t i = 0; i < inputs.rows(); ++i) {
      Matrix<float> one(1, 300);
      std::copy(inputs.row(i).begin(), inputs.row(i).end(), one.row(0).begin());
      EXPECT_EQ(written(distance, weights, 0, one)[0], together[i]);
    }
  }
}

TEST(DistanceKernels, InDoublePrecisionAreTheSameBitsEverywhere) {
  Random random(3);
  for (std::size_t count : {0U, 1U, 15U, 16U, 17U, 500U}) {
    std::vector<float> a(count);
    std::vector<float> b(count);
    double sum = 0.0;
    double most = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      a[i] = static_cast<float>(random.normal());
      b[i] = static_cast<float>(random.normal());
      sum += std::fabs(double{a[i]} - double{b[i]});
      most = std::max(most, std::fabs(double{a[i]} - double{b[i]}));
    }
    const auto& kernels = kernels::batch_table();
    const double found = kernels.absolute_distance(a.data(), b.data(), count);
    EXPECT_NEAR(found, sum, 1e-12 * sum);
    testing::for_each_instruction_set([&](InstructionSet /*set*/) {
      const auto& of_set = kernels::batch_table();
      EXPECT_EQ(of_set.absolute_distance(a.data(), b.data(), count), found);
      EXPECT_EQ(of_set.greatest_difference(a.data(), b.data(), count), most);
    });
  }
}

}  // namespace
}  // namespace somato
