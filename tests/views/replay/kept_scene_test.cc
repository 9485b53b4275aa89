#include "views/replay/kept_scene.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>

namespace somato::live {
namespace {

Exploration of_frames(std::size_t frames) {
  Channel channel;
  channel.name = "touch";
  channel.frames = Matrix<float>(frames, 1);
  return {{}, "", {channel}};
}

std::unique_ptr<KeptScene> kept_scene(std::size_t moments) {
  Scene scene;
  scene.bodies = {"finger"};
  auto kept = std::make_unique<KeptScene>(std::make_shared<const Scene>(std::move(scene)));
  for (std::size_t i = 0; i < moments; ++i) {
    ScenePose pose;
    pose.position[0] = static_cast<double>(i);
    kept->append({pose});
  }
  return kept;
}

double shown(KeptScene& scene, std::size_t frames, std::size_t frame) {
  return scene.poses(of_frames(frames), frame).at(0).position[0];
}

TEST(KeptScene, ShowsTheMomentOfEachFrame) {
  const auto scene = kept_scene(4);
  for (std::size_t frame = 0; frame < 4; ++frame) {
    EXPECT_EQ(shown(*scene, 4, frame), static_cast<double>(frame));
  }
}

// A probe that presses for a while gives one frame: it is shown pressed.
TEST(KeptScene, ShowsTheEndOfWhatWentIntoAFrame) {
  const auto scene = kept_scene(6);
  EXPECT_EQ(shown(*scene, 1, 0), 5.0);
  EXPECT_EQ(shown(*scene, 2, 0), 2.0);
  EXPECT_EQ(shown(*scene, 2, 1), 5.0);
}

TEST(KeptScene, RestsWhereNothingWasSeen) {
  const auto scene = kept_scene(0);
  EXPECT_EQ(shown(*scene, 3, 1), 0.0);
}

}  // namespace
}  // namespace somato::live
