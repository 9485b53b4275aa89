#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "hardware/boards/dynamixel_servos.h"
#include "hardware/boards/feetech_servos.h"
#include "hardware/buses/bus_kind.h"
#include "hardware/buses/dynamixel_bus.h"
#include "hardware/buses/feetech_bus.h"
#include "hardware/support/board_line.h"
#include "hardware/support/damaged_streams.h"

namespace somato::testing {

/// A position that leaves a servo as it is.
inline constexpr double kLeft = std::numeric_limits<double>::quiet_NaN();

/// A bus and its servos with the ids 1, 2, ... at one line.
struct PacketHand {
  PacketHand(devices::BusKind bus_kind, std::size_t count, bool echo = false)
      : kind(bus_kind),
        servos(made(kind, count, echo)),
        line(*servos),
        exchange(line, 0),
        bus(driver(kind, count)) {}

  /// The position of a servo at the beginning.
  static double place(devices::BusKind kind, std::size_t servo) {
    const auto i = static_cast<double>(servo);
    return kind == devices::BusKind::kDynamixel ? 1000.0 + 100.0 * i : 300.0 + 10.0 * i;
  }

  Result<void> start() { return bus->start(exchange); }

  void take() {
    const Bytes bytes = arrived();
    bus->receive(bytes, line.now());
  }

  Bytes arrived() {
    Bytes bytes(4096);
    const auto count = line.read(0, bytes);
    EXPECT_TRUE(count);
    bytes.resize(*count);
    return bytes;
  }

  /// One tick with its follow-ups.
  void tick(const std::vector<double>& positions, double seconds = 0.02) {
    const double until = line.now() + seconds;
    auto bytes = bus->tick(positions, seconds);
    for (; !bytes.empty(); bytes = bus->follow_up()) {
      ASSERT_TRUE(exchange.send(bytes));
      exchange.pause(0.001);
      take();
    }
    exchange.pause(until - line.now());
  }

  devices::BusKind kind;
  std::unique_ptr<emulation::ServoChain> servos;
  BoardLine line;
  wire::Exchange exchange;
  std::unique_ptr<devices::PacketBus> bus;

 private:
  template <typename Made>
  static std::vector<Made> all_made(devices::BusKind kind, std::size_t count, Made made) {
    std::vector<Made> all(count, made);
    for (std::size_t i = 0; i < count; ++i) {
      all[i].id = static_cast<std::uint8_t>(i + 1);
      all[i].position = place(kind, i);
    }
    return all;
  }

  static std::unique_ptr<emulation::ServoChain> made(devices::BusKind kind, std::size_t count,
                                                     bool echo) {
    using emulation::EmulatedFeetech;
    if (kind == devices::BusKind::kDynamixel) {
      const emulation::EmulatedDynamixel made{.return_delay = 0};
      return std::make_unique<emulation::DynamixelServos>(all_made(kind, count, made), echo);
    }
    const bool sts = kind == devices::BusKind::kSts;
    const auto series = sts ? wire::FeetechSeries::kSts : wire::FeetechSeries::kScs;
    const EmulatedFeetech made{.model = static_cast<std::uint16_t>(sts ? 777 : 1284)};
    return std::make_unique<emulation::FeetechServos>(series, all_made(kind, count, made), echo);
  }

  static std::unique_ptr<devices::PacketBus> driver(devices::BusKind kind, std::size_t count) {
    const bool sts = kind == devices::BusKind::kSts;
    const bool dynamixel = kind == devices::BusKind::kDynamixel;
    const char* model = dynamixel ? "XC330-M288" : sts ? "STS3215" : "SCS0009";
    std::vector<devices::PacketServo> declared;
    for (std::size_t i = 1; i <= count; ++i) {
      declared.push_back({static_cast<std::uint8_t>(i), model});
    }
    if (dynamixel) return std::make_unique<devices::DynamixelBus>(declared);
    return std::make_unique<devices::FeetechBus>(declared);
  }
};

/// Returns the error of start() with two servos after `change`, and checks that no servo holds.
inline Error start_error(devices::BusKind kind,
                         const std::function<void(emulation::ServoChain&)>& change) {
  PacketHand hand(kind, 2);
  change(*hand.servos);
  const auto started = hand.start();
  EXPECT_FALSE(started);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_FALSE(hand.servos->driven_position(i));
  return started ? Error{} : started.error();
}

}  // namespace somato::testing
