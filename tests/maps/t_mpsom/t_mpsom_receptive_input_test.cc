#include "maps/t_mpsom/t_mpsom_receptive_input.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "somato/core/check.h"
#include "somato/core/signal.h"

namespace somato {
namespace {

std::vector<float> dense_of(const TMpsomReceptiveInput& receptive) {
  std::vector<float> values(receptive.size(), -1.0F);
  receptive.write_dense(values);
  return values;
}

TMpsomReceptiveInput receptive_of(const Signal& signal, TMpsomNorm norm) {
  TMpsomReceptiveInput receptive(signal.size(), 16);
  receptive.take(signal.view(), norm);
  return receptive;
}

TEST(TMpsomReceptiveInput, DividesBySignalsLength) {
  for (const Signal& signal :
       {Signal::dense({0, 3, 0, -4}), Signal::sparse({4}, {1, 2, 3}, {3, 0, -4})}) {
    const TMpsomReceptiveInput receptive = receptive_of(signal, TMpsomNorm::kL2);
    EXPECT_EQ(dense_of(receptive), (std::vector<float>{0, 0.6F, 0, -0.8F}));
    EXPECT_NEAR(receptive.squared_length(), 1.0F, 1e-7F);
    const TMpsomReceptiveInput plain = receptive_of(signal, TMpsomNorm::kNone);
    EXPECT_EQ(dense_of(plain), (std::vector<float>{0, 3, 0, -4}));
    EXPECT_EQ(plain.squared_length(), 25.0F);
  }
}

TEST(TMpsomReceptiveInput, GivesElementsOfABand) {
  const TMpsomReceptiveInput receptive =
      receptive_of(Signal::sparse({9}, {1, 4, 5, 8}, {1, 2, 3, 4}), TMpsomNorm::kNone);
  const std::vector<std::vector<float>> inside{{1}, {1, 2}, {2, 3}, {}, {3, 4}, {1, 2, 3, 4}};
  const std::vector<std::pair<std::size_t, std::size_t>> bands{{0, 2}, {1, 5}, {2, 8},
                                                               {6, 8}, {5, 9}, {0, 9}};
  for (std::size_t i = 0; i < bands.size(); ++i) {
    const auto [places, values, count] = receptive.elements(bands[i].first, bands[i].second);
    EXPECT_EQ(std::vector<float>(values, values + count), inside[i]);
    for (std::size_t j = 0; j < count; ++j) {
      EXPECT_GE(places[j], bands[i].first);
      EXPECT_LT(places[j], bands[i].second);
    }
  }
}

// Parts far below the signal's length would only give denormal numbers.
TEST(TMpsomReceptiveInput, TakesNegligiblePartsForZero) {
  const Signal signal = Signal::dense({1e10F, 2e-8F, 0.5e-8F, -0.5e-8F});
  const std::vector<float> shares = dense_of(receptive_of(signal, TMpsomNorm::kL2));
  EXPECT_FLOAT_EQ(shares[1], 2e-18F);
  EXPECT_EQ(shares, (std::vector<float>{1, shares[1], 0, 0}));
  const std::vector<float> values(signal.values().begin(), signal.values().end());
  EXPECT_EQ(dense_of(receptive_of(signal, TMpsomNorm::kNone)), values);
}

TEST(TMpsomReceptiveInput, KnowsItsSignalAgain) {
  TMpsomReceptiveInput receptive = receptive_of(Signal::dense({0, 2, 0, 1}), TMpsomNorm::kL2);
  EXPECT_TRUE(receptive.is_again(Signal::sparse({4}, {1, 3}, {2, 1}).view()));
  EXPECT_FALSE(receptive.is_again(Signal::dense({0, 2, 1, 0}).view()));
  EXPECT_FALSE(receptive.is_again(Signal::dense({0, 2, 0, 0}).view()));
  EXPECT_FALSE(receptive.is_again(Signal::dense({0, std::nextafter(2.0F, 3.0F), 0, 1}).view()));
}

TEST(TMpsomReceptiveInput, ForgetsPartialActivationsWithItsSignal) {
  TMpsomReceptiveInput receptive = receptive_of(Signal::dense({0, 2}), TMpsomNorm::kL2);
  EXPECT_EQ(receptive.state(), 0U);
  receptive.set_state(7);
  EXPECT_THROW(receptive.take(Signal::dense({0, std::nanf("")}).view(), TMpsomNorm::kL2),
               InvalidArgument);
  EXPECT_EQ(receptive.state(), 7U);
  EXPECT_EQ(dense_of(receptive), (std::vector<float>{0, 1}));
  receptive.take(Signal::dense({1, 0}).view(), TMpsomNorm::kL2);
  EXPECT_EQ(receptive.state(), 0U);
}

TEST(TMpsomReceptiveInput, LeavesZerosAsTheyAre) {
  const TMpsomReceptiveInput receptive = receptive_of(Signal::dense({0, -0.0F}), TMpsomNorm::kL2);
  EXPECT_EQ(dense_of(receptive), (std::vector<float>{0, 0}));
  EXPECT_EQ(receptive.squared_length(), 0.0F);
  EXPECT_EQ(receptive.elements(0, 2).count, 0U);
}

}  // namespace
}  // namespace somato
