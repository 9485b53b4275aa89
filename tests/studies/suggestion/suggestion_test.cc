#include "studies/suggestion/suggestion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/files/toml_file.h"
#include "somato/studies/study.h"
#include "studies/support/made_senses.h"

namespace somato {
namespace {

using testing::made_senses;
using testing::MadeSense;

const std::vector<std::size_t> kSix{0, 1, 2, 3, 4, 5};

Suggestion suggested(const Recording& recording, const SuggestionParameters& parameters = {}) {
  auto found = suggest(recording, parameters);
  if (!found) ADD_FAILURE() << to_string(found.error());
  return found ? *found : Suggestion{};
}

Error error_of(const Recording& recording, const SuggestionParameters& parameters = {}) {
  const auto found = suggest(recording, parameters);
  return found ? Error{} : found.error();
}

// The weight with which a channel is used, 0 if it is not.
double weight_of(const Suggestion& suggestion, const std::string& channel) {
  double weight = 0.0;
  for (const SuggestedPart& part : suggestion.parts) {
    const auto& channels = suggestion.groups[part.group].channels;
    if (std::ranges::find(channels, channel) != channels.end()) weight += part.weight;
  }
  return weight;
}

ChannelRole role_of(const Suggestion& suggestion, std::size_t channel) {
  return suggestion.groups[channel].role;
}

// The accuracy of the nearest neighbour, with each exploration left out.
double accuracy_of(const Suggestion& suggestion, const Recording& recording) {
  auto study = read_study(parse_toml(to_toml(suggestion), "suggested.toml").value()).value();
  study.study.seeds = 1;
  study.study.protocols = {Protocol::kLeaveOneOut};
  for (Table::Entry& entry : study.system.modules.back().settings.entries) {
    if (entry.name == "epochs") entry.content = Value{std::int64_t{1}};
    if (entry.name == "tolerance") entry.content = Value{0.0};
  }
  const auto outcome = run_study(study, recording);
  if (!outcome) ADD_FAILURE() << to_string(outcome.error());
  return outcome ? outcome->results.protocols[0].find_metric("baseline_accuracy_raw")->mean() : 0.0;
}

TEST(Suggestion, NoiseIsDropped) {
  const Recording recording =
      made_senses(6, 5, {{"noise", {}, 0.0, 1.0}, {"touch", kSix}, {"joints", kSix}});
  const Suggestion found = suggested(recording);
  EXPECT_EQ(role_of(found, 0), ChannelRole::kUnrelated);
  EXPECT_EQ(weight_of(found, "noise"), 0.0);
  EXPECT_EQ(found.senses, (std::vector<std::string>{"touch", "joints"}));
  EXPECT_EQ(accuracy_of(found, recording), 1.0);
}

// Neither sense separates more than three of nine objects.
TEST(Suggestion, ComplementarySensesAreBothKept) {
  const Recording recording = made_senses(9, 4,
                                          {{"shape", {0, 0, 0, 1, 1, 1, 2, 2, 2}, 0.05},
                                           {"material", {0, 1, 2, 0, 1, 2, 0, 1, 2}, 0.05}});
  const Suggestion found = suggested(recording);
  EXPECT_GT(weight_of(found, "shape"), 0.0);
  EXPECT_GT(weight_of(found, "material"), 0.0);
  EXPECT_GE(accuracy_of(found, recording), 0.95);  // 1 of 36 is 0.028; 0.33 for one sense
}

TEST(Suggestion, ScalesOfSensesDoNotMatter) {
  std::vector<MadeSense> senses{{"shape", {0, 0, 0, 1, 1, 1, 2, 2, 2}, 0.05},
                                {"material", {0, 1, 2, 0, 1, 2, 0, 1, 2}, 0.05}};
  const Suggestion equal = suggested(made_senses(9, 4, senses));
  senses[1].scale = 1024.0;
  const Recording scaled = made_senses(9, 4, senses);
  const Suggestion found = suggested(scaled);
  ASSERT_EQ(found.parts.size(), equal.parts.size());
  for (std::size_t i = 0; i < found.parts.size(); ++i) {
    EXPECT_EQ(found.parts[i].weight, equal.parts[i].weight);
    EXPECT_EQ(found.parts[i].group, equal.parts[i].group);
  }
  EXPECT_GE(accuracy_of(found, scaled), 0.95);
}

// One element is noise a thousand times as large as the others.
TEST(Suggestion, ASenseIsStandardizedIfThatIsRequired) {
  Recording recording = made_senses(6, 5, {{"touch", kSix, 0.05, 0.05, 1.0, 6}, {"joints", kSix}});
  Random noise(7);
  for (Exploration& exploration : recording.explorations) {
    Matrix<float>& frames = exploration.channels[0].frames;
    for (std::size_t row = 0; row < frames.rows(); ++row) {
      frames(row, 0) = static_cast<float>(1000.0 * noise.normal());
    }
  }
  const Suggestion found = suggested(recording);
  const auto& codes = found.groups[0].codes;
  const auto best = std::ranges::min_element(codes, {}, &SuggestedCode::score);
  EXPECT_EQ(best->scaling, "standardized");
}

TEST(Suggestion, LabelsAndSourcesHaveNoEffect) {
  Recording recording = made_senses(6, 4, {{"touch", kSix}, {"joints", kSix}});
  const std::string text = to_toml(suggested(recording));
  Recording permuted = recording;
  for (std::size_t i = 0; i < permuted.explorations.size(); ++i) {
    const std::size_t other = (i * 7 + 3) % permuted.explorations.size();
    permuted.explorations[i].labels = recording.explorations[other].labels;
  }
  EXPECT_EQ(to_toml(suggested(permuted)), text);
  for (Exploration& exploration : recording.explorations) {
    exploration.labels.clear();
    exploration.source = "elsewhere";
  }
  EXPECT_EQ(to_toml(suggested(recording)), text);
}

TEST(Suggestion, ThreadsHaveNoEffect) {
  const Recording recording = made_senses(6, 4, {{"touch", kSix}, {"joints", kSix}});
  const Suggestion one = suggested(recording);
  const Suggestion four = suggest(recording, {}, {4, {}}).value();
  EXPECT_EQ(to_toml(four), to_toml(one));
  EXPECT_EQ(to_json(four), to_json(one));
}

TEST(Suggestion, ConstantChannelsAndSettingsAreNotSenses) {
  Recording recording = made_senses(6, 4, {{"touch", kSix}, {"still", {}}, {"speed", {}}});
  for (std::size_t i = 0; i < recording.explorations.size(); ++i) {
    for (float& value : recording.explorations[i].channels[1].frames.values()) value = 3.0F;
    for (float& value : recording.explorations[i].channels[2].frames.values()) {
      value = static_cast<float>(i % 3);
    }
  }
  const Suggestion found = suggested(recording);
  EXPECT_EQ(role_of(found, 1), ChannelRole::kConstant);
  EXPECT_EQ(role_of(found, 2), ChannelRole::kSetting);
  EXPECT_EQ(found.senses, std::vector<std::string>{"touch"});
}

TEST(Suggestion, WorksForTwoExplorationsAndNamesTheReason) {
  const Recording recording = made_senses(2, 1, {{"touch", kSix}, {"joints", kSix}});
  const Suggestion found = suggested(recording);
  EXPECT_TRUE(found.nothing_related);
  EXPECT_EQ(found.parts.size(), 2U);
  EXPECT_NE(to_toml(found).find("# No sense is predicted better than by chance"),
            std::string::npos);
}

TEST(Suggestion, WorksForChannelsWithSeparateClocksAndSingleFrames) {
  const Recording recording = made_senses(
      6, 5, {{"touch", kSix, 0.05, 0.1, 1.0, 3, 20}, {"hardness", kSix, 0.05, 0.0, 1.0, 1, 1}});
  const Suggestion found = suggested(recording);
  EXPECT_GE(accuracy_of(found, recording), 0.9);  // 0.17 by chance
  for (const SuggestedGroup& group : found.groups) EXPECT_EQ(group.channels.size(), 1U);
}

TEST(Suggestion, ExtremeValuesAndNamesAreHarmless) {
  Recording recording = made_senses(4, 3, {{"touch", kSix}, {"\n[module.x]\n\"", kSix}});
  recording.explorations[0].channels[0].frames(0, 0) = std::numeric_limits<float>::max();
  recording.explorations[1].channels[0].frames(1, 1) = std::numeric_limits<float>::lowest();
  const std::string text = to_toml(suggested(recording));
  EXPECT_TRUE(read_study(parse_toml(text, "suggested.toml").value()).has_value()) << text;
}

TEST(Suggestion, ManyExplorationsAreDrawnBySeed) {
  const Recording recording = made_senses(6, 5, {{"touch", kSix}, {"joints", kSix}});
  SuggestionParameters parameters;
  parameters.explorations = 12;
  const Suggestion found = suggested(recording, parameters);
  EXPECT_EQ(found.compared, 12U);
  EXPECT_EQ(found.explorations, 30U);
  parameters.seed = 2;
  EXPECT_NE(to_json(suggested(recording, parameters)), to_json(found));
}

TEST(Suggestion, TakesTheTablesOfAnotherStudy) {
  const Recording recording = made_senses(6, 4, {{"touch", kSix}});
  const Table like = parse_toml(
                         "[study]\nname = 'other'\nlabel = 'shape'\nmap = 'm'\nseeds = 3\n"
                         "[explore]\nbody = 'lucs2'\n[explore.plan]\ngrasps = 9\n",
                         "other.toml")
                         .value();
  const std::string text = to_toml(suggested(recording), like);
  const Table file = parse_toml(text, "suggested.toml").value();
  const auto study = read_study(file).value();
  EXPECT_EQ(study.study.name, "suggested");
  EXPECT_EQ(study.study.label, "shape");
  EXPECT_EQ(study.study.seeds, 3U);
  EXPECT_NE(text.find("[explore]\nbody = \"lucs2\"\n\n[explore.plan]\ngrasps = 9\n"),
            std::string::npos);
}

TEST(Suggestion, JsonHasTheScoresOfAllCodes) {
  const Recording recording = made_senses(6, 4, {{"touch", kSix}, {"joints", kSix}});
  const auto json = nlohmann::json::parse(to_json(suggested(recording)));
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["senses"], (nlohmann::json{"touch", "joints"}));
  const auto& code = json["groups"][0]["codes"][0];
  EXPECT_EQ(code["module"], "last_of_touch");
  EXPECT_NEAR(
      code["score"].get<double>(),
      (code["predicts"]["touch"].get<double>() + code["predicts"]["joints"].get<double>()) / 2,
      1e-12);
}

TEST(Suggestion, RecordingsThatCannotBeComparedAreRefused) {
  EXPECT_EQ(error_of(made_senses(1, 1, {{"touch", kSix}})).what,
            "the recording has only one exploration");
  Recording constant = made_senses(3, 2, {{"touch", kSix}});
  for (Exploration& exploration : constant.explorations) {
    for (float& value : exploration.channels[0].frames.values()) value = 1.0F;
  }
  EXPECT_EQ(error_of(constant).what, "no channel differs between explorations");
  EXPECT_EQ(error_of(Recording{}).kind, ErrorKind::kData);
  const Recording played = made_senses(3, 2, {{"touch", kSix}, {"true_draws", kSix}});
  EXPECT_EQ(error_of(played).what,
            "the recording contains true values of a simulation, which no robot has");
  SuggestionParameters parameters;
  parameters.weights = {};
  EXPECT_EQ(error_of(made_senses(3, 2, {{"touch", kSix}}), parameters).kind, ErrorKind::kUsage);
}

// As a table: one channel of a frame, whose elements have different units.
Recording table_of(std::size_t rows, const std::vector<double>& scales) {
  std::vector<std::size_t> kinds(6);
  for (std::size_t i = 0; i < kinds.size(); ++i) kinds[i] = i;
  Recording table = made_senses(6, rows / 6, {{"columns", kinds, 0.3, 0.0, 1.0, scales.size(), 1}});
  for (Exploration& exploration : table.explorations) {
    for (std::size_t i = 0; i < scales.size(); ++i) {
      exploration.channels[0].frames(0, i) *= static_cast<float>(scales[i]);
    }
  }
  return table;
}

// Factors that are powers of two leave the bits of standardized values.
TEST(Suggestion, ScalesOfColumnsChangeNothing) {
  const Suggestion plain = suggested(table_of(60, {1, 1, 1, 1}));
  const Suggestion scaled = suggested(table_of(60, {1024, 0.125, 1, 65536}));
  EXPECT_EQ(to_toml(scaled), to_toml(plain));
  EXPECT_EQ(to_json(scaled), to_json(plain));
}

TEST(Suggestion, ATableHasAtMostAsManyNeuronsAsRows) {
  const Suggestion found = suggested(table_of(120, {1, 1, 1, 1, 1, 1}));
  const auto& map = found.system.modules.back().settings;
  const auto side_of = [&](const char* name) {
    return std::get<std::int64_t>(std::get<Value>(map.find(name)->content).content);
  };
  EXPECT_LE(side_of("rows") * side_of("columns"), 120);
  EXPECT_FALSE(found.size.checks.empty());
}

// Each row has one wild value, whose square decides the Euclidean distance.
TEST(Suggestion, WildValuesAreComparedByManhattanDistance) {
  Recording table = table_of(120, std::vector<double>(16, 1.0));
  Random random(9);
  for (Exploration& exploration : table.explorations) {
    exploration.channels[0].frames(0, random.below(16)) += 12.0F;
  }
  EXPECT_EQ(suggested(table).similarity, Similarity::kManhattan);
}

TEST(Suggestion, ThePlainVectorReplacesACombinationThatIsNotClearlyBetter) {
  const Suggestion found = suggested(made_senses(6, 5, {{"touch", kSix}, {"joints", kSix}}));
  ASSERT_EQ(found.comparisons.size(), 3U);
  EXPECT_NE(found.comparisons[0].is_chosen, found.comparisons[1].is_chosen);
  if (found.comparisons[0].is_chosen) {
    EXPECT_LT(found.comparisons[0].score, found.comparisons[1].score);
    return;
  }
  for (const SuggestedPart& part : found.parts) {
    EXPECT_EQ(found.groups[part.group].codes[part.code].scaling, "standardized");
    EXPECT_EQ(part.factor, 1.0);
  }
}

TEST(Suggestion, SmallAndConstantTablesAreHarmless) {
  EXPECT_EQ(suggested(table_of(6, {1, 1})).parts.size(), 1U);
  EXPECT_EQ(suggested(table_of(12, {1})).parts.size(), 1U);
  EXPECT_EQ(suggested(table_of(36, {1, 0, 1})).parts.size(), 1U);  // a constant column
  Recording equal = table_of(12, {1, 1});
  for (std::size_t i = 1; i < 11; ++i) equal.explorations[i] = equal.explorations[0];
  EXPECT_EQ(suggested(equal).parts.size(), 1U);
}

TEST(Suggestion, CanBeInterrupted) {
  const Recording recording = made_senses(6, 4, {{"touch", kSix}, {"joints", kSix}});
  std::size_t calls = 0;
  const auto count = [&](std::uint64_t done, std::uint64_t total) {
    EXPECT_LE(done, total);
    ++calls;
    return true;
  };
  ASSERT_TRUE(suggest(recording, {}, {1, count}).has_value());
  for (const std::size_t at : {std::size_t{1}, calls / 2, calls}) {
    std::size_t left = at;
    const auto found = suggest(recording, {}, {1, [&](auto, auto) { return --left > 0; }});
    ASSERT_FALSE(found.has_value());
    EXPECT_EQ(found.error().kind, ErrorKind::kInterrupted);
  }
}

}  // namespace
}  // namespace somato
