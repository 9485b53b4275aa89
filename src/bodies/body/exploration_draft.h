#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "bodies/body/frame_log.h"
#include "recordings/file/growing_recording.h"
#include "somato/bodies/body.h"
#include "somato/recording/recording.h"

namespace somato {

/// Writes what a body reads during an exploration as the draft of a recording, so that it is not
/// lost if the program dies before the exploration ends.
class ExplorationDraft {
 public:
  /// `to` must outlive it.
  explicit ExplorationDraft(GrowingRecording& to) : to_(&to) {}

  /// An exploration begins; another body may follow within it.
  void begin(const BodyDescription& body, std::vector<Label> labels);

  /// Adds the readings of a step that is recorded. Readings that do not fit the description are
  /// left out: what explores reports them. Errors: those of GrowingRecording.
  Result<void> append(const BodyState& state);

 private:
  struct Sensor {
    double rate = 0.0;
    std::size_t elements = 0;  // 0: not known before the first frame
    double latest = -std::numeric_limits<double>::infinity();
  };

  Result<void> open(const BodyState& state);
  Result<void> append(std::size_t sensor, const Matrix<float>& frames, const FrameTimes& times);

  GrowingRecording* to_;
  ExplorationStart start_;
  std::vector<Sensor> sensors_;
  bool is_open_ = false;
};

}  // namespace somato
