#include "somato/studies/study_parameters.h"

#include <gtest/gtest.h>

#include "base/files/toml_file.h"

namespace somato {
namespace {

const std::string kGood = R"([study]
name = "shapes"
label = "shape"
only = ["cube", "ball"]
labels = ["object", "side"]
individual = "object"
order = "girth"
within = "side"
mapped_with = ["cube ball", "ball cube"]
map = "first_map"
protocols = ["leave_group_out", "k_folds"]
groups = ["session"]
folds = 4
seeds = 3
first_seed = 40
wrong_groupings = 7

[recording]
format = "icub_grasp"

[module.joints]
type = "channel"
channel = "joints"

[module.first_map]
type = "som"
input = "joints"
rows = 5

[[phase]]
learn = ["first_map"]
draws = 40
)";

const std::string kLeast = "[study]\nname = \"n\"\n[module.a]\ntype = \"channel\"\n";

Result<StudyDescription> read_study(const std::string& toml) {
  return read_study(parse_toml(toml, "study.toml").value());
}

void expect_study_refused(const std::string& toml, const std::string& message) {
  const auto description = read_study(toml);
  ASSERT_FALSE(description) << message;
  EXPECT_EQ(description.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(to_string(description.error()), message);
}

TEST(ReadStudy, ReadsEveryPart) {
  const StudyDescription description = read_study(kGood).value();
  const StudyParameters& study = description.study;
  EXPECT_EQ(study.name, "shapes");
  EXPECT_EQ(study.label, "shape");
  EXPECT_EQ(study.only, (std::vector<std::string>{"cube", "ball"}));
  EXPECT_EQ(study.labels, (std::vector<std::string>{"object", "side"}));
  EXPECT_EQ(study.individual, "object");
  EXPECT_EQ(study.order, "girth");
  EXPECT_EQ(study.within, "side");
  EXPECT_EQ(study.mapped_with, (std::vector<std::string>{"cube ball", "ball cube"}));
  EXPECT_EQ(study.map, "first_map");
  EXPECT_EQ(study.protocols, (std::vector<Protocol>{Protocol::kLeaveGroupOut, Protocol::kFolds}));
  EXPECT_EQ(study.groups, std::vector<std::string>{"session"});
  EXPECT_EQ(study.folds, 4U);
  EXPECT_EQ(study.seeds, 3U);
  EXPECT_EQ(study.first_seed, 40U);
  EXPECT_EQ(study.wrong_groupings, 7U);
  EXPECT_EQ(description.recording.format, RecordingFormat::kIcubGrasp);
  EXPECT_EQ(description.system.name, "shapes");
  ASSERT_EQ(description.system.modules.size(), 2U);
  EXPECT_EQ(description.system.modules[0].name, "joints");
  EXPECT_EQ(description.system.modules[1].name, "first_map");
  EXPECT_NE(description.system.modules[1].settings.find("rows"), nullptr);
  ASSERT_EQ(description.system.phases.size(), 1U);
  EXPECT_EQ(description.system.phases[0].draws, 40U);
}

TEST(ReadStudy, NeedsNameAndModulesOnly) {
  const StudyDescription description = read_study(kLeast).value();
  EXPECT_EQ(description.study.protocols,
            (std::vector<Protocol>{Protocol::kTrainIsTest, Protocol::kLeaveOneOut}));
  EXPECT_EQ(description.study.label, "object");
  EXPECT_EQ(description.study.map, "");
  EXPECT_EQ(description.study.folds, 10U);
  EXPECT_EQ(description.recording.format, RecordingFormat::kAutomatic);
}

TEST(ReadStudy, SaysWhatIsMissing) {
  expect_study_refused("[module.a]\ntype = \"channel\"\n",
                       "study.toml:1: the study has no name; add name = \"...\" to [study]");
  expect_study_refused(
      "[study]\nname = \"n\"\n",
      "study.toml:1: the description has no modules; add [module.NAME] with a type");
  expect_study_refused(
      "[study]\nname = \"n\"\nprotocols = []\n[module.a]\ntype = \"channel\"\n",
      "study.toml:3: the study has no protocols; add protocols = [\"leave_one_out\"] to "
      "[study]");
}

TEST(ReadStudy, SaysWhatIsMisspelt) {
  expect_study_refused("[study]\nname = \"n\"\n[modules.a]\ntype = \"channel\"\n",
                       "study.toml:3: unknown table 'modules'; did you mean 'module'?");
  expect_study_refused("[study]\nname = \"n\"\nsseds = 3\n",
                       "study.toml:3: unknown key 'sseds'; did you mean 'seeds'?");
  expect_study_refused(kLeast + "[recording]\nformats = \"icub_grasp\"\n",
                       "study.toml:6: unknown key 'formats'; did you mean 'format'?");
  expect_study_refused("[study]\nname = \"n\"\nprotocols = [\"leave_one_in\"]\n",
                       "study.toml:3: 'protocols' must be one of train_is_test, leave_one_out, "
                       "leave_group_out, leave_class_out, k_folds, "
                       "object_after_object, test_data, not \"leave_one_in\"; did you mean "
                       "'leave_one_out'?");
}

// The tables that described a system before there were modules.
TEST(ReadStudy, RefusesTheTablesVectorAndMap) {
  expect_study_refused(kLeast + "[vector]\nchannels = [\"joints\"]\n",
                       "study.toml:5: unknown table 'vector'; known are: system, module, phase, "
                       "study, recording, altered, explore, variation, claim");
}

TEST(ReadStudy, RefusesAKeyWhereATableBelongs) {
  expect_study_refused(
      "study = 3\n",
      "study.toml:1: 'study' must be a table; write [study] on a separate line, its "
      "keys below");
  expect_study_refused(kLeast + "[[recording]]\nformat = \"icub_grasp\"\n",
                       "study.toml:5: 'recording' must be a table; write [recording] on a separate "
                       "line, its keys below");
}

TEST(ReadStudy, RefusesProtocolsThatDoNotFit) {
  const std::string study = "[study]\nname = \"n\"\n";
  const std::string module = "[module.a]\ntype = \"channel\"\n";
  expect_study_refused(study + "protocols = [\"leave_one_out\", \"leave_one_out\"]\n" + module,
                       "study.toml:3: a protocol is listed twice; list each protocol once");
  expect_study_refused(
      study + "protocols = [\"test_data\"]\n" + module,
      "study.toml:3: 'test_data' cannot be selected as a protocol; give the study a test recording "
      "instead");
  expect_study_refused(study + "protocols = [\"leave_group_out\"]\n" + module,
                       "study.toml:3: leave_group_out needs labels that define the groups; add "
                       "groups = [\"...\"] to [study]");
  expect_study_refused(
      study + "groups = [\"trial\"]\n" + module,
      "study.toml:3: 'groups' has no effect without the protocol leave_group_out; leave "
      "it out, or add it");
  EXPECT_TRUE(read_study(study + "groups = []\n" + module));  // as a variation takes them away
  expect_study_refused(study + "folds = 4\n" + module,
                       "study.toml:3: 'folds' has no effect without the protocol k_folds, "
                       "leave_class_out or object_after_object; leave it out, or add it");
  const std::string choice = "fold_choice = \"blocks\"\n";
  expect_study_refused(study + choice + module,
                       "study.toml:3: 'fold_choice' has no effect without the protocol k_folds, "
                       "leave_class_out or object_after_object and test_last = 0, or unknown = "
                       "true; leave it out, or add it");
  expect_study_refused(study + choice + "protocols = [\"k_folds\"]\ntest_last = 2\n" + module,
                       "study.toml:3: 'fold_choice' has no effect without the protocol k_folds, "
                       "leave_class_out or object_after_object and test_last = 0, or unknown = "
                       "true; leave it out, or add it");
}

// The parts that find a threshold follow it under every protocol.
TEST(ReadStudy, TakesAFoldChoiceForThresholds) {
  const std::string module = "[module.a]\ntype = \"channel\"\n";
  const std::string choice = "[study]\nname = \"n\"\nfold_choice = \"interleaved\"\n";
  EXPECT_TRUE(read_study(choice + "protocols = [\"train_is_test\"]\nunknown = true\n" + module));
  EXPECT_TRUE(read_study(choice + "protocols = [\"leave_class_out\"]\ntest_last = 2\n" + module));
}

TEST(ReadStudy, KeepsNeighboursTogetherUnlessAnotherChoiceIsNamed) {
  const std::string study = "[study]\nname = \"n\"\nprotocols = [\"k_folds\"]\n";
  const std::string module = "[module.a]\ntype = \"channel\"\n";
  EXPECT_EQ(read_study(study + module)->study.fold_choice, FoldChoice::kBlocks);
  const auto named = read_study(study + "fold_choice = \"interleaved\"\n" + module);
  EXPECT_EQ(named->study.fold_choice, FoldChoice::kInterleaved);
  EXPECT_NE(to_toml(*named).find("fold_choice = \"interleaved\""), std::string::npos);
}

TEST(ReadStudy, RefusesQuestionsThatAskForNothing) {
  const std::string study = "[study]\nname = \"n\"\n";
  const std::string module = "[module.a]\ntype = \"channel\"\n";
  expect_study_refused(
      study + "groups = [\"a\", \"b\", \"a\"]\nprotocols = [\"leave_group_out\"]\n" + module,
      "study.toml:3: a label is listed twice; list each label once");
  expect_study_refused(study + "order = \"girth\"\n" + module,
                       "study.toml:3: an order requires individuals; add individual "
                       "= \"...\" to [study]");
  expect_study_refused(
      study + "individual = \"object\"\nwithin = \"shape\"\n" + module,
      "study.toml:4: 'within' has no effect without 'order'; remove it, or add the order");
  for (const std::string pair : {"sphere", "a b c"}) {
    expect_study_refused(
        study + "mapped_with = [\"x y\", \"" + pair + "\"]\n" + module,
        "study.toml:3: '" + pair +
            "' does not consist of two classes; write two names separated by a space: the class "
            "that is mapped, and the class that it is mapped with");
  }
}

// A value that no parameter of that type takes.
std::string wrong_value(const ParameterInfo& info) {
  if (info.type == "text") return "3";
  if (info.type == "integer") return "1.5";
  return info.type.starts_with("list of") ? "[true]" : "[]";
}

template <typename Parameters>
void expect_wrong_types_refused(const std::string& table) {
  for (const auto& parameter : Parameters::declarations().all()) {
    const std::string line = parameter.info.name + " = " + wrong_value(parameter.info);
    const auto description = read_study("# a study\n[" + table + "]\n" + line + "\n");
    ASSERT_FALSE(description) << line;
    const std::string message = to_string(description.error());
    EXPECT_EQ(description.error().kind, ErrorKind::kUsage);
    EXPECT_TRUE(message.starts_with("study.toml:3: '" + parameter.info.name + "' must be"))
        << message;
  }
}

TEST(ReadStudy, RefusesEveryWrongTypeWithItsPlace) {
  expect_wrong_types_refused<StudyParameters>("study");
  expect_wrong_types_refused<RecordingParameters>("recording");
}

TEST(ReadStudy, RefusesNumbersOutOfRange) {
  expect_study_refused("[study]\nseeds = 0\n",
                       "study.toml:2: 'seeds' must be a whole number, 1 to 1000000, not 0");
  expect_study_refused("[study]\nfirst_seed = -1\n",
                       "study.toml:2: 'first_seed' must be a whole number, 0 to 1000000000000000, "
                       "not -1");
  expect_study_refused(
      "[study]\nwrong_groupings = 10001\n",
      "study.toml:2: 'wrong_groupings' must be a whole number, 0 to 10000, not 10001");
  expect_study_refused("[study]\nfolds = 1\n",
                       "study.toml:2: 'folds' must be a whole number, 2 to 1000000, not 1");
}

// Another value than the default, and for every name another.
Value other_value(const ParameterInfo& info) {
  if (info.type == "text") return {"other " + info.name};
  if (info.type == "list of text") return {Value::List{{std::string("a")}, {std::string("b")}}};
  if (info.type == "list of choice") return {Value::List{{info.choices.back()}}};
  if (info.type == "choice") return {info.choices.back()};
  if (info.type == "switch") return {info.default_text != "true"};
  if (info.type == "number") return {0.25};
  return {static_cast<std::int64_t>(info.name.size())};
}

// A field that is not declared could not be set from a description, nor stand in the results; two
// declarations of one field would not both be read back.
template <typename Parameters>
void expect_every_key_settable() {
  Parameters parameters;
  for (const auto& parameter : Parameters::declarations().all()) {
    ASSERT_TRUE(parameter.assign(parameters, other_value(parameter.info))) << parameter.info.name;
  }
  for (const auto& parameter : Parameters::declarations().all()) {
    EXPECT_EQ(parameter.read(parameters), other_value(parameter.info)) << parameter.info.name;
    EXPECT_FALSE(parameter.info.text.empty()) << parameter.info.name;
  }
}

// The text of kGood has to say every key, that of kLeast only the name.
TEST(StudyParameters, AStudyAsTomlReadsBackAsTheSame) {
  for (const std::string& text : {kGood, kLeast}) {
    const StudyDescription description = read_study(parse_toml(text, "x").value()).value();
    const std::string toml = to_toml(description);
    const auto again = read_study(parse_toml(toml, "y").value());
    ASSERT_TRUE(again) << toml << to_string(again.error());
    EXPECT_EQ(parameters_to_toml(again->study), parameters_to_toml(description.study));
    EXPECT_EQ(parameters_to_toml(again->recording), parameters_to_toml(description.recording));
    EXPECT_EQ(to_toml(again->system), to_toml(description.system));
  }
}

TEST(StudyParameters, WhatNoProtocolReadsCanBeReset) {
  StudyParameters study;
  study.protocols = {Protocol::kTrainIsTest};
  study.folds = 7;
  study.taught_per_class = 3;
  study.false_alarm_rate = 0.2;
  study.calibration_folds = 4;
  study.seeds = 9;
  reset_unread(study, {"taught_per_class"});
  EXPECT_EQ(study.folds, StudyParameters().folds);
  EXPECT_EQ(study.false_alarm_rate, StudyParameters().false_alarm_rate);
  EXPECT_EQ(study.taught_per_class, 3U);
  EXPECT_EQ(study.seeds, 9U);
  study.unknown = true;
  study.false_alarm_rate = 0.2;
  reset_unread(study, {});
  EXPECT_EQ(study.false_alarm_rate, 0.2);
}

TEST(StudyParameters, EveryDeclaredKeyCanBeSet) {
  expect_every_key_settable<StudyParameters>();
  expect_every_key_settable<RecordingParameters>();
}

}  // namespace
}  // namespace somato
