#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>

#include "somato/core/progress.h"
#include "somato/core/result.h"

namespace somato {

/// Counts what is completed by several threads, such as the trainings of a study, and keeps the
/// first failure. `work` names it in the message of an interruption, such as "the study"; the
/// progress must outlive the tally.
class Tally {
 public:
  Tally(const char* work, const Progress& progress, std::uint64_t total)
      : work_(work), progress_(progress), total_(total) {}

  void one_done();
  void failed(Error error);
  bool stopped() const { return stopped_; }
  const Error& error() const { return *error_; }

  /// Called regularly during a training to request a stop.
  bool should_continue();

 private:
  void keep(Error error);
  void report();

  const char* work_;
  const Progress& progress_;
  std::uint64_t total_;
  std::uint64_t done_ = 0;
  std::mutex mutex_;
  std::chrono::steady_clock::time_point checked_;
  std::optional<Error> error_;
  std::atomic<bool> stopped_ = false;
};

}  // namespace somato
