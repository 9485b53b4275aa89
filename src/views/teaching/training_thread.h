#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "views/http/event_hub.h"
#include "views/teaching/map_training.h"

namespace somato::live {

/// Trains one system at a time beside what is played, and publishes looks at it. Used by one
/// thread.
class TrainingThread {
 public:
  /// Called at the end, by the thread that trained.
  using Done = std::function<void(Result<std::shared_ptr<const SystemModel>>)>;

  TrainingThread(EventHub& hub, std::chrono::duration<double> pause) : hub_(hub), pause_(pause) {}
  TrainingThread(const TrainingThread&) = delete;
  TrainingThread(TrainingThread&&) = delete;
  TrainingThread& operator=(const TrainingThread&) = delete;
  TrainingThread& operator=(TrainingThread&&) = delete;
  ~TrainingThread() { stop(); }

  /// Stops what was trained, and trains this.
  void start(ViewSystem system, std::shared_ptr<const Recording> recording, std::uint64_t seed,
             Done done);

  /// Requests a stop, which takes effect soon: it ends the pause after a snapshot.
  void request_stop();

  /// Stops and waits.
  void stop();

 private:
  Result<std::shared_ptr<const SystemModel>> train(const ViewSystem& system,
                                                   const Recording& recording, std::uint64_t seed);
  void pause();
  bool show(const std::string& system, const TrainingSnapshot& look);

  EventHub& hub_;
  std::chrono::duration<double> pause_;
  std::atomic<bool> stopping_ = false;
  std::mutex mutex_;
  std::condition_variable stop_requested_;
  std::chrono::steady_clock::time_point shown_at_;
  std::thread thread_;
};

}  // namespace somato::live
