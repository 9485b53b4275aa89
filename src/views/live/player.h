#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "views/http/event_hub.h"
#include "views/live/body_session.h"
#include "views/live/naming.h"
#include "views/live/playback.h"
#include "views/live/stage.h"
#include "views/live/strips.h"
#include "views/replay/task_queue.h"
#include "views/session/losses.h"
#include "views/session/view_command.h"

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

  /// The following functions are for the thread of run(), by tasks. Errors: kUsage for an
  /// impossible command; kSystem if the change is made, but not on the disk.
  Result<void> handle(const ViewCommand& command);

  const ViewSource& source() const { return stage_.source; }

  /// The labels that viewers gave to explorations.
  const GivenNames& names() const { return stage_.kept.names(); }

  /// The system that is chosen, or nullptr.
  const ViewSystem* system() const { return stage_.chosen.system(); }

  /// The strips over time of the exploration that is played, or nothing.
  std::optional<Strips> strips() const;

  /// See ChosenSystem.
  void take_trained(const std::string& name, const std::shared_ptr<const SystemModel>& model) {
    stage_.chosen.take_trained(name, model);
  }

  void show_training(bool training);
  void show_problem(std::string problem);
  void publish_state();

  /// The losses of the session so far.
  Losses losses() const;

  /// The state as it is now, in JSON.
  std::string state_text() const;

  /// See Playback.
  void on_viewers(std::size_t viewers) { playback_.on_viewers(viewers); }

 private:
  void turn();
  void guarded(const std::function<void()>& work);
  bool is_complete() const;
  std::vector<Label> shown_labels() const;

  EventHub& hub_;
  TaskQueue& queue_;
  Stage stage_;
  Naming naming_{stage_};
  BodySession body_;
  Playback playback_;
  std::string shown_system_problem_;
  bool training_ = false;
  bool closed_ = false;
};

}  // namespace somato::live
