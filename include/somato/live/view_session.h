#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "somato/core/result.h"
#include "somato/live/view_source.h"

namespace somato {

namespace live {
class EventHub;
}  // namespace live

/// Explorations before everybody's eyes: plays them, or has a body explore, says what a system
/// makes of them, and trains systems. It runs in a thread of its own and never waits for who looks
/// on. What a page is told and may ask for is in docs/formats/view.md.
class ViewSession {
 public:
  ViewSession(ViewSource source, const ViewSettings& settings = {});
  ViewSession(const ViewSession&) = delete;
  ViewSession(ViewSession&&) = delete;
  ViewSession& operator=(const ViewSession&) = delete;
  ViewSession& operator=(ViewSession&&) = delete;
  ~ViewSession();

  /// From here on there is something to be told: the state, and of a recording its first frame.
  void start();

  /// Ends what goes on and waits for it; nobody is told anything any more.
  void stop();

  /// What was viewed: with all that a body has explored so far. After stop().
  const Recording& recording() const;

  /// Does what a command in JSON says. From any thread. Errors (kUsage): no such command, or one
  /// that cannot be done now.
  Result<void> command(std::string_view json);

  /// Answers in JSON: what a neuron of a map of the chosen system stands for; where on its maps an
  /// element of the channel `touch` matters. From any thread. Errors (kUsage): there is no such
  /// thing, or no system that has learned.
  Result<std::string> neuron(const std::string& map, std::size_t neuron);
  Result<std::string> taxel(std::size_t element);

  /// Answers in JSON: what the channels told over the exploration that is shown, as far as that is
  /// known, or null. From any thread. Errors (kUsage): the view is busy or about to end.
  Result<std::string> strips();

  /// For whoever tells others.
  live::EventHub& hub();

 private:
  class Works;
  std::unique_ptr<Works> works_;
};

}  // namespace somato
