#include "hardware/protocols/bus_kind.h"

#include <algorithm>
#include <iterator>

namespace somato::devices {
namespace {

constexpr BusTraits kBuses[] = {
    {"ssc32", 500.0, 2500.0, 1500.0, 900.0, 10.0, 0, 32, 115200, BusKind::kSsc32, false},
    {"dynamixel", 0.0, 4095.0, 2047.0, 1800.0, 4096.0 / 360.0, 1, 253, 1000000, BusKind::kDynamixel,
     true},
    {"sts", 0.0, 4095.0, 2047.0, 1800.0, 4096.0 / 360.0, 1, 253, 1000000, BusKind::kSts, true},
    {"scs", 0.0, 1023.0, 511.0, 400.0, 1024.0 / 300.0, 1, 253, 1000000, BusKind::kScs, true},
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
