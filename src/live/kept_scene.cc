#include "live/kept_scene.h"

#include <algorithm>

namespace somato::live {

KeptScene::KeptScene(Scene scene, std::vector<std::vector<ScenePose>> poses)
    : scene_(std::move(scene)), poses_(std::move(poses)) {}

std::vector<ScenePose> KeptScene::poses(const Exploration& exploration, std::size_t frame) {
  std::size_t frames = 1;
  for (const Channel& channel : exploration.channels) {
    frames = std::max(frames, channel.frames.rows());
  }
  if (poses_.empty()) return std::vector<ScenePose>(scene_.bodies.size());
  return poses_[std::min(frame * poses_.size() / frames, poses_.size() - 1)];
}

}  // namespace somato::live
