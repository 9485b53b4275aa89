#include "systems/signals/frequency_bands.h"

#include <gtest/gtest.h>

#include <vector>

#include "somato/core/random.h"

namespace somato {
namespace {

SpectrumParameters bands_from(double low, std::size_t bands, BandSpacing spacing) {
  SpectrumParameters parameters;
  parameters.low = low;
  parameters.bands = bands;
  parameters.band_spacing = spacing;
  return parameters;
}

using Numbers = std::vector<double>;

TEST(FrequencyBands, AreEquallyWide) {
  EXPECT_EQ(band_edges(bands_from(0.0, 4, BandSpacing::kLinear), 10.0),
            (Numbers{0.0, 2.5, 5.0, 7.5, 10.0}));
  EXPECT_EQ(band_edges(bands_from(2.0, 1, BandSpacing::kLinear), 3.0), (Numbers{2.0, 3.0}));
}

TEST(FrequencyBands, OrHaveEqualRatios) {
  const Numbers edges = band_edges(bands_from(0.5, 4, BandSpacing::kGeometric), 8.0);
  const Numbers expected{0.5, 1.0, 2.0, 4.0, 8.0};
  ASSERT_EQ(edges.size(), expected.size());
  for (std::size_t i = 0; i < edges.size(); ++i) EXPECT_NEAR(edges[i], expected[i], 1e-14);
  EXPECT_EQ(edges.back(), 8.0);
}

const Numbers kBins{8.0, 2.0, 4.0, 16.0};

TEST(SumBetween, TakesWholeBinsBetweenTheirEdges) {
  EXPECT_EQ(sum_between(kBins, 0.5, 2.5), 6.0);
  EXPECT_EQ(sum_between(kBins, 1.5, 2.5), 4.0);
}

TEST(SumBetween, CutsBinsWhereTheEdgesLie) {
  EXPECT_EQ(sum_between(kBins, 1.0, 2.75), 1.0 + 4.0 + 4.0);
  EXPECT_EQ(sum_between(kBins, 0.25, 0.75), 2.0 + 0.5);
}

TEST(SumBetween, TakesASliceOfASingleBin) {
  EXPECT_EQ(sum_between(kBins, 1.75, 2.0), 1.0);
  EXPECT_EQ(sum_between(kBins, 2.5, 2.75), 4.0);
  EXPECT_EQ(sum_between(kBins, 2.0, 2.0), 0.0);
}

// From 0 to the highest frequency of an even transform the two ends count half, as they have no
// negative frequency beside them.
TEST(SumBetween, TakesHalfOfTheEnds) {
  EXPECT_EQ(sum_between(kBins, 0.0, 3.0), 4.0 + 2.0 + 4.0 + 8.0);
}

TEST(SumBetween, FindsNothingBeyondTheBins) {
  EXPECT_EQ(sum_between(kBins, 3.5, 9.0), 0.0);
  EXPECT_EQ(sum_between(kBins, 3.0, 9.0), 8.0);
}

TEST(SumBetween, OfNeighbouringBandsAddsUp) {
  Random random(1);
  Numbers bins(40);
  for (double& bin : bins) bin = random.uniform();
  for (int i = 0; i < 200; ++i) {
    const double low = 20.0 * random.uniform();
    const double middle = low + 10.0 * random.uniform();
    const double high = middle + 9.0 * random.uniform();
    EXPECT_NEAR(sum_between(bins, low, middle) + sum_between(bins, middle, high),
                sum_between(bins, low, high), 1e-12);
  }
}

}  // namespace
}  // namespace somato
