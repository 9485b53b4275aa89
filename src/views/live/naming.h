#pragma once

#include <cstddef>
#include <string>

#include "somato/core/result.h"
#include "views/live/stage.h"
#include "views/session/view_command.h"

namespace somato::live {

/// Gives names to explorations, and teaches them to the chosen system. Used by the thread of the
/// player.
class Naming {
 public:
  /// `stage` must outlive it.
  explicit Naming(Stage& stage) : stage_(stage) {}

  /// Errors: kUsage for an impossible command; kSystem if the change is made, but not on the disk.
  Result<void> name(const NameCommand& command);
  Result<void> undo_name(const UndoNameCommand& command);

  /// Teaches the system the name of an exploration, or the one that it was given, if any.
  void teach(std::size_t exploration, const std::string& name);
  void teach_given(std::size_t exploration);

  /// Takes the name that the receiver of the readings gives, if any.
  void take_name();

  /// Teaches the name of the exploration that is shown if the system does not know it; whether it
  /// was taught.
  bool teach_demonstrated();

  /// Reports the error of the file of the session, which continues without it.
  void report(const Result<void>& saved);

 private:
  void forget_taught(const GivenName& name);
  Result<void> check_saved(const Result<void>& saved);

  Stage& stage_;
};

}  // namespace somato::live
