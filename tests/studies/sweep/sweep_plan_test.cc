#include "studies/sweep/sweep_plan.h"

#include <gtest/gtest.h>

#include "studies/sweep/sweeps.h"

namespace somato {
namespace {

using test::kDraws;
using test::kSweptSystem;
using test::planned;
using test::rate;
using test::sweep_toml;

std::string unknown(const std::string& key, const std::string& values) {
  return "[unknown.u]\nkey = '" + key + "'\ntext = 'x'\nvalues = " + values + "\n";
}

std::string setting(const ReproductionPart& part, const std::string& module,
                    const std::string& key) {
  for (const ModuleDescription& one : part.description.system.modules) {
    if (one.name != module) continue;
    const Table::Entry* entry = one.settings.find(key);
    return entry ? to_toml(std::get<Value>(entry->content)) : "";
  }
  return "no module";
}

TEST(SweepPlan, RunsWhatClaimsAreAboutAtEachPoint) {
  const auto sweep = planned(sweep_toml("one_at_a_time", unknown("module.map.rows", "[7]")));
  ASSERT_TRUE(sweep) << to_string(sweep.error());
  EXPECT_EQ(names_of(*sweep), "press");
  EXPECT_EQ(sweep->claims.size(), 2U);
  const auto points = sweep_points(sweep->sweep);
  ASSERT_EQ(points.size(), 2U);
  const auto plan = plan_of_point(*sweep, points[1]);
  ASSERT_TRUE(plan) << to_string(plan.error());
  ASSERT_EQ(plan->parts.size(), 2U);  // nothing is claimed of the third
  EXPECT_EQ(plan->parts[0].variation, "");
  EXPECT_EQ(plan->parts[1].variation, "small");
  for (const ReproductionPart& part : plan->parts) EXPECT_EQ(setting(part, "map", "rows"), "7");
  EXPECT_EQ(setting(plan->parts[1], "map", "columns"), "2");
  const auto base = plan_of_point(*sweep, points[0]);
  EXPECT_EQ(setting(base->parts[0], "map", "rows"), "5");
  EXPECT_EQ(name_of_point(sweep->sweep, points[0]), "the unchanged system");
  EXPECT_EQ(name_of_point(sweep->sweep, points[1]), "u = 7");
}

TEST(SweepPlan, GivesSeveralKeysTheSameValueAndReachesExploring) {
  const std::string two =
      "[unknown.u]\nkey = ['module.map.rows', 'module.map.columns']\ntext = 'x'\nvalues = [4]\n"
      "[unknown.n]\nkey = 'explore.press.step'\ntext = 'x'\nvalues = [0.25]\n";
  const auto sweep = planned(sweep_toml("full_factorial", two));
  ASSERT_TRUE(sweep) << to_string(sweep.error());
  EXPECT_EQ(sweep->own_values, (std::vector<std::string>{"5, \"automatic\"", "0.5"}));
  const auto plan = plan_of_point(*sweep, sweep_points(sweep->sweep)[0]);
  ASSERT_TRUE(plan) << to_string(plan.error());
  EXPECT_EQ(setting(plan->parts[0], "map", "rows"), "4");
  EXPECT_EQ(setting(plan->parts[0], "map", "columns"), "4");
  const auto explored = explore_settings(plan->parts[0].explore);
  ASSERT_EQ(explored.size(), 2U);
  EXPECT_EQ(explored[1].part, "explore.press");
  EXPECT_EQ(explored[1].settings[0].value, "0.25");
}

TEST(SweepPlan, OtherTablesOfTheSweepChangeTheSystem) {
  const std::string claim =
      "[[claim]]\ntext = 'Mine.'\nmetric = 'classes_separated'\nat_least = 1\n";
  const auto sweep =
      planned(sweep_toml("one_at_a_time", kDraws + "[module.map]\ncolumns = 6\n" + claim));
  ASSERT_TRUE(sweep) << to_string(sweep.error());
  ASSERT_EQ(sweep->claims.size(), 1U);
  EXPECT_EQ(sweep->claims[0].text, "Mine.");
  const auto plan = plan_of_point(*sweep, sweep_points(sweep->sweep)[1]);
  ASSERT_EQ(plan->parts.size(), 1U);
  EXPECT_EQ(setting(plan->parts[0], "map", "columns"), "6");
  EXPECT_EQ(setting(plan->parts[0], "map", "draws"), "\"with_replacement\"");
}

TEST(SweepPlan, ClaimsAboutAnotherSystemAreNotJudged) {
  const std::string more =
      "[[claim]]\ntext = 'Better.'\nthan_system = 'other'\nmetric = 'accuracy'\nat_least = 0\n";
  const auto sweep = planned(sweep_toml("one_at_a_time", rate()), kSweptSystem + more);
  ASSERT_TRUE(sweep) << to_string(sweep.error());
  EXPECT_EQ(sweep->claims.size(), 2U);
  EXPECT_EQ(sweep->not_judged, std::vector<std::string>{"Better."});
}

TEST(SweepPlan, AnUnknownMayBeOfOneSystem) {
  std::string other = kSweptSystem;
  other.replace(other.find("\"press\""), 7, "\"other\"");
  const auto plan_with = [&](const std::string& unknowns) {
    const auto description = test::read(sweep_toml("full_factorial", unknowns));
    return plan_sweep(description.value(),
                      {{"press", parse_toml(kSweptSystem, "press.toml").value()},
                       {"other", parse_toml(other, "other.toml").value()}},
                      {{"explore.press.step", "0.5"}});
  };
  const auto sweep = plan_with(unknown("explore.press.step", "[0.25]") +
                               "systems = ['other']\n[unknown.rows]\nkey = 'module.map.rows'\n"
                               "text = 'x'\nvalues = [4]\n");
  ASSERT_TRUE(sweep) << to_string(sweep.error());
  EXPECT_EQ(sweep->own_values, (std::vector<std::string>{"0.5", "5"}));
  const auto plan = plan_of_point(*sweep, sweep_points(sweep->sweep)[0]).value();
  ASSERT_EQ(plan.parts.size(), 4U);
  for (const ReproductionPart& part : plan.parts) {
    EXPECT_EQ(explore_settings(part.explore).size(), part.system == "other" ? 2U : 1U);
    EXPECT_EQ(setting(part, "map", "rows"), "4");
  }
  const auto unnamed = plan_with(unknown("module.map.rows", "[3]") + "systems = ['othr']\n");
  ASSERT_FALSE(unnamed);
  EXPECT_EQ(unnamed.error().where, "sweep.toml:3");
  EXPECT_NE(to_string(unnamed.error()).find("did you mean 'other'?"), std::string::npos);
}

TEST(SweepPlan, RefusesKeysThatTheSystemDoesNotHave) {
  const auto refused = [](const std::string& key, const std::string& says) {
    const auto sweep = planned(sweep_toml("one_at_a_time", unknown(key, "[1]")));
    ASSERT_FALSE(sweep) << key;
    EXPECT_EQ(sweep.error().kind, ErrorKind::kUsage);
    EXPECT_EQ(sweep.error().where, "sweep.toml:3");
    EXPECT_NE(to_string(sweep.error()).find(says), std::string::npos) << to_string(sweep.error());
  };
  refused("module.mpa.rows", "did you mean 'map'?");
  refused("module.map.row", "did you mean 'rows'?");
  refused("module.map", "unknown module 'map'");
  refused("explore.press.stp", "did you mean 'explore.press.step'?");
  refused("study.seeds", "not a key of a module or of the exploration");
  refused("rows", "not a key of a module or of the exploration");
}

TEST(SweepPlan, RefusesQuestionsAndSystemsWithoutClaims) {
  const auto question =
      planned(sweep_toml("one_at_a_time", rate()), "[question]\nname = 'q'\nsystems = ['a']\n");
  ASSERT_FALSE(question);
  EXPECT_EQ(question.error().where, "press.toml:1");
  const auto claimless = planned(sweep_toml("one_at_a_time", rate()),
                                 kSweptSystem.substr(0, kSweptSystem.find("[variation")));
  ASSERT_FALSE(claimless);
  EXPECT_NE(claimless.error().what.find("has no claims"), std::string::npos);
}

TEST(SweepPlan, ValuesThatAModuleRefusesAreRefusedAtTheUnknown) {
  const auto sweep = planned(sweep_toml("one_at_a_time", unknown("module.map.rows", "[3, 0]")));
  ASSERT_TRUE(sweep) << to_string(sweep.error());
  const auto points = sweep_points(sweep->sweep);
  EXPECT_TRUE(plan_of_point(*sweep, points[1]));
  const auto plan = plan_of_point(*sweep, points[2]);
  ASSERT_FALSE(plan);
  EXPECT_TRUE(plan.error().where.starts_with("sweep.toml:3")) << plan.error().where;
  EXPECT_NE(plan.error().what.find("'rows'"), std::string::npos) << plan.error().what;
}

}  // namespace
}  // namespace somato
