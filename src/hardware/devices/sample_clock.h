#pragma once

#include <cstddef>
#include <limits>
#include <optional>

#include "hardware/device_files/device_file.h"
#include "somato/core/result.h"

namespace somato::devices {

/// Counts the samples of a microphone against the clock of its lines, and finds another rate and
/// samples that were lost. Samples arrive in blocks; a block may be late, never early: what counts
/// is the time from the arrival of one block to that of another.
class SampleClock {
 public:
  /// `clock`: seconds of the lines' clock per second; a delay of the host is as much longer.
  SampleClock(MicrophoneSettings microphone, double clock);

  /// Begins anew with the next block.
  void begin() { first_.reset(); }

  /// `samples` arrived at `now`.
  void add(std::size_t samples, double now);

  /// Whether a block has arrived since begin().
  bool has_begun() const { return first_.has_value(); }

  /// Samples per second since the first block; 0 before a second one.
  double rate() const;

  /// Seconds since the last block.
  double age(double now) const { return now - last_; }

  /// Seconds of sound that should have arrived until `now`, but have not.
  double missing(double now) const;

  /// Fails (kSystem) if the samples are not where the clock says for so long that they are not only
  /// late: samples were lost, or there are too many.
  Result<void> check() const;

  /// Whether the last block was late: it may be followed by more, or samples were lost.
  bool is_off() const { return off_since_.has_value(); }

  /// For the end of a measurement: also fails (kSystem) if the last block was late, or the rate is
  /// another one.
  Result<void> check_all() const;

  /// The same for a device that has been running for a while: there is no latency that may end.
  Result<void> check_rate() const;

 private:
  void note_delay(double delay, double now);
  double late() const;
  double early() const;
  tl::unexpected<Error> fault() const;
  bool is_other_rate(double rate, double latency) const;

  MicrophoneSettings microphone_;
  double clock_;
  std::optional<double> first_;  // The arrival of the first block,
  double last_ = 0.0;            // and of the last.
  std::size_t samples_ = 0;      // Those after the first block.
  double delay_ = 0.0;           // That of the last block, and the least one:
  double least_ = 0.0;  // in the beginning, in the last window of time, and in the present one.
  double least_before_ = 0.0;
  double least_in_window_ = 0.0;
  double window_ = 0.0;  // Its beginning.
  std::optional<double> off_since_;
  double rate_before_ = 0.0;  // The mean rate as long as the samples were where they should be.
};

}  // namespace somato::devices
