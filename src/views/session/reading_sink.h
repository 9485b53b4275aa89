#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "recordings/explorations/given_names.h"
#include "somato/core/result.h"
#include "somato/graph/further_learning.h"
#include "somato/graph/system_model.h"
#include "somato/recording/recording.h"
#include "views/session/system_reading.h"

namespace somato::live {

/// The reading of a system after a moment of an exploration.
struct SaidReading {
  std::size_t exploration = 0;  ///< Counting from 0.
  std::size_t moments = 0;      ///< So far, with this one.
  double time = 0.0;            ///< Seconds since the first moment.
  const SystemModel& model;
  const Reading* reading = nullptr;  ///< Or nothing yet.
};

/// A name that an exploration was given, and what the system has learned from it.
struct TaughtName {
  std::size_t exploration = 0;  ///< Counting from 0.
  std::string name;
  Taught taught = {};   ///< Without a problem.
  std::string problem;  ///< Why the system could not learn it, a sentence; or empty.
};

/// Receives what a system says while explorations are played, each moment once and in order. The
/// player waits during each call. An error of a call ends the readings with that error.
struct ReadingSink {
  /// Before the first moment, with the channels of the exploration; those of a body have no frames
  /// yet.
  std::function<Result<void>(const Exploration& exploration)> on_begin;

  std::function<Result<void>(const SaidReading& said)> on_moment;

  /// After the last moment, with the whole exploration and its labels.
  std::function<Result<void>(const SaidReading& said, const Exploration& exploration)> on_end;

  /// After on_end, the name that the exploration is given, if any, for a system that learns names;
  /// may be empty.
  std::function<std::optional<std::string>(const SaidReading& said)> name_of = {};

  /// The system has learned a name, or could not; may be empty.
  std::function<Result<void>(const TaughtName& name)> on_taught = {};

  /// The system has forgotten the name of an exploration, which was taken back; may be empty.
  std::function<Result<void>(const GivenName& name)> on_forgotten = {};

  /// A body's exploration has failed; the next one follows.
  std::function<void(const Error& error)> on_failure;

  /// The file of the session cannot be written: explorations are no longer saved; may be empty.
  std::function<void(const Error& error)> on_unsaved = {};

  /// Once, after which nothing is called any more; not if the session is stopped before.
  std::function<void(const Result<void>& outcome)> on_done;
};

}  // namespace somato::live
