#pragma once

#include <cstddef>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "views/live/exploration_sequence.h"
#include "views/live/naming.h"
#include "views/live/stage.h"
#include "views/replay/body_thread.h"
#include "views/replay/growing_exploration.h"
#include "views/replay/task_queue.h"

namespace somato::live {

/// Lets the body of a source explore, shows its steps, and keeps what it has explored. Used by the
/// thread of the player.
class BodySession {
 public:
  /// `stage`, `naming` and `queue` must outlive it.
  BodySession(Stage& stage, Naming& naming, const ViewSettings& settings, TaskQueue& queue);

  /// Commands of viewers. Errors (kUsage): an impossible command.
  Result<void> choose_thing(const std::string& name);
  Result<void> place(const Placement& placement);
  Result<void> begin_exploring();

  /// Begins the next exploration.
  void explore();

  /// Whether the next exploration is to begin.
  bool wants_to_explore() const { return wants_exploring_; }
  void want_to_explore(bool wants) { wants_exploring_ = wants; }

  /// Whether the body explores: from explore() until its end is shown.
  bool is_exploring() const { return body_.is_exploring(); }

  /// Whether an exploration in progress is played.
  bool is_growing() const { return growing_.has_value(); }

  /// Seconds from the step that is shown to the one that the body has taken; nothing without one.
  std::optional<double> seconds_to_step() const;

  /// Shows the step that the body has taken.
  void show_step();

  /// Ends an exploration early.
  void give_up();

  /// Waits for the end of the exploration in progress.
  void join() { body_.join(); }

  ExplorationSequence& plan() { return plan_; }
  const ExplorationSequence& plan() const { return plan_; }

  /// The name of the thing that the body explores, as a label.
  Label thing() const;

  /// The number of explorations that failed.
  std::size_t failed() const { return failed_; }

 private:
  // The most memory in bytes of the exploration in progress, and of all that is kept for a page.
  struct Memory {
    std::size_t exploration = 0;
    std::size_t page = 0;
  };

  void grow(const BodyDescription& body, const Scene& scene);
  void make_room();
  void drop_before(std::size_t exploration);
  void finish(std::future<Result<Exploration>> explored);
  void end_growing();
  void end_unkept(std::vector<Label> labels);
  void catch_up();
  void await_start();
  void fail_exploring(const Error& error);
  Result<void> keep(Exploration exploration, std::shared_ptr<KeptScene> scene);

  Stage& stage_;
  Naming& naming_;
  Memory memory_;
  ExplorationSequence plan_;
  ExplorationSequence::Next exploring_;  // what is explored
  bool wants_exploring_ = false;
  bool is_permitted_ = false;  // a viewer lets a body explore that a fault has stopped
  std::size_t failed_ = 0;     // explorations
  std::optional<GrowingExploration> growing_;
  std::optional<BodyStep> coming_;  // the step that the body has taken, until it is shown
  std::map<std::string, std::shared_ptr<const Scene>> kept_scenes_;  // by their JSON
  BodyThread body_;                                                  // ends before the rest
};

}  // namespace somato::live
