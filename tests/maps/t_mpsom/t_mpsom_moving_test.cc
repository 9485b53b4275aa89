#include "maps/t_mpsom/t_mpsom_moving.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/support/instruction_sets.h"
#include "maps/support/t_mpsom_problems.h"

namespace somato {
namespace {

using testing::length;
using testing::random_value;
using testing::Sign;

struct MovingProblem {
  Matrix<float> weights;
  std::vector<float> sample;
  AlignedVector<float> gains;

  LaneMatrix<float> moved(TMpsomNorm norm, bool all_rows = false) const {
    LaneMatrix<float> moved(weights);
    double squared = 0.0;
    for (const float value : sample) squared += double{value} * double{value};
    move_weights(moved, {sample, static_cast<float>(squared), gains, all_rows}, norm);
    return moved;
  }
};

// Some gains are zero, of whole groups of neurons too.
MovingProblem random_problem(Random& random, Sign sign) {
  MovingProblem p;
  p.weights = Matrix<float>(1 + random.below(200), 1 + random.below(300));
  for (std::size_t row = 0; row < p.weights.rows(); ++row) {
    for (float& weight : p.weights.row(row)) weight = random_value(random, sign);
    testing::scale_to_unit_length(p.weights.row(row));
  }
  p.sample.resize(p.weights.columns());
  for (float& value : p.sample) value = random_value(random, sign);
  testing::scale_to_unit_length(p.sample);
  p.gains.resize(LaneMatrix<float>(p.weights).padded_rows());
  const std::size_t still = random.below(p.weights.rows());
  for (std::size_t row = 0; row < still; ++row) {
    p.gains[row] = static_cast<float>(random.uniform());
  }
  return p;
}

std::vector<double> moved_row(const MovingProblem& p, std::size_t row, TMpsomNorm norm) {
  std::vector<double> moved;
  double squared = 0.0;
  for (std::size_t k = 0; k < p.sample.size(); ++k) {
    const double weight = p.weights(row, k);
    moved.push_back(weight + double{p.gains[row]} * (double{p.sample[k]} - weight));
    squared += moved.back() * moved.back();
  }
  const bool divides = norm == TMpsomNorm::kL2 && squared > 0.0;
  for (double& weight : moved) weight /= divides ? std::sqrt(squared) : 1.0;
  return moved;
}

TEST(TMpsomMoving, MovesAndNormalizesEachRow) {
  Random random(1);
  for (int i = 0; i < 60; ++i) {
    const MovingProblem p = random_problem(random, i % 2 == 0 ? Sign::kPositive : Sign::kEither);
    for (const TMpsomNorm norm : {TMpsomNorm::kL2, TMpsomNorm::kNone}) {
      LaneMatrix<float> before;
      testing::for_each_instruction_set([&](InstructionSet set) {
        const LaneMatrix<float> moved = p.moved(norm);
        for (std::size_t row = 0; row < moved.rows(); ++row) {
          const std::vector<double> expected = moved_row(p, row, norm);
          for (std::size_t k = 0; k < moved.columns(); ++k) {
            EXPECT_NEAR(double{moved(row, k)}, expected[k], 1e-6) << name_of(set);
          }
        }
        if (before.rows() == 0) before = moved;
        EXPECT_EQ(moved, before) << name_of(set);
      });
    }
  }
}

// Parts that cancel leave a short vector, whose length single precision would not know.
TEST(TMpsomMoving, GivesBackTheLengthThatCancellingTakes) {
  Random random(2);
  MovingProblem p = random_problem(random, Sign::kEither);
  for (std::size_t row = 0; row < p.weights.rows(); ++row) {
    const double apart = 1e-4 * static_cast<double>(row % 7);
    for (std::size_t k = 0; k < p.sample.size(); ++k) {
      p.weights(row, k) = static_cast<float>(-p.sample[k] * (1.0 + apart * double(k % 3)));
    }
    p.gains[row] = 0.5F;
  }
  const LaneMatrix<float> moved = p.moved(TMpsomNorm::kL2);
  for (std::size_t row = 0; row < p.weights.rows(); ++row) {
    const std::vector<double> expected = moved_row(p, row, TMpsomNorm::kL2);
    for (std::size_t k = 0; k < p.sample.size(); ++k) {
      EXPECT_NEAR(double{moved(row, k)}, expected[k], 1e-6);
    }
  }
}

TEST(TMpsomMoving, KeepsGroupsWithoutGains) {
  Random random(3);
  MovingProblem p = random_problem(random, Sign::kPositive);
  for (float& weight : p.weights.values()) weight *= 3.0F;
  std::fill(p.gains.begin(), p.gains.end(), 0.0F);
  EXPECT_EQ(p.moved(TMpsomNorm::kL2).to_matrix(), p.weights);
  EXPECT_EQ(p.moved(TMpsomNorm::kNone).to_matrix(), p.weights);
  const Matrix<float> normalized = p.moved(TMpsomNorm::kL2, true).to_matrix();
  for (std::size_t row = 0; row < normalized.rows(); ++row) {
    EXPECT_NEAR(length(normalized.row(row)), 1.0, 1e-6);
  }
}

TEST(TMpsomMoving, KeepsZerosAndFindsLengthsBeyondSinglePrecision) {
  MovingProblem p{Matrix<float>(40, 3), {0, 0, 0}, AlignedVector<float>(48)};
  for (std::size_t k = 0; k < 3; ++k) {
    p.weights(1, k) = 1e-25F;
    p.weights(2, k) = 1e30F;
    p.weights(3, k) = 1.0F;
  }
  p.gains[3] = 1.0F;
  const Matrix<float> moved = p.moved(TMpsomNorm::kL2, true).to_matrix();
  for (std::size_t row = 0; row < 40; ++row) {
    EXPECT_NEAR(length(moved.row(row)), row == 1 || row == 2 ? 1.0 : 0.0, 1e-6) << row;
  }
}

}  // namespace
}  // namespace somato
