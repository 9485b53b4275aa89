#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "hardware/buses/servo_bus.h"
#include "hardware/protocols/ssc32.h"

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
/// - `current` is NaN, and `error` is 0, or kRestarted if a channel that had a pulse has none.
///
/// Each tick queries the pulse of one channel, in turn, and then moves the servos. A board that
/// restarted has forgotten its pulses, and a servo that has sagged would jump; therefore a tick
/// moves nothing before the question of the last one is answered, and the first answer of a board
/// that restarted shows it. An answer is a single byte: bytes that follow it, such as those of an
/// echo, make it invalid. After an answer that does not come within kPatience, or bytes that are no
/// answer, the next tick consists of ESC and CR, and for kQuiet no tick sends anything, and
/// bytes that arrive are discarded, so that a late answer is not mistaken for that of another
/// channel. A query without moves follows; when it is answered, every position is sent again. Moves
/// that waited take as much longer.
///
/// The protocol has no checksum: a byte that is damaged on the line may send a servo to any pulse,
/// until the next tick.
class Ssc32Bus : public ServoBus {
 public:
  static constexpr double kPatience = 0.1;  ///< Seconds until an answer is given up.
  static constexpr double kQuiet = 0.05;    ///< Seconds without commands after that.
  static constexpr std::uint8_t kRestarted = 1;

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

  /// It states the pulses that it sends.
  bool measures_positions() const override { return false; }

  std::size_t bytes_per_tick() const override;
  bool has_sent_positions() const override { return has_moved_; }
  double recovery() const override { return kPatience + 2.0 * kQuiet; }
  Error explain(std::uint8_t error) const override;

  /// Valid answers since the start.
  std::size_t answers() const { return answers_; }

  /// How often the bus was resynchronized since the start.
  std::size_t resynchronizations() const { return resynchronizations_; }

 private:
  enum class State {
    kIdle,      ///< The next tick queries.
    kAsked,     ///< An answer is to come.
    kAnswered,  ///< The next tick takes the answer, unless other bytes follow it.
    kFailed,    ///< The next tick resynchronizes.
    kQuiet,     ///< Nothing is sent, and bytes are discarded.
  };

  Result<void> check_version(wire::Exchange& exchange);
  Result<void> read_pulses(wire::Exchange& exchange);
  Result<int> read_pulse(wire::Exchange& exchange, int channel);
  void add_moves(std::span<const double> positions, double seconds);
  void query();
  void resynchronize();
  void take(std::uint8_t byte, double now);
  void take_answer();
  bool has_restarted() const;

  std::vector<int> channels_;
  std::vector<std::optional<int>> sent_;  // Pulses, as far as the board is known to have them.
  std::vector<wire::Ssc32Move> moves_;
  wire::Ssc32Commands commands_;
  wire::Ssc32Commands relax_;
  State state_ = State::kIdle;
  std::size_t queried_ = 0;
  int answer_ = 0;
  double answer_time_ = 0.0;
  double unmoved_ = 0.0;     // s since the last moves.
  bool has_moved_ = false;   // whether the last tick contained positions
  bool is_unheard_ = false;  // since a resynchronization, no query was answered
  double waited_ = 0.0;
  std::size_t answers_ = 0;
  std::size_t resynchronizations_ = 0;
};

}  // namespace somato::devices
