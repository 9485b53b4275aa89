#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hardware/emulation/emulated_body.h"
#include "hardware/lines/line_clock.h"
#include "hardware/lines/serial_port.h"

namespace somato::emulation {

/// An emulated body behind pseudo-terminals, for hosts in other processes: in real time, a multiple
/// of it, or the time of the host. Used by one thread.
class PtyEmulator {
 public:
  /// Makes a body before the thing with that name, for a trial (from 0).
  using MakeBody =
      std::function<Result<std::unique_ptr<Body>>(const std::string& thing, std::size_t trial)>;

  /// Begins with the thing `first`. `file` describes the lines; its ports are replaced by
  /// pseudo-terminals, and `clock` is the number of emulated seconds per second; without it time
  /// passes only while the host waits, as fast as possible. Errors: those of `make_body`; kSystem.
  static Result<std::unique_ptr<PtyEmulator>> create(devices::DeviceFile file,
                                                     std::optional<double> clock,
                                                     const std::string& first, MakeBody make_body);

  /// The ports of the lines, in the order of devices::lines_of(), that of the placing, and that of
  /// the host's clock (empty: there is none).
  const std::vector<std::string>& ports() const { return ports_; }
  const std::string& placing_port() const { return placing_.port; }
  std::string clock_port() const { return host_clock_ ? host_clock_->port() : std::string(); }

  EmulatedBody& body() { return *body_; }

  /// Emulates until `should_continue` returns false, and what hosts have sent by then. At the port
  /// of the placing a line "place TRIAL NAME" has the thing placed and is answered by "placed", or
  /// by "error" and the reason. Errors: those of the body, kSystem.
  Result<void> run(const std::function<bool()>& should_continue);

 private:
  PtyEmulator(devices::DeviceFile file, std::optional<double> clock, MakeBody make_body);

  Result<void> open_ports();
  void take_from_host();
  void give_to_host();
  bool has_arrived() const;
  void handle_placing();
  std::string place(const std::string& line);
  double passed();
  Result<void> advance(double now);
  Result<void> follow_clock();
  Result<void> follow_host();
  Result<void> finish();
  void wait() const;

  devices::DeviceFile file_;
  std::optional<double> clock_;
  MakeBody make_body_;
  std::unique_ptr<EmulatedBody> body_;
  std::vector<wire::PseudoTerminal> terminals_;
  std::vector<std::vector<std::uint8_t>> waiting_;  // For each port, what it did not accept yet.
  wire::PseudoTerminal placing_;
  std::optional<wire::LineClockPort> host_clock_;
  std::string placing_text_;
  std::vector<std::string> ports_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  double now_ = 0.0;
};

}  // namespace somato::emulation
