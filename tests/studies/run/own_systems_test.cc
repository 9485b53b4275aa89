#include "somato/studies/own_systems.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/files/toml_file.h"
#include "somato/graph/system.h"
#include "somato/studies/study_parameters.h"

namespace somato {
namespace {

using Names = std::vector<std::string>;

OwnSystems own() {
  return own_systems().value();
}

// Without a recording, from the shapes that the modules of type channel state.
void expect_builds(const NamedFile& file) {
  SCOPED_TRACE(file.name);
  const auto description = read_study(file.content);
  ASSERT_TRUE(description) << to_string(description.error());
  EXPECT_EQ(description->study.name, file.name);
  const auto system = System::build(description->system, RecordingLayout{});
  EXPECT_TRUE(system) << to_string(system.error());
}

// As P06 and P11 present them.
TEST(OwnSystems, AreTheNineInTheOrderOfThePapers) {
  Names names;
  for (const NamedFile& file : own().systems) names.push_back(file.name);
  EXPECT_EQ(names,
            (Names{"single_tensor_product", "tensor_chain", "t_mpsom_multiplied", "t_mpsom_added",
                   "shape_and_size", "texture", "hardness", "combined", "bimodal"}));
}

TEST(OwnSystems, CanAllBeBuilt) {
  for (const NamedFile& file : questionable_systems(own())) expect_builds(file);
}

// The file says which it is: systems may be the subject of a question, but questions may not.
TEST(OwnSystems, BeyondThePapersAreSystemsOrQuestions) {
  for (const NamedFile& file : own().announced) EXPECT_FALSE(file.content.find("question"));
  for (const NamedFile& file : own().announced_questions) {
    EXPECT_TRUE(file.content.find("question")) << file.name;
  }
  EXPECT_EQ(questionable_systems(own()).size(), own().systems.size() + own().announced.size());
  EXPECT_FALSE(own().announced_questions.empty());
}

TEST(OwnSystems, ForDataSetsCanBeReadAndSayWhatTheyRead) {
  for (const NamedFile& file : own().recorded) {
    const auto description = read_study(file.content);
    ASSERT_TRUE(description) << file.name << ": " << to_string(description.error());
    EXPECT_NE(description->recording.format, RecordingFormat::kAutomatic) << file.name;
  }
}

TEST(OwnSystems, HaveTheTextOfTheirFiles) {
  for (const NamedFile& file : own().questions) {
    EXPECT_EQ(file.text, find_own_file(file.name)->text) << file.name;
  }
}

// The text in results describes the part that was run: all systems, variations and questions.
TEST(OwnSystems, ReadBackFromWhatResultsSayOfThem) {
  const OwnSystems all = own();
  ReproductionPlan plan;
  const std::vector<NamedFile> systems = questionable_systems(all);
  for (const auto* files : {&systems, &all.recorded, &all.questions, &all.announced_questions}) {
    for (const NamedFile& file : *files) ASSERT_TRUE(add_to_plan(file, systems, plan));
  }
  std::size_t as_they_stand = 0;
  for (const ReproductionPart& part : plan.parts) {
    const StudyDescription& description = part.description;
    as_they_stand += description.text.empty() ? 0 : 1;
    for (const std::string& text : {to_toml(description), description.text}) {
      if (text.empty()) continue;
      const auto again = read_study(parse_toml(text, part.system).value());
      ASSERT_TRUE(again) << part.system << part.variation << to_string(again.error());
      EXPECT_EQ(to_toml(*again), to_toml(description));
    }
  }
  EXPECT_EQ(as_they_stand, systems.size() + all.recorded.size());
}

// With all their variations and claims; a name stands for one file.
TEST(OwnSystems, MakeAPlan) {
  const OwnSystems all = own();
  ReproductionPlan plan;
  std::set<std::string> names;
  const std::vector<NamedFile> systems = questionable_systems(all);
  for (const auto* files : {&systems, &all.recorded, &all.questions, &all.announced_questions}) {
    for (const NamedFile& file : *files) {
      const auto added = add_to_plan(file, systems, plan);
      EXPECT_TRUE(added) << file.name << ": " << to_string(added.error());
      EXPECT_TRUE(names.insert(file.name).second) << file.name;
    }
  }
  for (const ReproductionPart& part : plan.parts) {
    const auto system = System::build(part.description.system, RecordingLayout{});
    EXPECT_TRUE(system || part.description.recording.format != RecordingFormat::kAutomatic)
        << part.question << " " << part.system << " " << part.variation;
  }
  EXPECT_GE(plan.parts.size(), 9U);
}

}  // namespace
}  // namespace somato
