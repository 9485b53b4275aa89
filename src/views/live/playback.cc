#include "views/live/playback.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

namespace somato::live {
namespace {

constexpr double kBetweenExplorations = 1.5;  // s
constexpr double kLongerResult = 3.0;         // times the pause after a result

}  // namespace

std::optional<Pace::Clock::time_point> Playback::due() const {
  if (!stage_.pace.playing && stage_.moments_left == 0) return {};
  if (!stage_.replay.is_over()) return stage_.pace.due(stage_.replay.pause());
  if (const auto step = body_.seconds_to_step()) {
    return stage_.pace.due(std::min(*step, kLongestPause));
  }
  if (body_.is_growing() || stage_.replay.played() == nullptr) return {};
  if (body_.plan().demonstrates()) return stage_.pace.due(pause_after_result() * stage_.pace.speed);
  return stage_.pace.due(kBetweenExplorations);
}

// Longer where an unknown thing can be named, and where that shows what was learned.
double Playback::pause_after_result() const {
  const bool is_named = stage_.chosen.is_taught(stage_.replay.played()->index);
  return is_named || stage_.chosen.answers_unknown() ? kLongerResult * result_pause_
                                                     : result_pause_;
}

void Playback::advance() {
  if (!stage_.replay.is_over()) return stage_.replay.show(stage_.replay.next());
  if (body_.seconds_to_step()) return body_.show_step();
  play_next();
  stage_.publish();
}

// After the last exploration everything rests.
void Playback::play_next() {
  if (body_.plan().demonstrates()) return play_next_of_demonstration();
  const std::size_t next = stage_.replay.played()->index + 1;
  if (next == stage_.kept.count() || stage_.source.explorer) return stage_.rest();
  stage_.begin_exploration(next);
  stage_.replay.show(0);
}

// After the last exploration, all are played again, by the system as it was at first.
void Playback::play_next_of_demonstration() {
  if (naming_.teach_demonstrated()) return;
  const std::size_t next = stage_.replay.played()->index + 1;
  const bool was_last = next == stage_.kept.count();
  body_.want_to_explore(was_last && body_.plan().has_next());
  if (body_.wants_to_explore()) return;
  if (was_last) {
    body_.plan().complete_round();
    stage_.chosen.forget();
  }
  stage_.begin_exploration(was_last ? stage_.kept.first() : next);
  stage_.replay.show(0);
}

Result<void> Playback::play() {
  if (stage_.audience.awaits_command()) {
    return not_now("the body is real and moves only after a press of Start");
  }
  if (body_.plan().is_planned() && stage_.audience.begin()) {
    body_.want_to_explore(true);
    return {};
  }
  if (stage_.replay.played() == nullptr && !body_.is_exploring()) return body_.begin_exploring();
  stage_.pace.playing = true;
  stage_.pace.begin();
  if (body_.is_exploring() || !stage_.replay.is_over()) return {};
  const std::size_t index = stage_.replay.played()->index;
  const bool is_last = index + 1 == stage_.kept.count();
  stage_.begin_exploration(stage_.source.explorer ? index : is_last ? 0 : index + 1);
  stage_.replay.show(0);
  return {};
}

// Beyond the last explored moment, the body continues.
Result<void> Playback::step(std::int64_t frames) {
  const auto first = static_cast<std::int64_t>(stage_.replay.first());
  const auto last = static_cast<std::int64_t>(stage_.replay.moments()) - 1;
  const std::int64_t wanted = static_cast<std::int64_t>(stage_.replay.next()) - 1 + frames;
  const bool beyond = body_.is_growing() && wanted > last;
  if (last < 0 && !beyond) return not_now("no frames to step through");
  stage_.rest();
  if (beyond) {
    stage_.moments_left = static_cast<std::size_t>(wanted - last);
    stage_.pace.begin();
  }
  if (!beyond || !stage_.replay.is_over()) {
    stage_.replay.show(static_cast<std::size_t>(std::clamp<std::int64_t>(wanted, first, last)));
  }
  return {};
}

Result<void> Playback::seek(const SeekCommand& seek) {
  const bool is_played =
      stage_.replay.played() != nullptr && seek.exploration == stage_.replay.played()->index;
  if (body_.is_growing() && !is_played) {
    return not_now("another exploration cannot be shown while the body explores");
  }
  if (!is_played && stage_.replay.tap().is_open()) {
    return not_now("another exploration cannot be shown while the readings are written");
  }
  if (!is_played && seek.exploration >= stage_.kept.count()) {
    return not_now(fmt::format("the recording has {} explorations", stage_.kept.count()));
  }
  const bool is_kept =
      is_played ? seek.frame >= stage_.replay.first() : seek.exploration >= stage_.kept.first();
  if (!is_kept) return not_now("it is no longer kept (--page-memory)");
  std::shared_ptr<const Timeline> timeline =
      is_played ? nullptr : std::make_shared<Timeline>(stage_.kept[seek.exploration]);
  const std::size_t moments = is_played ? stage_.replay.moments() : timeline->moments();
  if (seek.frame >= moments) return not_now(fmt::format("the exploration has {} frames", moments));
  if (!is_played) stage_.begin_exploration(seek.exploration, std::move(timeline));
  stage_.moments_left = 0;
  stage_.pace.begin();
  stage_.replay.show(seek.frame);
  return {};
}

void Playback::on_viewers(std::size_t viewers) {
  switch (stage_.audience.set_viewers(viewers, stage_.pace.playing)) {
    case Audience::Change::kBegin:
      return begin_seen();
    case Audience::Change::kRest:
      return stage_.rest();
    case Audience::Change::kContinue:
      stage_.pace.playing = true;
      return stage_.pace.begin();
    case Audience::Change::kNone:
      break;
  }
}

void Playback::begin_seen() {
  stage_.pace.begin();
  body_.want_to_explore(stage_.source.explorer != nullptr);
  stage_.pace.playing = !body_.wants_to_explore();
}

}  // namespace somato::live
