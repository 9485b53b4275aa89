// Each kernel against its formula, value by value; the bits are those of every instruction set.

#include "base/kernels/neuron_activity_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "base/support/instruction_sets.h"
#include "somato/core/matrix.h"
#include "somato/core/random.h"

namespace somato {
namespace {

constexpr std::size_t kLine = LaneMatrix<float>::kLanes;

// Values of several sizes; some are 0, negative zeros or below zero.
AlignedVector<float> mixed_values(std::size_t blocks, Random& random) {
  AlignedVector<float> values(blocks * kLine);
  for (float& value : values) {
    value = static_cast<float>(random.normal() * std::pow(10.0, 12.0 * random.uniform() - 6.0));
    if (random.below(9) == 0) value = random.below(2) == 0 ? 0.0F : -0.0F;
  }
  return values;
}

void expect_bits(float computed, float expected) {
  EXPECT_EQ(std::memcmp(&computed, &expected, sizeof(float)), 0) << computed << " " << expected;
}

template <typename Work>
void for_each_activity(const Work& work) {
  testing::for_each_instruction_set([&](InstructionSet) {
    Random random(5);
    for (std::size_t blocks = 0; blocks < 6; ++blocks) work(mixed_values(blocks, random), blocks);
  });
}

TEST(NeuronActivityKernels, SimilaritiesFollowFromSquares) {
  for_each_activity([](AlignedVector<float> values, std::size_t blocks) {
    for (float& value : values) value = std::fabs(value);
    const AlignedVector<float> before = values;
    for (const double left_out : {0.0, 0.3}) {
      values = before;
      kernels::activity_table().similarities(values.data(), blocks, left_out);
      for (std::size_t i = 0; i < values.size(); ++i) {
        const double distance = std::sqrt(double{before[i]} + left_out);
        expect_bits(values[i], static_cast<float>(1.0 / (1.0 + distance)));
      }
    }
  });
}

TEST(NeuronActivityKernels, NoValueStaysBelowZero) {
  for_each_activity([](AlignedVector<float> values, std::size_t blocks) {
    const AlignedVector<float> before = values;
    const float largest = kernels::activity_table().rectify(values.data(), blocks);
    float expected = 0.0F;
    for (std::size_t i = 0; i < values.size(); ++i) {
      expect_bits(values[i], before[i] < 0.0F ? 0.0F : before[i]);
      expected = std::max(expected, before[i]);
    }
    EXPECT_EQ(largest, expected);
  });
}

TEST(NeuronActivityKernels, PowersAreProducts) {
  for_each_activity([](AlignedVector<float> values, std::size_t blocks) {
    const AlignedVector<float> before = values;
    const auto& kernels = kernels::activity_table();
    AlignedVector<double> terms(values.size());
    kernels.power_terms(before.data(), blocks, 7.0, 3, terms.data());
    kernels.powers(values.data(), blocks, 7.0, 3);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double relative = double{before[i]} / 7.0;
      const double expected = relative * (relative * relative);  // by squaring
      EXPECT_EQ(terms[i], expected);
      expect_bits(values[i], static_cast<float>(expected));
    }
  });
}

// x^10 = x^2 x^8, by squaring; a product one after the other would be rounded otherwise.
TEST(NeuronActivityKernels, TheTenthPowerIsThatOfSquares) {
  AlignedVector<float> values(kLine);
  for (std::size_t i = 0; i < kLine; ++i) values[i] = 0.37F + 0.04F * static_cast<float>(i);
  AlignedVector<double> terms(kLine);
  kernels::activity_table().power_terms(values.data(), 1, 1.0, 10, terms.data());
  for (std::size_t i = 0; i < kLine; ++i) {
    const double square = double{values[i]} * double{values[i]};
    const double fourth = square * square;
    EXPECT_EQ(terms[i], square * (fourth * fourth));
  }
}

TEST(NeuronActivityKernels, DivideInDoublePrecision) {
  for_each_activity([](AlignedVector<float> values, std::size_t blocks) {
    const AlignedVector<float> before = values;
    kernels::activity_table().divide(values.data(), blocks, 0.1);
    for (std::size_t i = 0; i < values.size(); ++i) {
      expect_bits(values[i], static_cast<float>(double{before[i]} / 0.1));
    }
  });
}

}  // namespace
}  // namespace somato
