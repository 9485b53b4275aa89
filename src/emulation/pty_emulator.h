#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "emulation/emulated_body.h"
#include "wire/serial_port.h"

namespace somato::emulation {

/// An emulated body behind pseudo-terminals, in real time or a multiple of it: for hosts in other
/// processes. Used by one thread.
class PtyEmulator {
 public:
  /// Makes a body before the thing with that name, for a trial (from 0).
  using MakeBody =
      std::function<Result<std::unique_ptr<Body>>(const std::string& thing, std::size_t trial)>;

  /// Begins with the thing `first`. `file` describes the lines; its ports are replaced by
  /// pseudo-terminals, and `clock` is the number of emulated seconds per second. Errors: those of
  /// `make_body`; kSystem.
  static Result<std::unique_ptr<PtyEmulator>> create(devices::DeviceFile file, double clock,
                                                     const std::string& first, MakeBody make_body);

  /// The ports of the lines, in the order of devices::lines_of(), and that of the placing.
  const std::vector<std::string>& ports() const { return ports_; }
  const std::string& placing_port() const { return placing_.port; }

  EmulatedBody& body() { return *body_; }

  /// Emulates until `should_continue` returns false, and what hosts have sent by then. At the port
  /// of the placing a line "place TRIAL NAME" has the thing placed and is answered by "placed", or
  /// by "error" and the reason. Errors: those of the body, kSystem.
  Result<void> run(const std::function<bool()>& should_continue);

 private:
  PtyEmulator(devices::DeviceFile file, double clock, MakeBody make_body);

  Result<void> open_ports();
  void pass_on();
  void handle_placing();
  std::string place(const std::string& line);
  void pass_time();
  void wait() const;

  devices::DeviceFile file_;
  double clock_;
  MakeBody make_body_;
  std::unique_ptr<EmulatedBody> body_;
  std::vector<wire::PseudoTerminal> terminals_;
  std::vector<std::vector<std::uint8_t>> waiting_;  // For each port, what it did not accept yet.
  wire::PseudoTerminal placing_;
  std::string placing_text_;
  std::vector<std::string> ports_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
  double now_ = 0.0;
};

}  // namespace somato::emulation
