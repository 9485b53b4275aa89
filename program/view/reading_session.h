#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "somato/graph/system_model.h"
#include "terminal/line_output.h"
#include "terminal/name_input.h"
#include "views/session/view_source.h"

namespace somato::program {

/// The readings of a session on their way to standard output, and the end of the session.
class ReadingSession {
 public:
  /// The readings of `model`; problems with the channels of a body are attributed to `place`.
  ReadingSession(std::shared_ptr<const SystemModel> model, std::string place)
      : model_(std::move(model)), place_(std::move(place)) {}

  /// Takes names for the explorations from standard input from now on. `waits`: waits for one where
  /// an exploration is unknown.
  void take_names(bool waits) {
    takes_names_ = true;
    waits_ = waits;
  }

  /// The number of explorations whose names were learned.
  std::size_t taught() const { return taught_.size(); }

  /// Receives the readings of a player; must not outlive this object.
  live::ReadingSink sink();

  /// Waits until all is read, or a stop is requested; with `stays_open` only until a stop is
  /// requested, unless there was an error. Calls `meanwhile` 20 times per second.
  void wait(bool stays_open, const std::function<void()>& meanwhile);

  /// After the player was stopped. Errors: those of the readings; kInterrupted if they were not
  /// complete; kIncomplete if explorations have failed.
  Result<void> outcome() const;

 private:
  Result<void> begin(const Exploration& exploration);
  std::optional<std::string> name_of(const live::SaidReading& said);
  Result<void> note_taught(const live::TaughtName& name);
  Result<void> note_forgotten(const GivenName& name);
  void report(const Error& failure);
  void report_unsaved(const Error& error);
  void end(const Result<void>& outcome);
  bool is_over(bool stays_open) const;

  std::shared_ptr<const SystemModel> model_;
  std::string place_;
  LineOutput output_;
  NameInput names_;
  bool takes_names_ = false;
  bool waits_ = false;
  std::set<std::size_t> taught_;  // explorations
  bool is_checked_ = false;
  std::size_t failures_ = 0;
  bool is_unsaved_ = false;
  std::optional<ErrorKind> last_failure_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Result<void>> done_;
};

}  // namespace somato::program
