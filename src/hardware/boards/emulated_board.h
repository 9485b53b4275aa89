#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace somato::emulation {

/// The board at the other end of a serial line: a state machine of bytes and time, in seconds of
/// the emulation. It never waits; the same bytes at the same times give the same behaviour.
class EmulatedBoard {
 public:
  EmulatedBoard() = default;
  EmulatedBoard(const EmulatedBoard&) = delete;
  EmulatedBoard(EmulatedBoard&&) = delete;
  EmulatedBoard& operator=(const EmulatedBoard&) = delete;
  EmulatedBoard& operator=(EmulatedBoard&&) = delete;
  virtual ~EmulatedBoard() = default;

  /// Bytes that arrived from the host, at the time of the last advance().
  virtual void receive(std::span<const std::uint8_t> bytes) = 0;

  /// Advances to `now`, which never goes back; appends to `sent` what it sends in the meantime.
  virtual void advance(double now, std::vector<std::uint8_t>& sent) = 0;

  /// Switches it off and on: all state that its hardware does not keep is lost.
  virtual void restart() = 0;
};

/// A board with servos, numbered from 0 in the order given at its creation.
class EmulatedServos : public EmulatedBoard {
 public:
  /// The position to which the board drives the servo, in units of the bus; empty while it is off.
  virtual std::optional<double> driven_position(std::size_t servo) const = 0;

  /// Sets the servo's present measurements: its position in units of the bus, and its current in
  /// mA. Boards that cannot report this ignore it.
  virtual void set_measured(std::size_t servo, double position, double current) = 0;
};

/// A board that samples sensors at its own rate.
class EmulatedSensors : public EmulatedBoard {
 public:
  /// The values of all elements from now on.
  virtual void set_values(std::span<const float> values) = 0;
};

}  // namespace somato::emulation
