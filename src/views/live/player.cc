#include "views/live/player.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "views/live/naming_state.h"
#include "views/live/view_state.h"
#include "views/session/view_json.h"

namespace somato::live {
namespace {

constexpr auto kSlice = std::chrono::milliseconds(20);  // between two tasks, while it follows

template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};

}  // namespace

Player::Player(ViewSource source, const ViewSettings& settings, EventHub& hub, TaskQueue& queue)
    : hub_(hub),
      queue_(queue),
      stage_(std::move(source), settings, hub),
      body_(stage_, naming_, settings, queue),
      playback_(stage_, naming_, body_, settings.result_pause) {
  stage_.publish = [this] { publish_state(); };
}

void Player::begin() {
  guarded([this] {
    stage_.chosen.use();
    body_.want_to_explore(stage_.source.explorer && stage_.audience.has_begun());
    if (!stage_.source.explorer) {
      stage_.pace.playing = stage_.audience.has_begun();
      stage_.begin_exploration(0);
      stage_.replay.show(0);
    }
    publish_state();
  });
}

void Player::run() {
  while (!closed_) guarded([this] { turn(); });
  body_.join();
}

void Player::guarded(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::exception& error) {
    stage_.problem = fmt::format("Internal error: {}.", error.what());
    stage_.rest();
    stage_.replay.give_up();
    body_.give_up();
    publish_state();
    stage_.replay.tap().finish(fail(ErrorKind::kData, stage_.problem));
  }
}

// A task at a time: tasks that keep coming must not hold up what plays.
void Player::turn() {
  const bool may_explore = body_.wants_to_explore() && !stage_.audience.is_resting();
  if (may_explore && !body_.is_exploring() && !stage_.replay.is_behind()) body_.explore();
  closed_ = queue_.wait(stage_.replay.is_behind() ? Pace::Clock::now() : playback_.due()) ==
            TaskQueue::Woken::kClosed;
  if (closed_) return;
  naming_.take_name();  // before another exploration begins
  if (stage_.replay.is_behind()) {
    stage_.replay.follow(kSlice);
  } else if (const auto next = playback_.due(); next && *next <= Pace::Clock::now()) {
    stage_.pace.keep(*next);
    playback_.advance();
  }
  naming_.take_name();
  if (stage_.replay.reader().problem() != shown_system_problem_) publish_state();
  if (is_complete()) stage_.replay.tap().finish({});
}

// Whether all that was to be read has been played.
bool Player::is_complete() const {
  if (!stage_.source.explorer) return stage_.replay.tap().ended() == stage_.kept.count();
  if (body_.plan().demonstrates()) return false;
  const bool has_begun = body_.plan().is_planned() && !body_.plan().has_next();
  return has_begun && !body_.wants_to_explore() && !body_.is_exploring() &&
         !stage_.replay.is_behind();
}

Result<void> Player::handle(const ViewCommand& command) {
  stage_.audience.take_command();
  return std::visit(
      Overloaded{
          [&](const PlayCommand&) { return playback_.play(); },
          [&](const PauseCommand&) -> Result<void> {
            stage_.rest();
            return {};
          },
          [&](const StepCommand& one) { return playback_.step(one.frames); },
          [&](const SeekCommand& one) { return playback_.seek(one); },
          [&](const SpeedCommand& one) -> Result<void> {
            stage_.pace.speed = one.speed;
            return {};
          },
          [&](const ThingCommand& one) { return body_.choose_thing(one.name); },
          [&](const PlacementCommand& one) { return body_.place(one.placement); },
          [&](const ExploreCommand&) { return body_.begin_exploring(); },
          [&](const NameCommand& one) { return naming_.name(one); },
          [&](const UndoNameCommand& one) { return naming_.undo_name(one); },
          [&](const PlanCommand& one) -> Result<void> {
            stage_.kept.plan(one.each);
            return {};
          },
          [&](const SystemCommand& one) { return stage_.chosen.choose(one.name); },
          [&](const DismissCommand&) -> Result<void> {
            stage_.problem.clear();
            return {};
          },
          [&](const auto&) -> Result<void> { return not_now("the command is not supported"); }},
      command);
}

std::optional<Strips> Player::strips() const {
  if (stage_.replay.played() == nullptr) return {};
  return strips_of(*stage_.replay.played());
}

void Player::show_training(bool training) {
  training_ = training;
  publish_state();
}

void Player::show_problem(std::string problem) {
  stage_.problem = std::move(problem);
  publish_state();
}

Losses Player::losses() const {
  return {body_.failed(), stage_.kept.unsaved(), hub_.left()};
}

void Player::publish_state() {
  shown_system_problem_ = stage_.replay.reader().problem();
  hub_.publish(EventKind::kState, state_text());
}

std::string Player::state_text() const {
  ViewState state{stage_.source, stage_.replay.reader().picture(), stage_.kept,
                  stage_.replay.played()};
  state.labels = shown_labels();
  state.first_frame = stage_.replay.first();
  state.frame = stage_.replay.next();
  state.playing = stage_.pace.playing;
  state.speed = std::min(stage_.pace.speed, 100.0);  // the fastest that a page can choose
  state.thing = body_.plan().thing();
  state.placement = body_.plan().placement();
  state.system = stage_.chosen.number();
  state.system_problem = stage_.replay.reader().problem();
  state.teaches = stage_.chosen.teaches();
  state.taught = stage_.chosen.taught_names();
  state.training = training_;
  state.demonstrated = body_.plan().rounds();
  state.naming =
      naming_json(stage_.kept, stage_.replay.played(), stage_.replay.reader().picture().label);
  state.losses = losses();
  state.clients = hub_.viewers();
  state.awaits_start = stage_.audience.awaits_command();
  state.problem = stage_.problem;
  return json_text(state_json(state));
}

// While a body explores, the name of the thing that it was given.
std::vector<Label> Player::shown_labels() const {
  if (stage_.replay.played() == nullptr) return {};
  const PlayedExploration& played = *stage_.replay.played();
  if (played.has_ended) return stage_.kept.names().labels(played.index, played.exploration->labels);
  return stage_.kept.names().labels(played.index, {body_.thing()});
}

}  // namespace somato::live
