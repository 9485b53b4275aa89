#include "views/exports/foxglove_export.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/support/temporary_folder.h"
#include "recordings/bags/bag_files.h"
#include "recordings/explorations/exploration_frames.h"
#include "recordings/ros/channel_reader.h"
#include "recordings/ros/definition.h"
#include "views/exports/varied_recording.h"

namespace somato {
namespace {

// A finger whose two taxels are 10 cm apart along x, at the height of the frame's number.
class FingerPlayer final : public ScenePlayer {
 public:
  FingerPlayer() {
    scene_.bodies = {"finger"};
    scene_.geoms = {{.body = 0, .shape = GeomShape::kBox, .size = {0.1, 0.1, 0.1}},
                    {.body = 0, .size = {0.01, 0.01, 0.01}, .taxel = 0},
                    {.body = 0, .size = {0.01, 0.01, 0.01}, .taxel = 1}};
    scene_.geoms[2].pose.position = {0.1, 0.0, 0.0};
    scene_.camera = {0.0, -2.0, 0.0};
  }

  const Scene& scene() const override { return scene_; }
  std::vector<ScenePose> poses(const Exploration& /*exploration*/, std::size_t frame) override {
    return {{{0.0, 0.0, static_cast<double>(frame)}, {}}};
  }

 private:
  Scene scene_;
};

Recording touched() {
  Recording recording;
  Exploration exploration{{{"object", "cup"}}, "", {}};
  exploration.channels.push_back(
      {"joints", "deg", {"thumb"}, Matrix<float>(3, 1), {0, 0.1, 0.105}});
  exploration.channels.push_back(
      {"touch", "N", {}, Matrix<float>(2, 2, {0.0F, 1.0F, 2.0F, 0.5F}), {0.0, 0.1}});
  recording.explorations = {exploration, exploration};
  return recording;
}

class FoxgloveExportTest : public ::testing::Test {
 protected:
  void write(const Recording& recording, const SceneFinder& scenes) const {
    auto to = FoxgloveExport::begin(folder_.file("out"), scenes).value();
    for (const Exploration& exploration : recording.explorations) {
      ASSERT_TRUE(hand_frames(exploration, *to));
    }
    ASSERT_TRUE(to->finish());
  }

  // The numbers at a path of all messages of a topic, one list a message.
  std::vector<std::vector<double>> read(const std::string& topic, const std::string& path) const {
    std::vector<std::vector<double>> all;
    auto bag = open_bag(find_bags(folder_.file("out")).value().front(), "").value();
    for (;;) {
      const auto message = bag->next().value();
      if (!message) return all;
      const BagTopic& of = bag->topics()[message->topic];
      if (of.name != topic) continue;
      auto type = compile_ros_definition(of.encoding.type, of.encoding.definition_encoding,
                                         of.encoding.definition);
      const auto reader =
          ChannelReader::compile(std::make_shared<const RosType>(std::move(type.value())), {path});
      EXPECT_TRUE(reader->read(message->data, all.emplace_back()));
    }
  }

  nlohmann::json layout() const {
    return nlohmann::json::parse(bytes_of(folder_.file("out/foxglove_layout.json")));
  }

  TemporaryFolder folder_;
};

using Lists = std::vector<std::vector<double>>;

TEST_F(FoxgloveExportTest, TheSceneFollowsTheFrames) {
  write(touched(), [](const Exploration&) { return std::make_unique<FingerPlayer>(); });
  EXPECT_EQ(read("/scene", "entities[0].cubes[*].size"), (Lists{{0.2, 0.2, 0.2}, {0.2, 0.2, 0.2}}));
  // The third frame follows after 5 ms only.
  EXPECT_EQ(read("/tf", "transforms[*].transform.translation.z"), (Lists{{0}, {1}, {0}, {1}}));
  const Lists reds = read("/taxels", "entities[0].cubes[*].color.r");
  ASSERT_EQ(reds.size(), 4U);
  EXPECT_EQ(reds[0], (std::vector<double>{0.7, 0.7 * 0.5 + 0.5}));  // Half of the largest force.
  EXPECT_EQ(reds[1][0], 1.0);
  EXPECT_EQ(read("/taxel_points", "width"), (Lists{{2}, {2}, {2}, {2}}));
  EXPECT_EQ(read("/touch", "data").size(), 4U);
}

TEST_F(FoxgloveExportTest, TheLayoutShowsTheSceneAndPlots) {
  write(touched(), [](const Exploration&) { return std::make_unique<FingerPlayer>(); });
  const nlohmann::json shown = layout();
  EXPECT_EQ(shown["layout"]["first"], "3D!1");
  EXPECT_EQ(shown["configById"]["3D!1"]["topics"]["/scene"]["visible"], true);
  EXPECT_NEAR(shown["configById"]["3D!1"]["cameraState"]["phi"].get<double>(), 90.0, 1e-9);
  EXPECT_NEAR(shown["configById"]["3D!1"]["cameraState"]["thetaOffset"].get<double>(), 0.0, 1e-9);
  EXPECT_EQ(shown["configById"]["Plot!1"]["paths"][0]["value"], "/joints.position[0]");
  EXPECT_EQ(shown["configById"]["Plot!2"]["paths"][1]["value"], "/touch.data[1]");
  EXPECT_EQ(shown["configById"]["RawMessages!3"]["topicPath"], "/labels/object.data");
}

TEST_F(FoxgloveExportTest, WithoutABodyThereArePlotsOnly) {
  write(varied_recording(), [](const Exploration&) { return nullptr; });
  EXPECT_TRUE(read("/scene", "entities[0].frame_locked").empty());
  const nlohmann::json shown = layout();
  EXPECT_FALSE(shown["configById"].contains("3D!1"));
  EXPECT_EQ(shown["layout"]["direction"], "column");
  EXPECT_EQ(shown["configById"]["Plot!2"]["title"], "skin/left (counts)");
}

}  // namespace
}  // namespace somato
