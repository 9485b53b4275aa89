#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hardware/buses/goal_speed.h"
#include "hardware/buses/servo_bus.h"
#include "hardware/protocols/packets.h"

namespace somato::devices {

/// A servo as the device file declares it.
struct PacketServo {
  std::uint8_t id = 1;
  std::string model;  ///< A name that the bus knows.
};

/// The differences between kinds of servos that need no code: addresses in the memory of a servo,
/// sizes in bytes, and words of messages.
struct PacketServoKind {
  std::string_view maker;
  std::string_view series;  ///< With an article.
  unsigned highest_id = 0;
  std::uint16_t torque = 0;
  std::uint16_t return_delay = 0;
  std::uint16_t goals = 0;      ///< The first address of a sync write.
  std::uint16_t goal_size = 0;  ///< The data of one servo in it.
  std::uint8_t refusal = 0;     ///< Bits in the error of an answer that refuse the request.
  std::string_view error;       ///< The name of an error that a servo reports about itself.
  std::array<std::string_view, 6> errors{};  ///< The names of its bits.
};

/// How servos of a kind are searched by scan_bus(): a request that moves nothing, and the number of
/// the model in its answer.
struct BusInquiry {
  std::unique_ptr<wire::PacketWriter> writer;
  std::unique_ptr<wire::PacketDecoder> decoder;
  void (*request)(wire::PacketWriter& to, std::uint8_t id) = nullptr;
  std::size_t size = 0;   ///< The parameters of an answer.
  std::size_t model = 0;  ///< The place of the model's number in them.
  wire::ByteOrder order = wire::ByteOrder::kLowFirst;
  std::size_t ids = 0;                               ///< They are below this number.
  std::string (*name_of)(unsigned model) = nullptr;  ///< Empty for an unknown model.
};

/// The name of the first of `models` with this number.
template <typename Models>
std::string name_of_model(const Models& models, unsigned number) {
  for (const auto& model : models) {
    if (number != 0 && model.number == number) return std::string(model.name);
  }
  return {};
}

/// Servos that exchange packets with the host and have ids, at one line. Each tick sends one sync
/// write of goals, and requests for states. Nothing is written to the EEPROM.
class PacketBus : public ServoBus {
 public:
  /// Also switches the torque of all servos on, with their present positions as goals.
  Result<void> start(wire::Exchange& exchange) override;

  Result<void> reboot(std::size_t servo, wire::Exchange& exchange) override;
  std::span<const std::uint8_t> tick(std::span<const double> positions, double seconds) override;
  void receive(std::span<const std::uint8_t> bytes, double now) override;

  /// A broadcast to all servos of the line, repeated: if the packet before it was cut off, servos
  /// take the first ones for the rest of that packet.
  std::span<const std::uint8_t> relax_bytes() const override { return relax_; }

  bool reports_states() const override { return true; }

  /// Problems found by start() that do not prevent the use of the servos.
  const std::vector<std::string>& warnings() const { return warnings_; }

 protected:
  using Bytes = std::vector<std::uint8_t>;
  using Span = std::span<const std::uint8_t>;
  struct Coders {
    std::unique_ptr<wire::PacketWriter> writer;
    std::unique_ptr<wire::PacketDecoder> states;   // of what arrives between ticks
    std::unique_ptr<wire::PacketDecoder> answers;  // to single requests
  };
  struct Servo {
    PacketServo declared;
    double goal = 0.0;  // the last that was sent
    GoalSpeed speed{};
    double lowest = 0.0;
    double highest = 0.0;

    std::uint8_t id() const { return declared.id; }
    std::string place() const;
  };
  struct Answer {
    std::uint8_t error = 0;
    Bytes data;
  };
  static constexpr double kAnswerTime = 0.05;  // s; an adapter may collect bytes for 16 ms
  static constexpr std::size_t kAttempts = 3;

  /// Throws InvalidArgument for no servos, or an id that is not possible or occurs twice.
  PacketBus(const PacketServoKind& kind, const std::vector<PacketServo>& servos, Coders coders);

  /// For the constructor: the size of the longest tick, and of the longest packet for whose rest a
  /// servo may wait.
  void set_sizes(std::size_t tick, std::size_t longest);

  /// The bytes that `fill` writes.
  template <typename Fill>
  Bytes packet(const Fill& fill) {
    std::array<std::uint8_t, 64> memory{};
    coders_.writer->use(memory);
    fill(*coders_.writer);
    return {coders_.writer->written().begin(), coders_.writer->written().end()};
  }

  /// The writer of ticks, which begins a new one.
  wire::PacketWriter& tick_writer();

  /// The answer to a request, with data of `size` bytes.
  Result<Answer> ask(const Servo& servo, Span request, std::size_t size,
                     wire::Exchange& exchange) const;
  Result<Answer> read(const Servo& servo, std::uint16_t address, std::size_t size,
                      wire::Exchange& exchange);

  Result<void> check_error(const Servo& servo, std::uint8_t bits) const;
  void warn_of_delay(const Servo& servo, std::uint8_t units);
  double speed_to(std::size_t servo, double goal, double seconds);

  std::vector<Servo> servos_;
  Bytes ids_;
  Bytes tick_;
  Coders coders_;
  std::vector<std::string> warnings_;

 private:
  /// Checks that the servo can be used, and reads its settings.
  virtual Result<void> check(std::size_t servo, wire::Exchange& exchange) = 0;

  /// Reads the state of the servo into its report.
  virtual Result<void> measure(std::size_t servo, wire::Exchange& exchange) = 0;

  virtual Result<void> write(const Servo& servo, std::uint16_t address, const Bytes& data,
                             wire::Exchange& exchange) = 0;

  /// Sends the servo its goal, while its torque is off.
  virtual Result<void> write_goal(std::size_t servo, wire::Exchange& exchange) = 0;

  /// Restarts the servo, and waits until it answers.
  virtual Result<void> restart(const Servo& servo, wire::Exchange& exchange) = 0;

  virtual void put_goal(wire::PacketWriter& to, std::size_t servo, double goal, double seconds) = 0;
  virtual void request_states(wire::PacketWriter& to, double seconds) = 0;
  virtual void take(std::size_t servo, const wire::Packet& packet, double now) = 0;

  Result<void> hold(std::size_t servo, wire::Exchange& exchange);
  Result<void> hold_all(wire::Exchange& exchange);
  void write_goals(wire::PacketWriter& to, std::span<const double> positions, double seconds);

  const PacketServoKind& kind_;
  std::array<std::uint8_t, 256> servo_of_id_{};
  Bytes relax_;
};

}  // namespace somato::devices
