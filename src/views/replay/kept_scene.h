#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <utility>
#include <vector>

#include "somato/bodies/scene.h"

namespace somato::live {

/// A scene that was seen while it happened.
class KeptScene : public ScenePlayer {
 public:
  explicit KeptScene(std::shared_ptr<const Scene> scene) : scene_(std::move(scene)) {}

  /// Adds the poses of the next moment; moments are evenly spread over the exploration.
  void append(std::vector<ScenePose> poses) { poses_.push_back(std::move(poses)); }

  /// The oldest `moments` are dropped.
  void drop(std::size_t moments);

  /// The memory of its poses.
  std::size_t bytes() const;

  const Scene& scene() const override { return *scene_; }
  std::vector<ScenePose> poses(const Exploration& exploration, std::size_t frame) override;

 private:
  std::shared_ptr<const Scene> scene_;
  std::deque<std::vector<ScenePose>> poses_;
};

}  // namespace somato::live
