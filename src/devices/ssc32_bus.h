#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "devices/servo_bus.h"
#include "wire/ssc32.h"

namespace somato::devices {

/// Servos at the controller SSC-32, with positions in us of a pulse, 500 to 2500.
///
/// The board does not know where its servos are, and acknowledges nothing. A report therefore
/// states the following:
/// - `position` is the pulse that the board last said to command, in steps of 10 us; NaN: the
///   channel has no pulse, and the next move makes the servo jump. It is no measurement: it follows
///   the commands even if the servo is blocked or unplugged.
/// - `time` is the arrival of the last valid answer of the board to any question, the same for all
///   servos: a board that is switched off, silenced or unplugged lets it grow old.
/// - `current` is NaN and `error` 0.
///
/// Each tick asks for the pulse of one channel, in turn, as soon as the question before is answered
/// or given up. This also shows a board that restarted: its channels have no pulse then. After an
/// answer that does not come within kPatience, or bytes that are no answer, the next tick begins
/// with ESC and CR and sends every position again; for kQuiet no tick asks, and bytes that arrive
/// are discarded, so that a late answer is not mistaken for that of another channel.
class Ssc32Bus : public ServoBus {
 public:
  static constexpr double kPatience = 0.1;  ///< Seconds until an answer is given up.
  static constexpr double kQuiet = 0.05;    ///< Seconds without questions after that.

  /// The servos' channels on the board, each of 0 to 31, none twice.
  explicit Ssc32Bus(std::vector<int> channels);

  /// Works with a board that is in any state and executes a line of its own. Errors: nothing
  /// answers, bytes of another baud rate answer (kSystem); something else answers (kData).
  Result<void> start(wire::Exchange& exchange) override;

  /// Moves the servos whose pulse, rounded to us, differs from that of the last tick, in one group
  /// where the board's receive queue permits it. Servos with positions outside 500 to 2500 us are
  /// left as they are, as with NaN.
  std::span<const std::uint8_t> tick(std::span<const double> positions, double seconds) override;

  void receive(std::span<const std::uint8_t> bytes, double now) override;

  /// ESC, CR, and pulse off for every channel, a line each.
  std::span<const std::uint8_t> relax_bytes() const override { return relax_.bytes(); }

  /// True, because a silent board is a fault, although positions are no measurements.
  bool reports_states() const override { return true; }

  std::size_t bytes_per_tick() const override;

  /// Valid answers since the start.
  std::size_t answers() const { return answers_; }

  /// How often the bus was resynchronized since the start.
  std::size_t resynchronizations() const { return resynchronizations_; }

 private:
  enum class State {
    kIdle,    ///< The next tick asks.
    kAsked,   ///< An answer is to come.
    kFailed,  ///< The next tick resynchronizes.
    kQuiet,   ///< Bytes are discarded.
  };

  Result<void> check_version(wire::Exchange& exchange);
  Result<void> read_pulses(wire::Exchange& exchange);
  Result<int> read_pulse(wire::Exchange& exchange, int channel);
  void add_moves(std::span<const double> positions, double seconds);
  void ask();
  void resynchronize();
  void take(std::uint8_t byte, double now);
  void take_pulse(int pulse, double now);

  std::vector<int> channels_;
  std::vector<std::optional<int>> sent_;  // Pulses, as far as the board is known to have them.
  std::vector<wire::Ssc32Move> moves_;
  wire::Ssc32Commands commands_;
  wire::Ssc32Commands relax_;
  State state_ = State::kIdle;
  std::size_t asked_ = 0;
  double waited_ = 0.0;
  std::size_t answers_ = 0;
  std::size_t resynchronizations_ = 0;
};

}  // namespace somato::devices
