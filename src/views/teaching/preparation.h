#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <thread>

#include "somato/core/result.h"
#include "somato/graph/system_model.h"
#include "somato/recording/recording.h"
#include "views/session/view_source.h"

namespace somato::live {

/// The explorations before the view so far, and the system that was trained on it.
struct Prepared {
  std::shared_ptr<const Recording> recording;
  std::shared_ptr<const SystemModel> model;
  bool is_last = false;  ///< Or a further round follows.
};

/// Explores with a simulated body and trains a system in a thread of its own, so that a view begins
/// with a trained system.
class Preparation {
 public:
  /// Called by that thread after each round; after an error no round follows.
  using Done = std::function<void(const Result<Prepared>& prepared)>;

  Preparation() = default;
  Preparation(const Preparation&) = delete;
  Preparation(Preparation&&) = delete;
  Preparation& operator=(const Preparation&) = delete;
  Preparation& operator=(Preparation&&) = delete;
  ~Preparation() { stop(); }

  /// Explores, and trains `system` with `seed` after each round. To be called once.
  void start(ViewSystem system, PriorExplorations explorations, std::uint64_t seed, Done done);

  /// Has it end soon, with an error of kInterrupted.
  void request_stop() { stopping_ = true; }

  /// The same, and waits for the end.
  void stop();

 private:
  Result<void> prepare(const ViewSystem& system, const PriorExplorations& explorations,
                       std::uint64_t seed, const Done& done) const;

  std::atomic<bool> stopping_ = false;
  std::thread thread_;
};

}  // namespace somato::live
