#include "live/player.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "live/kept_scene.h"
#include "live/view_state.h"

namespace somato::live {
namespace {

constexpr std::size_t kMostExplorations = 10000;  // of a body
constexpr double kLongestPause = 1.0;         // s, between two moments: nothing was recorded there
constexpr double kBetweenExplorations = 1.5;  // s
constexpr auto kMostLate = std::chrono::milliseconds(250);
constexpr auto kSlice = std::chrono::milliseconds(20);          // between two looks at the queue
constexpr auto kMostFollowed = std::chrono::milliseconds(250);  // that a command waits for

template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};

std::chrono::steady_clock::duration in_clock(double seconds) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(
      std::chrono::duration<double>(seconds));
}

// True as long as this lives.
class Raised {
 public:
  explicit Raised(bool& flag) : flag_(flag) { flag_ = true; }
  Raised(const Raised&) = delete;
  Raised(Raised&&) = delete;
  Raised& operator=(const Raised&) = delete;
  Raised& operator=(Raised&&) = delete;
  ~Raised() { flag_ = false; }

 private:
  bool& flag_;
};

tl::unexpected<Error> not_now(std::string what) {
  return fail(ErrorKind::kUsage, std::move(what));
}

}  // namespace

Player::Player(ViewSource source, const ViewSettings& settings, EventHub& hub, TaskQueue& queue)
    : source_(std::move(source)),
      hub_(hub),
      queue_(queue),
      system_(source_.system),
      welcomed_(!settings.wait_for_viewer),
      speed_(settings.speed),
      thing_(source_.thing) {
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
    playing_ = false;
    wanted_.reset();
    if (std::exchange(live_, false)) lose_exploration();
    publish_state();
  }
}

void Player::set_out() {
  tell_narrator();
  if (source_.body) {
    wants_exploring_ = welcomed_;
  } else {
    playing_ = welcomed_;
    begin_exploration(0);
    show(0);
  }
  publish_state();
}

// Tasks that keep coming must not hold up what plays.
void Player::go_on() {
  if (wants_exploring_) return explore();
  if (wanted_) return follow_on();
  closed_ = queue_.wait(due()) == TaskQueue::Woken::kClosed;
  const auto next = due();
  if (!closed_ && next && *next <= Clock::now()) advance();
}

Result<void> Player::handle(const ViewCommand& command) {
  return std::visit(
      Overloaded{[&](const PlayCommand&) { return play(); },
                 [&](const PauseCommand&) -> Result<void> {
                   playing_ = false;
                   steps_left_ = 0;
                   return {};
                 },
                 [&](const StepCommand& one) { return step(one.frames); },
                 [&](const SeekCommand& one) { return seek(one); },
                 [&](const SpeedCommand& one) -> Result<void> {
                   speed_ = one.speed;
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
  shown_at_ = Clock::now();
  if (source_.body) {
    wants_exploring_ = true;
  } else {
    playing_ = true;
  }
}

void Player::begin_exploration(std::size_t exploration) {
  exploration_ = exploration;
  const Exploration& chosen = source_.recording.explorations[exploration];
  timeline_ = Timeline(chosen);
  next_ = 0;
  followed_ = 0;
  wanted_.reset();
  narrator_.start();
  scene_ = exploration < explored_scenes_.size() ? explored_scenes_[exploration] : nullptr;
  if (!scene_ && source_.scenes) scene_ = source_.scenes(chosen);
  publish_scene(scene_ ? &scene_->scene() : nullptr);
}

// Whoever follows already goes there instead of where it was going.
void Player::show(std::size_t moment) {
  if (timeline_.moments() == 0) return;
  wanted_ = moment;
  next_ = moment + 1;
  if (!following_) follow_on();
}

// It may be a long way to the moment that is wanted: tasks are done in between, which may want
// another. What is not reached in time go_on() takes up.
void Player::follow_on() {
  const auto until = Clock::now() + kMostFollowed;
  const Raised following(following_);
  while (wanted_ && !closed_ && !wants_exploring_ && Clock::now() < until) {
    if (follow_to(*wanted_)) {
      publish_moment(*std::exchange(wanted_, std::nullopt));
    } else {
      closed_ = queue_.wait(Clock::now()) == TaskQueue::Woken::kClosed;
    }
  }
}

// What a system remembers depends on every moment before. Returns whether it is there.
bool Player::follow_to(std::size_t moment) {
  if (moment + 1 < followed_) {
    narrator_.start();
    followed_ = 0;
  }
  const auto until = Clock::now() + kSlice;
  const Exploration& exploration = source_.recording.explorations[*exploration_];
  std::vector<std::size_t> come(exploration.channels.size());
  do {
    if (followed_ > moment) return true;
    for (std::size_t i = 0; i < come.size(); ++i) come[i] = timeline_.frames(i, followed_);
    narrator_.follow(exploration, come);
    ++followed_;
  } while (Clock::now() < until);
  return followed_ > moment;
}

void Player::publish_moment(std::size_t moment) {
  const Exploration& exploration = source_.recording.explorations[*exploration_];
  ShownMoment shown{*exploration_,
                    moment,
                    timeline_.moments(),
                    timeline_.time(moment),
                    moment + 1 == timeline_.moments(),
                    {},
                    {}};
  std::size_t frame = 0;
  for (std::size_t i = 0; i < exploration.channels.size(); ++i) {
    const std::size_t come = timeline_.frames(i, moment);
    frame = std::max(frame, come);
    shown.channels.emplace_back(exploration.channels[i].name,
                                shown_values(exploration.channels[i], timeline_.rate(i), come));
  }
  if (scene_) shown.poses = scene_->poses(exploration, frame - 1);
  publish_frame(shown, [&] { return cut_at(exploration, timeline_, moment); });
}

void Player::show_again() {
  if (live_ || !exploration_) return;
  show(next_ == 0 ? 0 : next_ - 1);
}

void Player::publish_frame(const ShownMoment& moment, const std::function<Exploration()>& so_far) {
  const Saying* saying = narrator_.say(moment.last || !playing_, so_far);
  hub_.publish(EventKind::kFrame, frame_text(moment, narrator_.model(), saying));
  if (narrator_.problem() != told_problem_) publish_state();
}

void Player::publish_scene(const Scene* scene) {
  std::string text = scene != nullptr ? json_text(scene_json(*scene)) : "null";
  const EventHub::Text before = hub_.latest(EventKind::kScene);
  if (!before || *before != text) hub_.publish(EventKind::kScene, std::move(text));
}

std::optional<Player::Clock::time_point> Player::due() const {
  if (!playing_ || !exploration_ || wanted_) return {};
  double pause = kBetweenExplorations;
  if (next_ < timeline_.moments()) {
    const double before = next_ == 0 ? 0.0 : timeline_.time(next_ - 1);
    pause = std::clamp(timeline_.time(next_) - before, 0.0, kLongestPause);
  }
  return shown_at_ + in_clock(pause / speed_);
}

// The next moment, or exploration; after the last one everything rests.
void Player::advance() {
  shown_at_ = std::max(*due(), Clock::now() - kMostLate);
  if (next_ < timeline_.moments()) return show(next_);
  if (*exploration_ + 1 < source_.recording.explorations.size() && !source_.body) {
    begin_exploration(*exploration_ + 1);
    show(0);
  } else {
    playing_ = false;
  }
  publish_state();
}

Result<void> Player::play() {
  if (!exploration_ && !live_) return begin_exploring();
  playing_ = true;
  shown_at_ = Clock::now();
  if (live_ || next_ < timeline_.moments()) return {};
  const bool is_last = *exploration_ + 1 == source_.recording.explorations.size();
  begin_exploration(source_.body ? *exploration_ : is_last ? 0 : *exploration_ + 1);
  show(0);
  return {};
}

Result<void> Player::step(std::int64_t frames) {
  if (live_) {
    if (frames < 0) return not_now("while the body explores there is no way back");
    playing_ = false;
    steps_left_ = static_cast<std::size_t>(frames);
    return {};
  }
  if (!exploration_ || timeline_.moments() == 0) {
    return not_now("there is nothing to step through");
  }
  playing_ = false;
  const auto last = static_cast<std::int64_t>(timeline_.moments()) - 1;
  const auto shown = static_cast<std::int64_t>(next_) - 1;
  show(static_cast<std::size_t>(std::clamp<std::int64_t>(shown + frames, 0, last)));
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
  if (seek.exploration != exploration_) begin_exploration(seek.exploration);
  shown_at_ = Clock::now();
  show(seek.frame);
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
  abandoned_ = live_;
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
  narrator_.choose(system(), layout());
  followed_ = 0;
  if (live_) {
    narrator_.follow(growing_.so_far(), growing_.frames());
  } else {
    show_again();
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

std::optional<RecordingLayout> Player::layout() const {
  if (source_.recording.explorations.empty()) return {};
  return layout_of(source_.recording);
}

const Exploration* Player::shown() const {
  if (live_) return &growing_.so_far();
  return exploration_ ? &source_.recording.explorations[*exploration_] : nullptr;
}

std::optional<Strips> Player::strips() const {
  if (!exploration_) return {};
  if (live_) return strips_of(growing_, *exploration_, begun_);
  return strips_of(source_.recording.explorations[*exploration_], *exploration_, timeline_);
}

void Player::publish_state() {
  ViewState state{source_, narrator_.picture(), shown(), exploration_};
  state.frame = live_ ? growing_.moments() : next_;
  if (!live_ && timeline_.moments() > 0) {
    state.frames = timeline_.moments();
    state.duration = timeline_.time(timeline_.moments() - 1);
  }
  state.playing = playing_;
  state.speed = speed_;
  state.live = live_;
  state.thing = thing_;
  state.placement = placement_;
  state.system = system_;
  state.system_problem = told_problem_ = narrator_.problem();
  state.training = training_;
  state.clients = hub_.lookers_on();
  state.problem = problem_;
  hub_.publish(EventKind::kState, json_text(state_json(state)));
}

void Player::explore() {
  wants_exploring_ = false;
  abandoned_ = false;
  live_ = true;
  playing_ = true;
  steps_left_ = 0;
  wanted_.reset();
  problem_.clear();
  exploration_ = source_.recording.explorations.size();
  live_poses_.clear();
  auto explored = source_.body->explore({thing_, trials_++, placement_}, *this);
  live_ = false;
  playing_ = false;
  if (explored) {
    keep_explored(std::move(*explored));
  } else {
    if (explored.error().kind != ErrorKind::kInterrupted) problem_ = sentence_of(explored.error());
    lose_exploration();
  }
  publish_state();
}

void Player::lose_exploration() {
  exploration_.reset();
  timeline_ = {};
  next_ = 0;
}

void Player::keep_explored(Exploration exploration) {
  auto& explorations = source_.recording.explorations;
  explorations.push_back(std::move(exploration));
  if (auto valid = validate(source_.recording); !valid) {
    explorations.pop_back();
    problem_ = sentence_of(valid.error());
    return lose_exploration();
  }
  explored_scenes_.push_back(std::make_shared<KeptScene>(live_scene_, std::move(live_poses_)));
  begin_exploration(source_.recording.explorations.size() - 1);
  show(timeline_.moments() - 1);
}

void Player::begins(const BodyDescription& body, const Scene& scene) {
  growing_ = GrowingExploration(body);
  felt_last_.assign(body.sensors.size(), {});
  keep_scene(scene);
  time_ = -1.0;
  shown_at_ = Clock::now();
  narrator_.start();
  publish_scene(&scene);
  publish_state();
}

// That of a thing is the same each time.
void Player::keep_scene(const Scene& scene) {
  std::shared_ptr<const Scene>& kept = kept_scenes_[json_text(scene_json(scene))];
  if (!kept) kept = std::make_shared<const Scene>(scene);
  live_scene_ = kept;
}

Result<void> Player::felt(const BodyState& state) {
  growing_.append(state);
  narrator_.follow(growing_.so_far(), growing_.frames());
  live_poses_.push_back(poses_);
  if (steps_left_ > 0) --steps_left_;
  publish_live();
  return {};
}

Result<void> Player::moved(const BodyState& state, const std::vector<ScenePose>& poses) {
  if (time_ < 0.0) begun_ = state.time;
  for (std::size_t i = 0; i < felt_last_.size(); ++i) {
    const Matrix<float>& frames = state.readings[i];
    if (frames.rows() == 0) continue;
    const auto row = frames.row(frames.rows() - 1);
    felt_last_[i].assign(row.begin(), row.end());
  }
  const double passed = time_ < 0.0 ? 0.0 : state.time - time_;
  time_ = state.time;
  poses_ = poses;
  if (auto going = keep_pace(passed); !going) return going;
  publish_live();
  return {};
}

// Between grasps the hand moves and nothing is recorded: then the last frame is told again.
void Player::publish_live() {
  const std::size_t come = growing_.moments();
  ShownMoment shown{*exploration_, come == 0 ? 0 : come - 1, {}, time_ - begun_, false, {}, poses_};
  const auto& channels = growing_.so_far().channels;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const bool fast = channels[i].rate > 0.0 && growing_.frames()[i] > 0;
    shown.channels.emplace_back(
        channels[i].name, fast ? shown_values(channels[i], channels[i].rate, growing_.frames()[i])
                               : std::span<const float>(felt_last_[i]));
  }
  publish_frame(shown, [&] { return growing_.so_far(); });
}

// The body waits until its time has come, as long as it is paused, and for what others want.
Result<void> Player::keep_pace(double passed) {
  const auto due = [&]() -> std::optional<Clock::time_point> {
    if (!playing_ && steps_left_ == 0) return {};
    return shown_at_ + in_clock(passed / speed_);
  };
  const auto stop = [] { return fail(ErrorKind::kInterrupted, "something else is wanted"); };
  for (;;) {
    if (closed_ || abandoned_) return stop();
    closed_ = queue_.wait(due()) == TaskQueue::Woken::kClosed;
    if (closed_ || abandoned_) return stop();
    if (const auto next = due(); next && *next <= Clock::now()) {
      shown_at_ = std::max(*next, Clock::now() - kMostLate);
      return {};
    }
  }
}

}  // namespace somato::live
