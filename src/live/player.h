#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "live/event_hub.h"
#include "live/live_exploration.h"
#include "live/replay.h"
#include "live/showing.h"
#include "live/strips.h"
#include "live/task_queue.h"
#include "live/view_command.h"
#include "somato/live/view_source.h"

namespace somato::live {

/// Plays explorations, or lets a body explore, and publishes what is to be seen. All of it happens
/// in one thread, which calls run(); others speak to it through the queue.
class Player {
 public:
  Player(ViewSource source, const ViewSettings& settings, EventHub& hub, TaskQueue& queue);

  /// Shows what there is before anything plays; before run().
  void begin();

  /// Plays until the queue is closed; a mistake of ours is told as a problem and does not end it.
  void run();

  /// What follows is for the thread of run(), by tasks. Errors (kUsage): what cannot be done now.
  Result<void> handle(const ViewCommand& command);

  const ViewSource& source() const { return source_; }

  /// The system that is chosen, or nullptr.
  const ViewSystem* system() const { return system_ ? &source_.systems[*system_] : nullptr; }

  /// What the strips over time show of what plays or grows, or nothing.
  std::optional<Strips> strips() const;

  /// A system that was trained; it is used when it is the one that is chosen.
  void take_trained(const std::string& name, const std::shared_ptr<const SystemModel>& model);
  void show_training(bool training);
  void show_problem(std::string problem);
  void publish_state();

  /// Begins to play, once, where that waited for somebody to look on.
  void welcome();

 private:
  void set_out();
  void go_on();
  void guarded(const std::function<void()>& work);
  void begin_exploration(std::size_t index);
  void advance();
  std::optional<Pace::Clock::time_point> due() const;

  Result<void> play();
  Result<void> pause();
  Result<void> step(std::int64_t frames);
  Result<void> seek(const SeekCommand& seek);
  Result<void> choose_thing(const std::string& name);
  Result<void> place(const Placement& placement);
  Result<void> begin_exploring();
  Result<void> choose_system(const std::string& name);
  void tell_narrator();

  void explore();
  Result<void> keep_explored(Exploration exploration);
  std::shared_ptr<ScenePlayer> kept_scene();

  ViewSource source_;
  EventHub& hub_;
  TaskQueue& queue_;
  Showing showing_;
  Replay replay_;
  std::optional<std::size_t> system_;
  std::string problem_;
  bool training_ = false;
  bool closed_ = false;
  bool welcomed_ = false;

  // Of a body.
  Placement placement_;
  std::size_t thing_ = 0;
  std::size_t trials_ = 0;
  bool wants_exploring_ = false;
  std::unique_ptr<LiveExploration> live_;                            // that goes on, or nullptr
  std::vector<std::shared_ptr<ScenePlayer>> explored_scenes_;        // of each, or nullptr
  std::map<std::string, std::shared_ptr<const Scene>> kept_scenes_;  // by what is told of them
};

}  // namespace somato::live
