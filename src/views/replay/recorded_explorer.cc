#include "views/replay/recorded_explorer.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <span>
#include <utility>

#include "base/files/file_system.h"
#include "recordings/explorations/checked_explorations.h"
#include "recordings/explorations/exploration_frames.h"
#include "recordings/explorations/growing_channel.h"
#include "views/replay/moments.h"

namespace somato::live {
namespace {

tl::unexpected<Error> stopped_playing() {
  return fail(ErrorKind::kInterrupted, "playing the recording was interrupted");
}

// Takes the frames of an exploration and gives its moments to an observer.
class PlayedMoments final : public FrameSink {
 public:
  PlayedMoments(const ExplorationOutline& outline, const ExploreOptions& options, bool collects)
      : outline_(&outline), options_(&options), collects_(collects), moments_(outline.channels) {}

  // The description has the rates of channels with times, too: modules compute with them.
  Result<void> begin_exploration(const ExplorationStart& start) override {
    if (start.channels.size() != outline_->channels.size()) return has_changed();
    start_ = start;
    BodyDescription body{start.source, {}, start.channels};
    for (std::size_t i = 0; i < body.sensors.size(); ++i) {
      body.sensors[i].rate = outline_->channels[i].rate;
    }
    waiting_.resize(body.sensors.size());
    collected_.resize(body.sensors.size());
    given_.resize(body.sensors.size());
    state_.readings.resize(body.sensors.size());
    const auto& on_begin = options_->observer.on_begin;
    return on_begin ? on_begin(body, Scene{}) : Result<void>();
  }

  Result<void> frame(std::size_t channel, std::span<const float> values, double time,
                     std::span<const std::uint8_t> valid) override {
    const auto& should_continue = options_->limits.should_continue;
    if (should_continue && !should_continue()) return stopped_playing();
    waiting_[channel].add(values, {}, valid);
    if (channel == moments_.longest()) times_.push_back(time);
    collect(channel, values, time, valid);
    while (next_ < moments_.count() && has_come()) SOMATO_TRY_VOID(give());
    return {};
  }

  Result<void> end_exploration() override {
    return next_ == moments_.count() ? Result<void>() : has_changed();
  }

  // Without frames if they were not to be collected, or took more memory than permitted.
  Exploration exploration() && {
    Exploration played{std::move(start_.labels), std::move(start_.source), {}};
    for (std::size_t i = 0; i < collected_.size(); ++i) {
      played.channels.push_back(
          described(std::move(collected_[i]), start_.channels[i], waiting_[i].elements()));
    }
    return played;
  }

 private:
  static tl::unexpected<Error> has_changed() {
    return fail(ErrorKind::kData, "the recording has changed since it was opened", {},
                "run the command again");
  }

  void collect(std::size_t channel, std::span<const float> values, double time,
               std::span<const std::uint8_t> valid) {
    if (!collects_) return;
    add_frame(collected_[channel], values, time, valid);
    bytes_ += values.size_bytes() + valid.size() + sizeof(double);
    collects_ = bytes_ <= options_->limits.memory;
    if (!collects_) collected_.assign(collected_.size(), {});
  }

  bool has_come() const {
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
      if (given_[i] + waiting_[i].count() < moments_.frames(i, next_)) return false;
    }
    return true;
  }

  Result<void> give() {
    const std::size_t longest = moments_.longest();
    const std::size_t frames = moments_.frames(longest, next_) - given_[longest];
    state_.time = time_of(moments_.frames(longest, next_) - 1, times_[frames - 1]);
    times_.erase(times_.begin(), times_.begin() + static_cast<std::ptrdiff_t>(frames));
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
      const std::size_t count = moments_.frames(i, next_) - given_[i];
      state_.readings[i] = waiting_[i].take(count);
      given_[i] += count;
    }
    ++next_;
    const auto& on_step = options_->observer.on_step;
    return on_step ? on_step({state_, {}, Readings::kRecorded}) : Result<void>();
  }

  // As in a Timeline of the whole exploration.
  double time_of(std::size_t frame, double time) const {
    const ChannelDescription& channel = start_.channels[moments_.longest()];
    if (channel.rate > 0.0) return static_cast<double>(frame) / channel.rate;
    return channel.times_known ? time : kUnknownStep * static_cast<double>(next_);
  }

  const ExplorationOutline* outline_;
  const ExploreOptions* options_;
  bool collects_;
  Moments moments_;
  ExplorationStart start_;
  BodyState state_;
  std::size_t next_ = 0;  // moment
  std::vector<WaitingFrames> waiting_;
  std::vector<std::size_t> given_;  // frames of each channel that a moment has had
  std::deque<double> times_;        // of the waiting frames of the longest channel
  std::vector<Channel> collected_;
  std::size_t bytes_ = 0;  // of these
};

}  // namespace

RecordedExplorer::RecordedExplorer(const std::string& path, RecordingReader reader,
                                   RecordingLayout layout, std::vector<ExplorationOutline> outlines,
                                   bool collects_frames)
    : Explorer({{"recording", {}, {}}}, path),
      reader_(std::move(reader)),
      layout_(std::move(layout)),
      outlines_(std::move(outlines)),
      collects_frames_(collects_frames) {}

Result<std::unique_ptr<RecordedExplorer>> RecordedExplorer::open(const std::string& path,
                                                                 bool collects_frames) {
  RecordingOutline outline;
  CheckedExplorations checked(outline);
  SOMATO_TRY_VOID(hand_file(operating_system(), path, checked));
  if (checked.count() == 0) return fail(validate({}).error());
  SOMATO_TRY(RecordingReader reader, RecordingReader::open(path));
  return std::unique_ptr<RecordedExplorer>(new RecordedExplorer(
      path, std::move(reader), layout_of(checked.first(), outline.explorations()),
      outline.explorations(), collects_frames));
}

std::vector<Label> RecordedExplorer::labels(std::size_t /*thing*/, std::size_t trial) const {
  return outlines_.at(trial).labels;
}

Result<Exploration> RecordedExplorer::explore_thing(std::size_t /*thing*/, std::size_t trial,
                                                    const ExploreOptions& options) {
  PlayedMoments moments(outlines_.at(trial), options, collects_frames_);
  SOMATO_TRY(const bool found, reader_.next(moments));
  if (found) return std::move(moments).exploration();
  return fail(ErrorKind::kUnavailable, "no further exploration of the recording can be read");
}

}  // namespace somato::live
