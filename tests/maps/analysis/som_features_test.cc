#include "somato/maps/som_features.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "maps/support/random_maps.h"
#include "somato/core/check.h"
#include "somato/maps/som_quality.h"
#include "somato/maps/som_training.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

double value_of(const Samples& samples, std::size_t i, std::size_t d) {
  return double{Signal::copy_of(samples[i]).to_dense()[d]};
}

// By the definition, in two passes.
FeatureMeasures feature_by_definition(const Som& som, const Samples& samples,
                                      const Numbers& winners, std::size_t d) {
  const auto count = static_cast<double>(samples.count());
  FeatureMeasures of;
  for (std::size_t i = 0; i < samples.count(); ++i) of.mean += value_of(samples, i, d) / count;
  double squares = 0.0;
  double residuals = 0.0;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    squares += std::pow(value_of(samples, i, d) - of.mean, 2);
    residuals += std::pow(value_of(samples, i, d) - double{som.weight(winners[i], d)}, 2);
  }
  of.deviation = std::sqrt(squares / count);
  of.explained_variance = 1.0 - residuals / squares;
  return of;
}

TEST(FeatureMeasurement, IsAsDefinedForDenseAndSparseSamplesInParts) {
  Random random(41);
  for (const bool sparse : {false, true}) {
    const Samples samples = testing::random_samples(50, 7, sparse, random);
    SomParameters p;
    p.rows = 3;
    p.columns = 3;
    p.iterations = 100;
    const Som som = train_som(p, samples).value();
    const Numbers winners = measure_quality(som, samples).winners;
    FeatureMeasurement measurement(som, 2);
    for (std::size_t first = 0; first < 50; first += 25) {
      Numbers part(25);
      for (std::size_t i = 0; i < 25; ++i) part[i] = first + i;
      measurement.add(samples.subset(part), std::span(winners).subspan(first, 25));
    }
    const std::vector<FeatureMeasures> found = measurement.features();
    for (std::size_t d = 0; d < 7; ++d) {
      const FeatureMeasures expected = feature_by_definition(som, samples, winners, d);
      EXPECT_NEAR(found[d].mean, expected.mean, 1e-12);
      EXPECT_NEAR(found[d].deviation, expected.deviation, 1e-12);
      EXPECT_NEAR(found[d].explained_variance, expected.explained_variance, 1e-10);
    }
  }
}

Som neurons_at_0_and_10() {
  SomParameters p;
  p.rows = 1;
  p.columns = 2;
  return Som(resolve(p, 4, 3).value(), Matrix<float>(2, 3, {0, 0, 5, 10, 0, 5}));
}

// Column 0 is -1, 1, 9, 11; column 1 is 2, 0, 0, 2; column 2 is constant.
TEST(FeatureMeasurement, ComparesGroupsWithAll) {
  const Samples samples(Matrix<float>(4, 3, {-1, 2, 5, 1, 0, 5, 9, 0, 5, 11, 2, 5}));
  const Som som = neurons_at_0_and_10();
  FeatureMeasurement measurement(som, 1, {0, 7}, 2);
  const Numbers winners{0, 0, 1, 1};
  measurement.add(samples, winners);
  const std::vector<FeatureDifference> differences = measurement.differences(0);
  ASSERT_EQ(differences.size(), 3U);
  EXPECT_EQ(differences[0].feature, 0U);
  EXPECT_DOUBLE_EQ(differences[0].difference, -5.0 / std::sqrt(26.0));
  EXPECT_EQ(differences[1].feature, 1U);
  EXPECT_EQ(differences[1].difference, 0.0);
  EXPECT_EQ(differences[2].difference, 0.0);
  EXPECT_TRUE(measurement.differences(1).empty());
  EXPECT_THROW((void)measurement.differences(2), InvalidArgument);
  EXPECT_DOUBLE_EQ(measurement.features()[0].explained_variance, 1.0 - 4.0 / 104.0);
  EXPECT_TRUE(std::isnan(measurement.features()[2].explained_variance));
  EXPECT_DOUBLE_EQ(measurement.explained_variance(), 1.0 - 12.0 / 108.0);
}

// Known in column 0: -1, 1, 11; in column 1: 2 of the first neuron, 2 of the second.
TEST(FeatureMeasurement, LeavesMissingValuesOut) {
  const float missing = std::numeric_limits<float>::quiet_NaN();
  const Samples samples(
      Matrix<float>(4, 3, {-1, 2, missing, 1, missing, missing, missing, missing, 5, 11, 2, 5}));
  const Som som = neurons_at_0_and_10();
  FeatureMeasurement measurement(som, 1, {0, 1}, 2);
  const Numbers winners{0, 0, 1, 1};
  measurement.add(samples, winners);
  const std::vector<FeatureMeasures> features = measurement.features();
  EXPECT_DOUBLE_EQ(features[0].mean, 11.0 / 3.0);
  EXPECT_DOUBLE_EQ(features[0].explained_variance, 1.0 - 3.0 / (123.0 - 121.0 / 3.0));
  EXPECT_EQ(features[1].mean, 2.0);
  EXPECT_TRUE(std::isnan(features[1].explained_variance));
  const std::vector<FeatureDifference> differences = measurement.differences(0);
  ASSERT_EQ(differences.size(), 2U) << "column 2 is known in no sample of the group";
  EXPECT_EQ(differences[0].feature, 0U);
  EXPECT_DOUBLE_EQ(differences[0].difference, (0.0 - features[0].mean) / features[0].deviation);
}

// Differences of 1 around a million, which a sum of squares in single precision would lose.
TEST(FeatureMeasurement, KeepsSmallVariancesAroundLargeMeans) {
  SomParameters p;
  p.rows = 1;
  p.columns = 1;
  const Som som(resolve(p, 2, 1).value(), Matrix<float>(1, 1, 1e6F));
  FeatureMeasurement measurement(som);
  const Numbers winners(1000, 0);
  Matrix<float> rows(1000, 1);
  for (std::size_t i = 0; i < 1000; ++i) rows(i, 0) = 1e6F + static_cast<float>(i % 2);
  measurement.add(Samples(rows), winners);
  EXPECT_NEAR(measurement.features()[0].deviation, 0.5, 1e-9);
  EXPECT_NEAR(measurement.explained_variance(), -1.0, 1e-9);
}

TEST(FeatureMeasurement, RefusesOtherSizes) {
  const Som som = neurons_at_0_and_10();
  FeatureMeasurement measurement(som);
  const Numbers one{0};
  EXPECT_THROW(measurement.add(Samples(Matrix<float>(2, 3)), one), InvalidArgument);
  EXPECT_THROW(measurement.add(Samples(Matrix<float>(1, 2)), one), InvalidArgument);
  EXPECT_THROW(FeatureMeasurement(som, 1, {0}, 1), InvalidArgument);
  EXPECT_TRUE(std::isnan(measurement.features()[0].mean));
}

Som with_planes(const std::vector<std::vector<float>>& planes) {
  SomParameters p;
  p.rows = 1;
  p.columns = planes.front().size();
  Matrix<float> weights(*p.columns, planes.size());
  for (std::size_t d = 0; d < planes.size(); ++d) {
    for (std::size_t i = 0; i < *p.columns; ++i) weights(i, d) = planes[d][i];
  }
  return Som(resolve(p, 1, planes.size()).value(), weights);
}

// 0 and 3 are proportional, 1 and 4 too; 2 is constant.
TEST(PlaneOrder, PutsSimilarPlanesBesideEachOther) {
  const Som som = with_planes({{1, 2, 3, 4},
                               {1, -1, 1, -1},
                               {7, 7, 7.000001F, 7},
                               {10, 20, 30, 41},
                               {100, -100, 100, -101}});
  const PlaneOrder order = order_planes(som);
  EXPECT_EQ(order.order, (Numbers{0, 3, 1, 4, 2}));
  EXPECT_EQ(order.group_of_feature, (Numbers{0, 1, 2, 0, 1}));
  EXPECT_EQ(order.groups, 3U);
}

TEST(PlaneOrder, OfOneNeuronIsThatOfTheFeatures) {
  const PlaneOrder order = order_planes(with_planes({{1}, {2}, {3}}));
  EXPECT_EQ(order.order, (Numbers{0, 1, 2}));
  EXPECT_EQ(order.groups, 1U);
  EXPECT_EQ(order_planes(with_planes({{1, 2}})).groups, 1U);
}

}  // namespace
}  // namespace somato
