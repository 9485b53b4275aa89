#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "hardware/boards/dynamixel_servos.h"
#include "hardware/boards/feetech_servos.h"
#include "hardware/protocols/dynamixel.h"
#include "hardware/support/damaged_streams.h"

namespace somato::testing {

/// A chain of servos and a host that exchanges packets with it.
struct ServoTalk {
  explicit ServoTalk(const std::vector<emulation::EmulatedDynamixel>& servos, bool echo = false)
      : chain(std::make_unique<emulation::DynamixelServos>(servos, echo)),
        writer(std::make_unique<wire::DynamixelWriter>()) {}
  ServoTalk(wire::FeetechSeries series, const std::vector<emulation::EmulatedFeetech>& servos,
            bool echo = false)
      : chain(std::make_unique<emulation::FeetechServos>(series, servos, echo)),
        writer(std::make_unique<wire::FeetechWriter>(wire::feetech_order(series))) {}

  /// Sends what `fill` writes; returns all that the chain sends in the `seconds` after it.
  template <typename Fill>
  Bytes exchange(const Fill& fill, double seconds = 0.01) {
    Bytes memory(4096);
    writer->use(memory);
    fill(*writer);
    chain->receive(writer->written());
    return pass(seconds);
  }

  Bytes pass(double seconds) {
    Bytes sent;
    chain->advance(now += seconds, sent);
    return sent;
  }

  Bytes write(std::uint8_t id, std::uint16_t address, const Bytes& data, double seconds = 0.01) {
    return exchange([&](auto& to) { to.write(id, address, data); }, seconds);
  }
  Bytes ping(std::uint8_t id, double seconds = 0.01) {
    return exchange([&](auto& to) { to.ping(id); }, seconds);
  }
  Bytes read(std::uint8_t id, std::uint16_t address, std::uint16_t size) {
    return exchange([&](auto& to) { to.read(id, address, size); });
  }

  std::unique_ptr<emulation::ServoChain> chain;
  std::unique_ptr<wire::PacketWriter> writer;
  double now = 0.0;
};

}  // namespace somato::testing
