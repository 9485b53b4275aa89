#include "studies/inference/targets.h"

#include <gtest/gtest.h>

#include "studies/inference/inferences.h"

namespace somato {
namespace {

using test::kTarget;
using test::planned;
using test::swept_at_once;
using test::targets_of;

std::string refusal(const Result<Targets>& targets) {
  return targets ? "nothing" : to_string(targets.error());
}

void expect_in(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << part << "\n is not in\n" << text;
}

TEST(Targets, AreReadWithTheirRule) {
  const auto read =
      targets_of("[inference]\naccepted = 0.2\nadjusted = false\nbodies = 3\n" + kTarget);
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(read->rule().share, 0.2);
  EXPECT_FALSE(read->rule().adjusted);
  EXPECT_EQ(read->inference.bodies, 3U);
  EXPECT_EQ(read->observation().values, (std::vector<double>{0.5}));
  EXPECT_EQ(read->observation().scales, (std::vector<double>{0.1}));
  EXPECT_EQ(read->targets[0].where, "targets.toml:5");
}

TEST(Targets, RefuseWhatIsMissingOrWrong) {
  const auto without = [](const std::string& line) {
    std::string text = kTarget;
    return text.erase(text.find(line), line.size());
  };
  expect_in(refusal(targets_of("")), "there are no targets");
  expect_in(refusal(targets_of(without("text = 'Half are named.'\n"))), "targets.toml:1");
  expect_in(refusal(targets_of(without("system = 'press'\n"))), "has no system");
  expect_in(refusal(targets_of(without("metric = 'accuracy'\n"))), "has no metric");
  expect_in(refusal(targets_of(without("observed = 0.5\n"))), "has no observed value");
  expect_in(refusal(targets_of(without("scale = 0.1\n"))), "has no scale");
  expect_in(refusal(targets_of(kTarget + "protocol = 'none'\n")), "protocol");
  expect_in(refusal(targets_of(kTarget + "obsrved = 1\n")), "did you mean 'observed'?");
  expect_in(refusal(targets_of(kTarget + kTarget)), "the same measure as 'Half are named.'");
  expect_in(refusal(targets_of("[sweep]\n" + kTarget)), "unknown table 'sweep'");
  expect_in(refusal(targets_of("inference = 1\n" + kTarget)), "must be a table");
  std::string wrong = kTarget;
  wrong.replace(wrong.find("0.1"), 3, "0.0");
  expect_in(refusal(targets_of(wrong)), "above 0");
}

TEST(Targets, AreMeasuredAtEveryPoint) {
  auto sweep = planned(swept_at_once(8)).value();
  const Targets targets = targets_of(kTarget).value();
  ASSERT_TRUE(add_targets(targets, sweep));
  ASSERT_EQ(sweep.measured.size(), 1U);
  EXPECT_EQ(sweep.measured[0].metric, "accuracy");
  EXPECT_TRUE(is_about(sweep.claims[0], targets.targets[0]));
  EXPECT_TRUE(is_about(sweep.claims[1], targets.targets[0])) << "it compares a variation with it";
}

// A variation without claims is run if a target is about it.
TEST(Targets, BringVariationsIntoThePlan) {
  auto sweep = planned(swept_at_once(8)).value();
  const SweepPoint point = sweep_points(sweep.sweep)[1];
  EXPECT_EQ(plan_of_point(sweep, point)->parts.size(), 2U);
  ASSERT_TRUE(add_targets(targets_of(kTarget + "variation = 'not_requested'\n").value(), sweep));
  EXPECT_EQ(plan_of_point(sweep, point)->parts.size(), 3U);
}

TEST(Targets, RefuseSystemsDesignsAndSeedsThatDoNotFit) {
  const auto added = [](const std::string& sweep, const std::string& targets) -> std::string {
    auto plan = planned(sweep).value();
    const auto right = add_targets(targets_of(targets).value(), plan);
    return right ? "nothing" : to_string(right.error());
  };
  std::string other = kTarget;
  other.replace(other.find("'press'"), 7, "'prss'");
  expect_in(added(swept_at_once(8), other), "did you mean 'press'?");
  expect_in(added(swept_at_once(8), kTarget + "variation = 'tiny'\n"), "unknown variation 'tiny'");
  expect_in(added(test::sweep_toml("one_at_a_time", test::rate()), kTarget),
            "all unknowns vary at once");
  const std::string leave_out = "protocol = 'leave_group_out'\ngroup = 'trial'\n";
  expect_in(added(swept_at_once(8), kTarget + leave_out), "which the system does not run");
  // Eight draws have two pairs and two recordings each, two bodies two pairs.
  const auto with_seed = [&](int seed) {
    return added(swept_at_once(8), "[inference]\nbodies = 2\npairs = 2\nseed = " +
                                       std::to_string(seed) + "\n" + kTarget);
  };
  expect_in(with_seed(2012), "among those of the sweep");
  expect_in(with_seed(2008), "among those of the sweep");
  const int next = 2011 + 8 * 2;
  EXPECT_EQ(with_seed(2007), "nothing");
  expect_in(with_seed(next - 1), "among those of the sweep");
  EXPECT_EQ(with_seed(next), "nothing");
}

}  // namespace
}  // namespace somato
