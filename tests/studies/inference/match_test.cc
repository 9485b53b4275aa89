#include "studies/inference/match.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "somato/core/random.h"
#include "studies/inference/inference_results.h"
#include "studies/inference/match_predictors.h"
#include "studies/inference/touches.h"
#include "studies/sweep/sweep_points.h"

namespace somato {
namespace {

using test::synthetic_recording;
using test::SyntheticBody;

// The level and the noise are unknown; a third setting has no effect.
SystemSweep unknown_body(std::size_t points) {
  const std::string toml = "[sweep]\ndesign = 'sobol'\npoints = " + std::to_string(points) +
                           "\n[unknown.level]\nkey = 'explore.level'\nlow = 0.0\nhigh = 5.0\n"
                           "text = 'x'\n[unknown.noise]\nkey = 'explore.noise'\nlow = 0.01\n"
                           "high = 1.0\nscale = 'logarithmic'\ntext = 'x'\n[unknown.other]\nkey = "
                           "'explore.other'\nvalues = [1, 2]\ntext = 'x'\n";
  const Table body = parse_toml("[explore]\nlevel = 1.0\nnoise = 0.5\nother = 1\n", "b").value();
  return plan_body_sweep(read_sweep(parse_toml(toml, "over.toml").value()).value(),
                         {"body", body, {}}, {})
      .value();
}

SyntheticBody body_at(const SweepPoint& point) {
  return {.level = std::get<double>(point[0]->value.content),
          .noise = std::get<double>(point[1]->value.content)};
}

Matrix<double> simulated_at(const MatchedTouch& touch, const std::vector<SweepPoint>& points,
                            std::uint64_t seed) {
  Matrix<double> rows(0, touch.names.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto statistics =
        simulated_statistics(touch, synthetic_recording(body_at(points[i]), 2, 3, seed + i));
    std::ranges::copy(*statistics, rows.add_row().begin());
  }
  return rows;
}

Result<Match> matched(const Recording& real, std::size_t points,
                      const InferenceParameters& parameters = {.accepted = 0.2}) {
  MatchDraws draws{unknown_body(points), {}, {}, {}};
  draws.points = sweep_points(draws.sweep.sweep);
  SOMATO_TRY(auto touch, matched_touch(real, synthetic_recording({}, 2, 2, 5), {}));
  draws.statistics = simulated_at(touch, draws.points, 100);
  return match_touch(std::move(touch), std::move(draws), parameters);
}

double number_at(const Match& match, std::size_t unknown, double place) {
  return std::get<double>(value_at_place(match.draws.sweep.sweep, unknown, place).content);
}

TEST(Match, FindsHiddenSettings) {
  Match match = matched(synthetic_recording({.level = 3.0, .noise = 0.2}, 2, 6, 1), 128).value();
  EXPECT_EQ(match.touch.fitted_explorations, 6U);
  EXPECT_EQ(match.touch.held_out_explorations, 6U);
  const auto& unknowns = match.inference.unknowns;
  EXPECT_NEAR(number_at(match, 0, unknowns[0].posterior.median), 3.0, 0.1);
  EXPECT_NEAR(number_at(match, 1, unknowns[1].posterior.median), 0.2, 0.05);
  EXPECT_LT(unknowns[0].shrinkage(), 0.25);
  EXPECT_LT(unknowns[1].shrinkage(), 0.4);
  EXPECT_GT(unknowns[2].shrinkage(), 0.9) << "it has no effect";
  EXPECT_TRUE(match.inference.posterior.is_adjusted);
  // On explorations that were held out, settings of the posterior are nearer than the prior.
  match.bodies = posterior_points(match.draws.sweep.sweep, match.inference.posterior, 5, 9);
  match.fresh = simulated_at(match.touch, match.bodies, 900);
  const TouchDistance after = mean_distance(match, match.fresh);
  std::vector<double> medians;
  std::vector<double> roots;
  for (const TouchDistance& distance : match.of_draws) {
    medians.push_back(distance.median);
    roots.push_back(distance.root_mean_square);
  }
  std::sort(medians.begin(), medians.end());
  std::sort(roots.begin(), roots.end());
  EXPECT_LT(after.median, medians[64]) << "of the median draw";
  EXPECT_LT(after.root_mean_square, 0.5 * roots[64]);
  EXPECT_LT(after.median, 2.0);
  EXPECT_GT(after.within_two, 0.7);
}

// The intervals are right: of 20 bodies, 14 to 20 lie in the central 90 % (0.9 ± 3 deviations).
TEST(Match, ChecksItsIntervals) {
  const Match match = matched(synthetic_recording({}, 2, 4, 1), 128).value();
  for (const double covered : match.inference.calibration.covered) EXPECT_GE(covered, 0.7);
}

TEST(Match, DistancesAreDifferencesOverScales) {
  Match match;
  match.touch.held_out = {1.0, 2.0, 3.0, 4.0};
  match.touch.scales = {1.0, 2.0, 1.0, 1.0};
  match.left_out = {"", "", "", "constant"};
  const std::vector<double> statistics{2.0, 8.0, std::nan(""), 100.0};
  const TouchDistance distance = distance_from_held_out(match, statistics);
  EXPECT_DOUBLE_EQ(distance.median, 2.0);  // of 1 and 3
  EXPECT_DOUBLE_EQ(distance.root_mean_square, std::sqrt(5.0));
  EXPECT_DOUBLE_EQ(distance.within_two, 0.5);
  match.left_out = {"x", "x", "x", "x"};
  EXPECT_TRUE(std::isnan(distance_from_held_out(match, statistics).median));
}

TEST(Match, SaysWhatNoDrawReaches) {
  const Match match =
      matched(synthetic_recording({.level = 50.0, .noise = 0.2}, 2, 4, 1), 64).value();
  EXPECT_TRUE(match.out_of_reach[0]) << "the mean";
  EXPECT_GT(match.inference.unknowns[0].shrinkage(), 0.5) << "nothing else says the level";
  EXPECT_NEAR(number_at(match, 1, match.inference.unknowns[1].posterior.median), 0.2, 0.15);
}

// A match of two statistics that are given by the places of level and noise, and others.
class GivenStatistics {
 public:
  explicit GivenStatistics(std::size_t points) : draws_{unknown_body(points), {}, {}, {}} {
    draws_.points = sweep_points(draws_.sweep.sweep);
    draws_.statistics = Matrix<double>(points, 0);
  }

  template <typename Values>
  void add(double fitted, const Values& values) {
    touch_.names.push_back({"touch", "statistic " + std::to_string(touch_.names.size()), ""});
    touch_.fitted.push_back(fitted);
    touch_.held_out.push_back(fitted);
    touch_.scales.push_back(1.0);
    Matrix<double> wider(draws_.points.size(), touch_.names.size());
    for (std::size_t i = 0; i < wider.rows(); ++i) {
      std::ranges::copy(draws_.statistics.row(i), wider.row(i).begin());
      const auto places = places_in_prior(draws_.sweep.sweep, draws_.points[i]);
      wider(i, touch_.names.size() - 1) = values(i, places[0], places[1]);
    }
    draws_.statistics = std::move(wider);
  }

  void play_movements(std::size_t count) {
    for (std::size_t i = 0; i < draws_.points.size(); ++i)
      draws_.movements.push_back(i * count / draws_.points.size());
  }

  Match match(bool adjusted = true) const {
    return match_touch(touch_, draws_, {.accepted = 0.2, .adjusted = adjusted}).value();
  }

 private:
  MatchedTouch touch_;
  MatchDraws draws_;
};

void add_sum_and_difference(GivenStatistics& given, double level, double noise) {
  given.add(level + noise, [](std::size_t, double a, double b) { return a + b; });
  given.add(level - noise, [](std::size_t, double a, double b) { return a - b; });
}

TEST(Match, IsNotChangedByStatisticsThatTheUnknownsDoNotChange) {
  GivenStatistics given(128);
  given.play_movements(4);
  add_sum_and_difference(given, 0.3, 0.6);
  const Match before = given.match();
  Random random(5);
  for (int k = 0; k < 300; ++k) {
    // The movements have effects of about 1000 noises.
    std::vector<double> effects;
    for (int m = 0; m < 4; ++m) effects.push_back(1000.0 * random.normal());
    given.add(effects[static_cast<std::size_t>(k) % 4],
              [&](std::size_t i, double, double) { return effects[i / 32] + random.normal(); });
  }
  const Match after = given.match();
  for (std::size_t k = 2; k < after.explained.size(); ++k)
    EXPECT_LT(after.explained[k], kLeastExplained);
  EXPECT_EQ(after.inference.posterior.simulations, before.inference.posterior.simulations);
  EXPECT_EQ(after.inference.posterior.places, before.inference.posterior.places);
  EXPECT_NEAR(after.inference.unknowns[0].posterior.mean, 0.3, 0.05);
  EXPECT_NEAR(after.inference.unknowns[1].posterior.mean, 0.6, 0.05);
}

// Four movements add 0.3 times a normal number to each of 12 statistics of the level. A combination
// of 12 statistics that does not depend on four known movements has hardly an error if only draws
// are left out. On a movement that is not known it has one.
TEST(Match, DoesNotRecognizeMovements) {
  GivenStatistics given(128);
  given.play_movements(4);
  Random random(7);
  for (int k = 0; k < 12; ++k) {
    std::vector<double> effects;
    for (int m = 0; m < 4; ++m) effects.push_back(0.3 * random.normal());
    given.add(0.5, [&](std::size_t i, double level, double) { return level + effects[i / 32]; });
  }
  const Match match = given.match();
  EXPECT_GT(match.summaries[0].error, 0.015);
  EXPECT_EQ(match.inference.simulations.group[127], 3U);
}

// The level at the place 1.3 of its prior gives values that some draws reach, each by itself.
TEST(Match, ReportsAnObservationOutsideOfTheDraws) {
  GivenStatistics given(128);
  add_sum_and_difference(given, 1.3, 0.5);
  const Match match = given.match();
  EXPECT_FALSE(match.out_of_reach[0] || match.out_of_reach[1]);
  EXPECT_EQ(match.outside, std::vector<std::string>{"level"});
  EXPECT_NE(match.not_adjusted.find("beyond all draws in what predicts level"), std::string::npos);
  EXPECT_FALSE(match.inference.posterior.is_adjusted);
  const auto json = nlohmann::json::parse(to_json(match));
  EXPECT_EQ(json["adjusted"], false);
  EXPECT_EQ(json["not_adjusted"], match.not_adjusted);
  EXPECT_EQ(json["unknowns"][0]["outside"], true);
  EXPECT_EQ(json["unknowns"][1]["outside"], false);
  const Match not_wanted = given.match(false);
  EXPECT_EQ(not_wanted.not_adjusted, "");
  EXPECT_FALSE(not_wanted.inference.posterior.is_adjusted);
}

TEST(Match, KeepsThePriorWithoutInformation) {
  GivenStatistics given(64);
  Random random(6);
  for (int k = 0; k < 3; ++k)
    given.add(0.0, [&](std::size_t, double, double) { return random.normal(); });
  const Match match = given.match();
  EXPECT_EQ(match.inference.posterior.size(), 64U) << "all draws are at the same distance";
  EXPECT_EQ(match.inference.unknowns[0].shrinkage(), 1.0);
}

TEST(Match, LeavesOutStatisticsThatCannotBeCompared) {
  Recording real = synthetic_recording({.level = 3.0, .noise = 0.2}, 2, 4, 1);
  for (Exploration& exploration : real.explorations) {
    for (float& value : exploration.channels[1].frames.values()) value = 0.0F;
  }
  const Match match = matched(real, 64).value();
  std::size_t constant = 0;
  for (std::size_t k = 0; k < match.left_out.size(); ++k) {
    if (match.touch.names[k].channel == "sound" && match.left_out[k].ends_with("recording"))
      ++constant;
    EXPECT_TRUE(match.left_out[k].empty() ||
                match.touch.names[k].channel.find("sound") != std::string::npos);
  }
  EXPECT_GT(constant, 10U);
  for (Exploration& exploration : real.explorations)
    exploration.channels.erase(exploration.channels.begin());
  const auto nothing = matched(real, 64);
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().kind, ErrorKind::kData);
}

TEST(Match, BearsMissingValues) {
  Recording real = synthetic_recording({.level = 3.0, .noise = 0.2}, 2, 4, 1);
  for (Exploration& exploration : real.explorations) {
    Channel& touch = exploration.channels[0];
    touch.valid = Matrix<std::uint8_t>(8, 3, 1);
    for (std::size_t i = 0; i < 8; ++i) touch.valid(i, 1) = 0;  // a sensor that failed
    for (std::size_t i = 0; i < 8; ++i) touch.frames(i, 1) = 0.0F;
  }
  const Match match = matched(real, 64).value();
  EXPECT_EQ(match.left_out[3], "it cannot be measured in the recording");  // mean of element 2
  EXPECT_TRUE(match.left_out[2].empty());
}

TEST(Match, RequiresTwoExplorationsInEachHalf) {
  const auto match = matched(synthetic_recording({}, 1, 1, 1), 16);
  ASSERT_FALSE(match);
  EXPECT_EQ(match.error().kind, ErrorKind::kData);
  EXPECT_NE(match.error().what.find("1 explorations to fit and 0 to check"), std::string::npos);
}

TEST(Match, IsWrittenAsJson) {
  Match match = matched(synthetic_recording({}, 2, 4, 1), 32).value();
  match.bodies = posterior_points(match.draws.sweep.sweep, match.inference.posterior, 2, 9);
  match.fresh = simulated_at(match.touch, match.bodies, 900);
  match.system = simulated_at(match.touch, {match.bodies[0]}, 950);
  const auto json = nlohmann::json::parse(to_json(match));
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["body"], "body");
  EXPECT_EQ(json["draws"], 32);
  EXPECT_EQ(json["compared"]["things"], nlohmann::json::array({"a", "b"}));
  EXPECT_EQ(json["statistics"].size(), match.touch.names.size());
  EXPECT_EQ(json["statistics"][0]["system"], match.system(0, 0));
  EXPECT_EQ(json["unknowns"][0]["system"], "1.0");
  EXPECT_EQ(json["unknowns"].size(), 3U);
  EXPECT_EQ(json["bodies"][1].size(), 3U);
  for (const char* name : {"real", "system", "prior", "nearest_twentieth", "posterior"}) {
    EXPECT_TRUE(json["distances"][name]["median"].is_number()) << name;
  }
}

}  // namespace
}  // namespace somato
