#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "hardware/boards/emulated_board.h"
#include "somato/core/random.h"

namespace somato::emulation {

/// The step in which emulated time passes, in s.
inline constexpr double kTimeStep = 0.001;

/// The faults of a serial line. Everything is off by default and may change at any time.
struct WireFaults {
  bool hung_up = false;   ///< The line is gone: reading and writing fail.
  bool silent = false;    ///< The board's bytes are lost.
  bool deaf = false;      ///< The host's bytes are lost.
  bool echo = false;      ///< The host receives what it sends, as on a half-duplex adapter.
  double flipped = 0.0;   ///< Share of bytes, in both directions, in which one bit is inverted.
  double slowness = 1.0;  ///< Factor by which the line is slower than its speed.
  std::vector<std::uint8_t> garbage;  ///< Sent to the host once, before anything else.
};

/// A serial line between a host and a board, with the speed of the line: a byte takes ten bits.
class EmulatedWire {
 public:
  /// `board` must outlive it. `baud` 0: no delay. `seed` is that of the flipped bits.
  EmulatedWire(EmulatedBoard& board, double baud, std::uint64_t seed = 1);

  WireFaults faults;

  EmulatedBoard& board() { return board_; }

  /// Takes bytes of the host, as many as its buffer of 4096 bytes holds; returns their number.
  std::size_t send(std::span<const std::uint8_t> bytes, double now);

  /// Advances the line and the board to `now`.
  void advance(double now);

  /// Whether bytes have arrived at the host.
  bool has_arrived() const { return !arrived_.empty(); }

  /// Takes what has arrived at the host, at most `bytes.size()`; returns the number of bytes.
  std::size_t receive(std::span<std::uint8_t> bytes);

 private:
  // Bytes on their way in one direction.
  struct Way {
    struct Byte {
      double arrival = 0.0;
      std::uint8_t value = 0;
    };
    std::deque<Byte> bytes;
    double free = 0.0;  // The time at which the last byte has passed.
  };

  void put(Way& way, std::span<const std::uint8_t> bytes, double now);
  std::vector<std::uint8_t> take(Way& way, double now);

  EmulatedBoard& board_;
  double baud_;
  Random random_;
  Way to_board_;
  Way to_host_;
  std::deque<std::uint8_t> arrived_;
};

}  // namespace somato::emulation
