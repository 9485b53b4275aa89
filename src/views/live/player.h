#pragma once

#include <cstddef>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "views/http/audience.h"
#include "views/http/event_hub.h"
#include "views/live/chosen_system.h"
#include "views/live/exploration_sequence.h"
#include "views/live/strips.h"
#include "views/replay/body_thread.h"
#include "views/replay/growing_exploration.h"
#include "views/replay/pace.h"
#include "views/replay/replay.h"
#include "views/replay/task_queue.h"
#include "views/session/losses.h"
#include "views/session/view_command.h"
#include "views/session/view_source.h"
#include "views/teaching/kept_explorations.h"

namespace somato::live {

/// Plays explorations, those of a recording or one that a body still makes, and publishes what is
/// to be seen. All of it happens in one thread, which calls run(); others speak to it through the
/// queue.
class Player {
 public:
  Player(ViewSource source, const ViewSettings& settings, EventHub& hub, TaskQueue& queue);

  /// Shows what there is before anything plays; before run().
  void begin();

  /// Plays until the queue is closed; an internal error is reported as a problem and does not end
  /// it.
  void run();

  /// The following functions are for the thread of run(), by tasks. Errors (kUsage): an impossible
  /// command.
  Result<void> handle(const ViewCommand& command);

  const ViewSource& source() const { return source_; }

  /// The labels that viewers gave to explorations.
  const GivenNames& names() const { return kept_.names(); }

  /// The system that is chosen, or nullptr.
  const ViewSystem* system() const { return chosen_.system(); }

  /// The strips over time of the exploration that is played, or nothing.
  std::optional<Strips> strips() const;

  /// See ChosenSystem.
  void take_trained(const std::string& name, const std::shared_ptr<const SystemModel>& model) {
    chosen_.take_trained(name, model);
  }

  void show_training(bool training);
  void show_problem(std::string problem);
  void publish_state();

  /// The losses of the session so far.
  Losses losses() const;

  /// The state as it is now, in JSON.
  std::string state_text() const;

  /// Begins to play with the first viewer where that was waited for. A recording and a
  /// demonstration then rest while there are no viewers.
  void on_viewers(std::size_t viewers);

 private:
  // The most memory in bytes of the exploration in progress, and of all that is kept for a page.
  struct Memory {
    std::size_t exploration = 0;
    std::size_t page = 0;
  };

  void begin_seen();
  void turn();
  void guarded(const std::function<void()>& work);
  void begin_exploration(std::size_t index);
  void begin_exploration(std::size_t index, std::shared_ptr<const Timeline> timeline);
  void advance();
  bool is_complete() const;
  void rest();
  std::optional<Pace::Clock::time_point> due() const;

  void play_next();
  void play_next_of_demonstration();

  Result<void> play();
  Result<void> step(std::int64_t frames);
  Result<void> seek(const SeekCommand& seek);
  Result<void> choose_thing(const std::string& name);
  Result<void> place(const Placement& placement);
  Result<void> begin_exploring();

  void teach(std::size_t exploration, const std::string& name);
  void teach_given(std::size_t exploration);
  void take_name();
  bool teach_demonstrated();
  double pause_after_result() const;

  void explore();
  void grow(const BodyDescription& body, const Scene& scene);
  void show_step();
  void make_room();
  void drop_before(std::size_t exploration);
  void finish(std::future<Result<Exploration>> explored);
  void end_growing();
  void end_unkept(std::vector<Label> labels);
  void catch_up();
  void await_start();
  void fail_exploring(const Error& error);
  Result<void> keep(Exploration exploration, std::shared_ptr<KeptScene> scene);
  Result<void> name(const NameCommand& command);
  Result<void> undo_name(const UndoNameCommand& command);
  void forget_taught(const GivenName& name);
  Result<void> check_saved(const Result<void>& saved);
  std::vector<Label> shown_labels() const;
  void report(const Result<void>& saved);

  ViewSource source_;
  EventHub& hub_;
  TaskQueue& queue_;
  Pace pace_;
  Replay replay_;
  ChosenSystem chosen_;
  KeptExplorations kept_;
  Memory memory_;
  Audience audience_;
  std::string problem_;
  std::string shown_system_problem_;
  std::size_t failed_ = 0;  // explorations
  bool training_ = false;
  bool closed_ = false;

  // The state of a body.
  ExplorationSequence plan_;
  double result_pause_ = 0.0;            // s
  ExplorationSequence::Next exploring_;  // what is explored
  bool wants_exploring_ = false;
  bool is_permitted_ = false;  // a viewer lets a body explore that a fault has stopped
  std::optional<GrowingExploration> growing_;
  std::optional<BodyStep> coming_;  // the step that the body has taken, until it is shown
  std::size_t moments_left_ = 0;    // to be shown though nothing plays
  std::map<std::string, std::shared_ptr<const Scene>> kept_scenes_;  // by their JSON
  BodyThread body_;                                                  // ends before the rest
};

}  // namespace somato::live
