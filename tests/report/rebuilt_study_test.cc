#include "report/rebuilt_study.h"

#include <gtest/gtest.h>

#include "somato/studies/own_systems.h"
#include "somato/studies/reproduction_plan.h"
#include "somato/studies/study.h"
#include "studies/settings.h"
#include "support/made_study.h"

namespace somato {
namespace {

using detail::find_setting;
using detail::rebuilt_study;
using detail::same_system;

// The nine, their variations, and all that is asked about them: from all that results say of them,
// each is built again as it was.
TEST(RebuiltStudy, EverySystemOfTheLibraryIsBuiltAgainFromItsSettings) {
  const OwnSystems own = own_systems().value();
  ReproductionPlan plan;
  for (const NamedFile& file : own.systems) ASSERT_TRUE(add_to_plan(file, own.systems, plan));
  ASSERT_GT(plan.parts.size(), 9U);
  for (const ReproductionPart& part : plan.parts) {
    const System system = System::build(part.description.system, {}).value();
    const auto settings = study_settings(part.description, system);
    const auto rebuilt = rebuilt_study(settings);
    ASSERT_TRUE(rebuilt) << part.system << part.variation << to_string(rebuilt.error());
    EXPECT_EQ(rebuilt->study.name, part.system);
    EXPECT_EQ(rebuilt->study.labels, part.description.study.labels);
    EXPECT_EQ(rebuilt->study.groups, part.description.study.groups);
    const auto again = System::build(rebuilt->system, {});
    ASSERT_TRUE(again) << part.system << to_string(again.error());
    EXPECT_TRUE(same_system(system_settings(*again), settings));
    for (std::size_t i = 0; i < system.modules().size(); ++i) {
      EXPECT_EQ(again->modules()[i].output, system.modules()[i].output);
    }
  }
}

TEST(RebuiltStudy, DifferentSystemsAreToldApart) {
  const OwnSystems own = own_systems().value();
  ReproductionPlan plan;
  for (const NamedFile& file : own.systems) ASSERT_TRUE(add_to_plan(file, own.systems, plan));
  std::vector<std::vector<Settings>> all;
  for (const ReproductionPart& part : plan.parts) {
    all.push_back(system_settings(System::build(part.description.system, {}).value()));
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = 0; j < all.size(); ++j) {
      EXPECT_EQ(same_system(all[i], all[j]), i == j) << i << " " << j;
    }
  }
}

TEST(RebuiltStudy, WhatTrainingDecidedIsNoDifference) {
  std::vector<Settings> own{{"module.map", {{"type", "\"som\""}, {"iterations", "\"automatic\""}}}};
  std::vector<Settings> other = own;
  other[0].settings[1].value = "3000";
  EXPECT_TRUE(same_system(own, other));
  EXPECT_FALSE(same_system(other, own));
  other.push_back({"phase.1", {}});
  EXPECT_FALSE(same_system(own, other));
  own[0].settings.pop_back();
  other.pop_back();
  EXPECT_FALSE(same_system(own, other));
}

TEST(RebuiltStudy, WhatATrainedBatchMapDecidedDoesNotHinder) {
  const auto description = testing::study_from("[study]\nname = 'batch'\nseeds = 1\n" +
                                               testing::joints_system("none") + "");
  StudyDescription batch = description;
  for (ModuleDescription& module : batch.system.modules) {
    if (module.name != "map") continue;
    std::erase_if(module.settings.entries, [](const auto& e) { return e.name == "iterations"; });
    module.settings.entries.push_back({"training", {}, Value{std::string("batch")}});
    module.settings.entries.push_back({"radius_schedule", {}, Value{std::string("constant")}});
  }
  const auto outcome = run_study(batch, testing::grasps(3, 3, 1)).value();
  const auto rebuilt = rebuilt_study(outcome.results.settings);
  ASSERT_TRUE(rebuilt) << to_string(rebuilt.error());
  const auto again = System::build(rebuilt->system, layout_of(testing::grasps(3, 3, 1)));
  EXPECT_TRUE(again) << to_string(again.error());
}

TEST(RebuiltStudy, WhatPhasesDecidedDoesNotHinder) {
  for (const char* order : {"", "order = 'without_replacement'\n"}) {
    const auto phased = testing::study_from(
        "[study]\nname = 'phased'\nseeds = 1\n"
        "[module.joints]\ntype = 'channel'\nchannel = 'joints'\n"
        "[module.closed]\ntype = 'last'\ninput = 'joints'\n"
        "[module.map]\ntype = 'som'\ninput = 'closed'\nrows = 5\ncolumns = 5\n"
        "[[phase]]\nlearn = ['map']\ndraws = 200\n" +
        std::string(order));
    const auto outcome = run_study(phased, testing::grasps(3, 3, 1)).value();
    EXPECT_EQ(*find_setting(outcome.results.settings, "module.map", "iterations"), "200");
    const auto rebuilt = rebuilt_study(outcome.results.settings);
    ASSERT_TRUE(rebuilt) << to_string(rebuilt.error());
    const auto again = System::build(rebuilt->system, layout_of(testing::grasps(3, 3, 1)));
    ASSERT_TRUE(again) << to_string(again.error());
    EXPECT_EQ(again->phases().front().draws, 200U);
  }
}

// Each of them says how it drew, which was the phase's to say.
TEST(RebuiltStudy, WhatAPhaseOfTwoDecidedDoesNotHinder) {
  const std::string map = "type = 'som'\ninput = 'closed'\nrows = 3\ncolumns = 3\n";
  const auto phased = testing::study_from(
      "[study]\nname = 'together'\nmap = 'one'\nseeds = 1\n"
      "[module.joints]\ntype = 'channel'\nchannel = 'joints'\n"
      "[module.closed]\ntype = 'last'\ninput = 'joints'\n"
      "[module.one]\n" +
      map + "[module.other]\n" + map + "[[phase]]\nlearn = ['one', 'other']\ndraws = 50\n");
  const auto outcome = run_study(phased, testing::grasps(3, 3, 1)).value();
  const auto rebuilt = rebuilt_study(outcome.results.settings);
  ASSERT_TRUE(rebuilt) << to_string(rebuilt.error());
  for (const ModuleDescription& module : rebuilt->system.modules) {
    EXPECT_EQ(module.settings.find("draws"), nullptr) << module.name;
  }
  const auto again = System::build(rebuilt->system, layout_of(testing::grasps(3, 3, 1)));
  ASSERT_TRUE(again) << to_string(again.error());
  EXPECT_EQ(again->phases().front().draws, 50U);
}

TEST(RebuiltStudy, SettingsThatAreNoneAreRefused) {
  EXPECT_FALSE(rebuilt_study({}));
  EXPECT_FALSE(rebuilt_study({{"study", {{"name", "\"a\""}, {"nonsense", "1"}}}}));
  const auto study = rebuilt_study({{"study", {{"name", "\"a\""}}}, {"module.x", {{"type", "1"}}}});
  ASSERT_TRUE(study);
  EXPECT_FALSE(System::build(study->system, {}));
}

TEST(RebuiltStudy, FindsSettings) {
  const std::vector<Settings> settings{{"study", {{"name", "\"a\""}}}};
  EXPECT_EQ(*find_setting(settings, "study", "name"), "\"a\"");
  EXPECT_EQ(find_setting(settings, "study", "label"), nullptr);
  EXPECT_EQ(find_setting(settings, "module.map", "rows"), nullptr);
}

}  // namespace
}  // namespace somato
