#pragma once

#include <cstdint>
#include <vector>

#include "bodies/sensors/exploration_draws.h"
#include "bodies/sensors/microphone.h"
#include "somato/recording/recording.h"

namespace somato::detail {

/// The signals that the microphone receives during a stroke.
class SoundTruth {
 public:
  /// A frame of the step in progress.
  void hear(const TrueSound& sound) { pending_.push_back(sound); }

  /// The step ends; whether it is recorded.
  void end_step(bool recorded);

  /// Frames before the first that is recorded.
  std::uint64_t before() const { return before_; }

  /// Adds the true channels `true_edge` and `true_servo` with the first `frames` frames.
  void add_to(Exploration& exploration, std::size_t frames) const;

 private:
  std::vector<TrueSound> pending_;
  std::vector<TrueSound> recorded_;
  std::uint64_t before_ = 0;
};

/// Whether the exploration is one of a texture probe with true values.
bool has_sound_truth(const Exploration& exploration);

/// The frames of the true channels of a stroke, `count` as in its sound. Errors (kData): channels
/// that SoundTruth does not write.
Result<std::vector<TrueSound>> true_sounds(const Exploration& exploration, std::size_t count);

/// Where the stick of a hardness probe is at the reading that is recorded, the last one.
struct StickTruth {
  double position = 0.0;    ///< mm.
  std::uint64_t ticks = 0;  ///< Ticks of the probe up to the reading.

  /// Adds the true channel `true_stick`.
  void add_to(Exploration& exploration) const;
};

/// Whether the exploration is one of a hardness probe with true values.
bool has_stick_truth(const Exploration& exploration);

/// The true position of the stick, mm. Errors (kData): a channel that StickTruth does not write.
Result<double> true_stick(const Exploration& exploration);

}  // namespace somato::detail
