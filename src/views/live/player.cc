#include "views/live/player.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <utility>

#include "views/live/naming_state.h"
#include "views/live/view_state.h"
#include "views/session/view_json.h"

namespace somato::live {
namespace {

constexpr std::size_t kUnread = std::size_t{1} << 20;   // bytes of frames without a page
constexpr double kBetweenExplorations = 1.5;            // s
constexpr double kLongerResult = 3.0;                   // times the pause after a result
constexpr auto kSlice = std::chrono::milliseconds(20);  // between two tasks, while it follows

template <typename... Cases>
struct Overloaded : Cases... {
  using Cases::operator()...;
};

bool has_frames(const Exploration& exploration) {
  return std::any_of(exploration.channels.begin(), exploration.channels.end(),
                     [](const Channel& channel) { return !channel.frames.empty(); });
}

tl::unexpected<Error> not_now(std::string what) {
  return fail(ErrorKind::kUsage, std::move(what));
}

// A body continues without viewers, unless it is a demonstration; readings are not held up.
bool may_rest(const ViewSource& source, const ViewSettings& settings) {
  return settings.wait_for_viewer && !source.readings.on_moment &&
         (!source.explorer || source.demonstrates);
}

// A real body moves by a person's command only: that of the program without a view, or a viewer's.
Beginning beginning_of(const ViewSource& source, const ViewSettings& settings) {
  if (!settings.wait_for_viewer) return Beginning::kAtOnce;
  const bool is_real = source.explorer && source.explorer->moves_real_body();
  return is_real ? Beginning::kByCommand : Beginning::kWithFirstViewer;
}

}  // namespace

Player::Player(ViewSource source, const ViewSettings& settings, EventHub& hub, TaskQueue& queue)
    : source_(std::move(source)),
      hub_(hub),
      queue_(queue),
      replay_(hub, pace_, source_.readings),
      chosen_(source_, replay_),
      kept_(source_),
      memory_{settings.memory / 4, settings.has_page ? settings.memory : 0},
      audience_(beginning_of(source_, settings), may_rest(source_, settings)),
      plan_(std::move(source_.plan), source_.demonstrates, source_.thing),
      result_pause_(settings.result_pause),
      body_(queue, {[this](const auto& body, const auto& scene) { grow(body, scene); },
                    [this](BodyStep step) { coming_ = std::move(step); },
                    [this](auto explored) { finish(std::move(explored)); }}) {
  pace_.speed = settings.speed;
  replay_.limit_memory(settings.memory / 2);
}

void Player::begin() {
  guarded([this] {
    chosen_.use();
    wants_exploring_ = source_.explorer && audience_.has_begun();
    if (!source_.explorer) {
      pace_.playing = audience_.has_begun();
      begin_exploration(0);
      replay_.show(0);
    }
    publish_state();
  });
}

void Player::run() {
  while (!closed_) guarded([this] { turn(); });
  body_.join();
}

// A body that is stopped ends its exploration by finish().
void Player::guarded(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::exception& error) {
    problem_ = fmt::format("Internal error: {}.", error.what());
    rest();
    replay_.give_up();
    body_.stop();
    if (!body_.is_exploring()) {
      if (growing_) kept_.discard_next();
      end_growing();
    }
    publish_state();
    replay_.tap().finish(fail(ErrorKind::kData, problem_));
  }
}

// A task at a time: tasks that keep coming must not hold up what plays.
void Player::turn() {
  const bool may_explore = wants_exploring_ && !audience_.is_resting();
  if (may_explore && !body_.is_exploring() && !replay_.is_behind()) explore();
  closed_ =
      queue_.wait(replay_.is_behind() ? Pace::Clock::now() : due()) == TaskQueue::Woken::kClosed;
  if (closed_) return;
  take_name();  // before another exploration begins
  if (replay_.is_behind()) {
    replay_.follow(kSlice);
  } else if (const auto next = due(); next && *next <= Pace::Clock::now()) {
    pace_.keep(*next);
    advance();
  }
  take_name();
  if (replay_.reader().problem() != shown_system_problem_) publish_state();
  if (is_complete()) replay_.tap().finish({});
}

// Whether all that was to be read has been played.
bool Player::is_complete() const {
  if (!source_.explorer) return replay_.tap().ended() == kept_.count();
  if (plan_.demonstrates()) return false;
  const bool has_begun = plan_.is_planned() && !plan_.has_next();
  return has_begun && !wants_exploring_ && !body_.is_exploring() && !replay_.is_behind();
}

Result<void> Player::handle(const ViewCommand& command) {
  audience_.take_command();
  return std::visit(Overloaded{[&](const PlayCommand&) { return play(); },
                               [&](const PauseCommand&) -> Result<void> {
                                 rest();
                                 return {};
                               },
                               [&](const StepCommand& one) { return step(one.frames); },
                               [&](const SeekCommand& one) { return seek(one); },
                               [&](const SpeedCommand& one) -> Result<void> {
                                 pace_.speed = one.speed;
                                 return {};
                               },
                               [&](const ThingCommand& one) { return choose_thing(one.name); },
                               [&](const PlacementCommand& one) { return place(one.placement); },
                               [&](const ExploreCommand&) { return begin_exploring(); },
                               [&](const NameCommand& one) { return name(one); },
                               [&](const UndoNameCommand& one) { return undo_name(one); },
                               [&](const PlanCommand& one) -> Result<void> {
                                 kept_.plan(one.each);
                                 return {};
                               },
                               [&](const SystemCommand& one) { return chosen_.choose(one.name); },
                               [&](const DismissCommand&) -> Result<void> {
                                 problem_.clear();
                                 return {};
                               },
                               [&](const auto&) -> Result<void> {
                                 return not_now("the command is not supported");
                               }},
                    command);
}

void Player::on_viewers(std::size_t viewers) {
  switch (audience_.set_viewers(viewers, pace_.playing)) {
    case Audience::Change::kBegin:
      return begin_seen();
    case Audience::Change::kRest:
      return rest();
    case Audience::Change::kContinue:
      pace_.playing = true;
      return pace_.begin();
    case Audience::Change::kNone:
      break;
  }
}

void Player::begin_seen() {
  pace_.begin();
  wants_exploring_ = source_.explorer != nullptr;
  pace_.playing = !wants_exploring_;
}

void Player::begin_exploration(std::size_t index) {
  begin_exploration(index, std::make_shared<Timeline>(kept_[index]));
}

void Player::begin_exploration(std::size_t index, std::shared_ptr<const Timeline> timeline) {
  const Exploration& chosen = kept_[index];
  std::shared_ptr<ScenePlayer> scene = kept_.scene(index);
  if (!scene && source_.scenes) scene = source_.scenes(chosen);
  replay_.begin({index, &chosen, std::move(timeline), std::move(scene)});
}

// The time at which the next moment, step of the body or exploration is to be shown; never while
// all rests.
std::optional<Pace::Clock::time_point> Player::due() const {
  if (!pace_.playing && moments_left_ == 0) return {};
  if (!replay_.is_over()) return pace_.due(replay_.pause());
  if (coming_) return pace_.due(std::min(growing_->seconds_to(*coming_), kLongestPause));
  if (growing_ || replay_.played() == nullptr) return {};
  if (plan_.demonstrates()) return pace_.due(pause_after_result() * pace_.speed);
  return pace_.due(kBetweenExplorations);
}

// Longer where an unknown thing can be named, and where that shows what was learned.
double Player::pause_after_result() const {
  const bool is_named = chosen_.is_taught(replay_.played()->index);
  return is_named || chosen_.answers_unknown() ? kLongerResult * result_pause_ : result_pause_;
}

void Player::advance() {
  if (!replay_.is_over()) return replay_.show(replay_.next());
  if (coming_) return show_step();
  play_next();
  publish_state();
}

// After the last exploration everything rests.
void Player::play_next() {
  if (plan_.demonstrates()) return play_next_of_demonstration();
  const std::size_t next = replay_.played()->index + 1;
  if (next == kept_.count() || source_.explorer) return rest();
  begin_exploration(next);
  replay_.show(0);
}

// After the last exploration, all are played again, by the system as it was at first.
void Player::play_next_of_demonstration() {
  if (teach_demonstrated()) return;
  const std::size_t next = replay_.played()->index + 1;
  const bool was_last = next == kept_.count();
  wants_exploring_ = was_last && plan_.has_next();
  if (wants_exploring_) return;
  if (was_last) {
    plan_.complete_round();
    chosen_.forget();
  }
  begin_exploration(was_last ? kept_.first() : next);
  replay_.show(0);
}

void Player::rest() {
  pace_.playing = false;
  moments_left_ = 0;
}

Result<void> Player::play() {
  if (audience_.awaits_command()) {
    return not_now("the body is real and moves only after a press of Start");
  }
  if (plan_.is_planned() && audience_.begin()) {
    wants_exploring_ = true;
    return {};
  }
  if (replay_.played() == nullptr && !body_.is_exploring()) return begin_exploring();
  pace_.playing = true;
  pace_.begin();
  if (body_.is_exploring() || !replay_.is_over()) return {};
  const std::size_t index = replay_.played()->index;
  const bool is_last = index + 1 == kept_.count();
  begin_exploration(source_.explorer ? index : is_last ? 0 : index + 1);
  replay_.show(0);
  return {};
}

// Beyond the last explored moment, the body continues.
Result<void> Player::step(std::int64_t frames) {
  const auto first = static_cast<std::int64_t>(replay_.first());
  const auto last = static_cast<std::int64_t>(replay_.moments()) - 1;
  const std::int64_t wanted = static_cast<std::int64_t>(replay_.next()) - 1 + frames;
  const bool beyond = growing_ && wanted > last;
  if (last < 0 && !beyond) return not_now("no frames to step through");
  rest();
  if (beyond) {
    moments_left_ = static_cast<std::size_t>(wanted - last);
    pace_.begin();
  }
  if (!beyond || !replay_.is_over()) {
    replay_.show(static_cast<std::size_t>(std::clamp<std::int64_t>(wanted, first, last)));
  }
  return {};
}

Result<void> Player::seek(const SeekCommand& seek) {
  const bool is_played = replay_.played() != nullptr && seek.exploration == replay_.played()->index;
  if (growing_ && !is_played) {
    return not_now("another exploration cannot be shown while the body explores");
  }
  if (!is_played && replay_.tap().is_open()) {
    return not_now("another exploration cannot be shown while the readings are written");
  }
  if (!is_played && seek.exploration >= kept_.count()) {
    return not_now(fmt::format("the recording has {} explorations", kept_.count()));
  }
  const bool is_kept =
      is_played ? seek.frame >= replay_.first() : seek.exploration >= kept_.first();
  if (!is_kept) return not_now("it is no longer kept (--page-memory)");
  std::shared_ptr<const Timeline> timeline =
      is_played ? nullptr : std::make_shared<Timeline>(kept_[seek.exploration]);
  const std::size_t moments = is_played ? replay_.moments() : timeline->moments();
  if (seek.frame >= moments) return not_now(fmt::format("the exploration has {} frames", moments));
  if (!is_played) begin_exploration(seek.exploration, std::move(timeline));
  moments_left_ = 0;
  pace_.begin();
  replay_.show(seek.frame);
  return {};
}

Result<void> Player::choose_thing(const std::string& name) {
  if (!source_.explorer) return not_now("the object of a recording cannot be changed");
  SOMATO_TRY_VOID(plan_.take_over());
  const auto& things = source_.explorer->things();
  const auto found = std::find_if(things.begin(), things.end(),
                                  [&](const ExploredThing& thing) { return thing.name == name; });
  if (found == things.end()) return not_now("unknown object or material");
  plan_.select(static_cast<std::size_t>(found - things.begin()));
  return {};
}

Result<void> Player::place(const Placement& placement) {
  if (!source_.explorer || !plan_.take_over() ||
      !source_.explorer->things()[plan_.thing()].object) {
    return not_now("no object can be placed");
  }
  plan_.place(placement);
  return {};
}

// The exploration in progress ends first. A plan can be begun, but not changed.
Result<void> Player::begin_exploring() {
  if (!source_.explorer) return not_now("only a body can explore");
  const bool begins_plan = audience_.awaits_command() && plan_.has_next() && !plan_.demonstrates();
  if (!begins_plan) SOMATO_TRY_VOID(plan_.take_over());
  body_.stop();
  replay_.give_up();
  wants_exploring_ = true;
  is_permitted_ = true;
  audience_.begin();
  return {};
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
  if (replay_.played() == nullptr) return {};
  return strips_of(*replay_.played());
}

Losses Player::losses() const {
  return {failed_, kept_.unsaved(), hub_.left()};
}

void Player::publish_state() {
  shown_system_problem_ = replay_.reader().problem();
  hub_.publish(EventKind::kState, state_text());
}

std::string Player::state_text() const {
  ViewState state{source_, replay_.reader().picture(), kept_, replay_.played()};
  state.labels = shown_labels();
  state.first_frame = replay_.first();
  state.frame = replay_.next();
  state.playing = pace_.playing;
  state.speed = std::min(pace_.speed, 100.0);  // the fastest that a page can choose
  state.thing = plan_.thing();
  state.placement = plan_.placement();
  state.system = chosen_.number();
  state.system_problem = replay_.reader().problem();
  state.teaches = chosen_.teaches();
  state.taught = chosen_.taught_names();
  state.training = training_;
  state.demonstrated = plan_.rounds();
  state.naming = naming_json(kept_, replay_.played(), replay_.reader().picture().label);
  state.losses = losses();
  state.clients = hub_.viewers();
  state.awaits_start = audience_.awaits_command();
  state.problem = problem_;
  return json_text(state_json(state));
}

void Player::explore() {
  wants_exploring_ = false;
  problem_.clear();
  replay_.end();
  pace_.playing = true;
  moments_left_ = 0;
  if (std::exchange(is_permitted_, false)) source_.explorer->resume();
  const ExplorationSequence::Next next = plan_.next();
  exploring_ = next;
  body_.start(*source_.explorer, next.thing, next.trial, next.placement, memory_.exploration);
}

// The scene of a thing is the same each time.
void Player::grow(const BodyDescription& body, const Scene& scene) {
  std::shared_ptr<const Scene>& kept = kept_scenes_[json_text(scene_json(scene))];
  if (!kept) kept = std::make_shared<const Scene>(scene);
  growing_.emplace(kept_.count(), body, kept);
  kept_.begin_next(body, source_.explorer->labels(exploring_.thing, exploring_.trial));
  pace_.begin();
  replay_.begin(growing_->played());
  publish_state();
}

// The body takes its next step meanwhile.
void Player::show_step() {
  make_room();
  const BodyStep step = *std::exchange(coming_, std::nullopt);
  growing_->append(step);
  body_.go_on();
  if (step.readings == Readings::kRecorded) report(kept_.append_to_next(step.state));
  if (step.readings == Readings::kLeftOut) return replay_.show_between(growing_->last());
  if (moments_left_ > 0) --moments_left_;
  replay_.show(replay_.next());
}

// The exploration in progress is in memory twice: the body collects its frames as well. All of its
// moments have been read.
void Player::make_room() {
  const std::size_t growing = growing_->bytes();
  drop_before(kept_.first_within(memory_.page - std::min(memory_.page, 2 * growing)));
  const std::size_t most = memory_.page > 0 ? memory_.exploration : kUnread;
  if (growing > most) growing_->drop_half();
}

// A system keeps what it has learned from an exploration.
void Player::drop_before(std::size_t exploration) {
  if (exploration == kept_.first()) return;
  chosen_.settle_before(exploration);
  kept_.drop_before(exploration);
}

void Player::finish(std::future<Result<Exploration>> explored) {
  auto exploration = explored.get();
  catch_up();
  // One of which the beginning was dropped is not that of the exploration.
  const bool is_whole = growing_ && growing_->played().timeline->first() == 0;
  const std::shared_ptr<KeptScene> scene = is_whole ? growing_->scene() : nullptr;
  const bool is_kept = !exploration || !growing_ || has_frames(*exploration);
  if (!is_kept) end_unkept(std::move(exploration->labels));
  end_growing();
  const bool demonstrates = plan_.demonstrates();
  const bool plays_on = demonstrates && pace_.playing;
  rest();
  if (!exploration) {
    fail_exploring(exploration.error());
  } else if (!is_kept) {
    publish_state();
  } else if (const auto kept = keep(std::move(*exploration), scene); !kept) {
    problem_ = sentence_of(kept.error());
    replay_.tap().finish(kept);
  }
  // A demonstration shows the end of each exploration for a while.
  pace_.playing = plays_on && replay_.played() != nullptr;
  const bool goes_on = plan_.has_next() && !pace_.playing && (plays_on || !demonstrates) &&
                       !audience_.awaits_command();
  wants_exploring_ = wants_exploring_ || goes_on;
  publish_state();
}

void Player::end_growing() {
  replay_.end();
  growing_.reset();
  coming_.reset();
}

// Its frames took more memory than is permitted: its last reading is that of the last moment.
void Player::end_unkept(std::vector<Label> labels) {
  const std::size_t index = kept_.count();
  problem_ = fmt::format(
      "Exploration {} took more memory than --page-memory permits: its frames are not kept.",
      index + 1);
  const auto label = chosen_.answered_label();
  const auto given = label ? names().given(index, *label) : std::nullopt;
  drop_before(index);
  report(kept_.add_unkept());
  growing_->end(std::move(labels));
  replay_.say_end();
  const auto name = replay_.tap().take_name();
  if (label && (name || given)) teach(index, name ? *name : *given);
}

// The readings of the last moments are passed on before they are forgotten.
void Player::catch_up() {
  if (!replay_.tap().is_open() || replay_.moments() == 0) return;
  replay_.show(replay_.moments() - 1);
  while (replay_.is_behind()) replay_.follow(kSlice);
}

// A press of Start before the fault was shown permits nothing.
void Player::await_start() {
  audience_.await_command();
  wants_exploring_ = false;
  is_permitted_ = false;
}

void Player::fail_exploring(const Error& error) {
  kept_.discard_next();
  if (source_.explorer->is_stopped()) await_start();
  if (error.kind == ErrorKind::kInterrupted) return;
  ++failed_;
  problem_ = sentence_of(error);
  replay_.tap().say_failure(error);
  if (error.kind == ErrorKind::kUnavailable) plan_.give_up();
}

Result<void> Player::keep(Exploration exploration, std::shared_ptr<KeptScene> scene) {
  SOMATO_TRY_VOID(kept_.add(std::move(exploration), std::move(scene)));
  report(kept_.save_last());  // before its end is shown
  drop_before(kept_.first_within(memory_.page));
  begin_exploration(kept_.count() - 1);
  replay_.show(replay_.moments() - 1);
  teach_given(kept_.count() - 1);
  return {};
}

void Player::report(const Result<void>& saved) {
  if (saved) return;
  problem_ = sentence_of(saved.error()) + " The session continues without its file.";
  replay_.tap().say_unsaved(saved.error());
}

// Names the exploration that is shown, or another one that is kept: on a slow line, the one that is
// meant may have ended meanwhile.
Result<void> Player::name(const NameCommand& command) {
  const PlayedExploration* played = replay_.played();
  if (played == nullptr) return not_now("there is no exploration to name");
  std::size_t index = played->index;
  if (command.id) {
    SOMATO_TRY(index, kept_.index_of(*command.id));
  }
  if (index < kept_.first()) return not_now("it is no longer kept (--page-memory)");
  if (index != played->index && index >= kept_.count()) {
    return not_now("there is no such exploration");
  }
  auto named = kept_.name(index, command.label);
  if (!named && named.error().kind != ErrorKind::kSystem) return named;
  if (index < kept_.count() && command.label.name == chosen_.answered_label()) teach_given(index);
  return check_saved(named);
}

// Another page may have given another name meanwhile, or taken this one back.
Result<void> Player::undo_name(const UndoNameCommand& command) {
  if (names().last() == nullptr) return not_now("there is no name to undo");
  const GivenName last = *names().last();
  if (kept_.id(last.exploration) != command.id || last.label != command.label) {
    return not_now(fmt::format("the name that was given last is now {} = '{}' of exploration {}",
                               last.label.name, last.label.value, last.exploration + 1));
  }
  auto undone = kept_.take_back_name();
  if (!undone && undone.error().kind != ErrorKind::kSystem) return undone;
  forget_taught(last);
  return check_saved(undone);
}

void Player::forget_taught(const GivenName& name) {
  const bool was_taught = chosen_.is_taught(name.exploration);
  chosen_.take_back(name);
  if (!was_taught || name.label.name != chosen_.answered_label()) return;
  for (const TaughtName& one : chosen_.taught_names()) {
    if (one.exploration == name.exploration) return replay_.tap().say_taught(one);
  }
  replay_.tap().say_forgotten(name);
}

// A name is confirmed where it is on the disk, if the session has a file.
Result<void> Player::check_saved(const Result<void>& saved) {
  report(saved);
  if (source_.file == nullptr || kept_.saves()) return {};
  return fail(ErrorKind::kSystem,
              "the change is in the session, but not on the disk: its file cannot be written");
}

void Player::teach(std::size_t exploration, const std::string& name) {
  if (exploration >= kept_.first()) {
    replay_.tap().say_taught(chosen_.teach(exploration, name));
  } else {
    replay_.tap().say_taught({exploration,
                              name,
                              {},
                              "The frames of the exploration are no longer kept (--page-memory)."});
  }
  publish_state();
}

void Player::teach_given(std::size_t exploration) {
  const auto label = chosen_.answered_label();
  if (!label) return;
  if (const auto name = names().given(exploration, *label)) teach(exploration, *name);
}

// Given by the receiver of the readings.
void Player::take_name() {
  const auto name = replay_.tap().take_name();
  const auto label = chosen_.answered_label();
  if (!name || !label || replay_.played() == nullptr) return;
  const std::size_t exploration = replay_.played()->index;
  const auto named = kept_.name(exploration, {*label, *name});
  if (!named && named.error().kind != ErrorKind::kSystem) {
    problem_ = sentence_of(named.error());
    return;
  }
  report(named);
  teach(exploration, *name);
}

// An unknown thing is named; the system's answer after that is shown for a while, too.
bool Player::teach_demonstrated() {
  if (!chosen_.answers_unknown()) return false;
  const PlayedExploration& played = *replay_.played();
  Exploration named;
  named.labels = names().labels(played.index, played.exploration->labels);
  const auto name = find_label(named, *chosen_.answered_label());
  if (!name || chosen_.is_taught(played.index)) return false;
  teach(played.index, *name);
  return true;
}

// While a body explores, the name of the thing that it was given.
std::vector<Label> Player::shown_labels() const {
  if (replay_.played() == nullptr) return {};
  const PlayedExploration& played = *replay_.played();
  if (played.has_ended) return names().labels(played.index, played.exploration->labels);
  const ExploredThing& thing = source_.explorer->things()[exploring_.thing];
  const bool is_material = !thing.object && !thing.material.name.empty();
  return names().labels(played.index, {{is_material ? "material" : "object", thing.name}});
}

}  // namespace somato::live
