#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "live/growing_exploration.h"
#include "live/showing.h"
#include "live/task_queue.h"
#include "somato/bodies/watched_body.h"

namespace somato::live {

/// An exploration of a body that goes on: shows it, at the pace that is wanted, and does the tasks
/// of the queue while the body waits. Used by one thread.
class LiveExploration : public ExplorationWatcher {
 public:
  /// It will be the exploration with that index.
  LiveExploration(std::size_t index, Showing& showing, TaskQueue& queue)
      : index_(index), showing_(showing), queue_(queue) {}

  std::size_t index() const { return index_; }
  const GrowingExploration& grown() const { return growing_; }

  /// The body's clock at the first step, s: it counts as 0.
  double begun() const { return begun_; }

  /// Has the system, another one, hear what has come so far.
  void follow_anew();

  /// Pauses, but for so many frames more.
  void pause(std::size_t frames = 0);

  /// Has it end as soon as may be, with an error of kInterrupted.
  void abandon() { abandoned_ = true; }

  /// What was seen: the scene, and where its bodies were at each moment.
  const Scene& scene() const { return scene_; }
  std::vector<std::vector<ScenePose>> take_poses() { return std::move(poses_of_moments_); }

  void begins(const BodyDescription& body, const Scene& scene) override;
  Result<void> moved(const BodyState& state, const std::vector<ScenePose>& poses) override;
  Result<void> felt(const BodyState& state) override;

 private:
  void feel(const BodyState& state);
  Result<void> keep_pace(double passed);
  void tell();

  std::size_t index_;
  Showing& showing_;
  TaskQueue& queue_;
  GrowingExploration growing_;
  std::vector<std::vector<float>> felt_last_;  // of each channel
  Scene scene_;
  std::vector<ScenePose> poses_;  // after the last step
  std::vector<std::vector<ScenePose>> poses_of_moments_;
  double time_ = -1.0;  // by the body's clock; negative before its first step
  double begun_ = 0.0;
  std::size_t steps_left_ = 0;
  bool untold_ = false;  // the last step
  bool abandoned_ = false;
};

}  // namespace somato::live
