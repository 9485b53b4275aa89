#include "live/live_exploration.h"

#include <optional>
#include <span>

namespace somato::live {

void LiveExploration::begins(const BodyDescription& body, const Scene& scene) {
  growing_ = GrowingExploration(body);
  felt_last_.assign(body.sensors.size(), {});
  scene_ = scene;
  showing_.pace.begin();
  showing_.narrator.start();
  showing_.scene(&scene);
  showing_.change();
}

// Between grasps the body moves and nothing is recorded. Whether a step is recorded is known after
// it: one that was not is told before the next.
Result<void> LiveExploration::moved(const BodyState& state, const std::vector<ScenePose>& poses) {
  if (untold_) tell();
  if (time_ < 0.0) begun_ = time_ = state.time;
  const double passed = state.time - time_;
  time_ = state.time;
  poses_ = poses;
  feel(state);
  untold_ = true;
  return keep_pace(passed);
}

Result<void> LiveExploration::felt(const BodyState& state) {
  growing_.append(state);
  follow_anew();
  poses_of_moments_.push_back(poses_);
  if (steps_left_ > 0) --steps_left_;
  tell();
  return {};
}

void LiveExploration::follow_anew() {
  showing_.narrator.follow(growing_.so_far(), growing_.frames());
}

void LiveExploration::pause(std::size_t frames) {
  showing_.pace.playing = false;
  steps_left_ = frames;
}

void LiveExploration::feel(const BodyState& state) {
  for (std::size_t i = 0; i < felt_last_.size(); ++i) {
    const Matrix<float>& frames = state.readings[i];
    if (frames.rows() == 0) continue;
    const auto row = frames.row(frames.rows() - 1);
    felt_last_[i].assign(row.begin(), row.end());
  }
}

void LiveExploration::tell() {
  untold_ = false;
  const std::size_t come = growing_.moments();
  ShownMoment shown{index_, come == 0 ? 0 : come - 1, {}, time_ - begun_, false, {}, poses_};
  const auto& channels = growing_.so_far().channels;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const bool fast = channels[i].rate > 0.0 && growing_.frames()[i] > 0;
    shown.channels.emplace_back(
        channels[i].name, fast ? shown_values(channels[i], channels[i].rate, growing_.frames()[i])
                               : std::span<const float>(felt_last_[i]));
  }
  showing_.frame(shown, [&] { return growing_.so_far(); });
}

// The body waits until its time has come, as long as it is paused, and for what others want.
Result<void> LiveExploration::keep_pace(double passed) {
  Pace& pace = showing_.pace;
  const auto due = [&]() -> std::optional<Pace::Clock::time_point> {
    if (!pace.playing && steps_left_ == 0) return {};
    return pace.due(passed);
  };
  while (!abandoned_) {
    if (queue_.wait(due()) == TaskQueue::Woken::kClosed) break;
    const auto next = due();
    if (abandoned_ || !next || *next > Pace::Clock::now()) continue;
    pace.keep(*next);
    return {};
  }
  return fail(ErrorKind::kInterrupted, "something else is wanted");
}

}  // namespace somato::live
