#include "views/live/body_session.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "views/session/view_json.h"
#include "views/session/viewed_system.h"

namespace somato::live {
namespace {

constexpr std::size_t kUnread = std::size_t{1} << 20;     // bytes of frames without a page
constexpr auto kCatchUp = std::chrono::milliseconds(20);  // at a time

bool has_frames(const Exploration& exploration) {
  return std::any_of(exploration.channels.begin(), exploration.channels.end(),
                     [](const Channel& channel) { return !channel.frames.empty(); });
}

}  // namespace

BodySession::BodySession(Stage& stage, Naming& naming, const ViewSettings& settings,
                         TaskQueue& queue)
    : stage_(stage),
      naming_(naming),
      memory_{settings.memory / 4, settings.has_page ? settings.memory : 0},
      plan_(std::move(stage.source.plan), stage.source.demonstrates, stage.source.thing),
      body_(queue, {[this](const auto& body, const auto& scene) { grow(body, scene); },
                    [this](BodyStep step) { coming_ = std::move(step); },
                    [this](auto explored) { finish(std::move(explored)); }, settings.on_thread}) {}

Result<void> BodySession::choose_thing(const std::string& name) {
  if (!stage_.source.explorer) return not_now("the object of a recording cannot be changed");
  SOMATO_TRY_VOID(plan_.take_over());
  const auto& things = stage_.source.explorer->things();
  const auto found = std::find_if(things.begin(), things.end(),
                                  [&](const ExploredThing& thing) { return thing.name == name; });
  if (found == things.end()) return not_now("unknown object or material");
  plan_.select(static_cast<std::size_t>(found - things.begin()));
  return {};
}

Result<void> BodySession::place(const Placement& placement) {
  if (!stage_.source.explorer || !plan_.take_over() ||
      !stage_.source.explorer->things()[plan_.thing()].object) {
    return not_now("no object can be placed");
  }
  plan_.place(placement);
  return {};
}

// The exploration in progress ends first. A plan can be begun, but not changed.
Result<void> BodySession::begin_exploring() {
  if (!stage_.source.explorer) return not_now("only a body can explore");
  const bool begins_plan =
      stage_.audience.awaits_command() && plan_.has_next() && !plan_.demonstrates();
  if (!begins_plan) SOMATO_TRY_VOID(plan_.take_over());
  body_.stop();
  stage_.replay.give_up();
  wants_exploring_ = true;
  is_permitted_ = true;
  stage_.audience.begin();
  return {};
}

void BodySession::explore() {
  wants_exploring_ = false;
  stage_.problem.clear();
  stage_.replay.end();
  stage_.pace.playing = true;
  stage_.moments_left = 0;
  if (std::exchange(is_permitted_, false)) stage_.source.explorer->resume();
  const ExplorationSequence::Next next = plan_.next();
  exploring_ = next;
  body_.start(*stage_.source.explorer, next.thing, next.trial, next.placement, memory_.exploration);
}

// The scene of a thing is the same each time.
void BodySession::grow(const BodyDescription& body, const Scene& scene) {
  std::shared_ptr<const Scene>& kept = kept_scenes_[json_text(scene_json(scene))];
  if (!kept) kept = std::make_shared<const Scene>(scene);
  growing_.emplace(stage_.kept.count(), body, kept);
  stage_.kept.begin_next(body, stage_.source.explorer->labels(exploring_.thing, exploring_.trial));
  stage_.pace.begin();
  stage_.replay.begin(growing_->played());
  stage_.publish();
}

// The body takes its next step meanwhile.
void BodySession::show_step() {
  make_room();
  const BodyStep step = *std::exchange(coming_, std::nullopt);
  growing_->append(step);
  body_.go_on();
  if (step.readings == Readings::kRecorded) naming_.report(stage_.kept.append_to_next(step.state));
  if (step.readings == Readings::kLeftOut) return stage_.replay.show_between(growing_->last());
  if (stage_.moments_left > 0) --stage_.moments_left;
  stage_.replay.show(stage_.replay.next());
}

// The exploration in progress is in memory twice: the body collects its frames as well. All of its
// moments have been read.
void BodySession::make_room() {
  const std::size_t growing = growing_->bytes();
  drop_before(stage_.kept.first_within(memory_.page - std::min(memory_.page, 2 * growing)));
  const std::size_t most = memory_.page > 0 ? memory_.exploration : kUnread;
  if (growing > most) growing_->drop_half();
}

// A system keeps what it has learned from an exploration.
void BodySession::drop_before(std::size_t exploration) {
  if (exploration == stage_.kept.first()) return;
  stage_.chosen.settle_before(exploration);
  stage_.kept.drop_before(exploration);
}

void BodySession::finish(std::future<Result<Exploration>> explored) {
  auto exploration = explored.get();
  catch_up();
  // One of which the beginning was dropped is not that of the exploration.
  const bool is_whole = growing_ && growing_->played().timeline->first() == 0;
  const std::shared_ptr<KeptScene> scene = is_whole ? growing_->scene() : nullptr;
  const bool is_kept = !exploration || !growing_ || has_frames(*exploration);
  if (!is_kept) end_unkept(std::move(exploration->labels));
  end_growing();
  const bool demonstrates = plan_.demonstrates();
  const bool plays_on = demonstrates && stage_.pace.playing;
  stage_.rest();
  if (!exploration) {
    fail_exploring(exploration.error());
  } else if (!is_kept) {
    stage_.publish();
  } else if (const auto kept = keep(std::move(*exploration), scene); !kept) {
    stage_.problem = sentence_of(kept.error());
    stage_.replay.tap().finish(kept);
  }
  // A demonstration shows the end of each exploration for a while.
  stage_.pace.playing = plays_on && stage_.replay.played() != nullptr;
  const bool goes_on = plan_.has_next() && !stage_.pace.playing && (plays_on || !demonstrates) &&
                       !stage_.audience.awaits_command();
  wants_exploring_ = wants_exploring_ || goes_on;
  stage_.publish();
}

void BodySession::end_growing() {
  stage_.replay.end();
  growing_.reset();
  coming_.reset();
}

// Its frames took more memory than is permitted: its last reading is that of the last moment.
void BodySession::end_unkept(std::vector<Label> labels) {
  const std::size_t index = stage_.kept.count();
  stage_.problem = fmt::format(
      "Exploration {} took more memory than --page-memory permits: its frames are not kept.",
      index + 1);
  const auto label = stage_.chosen.answered_label();
  const auto given = label ? stage_.kept.names().given(index, *label) : std::nullopt;
  drop_before(index);
  naming_.report(stage_.kept.add_unkept());
  growing_->end(std::move(labels));
  stage_.replay.say_end();
  const auto name = stage_.replay.tap().take_name();
  if (label && (name || given)) naming_.teach(index, name ? *name : *given);
}

// The readings of the last moments are passed on before they are forgotten.
void BodySession::catch_up() {
  if (!stage_.replay.tap().is_open() || stage_.replay.moments() == 0) return;
  stage_.replay.show(stage_.replay.moments() - 1);
  while (stage_.replay.is_behind()) stage_.replay.follow(kCatchUp);
}

// A press of Start before the fault was shown permits nothing.
void BodySession::await_start() {
  stage_.audience.await_command();
  wants_exploring_ = false;
  is_permitted_ = false;
}

void BodySession::fail_exploring(const Error& error) {
  stage_.kept.discard_next();
  if (stage_.source.explorer->is_stopped()) await_start();
  if (error.kind == ErrorKind::kInterrupted) return;
  ++failed_;
  stage_.problem = sentence_of(error);
  stage_.replay.tap().say_failure(error);
  if (error.kind == ErrorKind::kUnavailable) plan_.give_up();
}

Result<void> BodySession::keep(Exploration exploration, std::shared_ptr<KeptScene> scene) {
  SOMATO_TRY_VOID(stage_.kept.add(std::move(exploration), std::move(scene)));
  naming_.report(stage_.kept.save_last());  // before its end is shown
  drop_before(stage_.kept.first_within(memory_.page));
  stage_.begin_exploration(stage_.kept.count() - 1);
  stage_.replay.show(stage_.replay.moments() - 1);
  naming_.teach_given(stage_.kept.count() - 1);
  return {};
}

std::optional<double> BodySession::seconds_to_step() const {
  return coming_ ? std::optional(growing_->seconds_to(*coming_)) : std::nullopt;
}

// A body that is stopped ends its exploration by finish().
void BodySession::give_up() {
  body_.stop();
  if (body_.is_exploring()) return;
  if (growing_) stage_.kept.discard_next();
  end_growing();
}

Label BodySession::thing() const {
  const ExploredThing& thing = stage_.source.explorer->things()[exploring_.thing];
  const bool is_material = !thing.object && !thing.material.name.empty();
  return {is_material ? "material" : "object", thing.name};
}

}  // namespace somato::live
