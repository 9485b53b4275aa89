#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include "hardware/lines/lines.h"
#include "somato/core/result.h"

namespace somato::wire {

/// Requests and answers on one line, with time-outs, which are multiplied by Lines::clock() if that
/// is above 1, and last at least `patience` seconds: for starting and calibrating a device, not for
/// its ticks.
class Exchange {
 public:
  /// Takes bytes that arrived; returns whether the answer is complete.
  using Take = std::function<bool(std::span<const std::uint8_t> bytes)>;

  Exchange(Lines& lines, std::size_t line, double patience = 0.0)
      : lines_(lines), line_(line), patience_(patience) {}

  double now() const { return lines_.now(); }

  /// Discards what has arrived so far.
  Result<void> clear();

  /// Sends all of `bytes`, for at most `timeout` seconds. Errors (kSystem): the line does not
  /// accept them in this time, or has hung up.
  Result<void> send(std::span<const std::uint8_t> bytes, double timeout = 1.0);

  /// Gives `take` everything that arrives until it returns true, for at most `timeout` seconds;
  /// returns whether it did. Errors (kSystem): the line has hung up.
  Result<bool> receive(double timeout, const Take& take);

  /// clear(), send() and receive(), at most `attempts` times; whether an answer was complete.
  Result<bool> request(std::span<const std::uint8_t> bytes, double timeout, std::size_t attempts,
                       const Take& take);

  /// Waits without reading.
  void pause(double seconds);

 private:
  Result<void> let_late_answers_pass(double timeout);
  double lengthened(double timeout) const;

  Lines& lines_;
  std::size_t line_;
  double patience_;
};

}  // namespace somato::wire
