#include "maps/som/map_rows.h"

#include <gtest/gtest.h>

#include <cmath>

namespace somato {
namespace {

TEST(MapRows, AreScaledToLengthOneExceptZeros) {
  LaneMatrix<float> weights(3, 2);
  weights(0, 0) = 3.0F;
  weights(0, 1) = 4.0F;
  weights(2, 1) = -0.5F;
  AlignedVector<float> factors;
  normalize_rows(weights, factors);
  EXPECT_FLOAT_EQ(weights(0, 0), 0.6F);
  EXPECT_FLOAT_EQ(weights(0, 1), 0.8F);
  EXPECT_EQ(weights(1, 0), 0.0F);
  EXPECT_FLOAT_EQ(weights(2, 1), -1.0F);
}

TEST(MapRows, KnowWhichElementsHaveWeights) {
  SomParameters parameters;
  parameters.rows = 1;
  parameters.columns = 1;
  const Som som(parameters, LaneMatrix<float>(1, 2), StoredElements(5, {1, 3}));
  const auto samples = [](std::uint32_t element) {
    return Samples::from_signals({Signal::sparse({5}, {element}, {1.0F})});
  };
  EXPECT_TRUE(has_weights_for(som, samples(3)));
  EXPECT_FALSE(has_weights_for(som, samples(4)));
}

}  // namespace
}  // namespace somato
