#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "somato/core/result.h"

namespace somato::wire {

/// The serial lines of a device, numbered from 0, and the clock by which it is driven. Either real
/// lines, or emulated boards in the same process, whose time only passes during wait().
class Lines {
 public:
  Lines() = default;
  Lines(const Lines&) = delete;
  Lines(Lines&&) = delete;
  Lines& operator=(const Lines&) = delete;
  Lines& operator=(Lines&&) = delete;
  virtual ~Lines() = default;

  /// Seconds of a clock that never goes back.
  virtual double now() const = 0;

  /// Seconds of that clock per second, 1 except for emulated devices in other processes: those
  /// answer no faster.
  virtual double clock() const { return 1.0; }

  /// Reads what has arrived, at most `bytes.size()`, without waiting; returns the number of bytes,
  /// 0 if there are none. Errors (kSystem): the line has hung up.
  virtual Result<std::size_t> read(std::size_t line, std::span<std::uint8_t> bytes) = 0;

  /// Sends as many of `bytes` as the line accepts without waiting; returns their number. Errors
  /// (kSystem): the line has hung up.
  virtual Result<std::size_t> write(std::size_t line, std::span<const std::uint8_t> bytes) = 0;

  /// Waits until bytes arrive on a line, a line hangs up, or the clock reaches `until`.
  virtual void wait(double until) = 0;

  /// Closes the line and opens it again. Errors (kSystem): the port is missing or in use.
  virtual Result<void> reopen(std::size_t line) = 0;
};

}  // namespace somato::wire
