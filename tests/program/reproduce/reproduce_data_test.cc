#include "program/support/reproducing.h"

namespace somato {
namespace {

using Json = nlohmann::json;

class ReproduceGiven : public Reproduce {
 protected:
  // Four recordings of the probe in explored/recordings.
  ReproduceGiven() {
    write("press.toml", press());
    output_of(
        {"reproduce", "press.toml", "--out", "explored", "--pairs", "4", "--recordings", "4"});
    for (const std::string& file : files("explored/recordings")) recordings_.push_back(file);
  }

  Json given(const std::string& system, const std::string& data, const Words& more = {}) const {
    Words words = reproduce(system, "given", {"--data", data});
    words.insert(words.end(), more.begin(), more.end());
    output_of(words);
    return results("given");
  }

  Words recordings_;
};

TEST_F(ReproduceGiven, MayBeAFile) {
  const Json json = given("press.toml", "explored/recordings/" + recordings_[2]);
  ASSERT_EQ(json["recordings"].size(), 1U);
  EXPECT_EQ(json["recordings"][0]["name"], recordings_[2]);
  EXPECT_EQ(json["recordings"][0]["source"], "given");
  EXPECT_EQ(json["parts"][0]["pairs"], Json::parse("[[0, 2011], [0, 2012], [0, 2013]]"));
  EXPECT_TRUE(files("given/recordings").empty());
}

// All of them, whatever --recordings says of exploring, as far as there are pairs.
TEST_F(ReproduceGiven, MayBeAFolderOfFiles) {
  for (const char* folder : {"explored/recordings", "explored/recordings/"}) {
    const Json json =
        given("press.toml", folder, {"--test-data", "explored/recordings/" + recordings_[3]});
    ASSERT_EQ(json["recordings"].size(), 4U);
    EXPECT_EQ(json["parts"][0]["recordings"], Json::parse("[0, 1, 2]"));
    EXPECT_EQ(json["parts"][0]["test_recordings"], Json::parse("[3, 3, 3]"));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(json["recordings"][i]["name"], recordings_[i]);
    EXPECT_EQ(json["parts"][0]["pairs"], Json::parse("[[0, 2011], [1, 2012], [2, 2013]]"));
    EXPECT_EQ(json["parts"][0]["protocols"][2]["protocol"], "test_data");
  }
}

TEST_F(ReproduceGiven, ThatDoesNotFitIsPassedOverForAllAndAnErrorWhenNamed) {
  const std::string data = "explored/recordings/" + recordings_[0];
  const Json json = given("all", data);
  ASSERT_FALSE(json["parts"].empty());
  for (const Json& one : json["parts"]) EXPECT_EQ(one["system"], "hardness");
  EXPECT_GE(json["not_applicable"].size(), 8U);
  bool texture = false;
  for (const Json& one : json["not_applicable"]) {
    const std::string reason = one["reason"];
    texture = texture || (one["system"] == "texture" &&
                          reason.find("unknown channel 'sound'") != std::string::npos);
  }
  EXPECT_TRUE(texture);
  const ProgramRun named = run(reproduce("texture", "named", {"--data", data}));
  EXPECT_EQ(named.exit_code, 2);
  EXPECT_NE(named.err.find("unknown channel 'sound'"), std::string::npos) << named.err;
  EXPECT_TRUE(files("named").empty());
}

// One has labels that leave nothing to name under leave_one_out: one press of each material.
TEST_F(ReproduceGiven, ThatCannotBeMeasuredAlikeIsAnError) {
  std::string once = press();
  once.replace(once.find("explorations = 2"), 16, "explorations = 1");
  write("once.toml", once);
  output_of({"reproduce", "once.toml", "--out", "once", "--pairs", "1"});
  fs::copy(path("once/recordings"), path("explored/recordings"));
  const ProgramRun done = run({"reproduce", "press.toml", "--data", "explored/recordings", "--out",
                               "given", "--pairs", "5"});
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_NE(done.err.find("do not permit the same measurements"), std::string::npos) << done.err;
  EXPECT_FALSE(fs::exists(path("given/results.json")));
}

// The example's grasps, in the data set's own format.
class ReproduceDataSets : public Reproduce {
 protected:
  ReproduceDataSets() {
    for (const char* name : {"sets/a", "sets/b"}) {
      fs::create_directories(path(name));
      fs::copy(kTrials, path(name));
    }
    fs::remove(*fs::directory_iterator(path("sets/b")));
    write("joints.toml",
          "[study]\nname = 'joints'\nprotocols = ['train_is_test']\n[recording]\n"
          "format = 'icub_grasp'\n[module.joints]\ntype = 'channel'\nchannel = 'joints'\n"
          "[module.closed]\ntype = 'last'\ninput = 'joints'\n[module.map]\ntype = 'som'\n"
          "input = 'closed'\nrows = 3\ncolumns = 3\niterations = 50\n");
  }
};

TEST_F(ReproduceDataSets, MayBeOneOrAFolderOfThem) {
  for (const char* data : {"sets/a", "sets/a/"}) {
    output_of(reproduce("joints.toml", "out", {"--data", data}));
    const Json json = results("out");
    ASSERT_EQ(json["recordings"].size(), 1U);
    EXPECT_EQ(json["recordings"][0]["name"], "a") << data;
    EXPECT_EQ(json["recordings"][0]["explorations"], 30);
  }
  output_of(reproduce("joints.toml", "out", {"--data", "sets"}));
  const Json json = results("out");
  ASSERT_EQ(json["recordings"].size(), 2U);
  EXPECT_EQ(json["recordings"][0]["name"], "a");
  EXPECT_EQ(json["recordings"][1]["name"], "b");
  EXPECT_LT(json["recordings"][1]["explorations"], 30);
}

TEST_F(ReproduceDataSets, AreNotForSystemsOfBodies) {
  const ProgramRun done = run(reproduce("hardness", "out", {"--data", "sets"}));
  EXPECT_EQ(done.exit_code, 2);
  EXPECT_NE(done.err.find(
                "the system needs recordings, and --data contains none; use --data with a file"),
            std::string::npos)
      << done.err;
  write("press.toml", press());
  // Nor can a system for data sets do without them.
  expect_refused(2, reproduce("joints.toml", "none"),
                 {"joints.toml:1", "'joints' does not define an exploration", "use --data"});
}

}  // namespace
}  // namespace somato
