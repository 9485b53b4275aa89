#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hardware/lines/line_clock.h"
#include "hardware/lines/lines.h"
#include "hardware/lines/serial_port.h"
#include "hardware/lines/sound_source.h"

namespace somato::wire {

/// Serial ports and sound sources, driven by the steady clock of the system or by the clock of
/// their emulator.
class SerialLines : public Lines {
 public:
  struct Port {
    std::string path;           ///< The path of a serial port, or a source; see open_sound().
    std::size_t baud = 115200;  ///< 0: a source of sound.
    double rate = 0.0;          ///< Samples per second of a source of sound.
  };

  /// Opens all ports. `clock` is the number of seconds of now() per second, 1 except for emulated
  /// devices. With `clock_port` time is that of an emulator; see LineClock. Errors: those of
  /// open_serial_port(), open_sound() and LineClock::open().
  static Result<std::unique_ptr<SerialLines>> open(std::vector<Port> ports, double clock = 1.0,
                                                   const std::string& clock_port = {});

  double now() const override;
  double clock() const override { return emulator_clock_ ? 1.0 : clock_; }
  Result<std::size_t> read(std::size_t line, std::span<std::uint8_t> bytes) override;
  Result<std::size_t> write(std::size_t line, std::span<const std::uint8_t> bytes) override;
  void wait(double until) override;
  Result<void> reopen(std::size_t line) override;

  /// The descriptor of a line, for a signal handler that switches the servos off; -1 if it is
  /// closed.
  int descriptor(std::size_t line) const { return open_.at(line).number(); }

 private:
  SerialLines(std::vector<Port> ports, double clock)
      : ports_(std::move(ports)),
        clock_(clock),
        open_(ports_.size()),
        sounds_(ports_.size()),
        words_(ports_.size()),
        hung_up_(ports_.size(), 0) {}

  void wait_at_ports(double until);

  std::vector<Port> ports_;
  double clock_;
  std::optional<LineClock> emulator_clock_;
  Result<void> check_words(std::size_t line);

  std::vector<Descriptor> open_;
  std::vector<SoundSource> sounds_;  // One for each line; the samples are in open_.
  std::vector<std::string> words_;   // The messages of their recorders.
  std::vector<char> hung_up_;        // Noticed while waiting: reading would only give nothing.
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace somato::wire
