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

void KeptScene::drop(std::size_t moments) {
  poses_.erase(poses_.begin(), poses_.begin() + static_cast<std::ptrdiff_t>(moments));
}

std::size_t KeptScene::bytes() const {
  const std::size_t bodies = poses_.empty() ? 0 : poses_.front().size();
  return poses_.size() * (sizeof(std::vector<ScenePose>) + bodies * sizeof(ScenePose));
}

}  // namespace somato::live
