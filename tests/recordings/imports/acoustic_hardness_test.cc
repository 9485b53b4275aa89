#include "recordings/imports/acoustic_hardness.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/support/temporary_folder.h"

namespace somato {
namespace {

using Json = nlohmann::ordered_json;

Json impact_of(const std::string& id) {
  return Json::parse(fmt::format(R"({{
    "metadata": {{"sample_id": "{}", "timestamp": "2026-06-28T17:38:28+00:00",
                  "material": "yoga_mat", "class": "soft", "comment": null}},
    "hardware": {{"board": "Arduino"}},
    "audio": {{"sample_rate": 16000, "num_samples": 4, "overflow": 0,
               "values": [-32768, 0, 7, 32767]}}}})",
                                 id));
}

class ImportAcousticHardness : public ::testing::Test {
 protected:
  Result<Recording> import() const { return import_acoustic_hardness(folder_.path()); }

  Exploration read(const Json& impact) const {
    folder_.with("1.json", impact.dump(2));
    const auto recording = import();
    return recording.value().explorations.at(0);
  }

  // The error for a file of this text, without the folder.
  std::string error_for(const std::string& text) const {
    folder_.with("1.json", text);
    const auto recording = import();
    if (recording) return "none";
    EXPECT_EQ(recording.error().kind, ErrorKind::kData);
    EXPECT_EQ(recording.error().advice, "repair or remove the file");
    return recording.error().where.substr(folder_.path().size() + 1) + ": " +
           recording.error().what;
  }

  // The same for an impact with `value` at the place `pointer`.
  std::string error_with(const char* pointer, const Json& value) const {
    Json impact = impact_of("1");
    impact[Json::json_pointer(pointer)] = value;
    return error_for(impact.dump());
  }

  // The same for an impact without the member `name` of `object`.
  std::string error_without(const char* object, const char* name) const {
    Json impact = impact_of("1");
    impact[object].erase(name);
    return error_for(impact.dump());
  }

  TemporaryFolder folder_;
};

TEST_F(ImportAcousticHardness, ReadsSoundAndLabels) {
  const Exploration impact = read(impact_of("1"));
  Channel sound{"sound", "counts", {}, Matrix<float>(4, 1, {-32768, 0, 7, 32767}), {}};
  sound.rate = 16000.0;
  EXPECT_EQ(impact,
            (Exploration{{{"hardness", "soft"}, {"material", "yoga_mat"}, {"release", "device"}},
                         folder_.file("1.json"),
                         {sound}}));
}

TEST_F(ImportAcousticHardness, LabelsHowTheMarbleWasReleased) {
  Json impact = impact_of("1");
  for (const auto& [comment, release] :
       {std::pair("manual", "manual"), {"", "device"}, {"by foot", "by foot"}}) {
    impact["metadata"]["comment"] = comment;
    EXPECT_EQ(read(impact).labels[2].value, release);
  }
  impact["metadata"].erase("comment");
  EXPECT_EQ(read(impact).labels[2].value, "device");
}

TEST_F(ImportAcousticHardness, FindsImpactsInAnyFolderInNaturalOrder) {
  for (const char* name : {"phase1/10.json", "phase1/9.json", "phase0/11.json"}) {
    std::filesystem::create_directories(std::filesystem::path(folder_.file(name)).parent_path());
    folder_.with(name, impact_of(name).dump());
  }
  folder_.with("README.md", "not read");
  const Recording recording = import().value();
  EXPECT_TRUE(validate(recording));
  ASSERT_EQ(recording.explorations.size(), 3U);
  EXPECT_EQ(recording.explorations[0].source, folder_.file("phase0/11.json"));
  EXPECT_EQ(recording.explorations[1].source, folder_.file("phase1/9.json"));
  EXPECT_EQ(import_acoustic_hardness(folder_.file("phase1"))->explorations.size(), 2U);
}

TEST_F(ImportAcousticHardness, TakesAnyWayToSayThatNothingOverflowed) {
  Json impact = impact_of("1");
  impact["audio"]["overflow"] = false;
  EXPECT_EQ(read(impact).channels.size(), 1U);
  impact["audio"].erase("overflow");
  EXPECT_EQ(read(impact).channels.size(), 1U);
}

TEST_F(ImportAcousticHardness, RefusesLostSamples) {
  const std::string lost = "1.json:/audio/overflow: the recorder overflowed: samples are lost";
  EXPECT_EQ(error_with("/audio/overflow", true), lost);
  EXPECT_EQ(error_with("/audio/overflow", 3), lost);
  EXPECT_EQ(error_with("/audio/overflow", "no"),
            "1.json:/audio/overflow: it must be true or false");
}

TEST_F(ImportAcousticHardness, RefusesMissingMembers) {
  for (const char* name : {"sample_id", "class", "material"}) {
    EXPECT_EQ(error_without("metadata", name),
              fmt::format("1.json:/metadata/{}: a text is missing", name));
  }
  EXPECT_EQ(error_without("audio", "sample_rate"),
            "1.json:/audio/sample_rate: a number is missing");
  EXPECT_EQ(error_without("audio", "values"), "1.json:/audio/values: a list of samples is missing");
  EXPECT_EQ(error_without("audio", "num_samples"),
            "1.json:/audio/values: there are 4 samples, but num_samples is 'null'");
}

TEST_F(ImportAcousticHardness, RefusesMembersOfAnotherType) {
  EXPECT_EQ(error_with("/metadata/class", 3), "1.json:/metadata/class: a text is missing");
  EXPECT_EQ(error_with("/metadata/comment", 3), "1.json:/metadata/comment: a text is missing");
  EXPECT_EQ(
      error_with("/metadata/material", "a\nb"),
      "1.json:/metadata/material: the text is empty, longer than 255 bytes or not on one line");
  EXPECT_EQ(error_with("/metadata", 3), "1.json:/metadata/sample_id: a text is missing");
  EXPECT_EQ(error_with("/audio/sample_rate", "16000"),
            "1.json:/audio/sample_rate: a number is missing");
  EXPECT_EQ(error_with("/audio/values", 5), "1.json:/audio/values: a list of samples is missing");
}

TEST_F(ImportAcousticHardness, RefusesSamplesThatAreNone) {
  const std::pair<Json, const char*> samples[] = {
      {"7", "\"7\""},     {7.5, "7.5"},    {nullptr, "null"}, {32768, "32768"},
      {-32769, "-32769"}, {1e30, "1e+30"}, {true, "true"}};
  for (const auto& [value, text] : samples) {
    EXPECT_EQ(error_with("/audio/values/2", value),
              fmt::format("1.json:/audio/values/2: '{}' is not a 16-bit integer", text));
  }
  EXPECT_EQ(error_with("/audio/values", Json::array()),
            "1.json:/audio/values: a list of samples is missing");
}

TEST_F(ImportAcousticHardness, RefusesAWrongCount) {
  EXPECT_EQ(error_with("/audio/num_samples", 5),
            "1.json:/audio/values: there are 4 samples, but num_samples is '5'");
  EXPECT_EQ(error_with("/audio/num_samples", -1),
            "1.json:/audio/values: there are 4 samples, but num_samples is '-1'");
}

TEST_F(ImportAcousticHardness, RefusesASamplingRateThatIsNone) {
  EXPECT_EQ(error_with("/audio/sample_rate", 0),
            "1.json:/audio/sample_rate: 0 Hz is not a valid sampling rate");
  EXPECT_EQ(error_with("/audio/sample_rate", -8000),
            "1.json:/audio/sample_rate: -8000 Hz is not a valid sampling rate");
}

TEST_F(ImportAcousticHardness, RefusesWhatIsNoImpact) {
  EXPECT_EQ(error_for("[]"), "1.json:/metadata/sample_id: a text is missing");
  EXPECT_EQ(error_for("3"), "1.json:/metadata/sample_id: a text is missing");
  EXPECT_EQ(error_for(""), "1.json:1:1: not valid JSON: it ends too early");
  EXPECT_EQ(error_for("{\n  \"a\": ]"), "1.json:2:8: not valid JSON");
  EXPECT_EQ(error_for(R"({"a": 1e999})"), "1.json: a number is out of range");
}

TEST_F(ImportAcousticHardness, RefusesTextThatIsNotUtf8) {
  folder_.with("1.json", "{\n\"a\": \"\xFF\"}");
  const auto recording = import();
  ASSERT_FALSE(recording);
  EXPECT_EQ(recording.error().where, folder_.file("1.json") + ":2");
  EXPECT_EQ(recording.error().what, "byte 0xFF is not UTF-8 text");
}

TEST_F(ImportAcousticHardness, RefusesNestingWithoutEnd) {
  EXPECT_EQ(error_for(std::string(1000000, '[')),
            "1.json:1:17: the JSON has more than 16 levels of nesting");
  Json impact = impact_of("1");
  impact["metadata"]["material"] = "\" [[[[[[[[[[[[[[[[[[[[ \\";
  EXPECT_EQ(read(impact).labels[1].value, "\" [[[[[[[[[[[[[[[[[[[[ \\");
}

TEST_F(ImportAcousticHardness, RefusesEveryCut) {
  const std::string text = impact_of("1").dump(1);
  for (std::size_t size = 0; size < text.size(); ++size) {
    EXPECT_NE(error_for(text.substr(0, size)), "none") << size;
  }
}

TEST_F(ImportAcousticHardness, ReadsOrRefusesWhateverBitIsTurned) {
  const std::string text = impact_of("1").dump();
  for (std::size_t bit = 0; bit < 8 * text.size(); ++bit) {
    std::string turned = text;
    turned[bit / 8] = static_cast<char>(turned[bit / 8] ^ (1 << bit % 8));
    const std::string file = folder_.with("1.json", turned);
    const auto recording = import();
    if (recording) {
      EXPECT_TRUE(validate(*recording)) << turned;
    } else {
      EXPECT_EQ(recording.error().kind, ErrorKind::kData) << turned;
      EXPECT_TRUE(recording.error().where.starts_with(file)) << turned;
    }
  }
}

TEST_F(ImportAcousticHardness, RefusesTheSameSampleTwice) {
  folder_.with("1.json", impact_of("x").dump());
  folder_.with("2.json", impact_of("x").dump());
  const auto recording = import();
  ASSERT_FALSE(recording);
  EXPECT_EQ(to_string(recording.error()), folder_.file("2.json") +
                                              ": the file has the same sample_id as " +
                                              folder_.file("1.json") + "; remove one of them");
}

TEST_F(ImportAcousticHardness, RefusesAnEmptyOrMissingFolder) {
  EXPECT_EQ(import().error().what, "there are no JSON files");
  EXPECT_EQ(import_acoustic_hardness(folder_.file("nowhere")).error().kind, ErrorKind::kSystem);
}

TEST_F(ImportAcousticHardness, RefusesAFileOfMoreThan64Mebibytes) {
  std::filesystem::resize_file(folder_.with("1.json", ""), (std::uintmax_t{64} << 20) + 1);
  EXPECT_EQ(import().error().what, "the file is larger than 67108864 bytes");
}

}  // namespace
}  // namespace somato
