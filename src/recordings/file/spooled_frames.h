#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/files/spool.h"
#include "somato/recording/frame_sink.h"

namespace somato {

/// The frames of an exploration whose start is known only when all its frames are; memory is that
/// of a Spool.
class SpooledFrames {
 public:
  /// As FrameSink::frame(). Errors: those of Spool.
  Result<void> add(std::size_t channel, std::span<const float> values, double time,
                   std::span<const std::uint8_t> valid);

  /// Hands the exploration to `to`, with the earliest time of a frame as that of its start, and
  /// forgets the frames. Errors: those of Spool and `to`.
  Result<void> hand_over(ExplorationStart start, FrameSink& to);

 private:
  Result<void> hand_frame(FrameSink& to);

  Spool spool_;
  double earliest_ = 0.0;
  std::vector<float> values_;
  std::vector<std::uint8_t> valid_;
};

}  // namespace somato
