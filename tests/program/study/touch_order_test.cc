#include <nlohmann/json.hpp>

#include "program/support/program_test.h"
#include "somato/core/random.h"
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

using Json = nlohmann::json;

class TouchOrderProgram : public ProgramTest {
 protected:
  // Two objects in three poses, of which only the last one distinguishes them.
  void write_grasps() const {
    Random random(5);
    Recording recording;
    for (std::size_t i = 0; i < 16; ++i) {
      Matrix<float> joints(3, 1);
      for (std::size_t pose = 0; pose < 3; ++pose) {
        const bool differs = pose == 2 && i % 2 == 1;
        joints(pose, 0) = static_cast<float>((differs ? 50.0 : 0.0) + random.uniform());
      }
      recording.explorations.push_back(
          {{{"object", i % 2 == 0 ? "ball" : "cube"}},
           {},
           {{"wrist", "deg", {}, Matrix<float>(3, 1, {0.0F, 20.0F, 40.0F}), {}, 10.0},
            {"joints", "deg", {}, std::move(joints), {}, 10.0}}});
    }
    ASSERT_TRUE(write_recording(path("grasps.mcap"), recording));
  }

  static Words words(const Words& more) {
    Words all{"touch-order", "grasps.mcap", "--pose",  "wrist", "--channels",  "joints",
              "--folds",     "4",           "--seeds", "2",     "--certainty", "0.7"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
};

TEST_F(TouchOrderProgram, PrintsTheCurveOfEachOrder) {
  write_grasps();
  const std::string text = output_of(words({}));
  EXPECT_EQ(text.rfind("16 explorations of 3 grasps, 2 classes, 2 seeds: accuracy\n", 0), 0U)
      << text;
  EXPECT_NE(text.find("chosen            fixed             random\n"), std::string::npos) << text;
  EXPECT_NE(text.find("until a name has the probability 0.7\n"), std::string::npos) << text;
  EXPECT_EQ(output_of(words({"--threads", "2"})), text);
  const Json json = Json::parse(output_of(words({"--json"})));
  EXPECT_EQ(json["grasps"], 3);
  ASSERT_EQ(json["orders"].size(), 3U);
  EXPECT_EQ(json["orders"][0]["order"], "chosen");
  EXPECT_EQ(json["orders"][0]["curve"][0]["accuracy"], 1.0) << "the last pose comes first";
  EXPECT_EQ(json["orders"][0]["stopped_grasps"], 1.0);
  EXPECT_EQ(json["orders"][1]["curve"][2]["accuracy"], 1.0);
  EXPECT_LT(json["orders"][1]["curve"][0]["accuracy"], 0.9);
}

TEST_F(TouchOrderProgram, RefusesWhatDoesNotFit) {
  write_grasps();
  expect_refused(2, {{words({"--label", "thing"}), {"unknown label 'thing'"}},
                     {{"touch-order", "grasps.mcap"}, {"unknown channel 'height'"}},
                     {words({"--folds", "1"}), {"--folds"}}});
  expect_refused(1, words({"--pose-tolerance", "100"}), {"fewer than two grasps", "'pose'"});
}

}  // namespace
}  // namespace somato
