#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "live/event_hub.h"
#include "live/growing_exploration.h"
#include "live/narrator.h"
#include "live/strips.h"
#include "live/task_queue.h"
#include "live/timeline.h"
#include "live/view_command.h"
#include "live/view_json.h"
#include "somato/live/view_source.h"

namespace somato::live {

/// Plays explorations, or lets a body explore, and publishes what is to be seen. All of it happens
/// in one thread, which calls run(); others speak to it through the queue.
class Player : private ExplorationWatcher {
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
  using Clock = std::chrono::steady_clock;

  void set_out();
  void go_on();
  void guarded(const std::function<void()>& work);
  void begin_exploration(std::size_t exploration);
  void show(std::size_t moment);
  void follow_on();
  bool follow_to(std::size_t moment);
  void publish_moment(std::size_t moment);
  void show_again();
  void publish_frame(const ShownMoment& moment, const std::function<Exploration()>& so_far);
  void publish_scene(const Scene* scene);
  void advance();
  std::optional<Clock::time_point> due() const;

  Result<void> seek(const SeekCommand& seek);
  Result<void> step(std::int64_t frames);
  Result<void> play();
  Result<void> choose_thing(const std::string& name);
  Result<void> place(const Placement& placement);
  Result<void> begin_exploring();
  Result<void> choose_system(const std::string& name);
  void tell_narrator();
  std::optional<RecordingLayout> layout() const;
  const Exploration* shown() const;

  void explore();
  void keep_explored(Exploration exploration);
  void lose_exploration();
  Result<void> keep_pace(double passed);
  void publish_live();
  void keep_scene(const Scene& scene);
  void begins(const BodyDescription& body, const Scene& scene) override;
  Result<void> moved(const BodyState& state, const std::vector<ScenePose>& poses) override;
  Result<void> felt(const BodyState& state) override;

  ViewSource source_;
  EventHub& hub_;
  TaskQueue& queue_;
  Narrator narrator_;
  std::optional<std::size_t> system_;
  std::string problem_;
  std::string told_problem_;  // of the system, in the last state
  bool training_ = false;
  bool closed_ = false;

  std::optional<std::size_t> exploration_;  // that plays
  Timeline timeline_;
  std::size_t next_ = 0;               // the moment to come
  std::size_t followed_ = 0;           // moments
  std::optional<std::size_t> wanted_;  // the moment to be shown once all before is followed
  bool following_ = false;
  bool playing_ = false;
  bool welcomed_ = false;
  double speed_ = 1.0;
  Clock::time_point shown_at_;  // or when it should have been
  std::shared_ptr<ScenePlayer> scene_;

  // Of a body.
  Placement placement_;
  std::size_t thing_ = 0;
  std::size_t trials_ = 0;
  bool wants_exploring_ = false;
  bool live_ = false;       // it explores now
  bool abandoned_ = false;  // and something else is wanted
  std::size_t steps_left_ = 0;
  GrowingExploration growing_;
  std::vector<std::vector<float>> felt_last_;  // of each channel
  double time_ = 0.0;                          // by the body's clock
  double begun_ = 0.0;
  std::shared_ptr<const Scene> live_scene_;
  std::map<std::string, std::shared_ptr<const Scene>> kept_scenes_;  // by what is told of them
  std::vector<ScenePose> poses_;                                     // after the last step
  std::vector<std::vector<ScenePose>> live_poses_;                   // of each moment
  std::vector<std::shared_ptr<ScenePlayer>> explored_scenes_;        // of each, or nullptr
};

}  // namespace somato::live
