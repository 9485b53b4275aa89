#include <nlohmann/json.hpp>

#include "program/support/program_test.h"
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

using Json = nlohmann::json;

class InformationProgram : public ProgramTest {
 protected:
  // Two frames of one joint: the hand is open at 0, and closes as far as the thing lets it.
  static Exploration closed_at(const char* object, const char* shape, const char* girth,
                               float joint) {
    Channel joints{"joints", "deg", {}, Matrix<float>(2, 1, {0.0F, joint}), {}, 10.0};
    return {{{"object", object}, {"shape", shape}, {"girth", girth}}, {}, {joints}};
  }

  void write_things() const {
    const Recording recording{{closed_at("a", "round", "30", 50), closed_at("a", "round", "30", 52),
                               closed_at("b", "round", "60", 40), closed_at("b", "round", "60", 42),
                               closed_at("c", "round", "90", 30),
                               closed_at("c", "round", "90", 32)}};
    ASSERT_TRUE(write_recording(path("things.mcap"), recording));
    write_study();
  }
};

// Objects lie 2 within; 8, 10, 10, 12 between neighbours and 18, 20, 20, 22 between the outer two.
TEST_F(InformationProgram, PrintsAndSavesTheFigures) {
  write_things();
  const std::string shown =
      output_of({"information", "study.toml", "--data", "things.mcap", "--individual", "object",
                 "--order", "girth", "--shuffles", "200", "-o", "information.json"});
  EXPECT_NE(shown.find("small: 6 explorations, vectors of 1 elements from 'closed'\n"),
            std::string::npos)
      << shown;
  EXPECT_NE(shown.find("object: 3 classes\n"
                       "  accuracy                          1.000\n"
                       "  chance                            0.200\n"
                       "  distance_ratio                    6.667\n"),
            std::string::npos)
      << shown;
  EXPECT_NE(shown.find("order by girth\n"
                       "  correlation                       1.000\n"),
            std::string::npos)
      << shown;
  const Json information = Json::parse(read("information.json"));
  EXPECT_EQ(information["parameters"]["shuffles"], 200);
  EXPECT_NEAR(information["labels"][0]["distance_ratio"], 20.0 / 3.0, 1e-6);
  EXPECT_EQ(information["order"]["correlation"], 1.0);
}

TEST_F(InformationProgram, MeasuresSeveralLabels) {
  const std::string study =
      "[study]\nname = 'own'\n[module.joints]\ntype = 'channel'\nchannel = 'joints'\n"
      "[module.closed]\ntype = 'last'\ninput = 'joints'\n"
      "[module.map]\ntype = 'som'\ninput = 'closed'\n";
  write_things();
  write("study.toml", study);
  const std::string shown =
      output_of({"information", "study.toml", "--data", "things.mcap", "--labels", "object,girth"});
  EXPECT_NE(shown.find("\nobject: 3 classes\n"), std::string::npos);
  EXPECT_NE(shown.find("\ngirth: 3 classes\n"), std::string::npos);
}

TEST_F(InformationProgram, RefusesWhatCannotBe) {
  write_things();
  const auto with = [](const Words& more) {
    Words words{"information", "study.toml", "--data", "things.mcap"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  };
  expect_refused(2, {{with({"--labels", "objcet"}), {"did you mean 'object'?"}},
                     {with({"--map", "closed"}), {"map: the module 'closed' is not a map"}},
                     {with({"--shuffles", "many"}), {"--shuffles", "many"}},
                     {{"information", "study.toml"}, {"--data"}}});
  expect_refused(
      1, {{with({"--labels", "shape"}), {"things.mcap: every exploration has the same 'shape'"}},
          {with({"--order", "object"}),
           {"things.mcap: the label 'object' is 'a', which is not a number"}},
          {with({"-o", "nowhere/information.json"}), {"nowhere"}}});
}

}  // namespace
}  // namespace somato
