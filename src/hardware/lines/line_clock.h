#pragma once

#include <optional>
#include <string>
#include <utility>

#include "hardware/lines/serial_port.h"
#include "somato/core/result.h"

namespace somato::wire {

/// The clock of an emulator in another process, whose time passes only while its host waits: both
/// sides then act at the same moments at any speed of the machine. The host sends the time until
/// which it waits, as a line of text; the emulator lets time pass, sends what its boards have sent,
/// and answers with a line of that time and the time now. A pseudo-terminal delivers what was
/// written before a line to its own port or to another one before the line.
class LineClock {
 public:
  /// Opens the emulator's port, and asks for the time. Errors: those of open_serial_port();
  /// kSystem: the emulator has ended, or does not answer within a minute.
  static Result<LineClock> open(const std::string& port);

  double now() const { return now_; }

  /// Lets time pass until `until`, or less if bytes arrive on a line. Errors: as open(); time then
  /// passes without the emulator.
  Result<void> wait(double until);

 private:
  LineClock(Descriptor emulator, std::string port)
      : emulator_(std::move(emulator)), port_(std::move(port)) {}

  Result<void> request(double until);
  Result<std::string> answer(std::string& text);

  Descriptor emulator_;
  std::string port_;
  double now_ = 0.0;
};

/// The emulator's side of a LineClock.
class LineClockPort {
 public:
  /// Errors: those of open_pseudo_terminal().
  static Result<LineClockPort> open();

  const std::string& port() const { return terminal_.port; }
  int descriptor() const { return terminal_.device.number(); }

  /// The time until which the host waits; empty if it does not.
  std::optional<double> requested();

  /// Lets the host go on.
  void answer(double now);

 private:
  explicit LineClockPort(PseudoTerminal terminal) : terminal_(std::move(terminal)) {}

  PseudoTerminal terminal_;
  std::string received_;
  std::string request_;
};

}  // namespace somato::wire
