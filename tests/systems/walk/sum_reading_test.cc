#include "systems/walk/sum_reading.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

Som two_neurons() {
  SomParameters parameters;
  parameters.rows = 1;
  parameters.columns = 2;
  return {parameters, Matrix<float>(2, 2, {1, 0, 0, 1})};
}

void add(SumReading& sum, float first, float second) {
  const Signal frame = Signal::sparse({2}, {0, 1}, {first, second});
  sum.add(frame.view());
}

TEST(SumReading, FindsTheNeuronThatIsMostSimilarToTheSum) {
  const Som som = two_neurons();
  for (const Norm norm : {Norm::kNone, Norm::kL1, Norm::kL2}) {
    SumReading sum(som, norm);
    sum.start();
    add(sum, 0.25F, 0.0F);
    EXPECT_EQ(sum.winner(), 0U);
    add(sum, 0.0F, 0.5F);
    EXPECT_EQ(sum.winner(), 1U);
    sum.start();
    add(sum, 0.25F, 0.0F);
    EXPECT_EQ(sum.winner(), 0U);
  }
}

// In single precision 0.1 + 0.1 + 0.1 and 0.3 are the same number, in double precision they are
// not.
TEST(SumReading, GivesNoWinnerWhereRoundingOfTheSumDecides) {
  const Som som = two_neurons();
  SumReading sum(som, Norm::kL2);
  sum.start();
  for (int i = 0; i < 3; ++i) add(sum, 0.1F, i == 0 ? 0.3F : 0.0F);
  ASSERT_EQ(static_cast<float>(3.0 * double{0.1F}), 0.3F);
  ASSERT_LT(3.0 * double{0.1F}, double{0.3F});
  EXPECT_FALSE(sum.winner());
  add(sum, 0.001F, 0.0F);
  EXPECT_EQ(sum.winner(), 0U);
}

}  // namespace
}  // namespace somato
