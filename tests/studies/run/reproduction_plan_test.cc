#include "somato/studies/reproduction.h"

#include <gtest/gtest.h>

#include "base/files/toml_file.h"

namespace somato {
namespace {

using Names = std::vector<std::string>;

std::string system_text(const std::string& name) {
  return "[study]\nname = '" + name +
         "'\n[module.joints]\ntype = 'channel'\nchannel = 'joints'\n[module.closed]\n"
         "type = 'last'\ninput = 'joints'\n[module.map]\ntype = 'som'\ninput = 'closed'\n"
         "rows = 5\n[explore]\nbody = 'lucs2'\n";
}

constexpr int kLines = 14;  // of system_text()

NamedFile file(const std::string& name, const std::string& toml) {
  return {name, parse_toml(toml, name + ".toml").value()};
}

std::vector<NamedFile> systems() {
  return {file("small", system_text("small")), file("large", system_text("large"))};
}

class Plan : public ::testing::Test {
 protected:
  Result<void> add(const std::string& name, const std::string& toml) {
    return add_to_plan(file(name, toml), systems(), plan_);
  }

  void expect_refused(const std::string& toml, const std::string& message) {
    const auto added = add("request", toml);
    ASSERT_FALSE(added) << message;
    EXPECT_EQ(added.error().kind, ErrorKind::kUsage);
    EXPECT_EQ(to_string(added.error()), message);
  }

  // "question/system/variation" of each part.
  Names parts() const {
    Names names;
    for (const ReproductionPart& part : plan_.parts) {
      names.push_back(part.question + "/" + part.system + "/" + part.variation);
    }
    return names;
  }

  // The value of a key of a part's module.
  std::string setting(std::size_t part, const std::string& module, const std::string& key) const {
    for (const ModuleDescription& one : plan_.parts.at(part).description.system.modules) {
      if (one.name != module) continue;
      const Table::Entry* entry = one.settings.find(key);
      return entry ? to_toml(std::get<Value>(entry->content)) : "";
    }
    return "no module";
  }

  ReproductionPlan plan_;
};

TEST_F(Plan, OfASystemIsItselfThenItsVariations) {
  ASSERT_TRUE(add("small", system_text("small") +
                               "[variation.wide]\nmodule.map.columns = 9\n[variation.raw]\n"
                               "study.label = 'shape'\nexplore.explorations = 2\n"));
  EXPECT_EQ(parts(), (Names{"/small/", "/small/wide", "/small/raw"}));
  EXPECT_EQ(setting(0, "map", "columns"), "");
  EXPECT_EQ(setting(1, "map", "columns"), "9");
  EXPECT_EQ(setting(1, "map", "rows"), "5");
  EXPECT_EQ(setting(2, "map", "columns"), "");
  EXPECT_EQ(plan_.parts[0].description.study.label, "object");
  EXPECT_EQ(plan_.parts[2].description.study.label, "shape");
  EXPECT_EQ(plan_.parts[1].explore.entries.size(), 1U);
  EXPECT_EQ(plan_.parts[2].explore.entries.size(), 2U);
  for (const ReproductionPart& part : plan_.parts) EXPECT_FALSE(part.pairs);
}

// A variation that is for another system is not run.
TEST_F(Plan, OfAQuestionIsEverySystemWithItsVariations) {
  ASSERT_TRUE(add("why", R"([question]
name = "how_wide"
systems = ["small", "large"]
pairs = 12
[module.map]
columns = 3
[variation.wide]
module.map.columns = 9
[variation.high]
systems = ["large"]
module.map.rows = 20
)"));
  EXPECT_EQ(parts(), (Names{"how_wide/small/", "how_wide/small/wide", "how_wide/large/",
                            "how_wide/large/wide", "how_wide/large/high"}));
  // The question's changes for all, and a variation's changes in addition.
  EXPECT_EQ(setting(0, "map", "columns"), "3");
  EXPECT_EQ(setting(1, "map", "columns"), "9");
  EXPECT_EQ(setting(2, "map", "columns"), "3");
  EXPECT_EQ(setting(4, "map", "columns"), "3");
  EXPECT_EQ(setting(4, "map", "rows"), "20");
  EXPECT_EQ(setting(3, "map", "rows"), "5");
  for (const ReproductionPart& part : plan_.parts) EXPECT_EQ(part.pairs, 12U);
}

TEST_F(Plan, KeepsWhatOtherFilesAskFor) {
  ASSERT_TRUE(add("small", system_text("small")));
  ASSERT_TRUE(add("why", "[question]\nname = 'q'\nsystems = ['large']\n"));
  EXPECT_EQ(parts(), (Names{"/small/", "q/large/"}));
  EXPECT_EQ(plan_.parts[1].pairs, 24U);
}

TEST_F(Plan, ClaimsAreAboutTheSystemOfTheirFile) {
  ASSERT_TRUE(add("small", system_text("small") + R"([variation.wide]
module.map.columns = 9
[[claim]]
text = "a"
metric = "accuracy"
at_least = 0
[[claim]]
text = "b"
variation = "wide"
metric = "accuracy"
at_least = 0
[[claim]]
text = "c"
than_variation = "wide"
metric = "accuracy"
at_least = 0
[[claim]]
text = "d"
than_system = "another"
metric = "accuracy"
at_least = 0
[[claim]]
text = "e"
variation = "wide"
metric = "accuracy"
than_metric = "baseline_accuracy"
at_least = 0
)"));
  ASSERT_EQ(plan_.claims.size(), 5U);
  for (const Claim& claim : plan_.claims) {
    EXPECT_EQ(claim.system, "small");
    EXPECT_EQ(claim.question, "");
  }
  EXPECT_EQ(plan_.claims[0].than_system, "");
  EXPECT_EQ(plan_.claims[1].variation, "wide");
  EXPECT_EQ(plan_.claims[2].than_system, "small");
  EXPECT_EQ(plan_.claims[2].than_variation, "wide");
  EXPECT_EQ(plan_.claims[3].than_system, "another");
  EXPECT_EQ(plan_.claims[3].than_variation, "");
  EXPECT_EQ(plan_.claims[4].than_system, "small");
  EXPECT_EQ(plan_.claims[4].than_variation, "wide");
}

TEST_F(Plan, ClaimsOfAQuestionBelongToIt) {
  ASSERT_TRUE(add("why", R"([question]
name = "q"
systems = ["small", "large"]
[[claim]]
text = "a"
system = "large"
than_system = "small"
metric = "accuracy"
at_least = 0
)"));
  ASSERT_EQ(plan_.claims.size(), 1U);
  EXPECT_EQ(plan_.claims[0].question, "q");
  EXPECT_EQ(plan_.claims[0].system, "large");
  EXPECT_EQ(plan_.claims[0].than_system, "small");
}

TEST_F(Plan, RefusesClaimsAboutWhatIsNotRun) {
  const auto place = [](int line) {
    return "request.toml:" + std::to_string(line) +
           ": the claim refers to a system or variation that is not run; use systems and "
           "variations of this file";
  };
  const std::string rest = "text = 't'\nmetric = 'accuracy'\nat_least = 0\n";
  const std::string claim = system_text("small") + "[variation.wide]\n[[claim]]\n" + rest;
  for (const std::string about :
       {"variation = 'wid'", "than_variation = 'wid'", "system = 'large'"}) {
    expect_refused(claim + about + "\n", place(kLines + 2));
  }
  const std::string question = "[question]\nname = 'q'\nsystems = ['small']\n[[claim]]\n" + rest;
  for (const std::string about :
       {"system = 'large'", "than_system = 'large'", "variation = 'wide'"}) {
    expect_refused(question + about + "\n", place(4));
  }
}

TEST_F(Plan, RefusesComparisonsOfAMetricWithItself) {
  const std::string start = system_text("small") +
                            "[variation.wide]\n[[claim]]\ntext = 't'\nmetric = 'accuracy'\n"
                            "at_least = 0\n";
  const std::string refusal = "request.toml:" + std::to_string(kLines + 2) +
                              ": the claim compares a metric with itself; use another "
                              "than_system, than_variation or than_metric";
  expect_refused(start + "than_metric = 'accuracy'\n", refusal);
  expect_refused(start + "than_system = 'small'\n", refusal);
  expect_refused(start + "variation = 'wide'\nthan_variation = 'wide'\n", refusal);
}

TEST_F(Plan, RefusesQuestionsAboutNothing) {
  expect_refused("[question]\nname = 'q'\nsystems = ['small', 'lagre']\n",
                 "request.toml:1: unknown system 'lagre'; did you mean 'large'?");
  expect_refused(
      "[question]\nsystems = ['small']\n",
      "request.toml:1: a question needs a name and systems; add name = \"...\" and systems "
      "= [\"...\"] to [question]");
  expect_refused(
      "[question]\nname = 'q'\n",
      "request.toml:1: a question needs a name and systems; add name = \"...\" and systems "
      "= [\"...\"] to [question]");
  expect_refused("question = 'why'\n",
                 "request.toml:1: 'question' must be a table; write [question] on a separate line, "
                 "its keys below");
  expect_refused("[question]\nname = 'q'\nsystem = ['small']\n",
                 "request.toml:3: unknown key 'system'; did you mean 'systems'?");
  expect_refused(
      "[question]\nname = 'q'\nsystems = ['small']\n[variation.v]\nsystems = ['large']\n",
      "request.toml:4: unknown system of the question 'large'; known are: small");
}

// Wherever a change leads astray, its own line is named.
TEST_F(Plan, RefusesChangesThatDoNotFit) {
  const std::string question = "[question]\nname = 'q'\nsystems = ['small']\n";
  expect_refused(question + "[module.mpa]\nrows = 3\n",
                 "request.toml:4: unknown module 'mpa'; did you mean 'map'?");
  expect_refused(question + "[variation.v]\nmodule.mpa.rows = 3\n",
                 "request.toml:5: unknown module 'mpa'; did you mean 'map'?");
  expect_refused(question + "[studdy]\nlabel = 'x'\n",
                 "request.toml:4: unknown table 'studdy'; did you mean 'study'?");
  expect_refused(question + "[variation.v]\nstudy.lable = 'x'\n",
                 "request.toml:5: unknown key 'lable'; did you mean 'label'?");
  expect_refused(system_text("small") + "[variation.v]\nstudy.seeds = 0\n",
                 "request.toml:" + std::to_string(kLines + 2) +
                     ": 'seeds' must be a whole number, 1 to 1000000, not 0");
}

// An error in a module can be found without a recording if the channels state their shapes.
TEST_F(Plan, BuildsWhatStatesItsShapes) {
  std::string shaped = system_text("small");
  shaped.insert(shaped.find("[module.closed]"), "shape = [3]\n");
  const std::string line = std::to_string(kLines + 3);
  const std::string none =
      "'rows' must be a whole number, 1 to 16777216, not 0; \"automatic\" is also accepted";
  expect_refused(shaped + "[variation.v]\nmodule.map.rows = 0\n",
                 "request.toml:" + line + ", module 'map': " + none);
  EXPECT_TRUE(add("request", shaped));
  EXPECT_TRUE(add("request", system_text("other") + "[variation.v]\nmodule.map.rows = 0\n"));
}

TEST_F(Plan, ExplorationIsListedInTheSettings) {
  const NamedFile explored =
      file("x", "body = 'lucs2'\nexplorations = 2\n[simulation]\nplacement_noise = 4.0\n");
  const auto settings = explore_settings(explored.content);
  ASSERT_EQ(settings.size(), 2U);
  EXPECT_EQ(settings[0].part, "explore");
  EXPECT_EQ(settings[0].settings[0].value, "\"lucs2\"");
  EXPECT_EQ(settings[0].settings[1].name, "explorations");
  EXPECT_EQ(settings[1].part, "explore.simulation");
  EXPECT_EQ(settings[1].settings[0].name, "placement_noise");
  EXPECT_EQ(settings[1].settings[0].value, "4.0");
  EXPECT_TRUE(explore_settings({}).empty());
  const auto nested = parse_toml("[material.cork]\nstiffness = 8.0\n", "a.toml").value();
  ASSERT_EQ(explore_settings(nested).size(), 1U);
  EXPECT_EQ(explore_settings(nested)[0].part, "explore.material.cork");
  EXPECT_EQ(explore_settings(nested)[0].settings[0].value, "8.0");
}

}  // namespace
}  // namespace somato
