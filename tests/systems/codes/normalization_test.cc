#include "somato/codes/normalization.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "somato/core/random.h"

namespace somato {
namespace {

using Values = std::vector<float>;

Values values_of(const Signal& signal) {
  return {signal.values().begin(), signal.values().end()};
}

TEST(Normalization, DividesByTheSelectedNorm) {
  const Signal signal = Signal::dense({3.0F, 0.0F, -4.0F, 12.0F});
  EXPECT_EQ(norm_of(Norm::kL2, signal.values()), 13.0);
  EXPECT_EQ(norm_of(Norm::kL1, signal.values()), 19.0);
  EXPECT_EQ(norm_of(Norm::kMaximum, signal.values()), 12.0);
  EXPECT_EQ(values_of(normalized(Norm::kNone, signal)), (Values{3.0F, 0.0F, -4.0F, 12.0F}));
  EXPECT_EQ(values_of(normalized(Norm::kL2, signal)),
            (Values{3.0F / 13.0F, 0.0F, -4.0F / 13.0F, 12.0F / 13.0F}));
  EXPECT_EQ(values_of(normalized(Norm::kL1, signal)),
            (Values{3.0F / 19.0F, 0.0F, -4.0F / 19.0F, 12.0F / 19.0F}));
  EXPECT_EQ(values_of(normalized(Norm::kMaximum, signal)), (Values{0.25F, 0.0F, -4.0F / 12.0F, 1}));
}

TEST(Normalization, TakesTheMagnitudeOfANegativeMaximum) {
  EXPECT_EQ(values_of(normalized(Norm::kMaximum, Signal::dense({1.0F, -2.0F}))),
            (Values{0.5F, -1.0F}));
}

TEST(Normalization, LeavesAZeroVectorZero) {
  for (const auto& [norm, name] : Choices<Norm>::all()) {
    EXPECT_EQ(values_of(normalized(norm, Signal::dense({0.0F, 0.0F}))), (Values{0.0F, 0.0F}))
        << name;
    EXPECT_EQ(normalized(norm, Signal::sparse({5}, {}, {})), Signal::sparse({5}, {}, {})) << name;
  }
}

TEST(Normalization, GivesSparseSignalsTheSameElementsAsDenseOnes) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const std::vector<std::uint32_t> indices{1, 4, 6};
    Values values(3);
    for (float& value : values) value = static_cast<float>(random.normal());
    const Signal sparse = Signal::sparse({2, 4}, indices, values);
    const Signal dense = Signal::dense({2, 4}, sparse.to_dense());
    for (const auto& [norm, name] : Choices<Norm>::all()) {
      const Signal result = normalized(norm, sparse);
      EXPECT_TRUE(result.is_sparse());
      EXPECT_EQ(result.to_dense(), normalized(norm, dense).to_dense()) << name;
    }
  }
}

// In single precision the squares would overflow or vanish.
TEST(Normalization, SurvivesTheLargestAndSmallestNumbers) {
  const float largest = std::numeric_limits<float>::max();
  const float smallest = std::numeric_limits<float>::denorm_min();
  for (const float value : {largest, smallest}) {
    const Values result = values_of(normalized(Norm::kL2, Signal::dense({value, value})));
    EXPECT_FLOAT_EQ(result[0], std::sqrt(0.5F));
    EXPECT_FLOAT_EQ(result[1], std::sqrt(0.5F));
  }
}

// In single precision 2^24 swallows every further 1.
TEST(Normalization, AddsInDoublePrecision) {
  EXPECT_EQ(norm_of(Norm::kL1, Values{16777216.0F, 1.0F, 1.0F, 1.0F}), 16777219.0);
}

TEST(Normalization, HasChoicesByName) {
  EXPECT_EQ(choice_name(Norm::kNone), "none");
  EXPECT_EQ(choice_name(Norm::kL2), "l2");
  EXPECT_EQ(choice_name(Norm::kL1), "l1");
  EXPECT_EQ(choice_name(Norm::kMaximum), "maximum");
}

}  // namespace
}  // namespace somato
