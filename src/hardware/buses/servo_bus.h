#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "hardware/lines/exchange.h"
#include "somato/core/result.h"

namespace somato::devices {

/// The last report of a servo about itself. A value that the bus cannot measure is NaN.
struct ServoReport {
  double position = std::numeric_limits<double>::quiet_NaN();     ///< In units of the bus.
  double current = std::numeric_limits<double>::quiet_NaN();      ///< mA, signed.
  double temperature = std::numeric_limits<double>::quiet_NaN();  ///< Degrees Celsius.
  std::size_t unanswered = 0;  ///< Successive requests for its own state without an answer.
  std::uint8_t error = 0;      ///< Hardware error bits of the protocol; 0: none.
  double time =
      -std::numeric_limits<double>::infinity();  ///< The time of its arrival, by the lines' clock.
};

/// The servos at one serial line, in the order of the device file, with positions in units of the
/// bus: microseconds of a pulse (SSC-32), or steps of an encoder. It encodes and decodes bytes;
/// only start() and restart() use the line themselves. It knows nothing of limits in degrees and
/// speeds, which the safety layer above keeps; positions that the protocol cannot express are
/// never sent.
class ServoBus {
 public:
  ServoBus(const ServoBus&) = delete;
  ServoBus(ServoBus&&) = delete;
  ServoBus& operator=(const ServoBus&) = delete;
  ServoBus& operator=(ServoBus&&) = delete;
  virtual ~ServoBus() = default;

  /// Checks that the controller and every servo answer, prepares them, and reads positions and
  /// errors into reports(). Moves nothing. Errors (kSystem): no answer, with the servo and what to
  /// check; (kData): another kind of board or servo than declared.
  virtual Result<void> start(wire::Exchange& exchange) = 0;

  /// Restarts a servo, which ends an overload, and prepares it as start() does: it then holds its
  /// position. Errors: those of start(); (kUsage): the bus has no such command.
  virtual Result<void> reboot(std::size_t /*servo*/, wire::Exchange& /*exchange*/) {
    return fail(ErrorKind::kUsage, "the servos of this bus cannot be restarted by a command", {},
                "switch their supply off and on");
  }

  /// The bytes of one tick: the positions, one for each servo, that are to be reached after
  /// `seconds`, and a request for the servos' states. A servo with NaN is left as it is. Allocates
  /// nothing; valid until the next call.
  virtual std::span<const std::uint8_t> tick(std::span<const double> positions, double seconds) = 0;

  /// Whether the last tick() contained the positions: a bus that waits for an answer first sends
  /// the positions of a later tick.
  virtual bool has_sent_positions() const { return true; }

  /// Bytes that arrived at `now`; updates reports(). Allocates nothing.
  virtual void receive(std::span<const std::uint8_t> bytes, double now) = 0;

  /// Bytes to be sent after receive(), mostly none: the next request of this tick, for a protocol
  /// that allows one at a time, once the answer to the last has arrived. Allocates nothing; valid
  /// until the next call. A bus works without it, but then reports are older.
  virtual std::span<const std::uint8_t> follow_up() { return {}; }

  /// The bytes that switch all servos off. They never change, so that they can be sent at any
  /// moment, even by a signal handler and during start().
  virtual std::span<const std::uint8_t> relax_bytes() const = 0;

  /// One for each servo.
  std::span<const ServoReport> reports() const { return reports_; }

  /// Whether tick() requests states which receive() must have got: then a bus that says nothing is
  /// a fault.
  virtual bool reports_states() const = 0;

  /// Whether reports() contain positions that the servos measure, not those that they were sent to.
  virtual bool measures_positions() const { return reports_states(); }

  /// Whether the state of one servo is requested after the other: the report of a servo may then be
  /// as old as a round through all of them, and those that do not answer are `unanswered`.
  virtual bool reads_one_by_one() const { return false; }

  /// Seconds without an answer in which a bus that was disturbed recovers: shorter silence is no
  /// fault.
  virtual double recovery() const { return 0.0; }

  /// The meaning of a report with that error, as the end of a sentence about its servo, and advice.
  virtual Error explain(std::uint8_t error) const;

  /// The number of bytes of the longest tick() and of the answer to it, for checking that the line
  /// can carry them.
  virtual std::size_t bytes_per_tick() const = 0;

 protected:
  explicit ServoBus(std::size_t servos) : reports_(servos) {}

  std::vector<ServoReport> reports_;
};

}  // namespace somato::devices
