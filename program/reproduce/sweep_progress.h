#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "somato/core/progress.h"

namespace somato::program {

/// The progress of the remaining points, as one line for all of them.
class SweepProgress {
 public:
  SweepProgress(const std::string& what, std::size_t points);

  /// Study `number`, from 0, of the point's `of` begins.
  void begin_study(std::size_t number, std::size_t of) { study_ = {number, of}; }
  void end_point() { ++done_; }
  void end() const;

  /// The progress of the study on recording `index`, from 0, of `count`. The object must outlive
  /// it.
  Progress of_recording(std::size_t index, std::size_t count) const;

 private:
  struct StudyNumber {
    std::size_t number = 0;
    std::size_t of = 1;
  };

  Progress progress_;
  std::size_t points_;
  std::size_t done_ = 0;
  StudyNumber study_;
};

}  // namespace somato::program
