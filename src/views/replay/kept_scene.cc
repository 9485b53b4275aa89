#include "views/replay/kept_scene.h"

#include <algorithm>

namespace somato::live {

std::vector<ScenePose> KeptScene::poses(const Exploration& exploration, std::size_t frame) {
  std::size_t frames = 1;
  for (const Channel& channel : exploration.channels) {
    frames = std::max(frames, channel.frames.rows());
  }
  if (poses_.empty()) return std::vector<ScenePose>(scene_->bodies.size());
  // As it was at the frame's end.
  return poses_[std::min(((frame + 1) * poses_.size() - 1) / frames, poses_.size() - 1)];
}

}  // namespace somato::live
