#include "studies/inference/inference.h"

#include <gtest/gtest.h>

#include <map>

#include "studies/inference/inferences.h"

namespace somato {
namespace {

using test::kTarget;
using test::rates_as_accuracies;
using test::targets_of;

TEST(Inference, ASimulationIsAPairOfAPoint) {
  const Targets targets = targets_of(kTarget).value();
  SweepResults results = rates_as_accuracies(16, targets);
  results.points[3].measured[0].reset();
  const Simulations all = simulations_of(results);
  ASSERT_EQ(all.draw.size(), 32U);
  EXPECT_EQ(all.draw[5], 2U);
  EXPECT_EQ(all.is_continuous, (std::vector<bool>{true, false}));
  for (std::size_t i = 0; i < 32; ++i) {
    const auto& point = results.points[i / 2];
    EXPECT_NEAR(all.places(i, 0) * 0.8 + 0.1, std::get<double>(point.point[0]->value.content),
                1e-12);
    EXPECT_EQ(all.places(i, 1), point.point[1]->cell == 0 ? 0.25 : 0.75);
    if (i / 2 == 3) {
      EXPECT_TRUE(std::isnan(all.statistics(i, 0)));
    } else {
      EXPECT_EQ(all.statistics(i, 0), point.measured[0]->values[i % 2]);
    }
  }
}

// The accuracy is the rate with a deviation of 0.02, of a range of 0.8.
TEST(Inference, FindsTheSettingThatGivesTheObservation) {
  const Targets targets =
      targets_of("[inference]\naccepted = 0.1\ntruths = 60\n" + kTarget).value();
  const auto found = infer(rates_as_accuracies(256, targets), targets);
  ASSERT_TRUE(found) << to_string(found.error());
  EXPECT_EQ(found->posterior.size(), 52U);  // a tenth of 512, rounded up
  EXPECT_NEAR(found->unknowns[0].posterior.mean * 0.8 + 0.1, 0.5, 0.01);
  EXPECT_NEAR(found->unknowns[0].posterior.deviation * 0.8, 0.02, 0.008);
  EXPECT_LT(found->unknowns[0].shrinkage(), 0.15);
  EXPECT_GT(found->unknowns[1].shrinkage(), 0.8) << "the order of drawing has no effect";
  EXPECT_NEAR(found->predicted[0], 0.5, 0.02);
  EXPECT_EQ(found->unknowns[1].prior_shares, (std::vector<double>{0.5, 0.5}));
  EXPECT_NEAR(found->unknowns[0].posterior_shares[3] + found->unknowns[0].posterior_shares[4], 1.0,
              1e-9)
      << "0.5 is the border of the two middle parts of eight";
  EXPECT_GT(found->calibration.uniform_p[0], 0.01);
}

TEST(Inference, RefusesTargetsThatNothingMeasures) {
  const Targets targets = targets_of(kTarget +
                                     "[[target]]\ntext = 'Never.'\nsystem = 'press'\n"
                                     "metric = 'classes_separated'\nobserved = 1\nscale = 1\n")
                              .value();
  const auto found = infer(rates_as_accuracies(8, targets), targets);
  ASSERT_FALSE(found);
  EXPECT_NE(to_string(found.error()).find("'Never.'"), std::string::npos)
      << to_string(found.error());
  EXPECT_EQ(found.error().where, "targets.toml:7");
}

TEST(Inference, PosteriorPointsFollowTheWeights) {
  const auto sweep = test::planned(test::swept_at_once(8)).value().sweep;
  Posterior posterior{
      {0, 1, 2}, {0.5, 0.3, 0.2}, Matrix<double>(3, 2, {0.0, 0.25, 0.5, 0.25, 1.0, 0.75})};
  std::map<double, int> counts;
  const auto points = posterior_points(sweep, posterior, 20, 3);
  ASSERT_EQ(points.size(), 20U);
  for (const SweepPoint& point : points) ++counts[std::get<double>(point[0]->value.content)];
  EXPECT_EQ(counts, (std::map<double, int>{{0.1, 10}, {0.5, 6}, {0.9, 4}}));
  EXPECT_EQ(to_toml(points.back()[1]->value), "\"without_replacement\"");
}

// Places of the posterior become settings, and settings places, without loss.
TEST(Inference, PlacesAndSettingsAgree) {
  const std::string whole =
      "[unknown.rows]\nkey = 'module.map.rows'\ntext = 'x'\nlow = 3\nhigh = 9\nwhole = true\n";
  const std::string logarithmic = test::rate("scale = 'logarithmic'\n");
  SweepResults results{
      test::planned("[sweep]\ndesign = 'sobol'\npoints = 64\n" + whole + logarithmic + test::kDraws)
          .value(),
      {}};
  for (const SweepPoint& point : sweep_points(results.sweep.sweep))
    results.points.push_back({point, {}, {}, {}});
  for (SweepPointResults& point : results.points) {
    ClaimOutcome outcome;
    outcome.values = {1.0};
    point.claims = {outcome};
  }
  const Simulations all = simulations_of(results);
  ASSERT_EQ(all.draw.size(), 64U);
  EXPECT_EQ(all.is_continuous, (std::vector<bool>{false, true, false}));
  for (std::size_t i = 0; i < 64; ++i) {
    const auto places = all.places.row(i);
    const SweepPoint again = point_at(results.sweep.sweep, {places.begin(), places.end()});
    EXPECT_EQ(again[0]->value, results.points[i].point[0]->value);
    EXPECT_NEAR(std::get<double>(again[1]->value.content),
                std::get<double>(results.points[i].point[1]->value.content), 1e-9);
    EXPECT_EQ(again[2]->value, results.points[i].point[2]->value);
  }
}

}  // namespace
}  // namespace somato
