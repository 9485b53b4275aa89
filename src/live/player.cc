#include "live/player.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "live/kept_scene.h"
#include "live/view_json.h"
#include "live/view_state.h"

namespace somato::live {
namespace {

constexpr std::size_t kMostExplorations = 10000;  // of a body
constexpr double kBetweenExplorations = 1.5;      // s

template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};

tl::unexpected<Error> not_now(std::string what) {
  return fail(ErrorKind::kUsage, std::move(what));
}

}  // namespace

Player::Player(ViewSource source, const ViewSettings& settings, EventHub& hub, TaskQueue& queue)
    : source_(std::move(source)),
      hub_(hub),
      queue_(queue),
      showing_(hub, [this] { publish_state(); }),
      replay_(showing_, queue),
      system_(source_.system),
      welcomed_(!settings.wait_for_viewer),
      thing_(source_.thing) {
  showing_.pace.speed = settings.speed;
  explored_scenes_.resize(source_.recording.explorations.size());
}

void Player::begin() {
  guarded([this] { set_out(); });
}

void Player::run() {
  while (!closed_) guarded([this] { go_on(); });
}

void Player::guarded(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::exception& error) {
    problem_ = fmt::format("Something went wrong here: {}.", error.what());
    showing_.pace.playing = false;
    replay_.give_up();
    live_.reset();
    publish_state();
  }
}

void Player::set_out() {
  tell_narrator();
  if (source_.body) {
    wants_exploring_ = welcomed_;
  } else {
    showing_.pace.playing = welcomed_;
    begin_exploration(0);
    replay_.show(0);
  }
  publish_state();
}

// Tasks that keep coming must not hold up what plays.
void Player::go_on() {
  if (wants_exploring_) return explore();
  if (replay_.is_behind()) return replay_.catch_up();
  closed_ = queue_.wait(due()) == TaskQueue::Woken::kClosed;
  const auto next = due();
  if (!closed_ && next && *next <= Pace::Clock::now()) advance();
}

Result<void> Player::handle(const ViewCommand& command) {
  return std::visit(
      Overloaded{[&](const PlayCommand&) { return play(); },
                 [&](const PauseCommand&) { return pause(); },
                 [&](const StepCommand& one) { return step(one.frames); },
                 [&](const SeekCommand& one) { return seek(one); },
                 [&](const SpeedCommand& one) -> Result<void> {
                   showing_.pace.speed = one.speed;
                   return {};
                 },
                 [&](const ThingCommand& one) { return choose_thing(one.name); },
                 [&](const PlacementCommand& one) { return place(one.placement); },
                 [&](const ExploreCommand&) { return begin_exploring(); },
                 [&](const SystemCommand& one) { return choose_system(one.name); },
                 [&](const auto&) -> Result<void> { return not_now("this is not done here"); }},
      command);
}

void Player::welcome() {
  if (std::exchange(welcomed_, true)) return;
  showing_.pace.begin();
  if (source_.body) {
    wants_exploring_ = true;
  } else {
    showing_.pace.playing = true;
  }
}

void Player::begin_exploration(std::size_t index) {
  const Exploration& chosen = source_.recording.explorations[index];
  std::shared_ptr<ScenePlayer> scene = explored_scenes_[index];
  if (!scene && source_.scenes) scene = source_.scenes(chosen);
  replay_.begin(index, chosen, std::move(scene));
}

std::optional<Pace::Clock::time_point> Player::due() const {
  if (!showing_.pace.playing || !replay_.index() || replay_.is_behind()) return {};
  return showing_.pace.due(replay_.is_over() ? kBetweenExplorations : replay_.pause());
}

// The next moment, or exploration; after the last one everything rests.
void Player::advance() {
  showing_.pace.keep(*due());
  if (!replay_.is_over()) return replay_.show(replay_.next());
  if (*replay_.index() + 1 < source_.recording.explorations.size() && !source_.body) {
    begin_exploration(*replay_.index() + 1);
    replay_.show(0);
  } else {
    showing_.pace.playing = false;
  }
  publish_state();
}

Result<void> Player::play() {
  if (!replay_.index() && !live_) return begin_exploring();
  showing_.pace.playing = true;
  showing_.pace.begin();
  if (live_ || !replay_.is_over()) return {};
  const std::size_t index = *replay_.index();
  const bool is_last = index + 1 == source_.recording.explorations.size();
  begin_exploration(source_.body ? index : is_last ? 0 : index + 1);
  replay_.show(0);
  return {};
}

Result<void> Player::pause() {
  showing_.pace.playing = false;
  if (live_) live_->pause();
  return {};
}

Result<void> Player::step(std::int64_t frames) {
  if (live_) {
    if (frames < 0) return not_now("while the body explores there is no way back");
    live_->pause(static_cast<std::size_t>(frames));
    return {};
  }
  if (replay_.timeline().moments() == 0) return not_now("there is nothing to step through");
  showing_.pace.playing = false;
  const auto last = static_cast<std::int64_t>(replay_.timeline().moments()) - 1;
  const auto shown = static_cast<std::int64_t>(replay_.next()) - 1;
  replay_.show(static_cast<std::size_t>(std::clamp<std::int64_t>(shown + frames, 0, last)));
  return {};
}

Result<void> Player::seek(const SeekCommand& seek) {
  if (live_) return not_now("while the body explores nothing else can be looked at");
  const auto& explorations = source_.recording.explorations;
  if (seek.exploration >= explorations.size()) {
    return not_now(fmt::format("there are {} explorations", explorations.size()));
  }
  const std::size_t moments = Timeline(explorations[seek.exploration]).moments();
  if (seek.frame >= moments) return not_now(fmt::format("this exploration has {} frames", moments));
  if (seek.exploration != replay_.index()) begin_exploration(seek.exploration);
  showing_.pace.begin();
  replay_.show(seek.frame);
  return {};
}

Result<void> Player::choose_thing(const std::string& name) {
  if (!source_.body) return not_now("a recording holds what it holds");
  const auto& things = source_.body->things();
  const auto found = std::find_if(things.begin(), things.end(),
                                  [&](const ShownThing& thing) { return thing.name == name; });
  if (found == things.end()) return not_now("there is no such thing");
  thing_ = static_cast<std::size_t>(found - things.begin());
  return {};
}

Result<void> Player::place(const Placement& placement) {
  if (!source_.body || !source_.body->takes_placement()) {
    return not_now("there is nothing to be placed");
  }
  placement_ = placement;
  return {};
}

Result<void> Player::begin_exploring() {
  if (!source_.body) return not_now("only a body can explore");
  if (source_.recording.explorations.size() >= kMostExplorations) {
    return not_now(fmt::format("{} explorations are kept, and no more", kMostExplorations));
  }
  if (live_) live_->abandon();
  replay_.give_up();
  wants_exploring_ = true;
  welcomed_ = true;
  return {};
}

Result<void> Player::choose_system(const std::string& name) {
  const auto found = std::find_if(source_.systems.begin(), source_.systems.end(),
                                  [&](const ViewSystem& one) { return one.name == name; });
  if (found == source_.systems.end()) return not_now("there is no such system");
  system_ = static_cast<std::size_t>(found - source_.systems.begin());
  tell_narrator();
  return {};
}

void Player::take_trained(const std::string& name,
                          const std::shared_ptr<const SystemModel>& model) {
  for (ViewSystem& one : source_.systems) {
    if (one.name == name) one.trained = model;
  }
  if (system() != nullptr && system()->name == name) tell_narrator();
}

// It hears what has come so far at once.
void Player::tell_narrator() {
  const Recording& recording = source_.recording;
  showing_.narrator.choose(system(), recording.explorations.empty()
                                         ? std::optional<RecordingLayout>()
                                         : layout_of(recording));
  if (live_) {
    live_->follow_anew();
  } else {
    replay_.follow_anew();
  }
}

void Player::show_training(bool training) {
  training_ = training;
  publish_state();
}

void Player::show_problem(std::string problem) {
  problem_ = std::move(problem);
  publish_state();
}

std::optional<Strips> Player::strips() const {
  if (live_) return strips_of(live_->grown(), live_->index(), live_->begun());
  if (!replay_.index()) return {};
  return strips_of(*replay_.exploration(), *replay_.index(), replay_.timeline());
}

void Player::publish_state() {
  ViewState state{source_, showing_.narrator.picture(),
                  live_ ? &live_->grown().so_far() : replay_.exploration(),
                  live_ ? std::optional(live_->index()) : replay_.index()};
  state.frame = live_ ? live_->grown().moments() : replay_.next();
  const Timeline& timeline = replay_.timeline();
  if (timeline.moments() > 0) {
    state.frames = timeline.moments();
    state.duration = timeline.time(timeline.moments() - 1);
  }
  state.playing = showing_.pace.playing;
  state.speed = showing_.pace.speed;
  state.live = live_ != nullptr;
  state.thing = thing_;
  state.placement = placement_;
  state.system = system_;
  state.system_problem = showing_.narrator.problem();
  state.training = training_;
  state.clients = hub_.lookers_on();
  state.problem = problem_;
  showing_.state(state);
}

void Player::explore() {
  wants_exploring_ = false;
  problem_.clear();
  replay_.end();
  live_ =
      std::make_unique<LiveExploration>(source_.recording.explorations.size(), showing_, queue_);
  showing_.pace.playing = true;
  auto kept = source_.body->explore({thing_, trials_++, placement_}, *live_)
                  .and_then([this](Exploration one) { return keep_explored(std::move(one)); });
  live_.reset();
  showing_.pace.playing = false;
  if (kept) {
    begin_exploration(source_.recording.explorations.size() - 1);
    replay_.show(replay_.timeline().moments() - 1);
  } else if (kept.error().kind != ErrorKind::kInterrupted) {
    problem_ = sentence_of(kept.error());
  }
  publish_state();
}

Result<void> Player::keep_explored(Exploration exploration) {
  auto& explorations = source_.recording.explorations;
  explorations.push_back(std::move(exploration));
  if (auto valid = validate(source_.recording); !valid) {
    explorations.pop_back();
    return valid;
  }
  explored_scenes_.push_back(kept_scene());
  return {};
}

// The scene of a thing is the same each time.
std::shared_ptr<ScenePlayer> Player::kept_scene() {
  std::shared_ptr<const Scene>& kept = kept_scenes_[json_text(scene_json(live_->scene()))];
  if (!kept) kept = std::make_shared<const Scene>(live_->scene());
  return std::make_shared<KeptScene>(kept, live_->take_poses());
}

}  // namespace somato::live
