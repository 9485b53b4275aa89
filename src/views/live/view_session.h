#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "somato/core/result.h"
#include "views/session/losses.h"
#include "views/session/view_source.h"

namespace somato {

namespace live {
class EventHub;
}  // namespace live

/// A view of explorations: plays those of a recording, or what a body explores meanwhile; reads
/// them with a system, and trains systems. It runs in threads of its own and never waits for
/// viewers. docs/formats/view.md describes what a page gets and may ask for.
class ViewSession {
 public:
  ViewSession(ViewSource source, const ViewSettings& settings = {});
  ViewSession(const ViewSession&) = delete;
  ViewSession(ViewSession&&) = delete;
  ViewSession& operator=(const ViewSession&) = delete;
  ViewSession& operator=(ViewSession&&) = delete;
  ~ViewSession();

  /// Publishes the state, and the first frame of a recording, and begins to run.
  void start();

  /// Ends everything and waits for it; nothing is published any more.
  void stop();

  /// The recording that was viewed, with all that a body has explored so far. After stop().
  const Recording& recording() const;

  /// The selected system, with the names that it was taught, or nullptr if it is not trained. After
  /// stop().
  std::shared_ptr<const SystemModel> system() const;

  /// The losses of the session. After stop().
  Losses losses() const;

  /// Does what a command in JSON says. From any thread. Errors: kUsage for no such command, or one
  /// that cannot be done now; kSystem if the change was made, but its file cannot be written.
  Result<void> command(std::string_view json);

  /// Has the thread of the session do a task when it is free; the task must not throw. From any
  /// thread. Returns whether it will be done: not if the session is about to end.
  bool post(std::function<void()> task);

  /// The state in JSON as it is now. From any thread. Errors (kUsage): the view is busy or about to
  /// end.
  Result<std::string> state();

  /// Answers in JSON: what a neuron of a map of the chosen system stands for; where on its maps an
  /// element of the channel `touch` matters. From any thread. Errors (kUsage): there is no such
  /// thing, or no system that has learned.
  Result<std::string> neuron(const std::string& map, std::size_t neuron);
  Result<std::string> taxel(std::size_t element);

  /// Answers in JSON: the channels over the exploration that is shown, as far as it has come, or
  /// null. From any thread. Errors (kUsage): the view is busy or about to end.
  Result<std::string> strips();

  /// The bytes of an MCAP file with all explorations so far, with the names that viewers gave, and
  /// of a file with the selected system. From any thread. Errors: kUsage without an exploration or
  /// a trained system; those of recording_bytes() and system_bytes().
  Result<std::string> recording_file();
  Result<std::string> system_file();

  /// The hub that publishes the events.
  live::EventHub& hub();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace somato
