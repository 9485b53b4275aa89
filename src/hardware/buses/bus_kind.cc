#include "hardware/buses/bus_kind.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

#include "hardware/boards/dynamixel_servos.h"
#include "hardware/boards/feetech_servos.h"
#include "hardware/boards/ssc32_board.h"
#include "hardware/buses/dynamixel_bus.h"
#include "hardware/buses/feetech_bus.h"
#include "hardware/buses/ssc32_bus.h"

namespace somato::devices {
namespace {

using Servos = std::span<const BusServo>;
using Bus = std::unique_ptr<ServoBus>;
using Emulated = std::unique_ptr<emulation::EmulatedServos>;

// The models of emulated servos.
constexpr std::uint16_t kXc330 = 1240;
constexpr std::uint16_t kSts3215 = 777;
constexpr std::uint16_t kScs0009 = 1284;

std::vector<int> channels_of(Servos servos) {
  std::vector<int> channels;
  channels.reserve(servos.size());
  for (const BusServo& servo : servos) channels.push_back(static_cast<int>(servo.channel));
  return channels;
}

std::vector<PacketServo> packet_servos(Servos servos, const char* model) {
  std::vector<PacketServo> declared;
  declared.reserve(servos.size());
  for (const BusServo& servo : servos) {
    declared.push_back({static_cast<std::uint8_t>(servo.channel), model});
  }
  return declared;
}

template <typename Made>
std::vector<Made> made_servos(Servos servos, std::uint16_t model) {
  std::vector<Made> all;
  all.reserve(servos.size());
  for (const BusServo& servo : servos) {
    Made made;
    made.id = static_cast<std::uint8_t>(servo.channel);
    made.model = model;
    made.position = servo.resting;
    all.push_back(made);
  }
  return all;
}

Emulated feetech_servos(Servos servos, wire::FeetechSeries series, std::uint16_t model) {
  return std::make_unique<emulation::FeetechServos>(
      series, made_servos<emulation::EmulatedFeetech>(servos, model));
}

constexpr std::size_t kSsc32Rates[] = {2400, 9600, 38400, 115200};
constexpr std::size_t kDynamixelRates[] = {57600, 1000000, 115200, 2000000, 3000000, 4000000, 9600};
constexpr std::size_t kFeetechRates[] = {1000000, 500000, 115200, 57600, 38400};

constexpr BusTraits kBuses[] = {
    {"ssc32", 500.0, 2500.0, 1500.0, 900.0, 10.0, 0, 32, 115200, BusKind::kSsc32, false,
     [](Servos servos) -> Bus { return std::make_unique<Ssc32Bus>(channels_of(servos)); },
     [](Servos servos) -> Emulated {
       return std::make_unique<emulation::Ssc32Board>(channels_of(servos));
     },
     kSsc32Rates, nullptr, "the servos of an SSC-32 have channels and no ids, and no answer"},
    {"dynamixel", 0.0, 4095.0, 2047.0, 1800.0, 4096.0 / 360.0, 1, 253, 1000000, BusKind::kDynamixel,
     true,
     [](Servos servos) -> Bus { return std::make_unique<DynamixelBus>(packet_servos(servos, "")); },
     [](Servos servos) -> Emulated {
       return std::make_unique<emulation::DynamixelServos>(
           made_servos<emulation::EmulatedDynamixel>(servos, kXc330));
     },
     kDynamixelRates, dynamixel_inquiry},
    {"sts", 0.0, 4095.0, 2047.0, 1800.0, 4096.0 / 360.0, 1, 253, 1000000, BusKind::kSts, true,
     [](Servos servos) -> Bus {
       return std::make_unique<FeetechBus>(packet_servos(servos, "STS"));
     },
     [](Servos servos) { return feetech_servos(servos, wire::FeetechSeries::kSts, kSts3215); },
     kFeetechRates, [] { return feetech_inquiry(wire::FeetechSeries::kSts); }},
    {"scs", 0.0, 1023.0, 511.0, 400.0, 1024.0 / 300.0, 1, 253, 1000000, BusKind::kScs, true,
     [](Servos servos) -> Bus {
       return std::make_unique<FeetechBus>(packet_servos(servos, "SCS"));
     },
     [](Servos servos) { return feetech_servos(servos, wire::FeetechSeries::kScs, kScs0009); },
     kFeetechRates, [] { return feetech_inquiry(wire::FeetechSeries::kScs); }},
};

}  // namespace

const BusTraits& traits_of(BusKind kind) {
  return *std::find_if(std::begin(kBuses), std::end(kBuses),
                       [&](const BusTraits& bus) { return bus.kind == kind; });
}

}  // namespace somato::devices

namespace somato {

const std::vector<std::pair<devices::BusKind, std::string>>& Choices<devices::BusKind>::all() {
  static const auto choices = [] {
    std::vector<std::pair<devices::BusKind, std::string>> all;
    all.reserve(std::size(devices::kBuses));
    for (const devices::BusTraits& bus : devices::kBuses) all.emplace_back(bus.kind, bus.name);
    return all;
  }();
  return choices;
}

}  // namespace somato
