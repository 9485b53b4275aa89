#include "views/replay/replay.h"

#include <algorithm>
#include <ctime>
#include <span>
#include <utility>
#include <vector>

#include "views/replay/body_thread.h"

namespace somato::live {
namespace {

constexpr auto kMostFollowed = std::chrono::milliseconds(250);  // that a command waits for

// The processor time of this thread: a busy machine takes none of it.
std::chrono::nanoseconds time_worked() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

}  // namespace

void Replay::begin(PlayedExploration played) {
  played_ = std::move(played);
  next_ = 0;
  followed_ = 0;
  wanted_.reset();
  reader_.start();
  tap_.begin(*played_);
  publish_scene();
}

void Replay::end() {
  played_.reset();
  next_ = 0;
  wanted_.reset();
}

void Replay::say_end() {
  played_->has_ended = true;
  tap_.say(*played_, followed_, reader_);
}

// A page redraws its scene for each new one.
void Replay::publish_scene() const {
  std::string text =
      played_->scene != nullptr ? json_text(scene_json(played_->scene->scene())) : "null";
  const EventHub::Text before = hub_.latest(EventKind::kScene);
  if (!before || *before != text) hub_.publish(EventKind::kScene, std::move(text));
}

void Replay::choose(const ViewSystem* system, const std::optional<RecordingLayout>& layout) {
  reader_.choose(system, layout);
  followed_ = first() == 0 ? 0 : next_;
  if (first() > 0) reader_.give_up();
  if (played_) show(next_ == 0 ? 0 : next_ - 1);
}

void Replay::show(std::size_t moment) {
  if (moments() == 0) return;
  wanted_ = moment;
  next_ = moment + 1;
  follow(kMostFollowed);
}

void Replay::follow(std::chrono::milliseconds patience) {
  if (*wanted_ + 1 < followed_ && first() == 0) {
    reader_.start();
    followed_ = 0;
  }
  const auto until = time_worked() + patience;
  std::vector<std::size_t> come(played_->exploration->channels.size());
  while (followed_ <= *wanted_) {
    if (time_worked() > until) return;
    ++followed_;
    for (std::size_t i = 0; i < come.size(); ++i) come[i] = frames(i, followed_);
    reader_.follow(*played_->exploration, come, played_->timeline->dropped());
    tap_.say(*played_, followed_, reader_);
  }
  publish_moment(*std::exchange(wanted_, std::nullopt));
}

std::size_t Replay::frames(std::size_t channel, std::size_t moments) const {
  return moments == 0 ? 0 : played_->timeline->frames(channel, moments - 1);
}

// The same, counted from the first one that is kept.
std::size_t Replay::kept_frames(std::size_t channel, std::size_t moments) const {
  const std::size_t come = frames(channel, moments);
  return come == 0 ? 0 : come - played_->timeline->dropped(channel);
}

// The moment that is shown when so many moments have passed.
ShownMoment Replay::shown_after(std::size_t moments) const {
  const Timeline& timeline = *played_->timeline;
  ShownMoment shown;
  shown.exploration = played_->index;
  shown.frame = moments == 0 ? 0 : moments - 1;
  if (played_->has_ended) {
    shown.frames = timeline.moments();
    shown.last = moments == timeline.moments();
  }
  const auto& channels = played_->exploration->channels;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    shown.channels.emplace_back(
        channels[i].name, shown_values(channels[i], timeline.rate(i), kept_frames(i, moments)));
  }
  return shown;
}

void Replay::publish_moment(std::size_t moment) {
  ShownMoment shown = shown_after(moment + 1);
  shown.time = played_->timeline->time(moment);
  if (played_->scene) {
    std::size_t most = 0;
    for (std::size_t i = 0; i < shown.channels.size(); ++i) {
      most = std::max(most, kept_frames(i, moment + 1));
    }
    shown.poses = played_->scene->poses(*played_->exploration, most - 1);
  }
  publish(shown);
}

// Stretches stay those of the exploration.
void Replay::show_between(const BodyStep& step) {
  ShownMoment shown = shown_after(moments());
  shown.time = step.state.time;
  shown.poses = step.poses;
  for (std::size_t i = 0; i < shown.channels.size(); ++i) {
    const Matrix<float>& read = step.state.readings[i];
    auto& values = shown.channels[i].second;
    if (values.size() > read.columns() || read.rows() == 0) continue;
    const std::span<const float> latest = read.row(read.rows() - 1);
    values.assign(latest.begin(), latest.end());
  }
  publish(shown);
}

void Replay::publish(const ShownMoment& shown) {
  const bool is_read = next_ >= followed_;
  const Reading* reading = is_read ? reader_.read(shown.last || !pace_.playing) : nullptr;
  std::string text = frame_text(shown, reader_.model(), reading);
  if (shown.last) return hub_.publish_end(std::move(text));
  hub_.publish(EventKind::kFrame, std::move(text));
}

double Replay::pause() const {
  const Timeline& timeline = *played_->timeline;
  const double before = next_ == 0 ? 0.0 : timeline.time(next_ - 1);
  return std::clamp(timeline.time(next_) - before, 0.0, kLongestPause);
}

}  // namespace somato::live
