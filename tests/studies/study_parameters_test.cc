#include "somato/studies/study_parameters.h"

#include <gtest/gtest.h>

#include "somato/files/toml_file.h"

namespace somato {
namespace {

const std::string kGood = R"([study]
name = "shapes"
label = "shape"
individual = "object"
protocols = ["leave_one_out"]
seeds = 3
first_seed = 40
wrong_groupings = 7

[recording]
format = "icub_grasp"

[vector]
channels = ["joints", "touch"]
frames = "change"
standardize = false
constant_columns = "zero"

[map]
rows = 5
columns = 6
)";

const std::string kLeast = "[study]\nname = \"n\"\n[vector]\nchannels = [\"joints\"]\n";

Result<StudyDescription> read(const std::string& toml) {
  return read_study(parse_toml(toml, "study.toml").value());
}

void expect_refused(const std::string& toml, const std::string& message) {
  const auto description = read(toml);
  ASSERT_FALSE(description) << message;
  EXPECT_EQ(description.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(to_string(description.error()), message);
}

TEST(ReadStudy, ReadsEveryPart) {
  const StudyDescription description = read(kGood).value();
  const StudyParameters& study = description.study;
  EXPECT_EQ(study.name, "shapes");
  EXPECT_EQ(study.label, "shape");
  EXPECT_EQ(study.individual, "object");
  EXPECT_EQ(study.protocols, (std::vector<Protocol>{Protocol::kLeaveOneOut}));
  EXPECT_EQ(study.seeds, 3U);
  EXPECT_EQ(study.first_seed, 40U);
  EXPECT_EQ(study.wrong_groupings, 7U);
  EXPECT_EQ(description.recording.format, RecordingFormat::kIcubGrasp);
  EXPECT_EQ(description.vector.channels, (std::vector<std::string>{"joints", "touch"}));
  EXPECT_EQ(description.vector.frames, FrameChoice::kChange);
  EXPECT_FALSE(description.vector.standardize);
  EXPECT_EQ(description.vector.constant_columns, ConstantColumns::kZero);
  EXPECT_EQ(description.map.rows, 5U);
  EXPECT_EQ(description.map.columns, 6U);
}

TEST(ReadStudy, NeedsNameAndChannelsOnly) {
  const StudyDescription description = read(kLeast).value();
  EXPECT_EQ(description.study.protocols,
            (std::vector<Protocol>{Protocol::kTrainIsTest, Protocol::kLeaveOneOut}));
  EXPECT_EQ(description.study.label, "object");
  EXPECT_EQ(description.vector.frames, FrameChoice::kLast);
  EXPECT_TRUE(description.vector.standardize);
  EXPECT_EQ(description.vector.constant_columns, ConstantColumns::kRefuse);
}

TEST(ReadStudy, SaysWhatIsMissing) {
  expect_refused("[vector]\nchannels = [\"joints\"]\n",
                 "study.toml:1: the study has no name; add name = \"...\" to [study]");
  expect_refused("[study]\nname = \"n\"\n",
                 "study.toml:1: the study names no channels; add channels = [\"...\"] to [vector]");
  expect_refused("[study]\nname = \"n\"\nprotocols = []\n[vector]\nchannels = [\"joints\"]\n",
                 "study.toml:1: the study has no protocols; add protocols = [\"leave_one_out\"] to "
                 "[study]");
}

TEST(ReadStudy, SaysWhatIsMisspelt) {
  expect_refused("[study]\nname = \"n\"\n[vectors]\nchannels = [\"joints\"]\n",
                 "study.toml:3: unknown table 'vectors'; did you mean 'vector'?");
  expect_refused("[study]\nname = \"n\"\nsseds = 3\n",
                 "study.toml:3: unknown key 'sseds'; did you mean 'seeds'?");
  expect_refused(kLeast + "frame = \"last\"\n",
                 "study.toml:5: unknown key 'frame'; did you mean 'frames'?");
  expect_refused(kLeast + "[map]\nrow = 4\n",
                 "study.toml:6: unknown key 'row'; did you mean 'rows'?");
  expect_refused(kLeast + "frames = \"lest\"\n",
                 "study.toml:5: 'frames' must be one of first, last, change, not \"lest\"; "
                 "did you mean 'last'?");
}

TEST(ReadStudy, RefusesAKeyWhereATableBelongs) {
  expect_refused("study = 3\n",
                 "study.toml:1: 'study' must be a table; write [study] on a line of its own, its "
                 "keys below");
  expect_refused(kLeast + "[[map]]\nrows = 4\n",
                 "study.toml:5: 'map' must be a table; write [map] on a line of its own, its keys "
                 "below");
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
    if (table == "map" && parameter.info.name == "seed") continue;  // refused whatever its value
    const std::string line = parameter.info.name + " = " + wrong_value(parameter.info);
    const auto description = read("# a study\n[" + table + "]\n" + line + "\n");
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
  expect_wrong_types_refused<VectorParameters>("vector");
  expect_wrong_types_refused<SomParameters>("map");
}

TEST(ReadStudy, RefusesNumbersOutOfRange) {
  expect_refused("[map]\ntraining = \"batch\"\niterations = 4\n",
                 "study.toml:3: 'iterations' has no effect, because training is batch; "
                 "leave it out");
  expect_refused(
      "[study]\nname = \"a\"\nprotocols = [\"leave_one_out\", \"leave_one_out\"]\n"
      "[vector]\nchannels = [\"joints\"]\n",
      "study.toml:1: a protocol is named twice; name each of protocols in [study] once");
  expect_refused("[map]\nrows = 3\nseed = 4\n",
                 "study.toml:3: a study's map has no 'seed' of its own; "
                 "write first_seed = ... in [study]");
  expect_refused("[study]\nseeds = 0\n",
                 "study.toml:2: 'seeds' must be a whole number, 1 to 1000000, not 0");
  expect_refused("[study]\nfirst_seed = -1\n",
                 "study.toml:2: 'first_seed' must be a whole number, 0 to 1000000000000000, "
                 "not -1");
  expect_refused("[study]\nwrong_groupings = 10001\n",
                 "study.toml:2: 'wrong_groupings' must be a whole number, 0 to 10000, not 10001");
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

TEST(StudyParameters, EveryDeclaredKeyCanBeSet) {
  expect_every_key_settable<StudyParameters>();
  expect_every_key_settable<RecordingParameters>();
  expect_every_key_settable<VectorParameters>();
}

}  // namespace
}  // namespace somato
