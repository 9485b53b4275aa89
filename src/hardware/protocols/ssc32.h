#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "somato/core/result.h"

namespace somato::wire {

inline constexpr int kSsc32Channels = 32;
inline constexpr int kSsc32LeastPulse = 500;      ///< us
inline constexpr int kSsc32MostPulse = 2500;      ///< us
inline constexpr std::size_t kSsc32Queue = 128;   ///< Bytes of the board's receive queue.
inline constexpr std::uint8_t kSsc32Escape = 27;  ///< Cancels the pending line.

/// A channel of a group move.
struct Ssc32Move {
  int channel = 0;
  int pulse = 1500;  ///< us, 500 to 2500.
  int speed = 0;     ///< us/s, at most 65,535; 0: not limited.
};

/// Lines for the servo controller Lynxmotion SSC-32, in memory of a fixed size: nothing allocates,
/// except the text of an error. A line is at most as long as the board's receive queue.
///
/// The board reports no errors and drops without a sign what it does not understand. Therefore the
/// errors (kUsage) are found here, before anything is sent: numbers that the protocol does not
/// express, commands that do not fit into the memory, and whatever wears the board's memory or
/// silences the board. After an error the bytes are as before.
class Ssc32Commands {
 public:
  static constexpr std::size_t kCapacity = 1024;

  /// Moves a group of channels in `milliseconds`, at most 65,535; 0: as fast as possible. A group
  /// that exceeds one line becomes several lines; only the channels of one line are sure to start
  /// and end together, because the board coordinates the channels of a line.
  Result<void> move(std::span<const Ssc32Move> moves, int milliseconds);

  Result<void> stop(int channel);
  Result<void> pulse_off(int channel);

  /// Shifts the channel's zero by -100 to 100 us.
  Result<void> offset(int channel, int microseconds);

  /// The answer is decoded by ssc32_moving().
  Result<void> query_moving();

  /// The answer is decoded by ssc32_pulse().
  Result<void> query_pulse(int channel);

  /// The answer is decoded by Ssc32Version.
  Result<void> query_version();

  /// ESC and CR: cancels a line that was cut short, so that it does not run on into the next one.
  Result<void> resynchronize();

  /// Any other line, without its CR, which is added. The checks hold for it too.
  Result<void> line(std::string_view text);

  void clear() { size_ = 0; }

  /// Valid until the commands change.
  std::span<const std::uint8_t> bytes() const { return std::span(bytes_).first(size_); }

 private:
  Result<void> put(std::string_view text);
  Result<void> put_group(std::span<const Ssc32Move> moves, std::string_view ending);
  Result<void> put_for_channel(std::string_view before, int channel, std::string_view after);

  std::array<std::uint8_t, kCapacity> bytes_{};
  std::size_t size_ = 0;
};

/// The answer to query_moving(): whether a channel of the last group still moves. Empty: other
/// bytes.
std::optional<bool> ssc32_moving(std::uint8_t byte);

/// The answer to query_pulse(): the commanded pulse in us, in steps of 10, never the servo's
/// position; 0: the channel has no pulse. Empty: a byte that is no such answer. No answer of
/// ssc32_moving() is one.
std::optional<int> ssc32_pulse(std::uint8_t byte);

/// The answer to query_version(): text that ends with CR.
class Ssc32Version {
 public:
  /// Takes bytes that arrived; returns whether the text is complete. Further bytes are ignored.
  bool take(std::span<const std::uint8_t> bytes);

  bool complete() const { return complete_; }

  /// The text received so far, at most 64 characters. Other characters than printable ASCII are
  /// `?`.
  std::string_view text() const { return {text_.data(), size_}; }

  /// Whether characters arrived that no version contains: a wrong baud rate yields such.
  bool unreadable() const { return unreadable_; }

 private:
  void add(std::uint8_t byte);

  std::array<char, 64> text_{};
  std::size_t size_ = 0;
  bool complete_ = false;
  bool unreadable_ = false;
};

}  // namespace somato::wire
