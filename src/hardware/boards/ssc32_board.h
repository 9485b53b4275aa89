#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hardware/boards/emulated_board.h"
#include "hardware/boards/ssc32_line.h"
#include "hardware/protocols/ssc32.h"

namespace somato::emulation {

/// The servo controller Lynxmotion SSC-32. Where its published description is silent, the emulated
/// board behaves as follows:
/// - A line with an unknown command, or with numbers that do not belong to one, does nothing.
/// - A line longer than the receive queue does nothing, however long it is.
/// - A pulse changes every 20 ms, counted from the moment the board was switched on.
/// - A single channel that moves with neither time nor speed reaches its target at the next step.
/// - After GOBOOT there are neither answers nor pulses until the board is switched off and on.
/// - Offsets shift the driven pulse, not the commanded one, which QP reports.
class Ssc32Board : public EmulatedServos {
 public:
  /// The servos at `channels`, each of 0 to 31, none twice.
  explicit Ssc32Board(std::vector<int> channels, std::string version = "SSC32-V2.01XE");

  void receive(std::span<const std::uint8_t> bytes) override;
  void advance(double now, std::vector<std::uint8_t>& sent) override;
  void restart() override;

  std::optional<double> driven_position(std::size_t servo) const override;

  /// Ignored: the board never knows where its servos are.
  void set_measured(std::size_t servo, double position, double current) override;

  /// The bytes that VA to VD answer: volts * 256 / 5.
  void set_analog(std::size_t input, std::uint8_t value) { analog_.at(input) = value; }

  /// The levels that the board reports for its inputs A to D.
  void set_digital(std::size_t input, bool value) { digital_.at(input) = value; }

  std::uint8_t outputs(std::size_t bank) const { return outputs_.at(bank); }

  /// Register writes so far; they wear the board's memory. Kept over a restart().
  std::size_t register_writes() const { return register_writes_; }

  /// Lines that did not fit the receive queue.
  std::size_t overflows() const { return overflows_; }

  bool silenced() const { return silenced_; }

 private:
  // Pulses in us, times in us since the board was switched on.
  struct Channel {
    std::optional<double> pulse;
    double from = 0.0;
    double target = 0.0;
    double begin = 0.0;
    double duration = 0.0;
    int offset = 0;
    bool moves = false;
    bool in_last_group = false;
  };

  void take(std::uint8_t byte);
  void take_line();
  void execute(const Ssc32Line& line);
  void execute_item(Ssc32Line::Type type, const Ssc32Line::Item& item);
  void move_group(const Ssc32Line& line);
  void start_move(const Ssc32Line::Item& item, double duration);
  double duration_of(const Ssc32Line& line) const;
  double last_step() const;
  void step(Channel& channel) const;
  void answer_pulse(int channel);
  void answer_moving();
  void answer_version();
  void silence();
  Channel& state(int channel) { return states_.at(static_cast<std::size_t>(channel)); }
  const Channel& state(int channel) const { return states_.at(static_cast<std::size_t>(channel)); }

  std::vector<int> channels_;
  std::string version_;
  std::array<Channel, wire::kSsc32Channels> states_{};
  std::array<char, wire::kSsc32Queue> queue_{};
  std::size_t queued_ = 0;
  std::vector<std::uint8_t> answers_;
  std::array<std::uint8_t, 4> analog_{};
  std::array<bool, 4> digital_{};
  std::array<std::uint8_t, 4> outputs_{};
  double switched_on_ = 0.0;
  double now_ = 0.0;
  std::size_t register_writes_ = 0;
  std::size_t overflows_ = 0;
  bool silenced_ = false;
};

}  // namespace somato::emulation
