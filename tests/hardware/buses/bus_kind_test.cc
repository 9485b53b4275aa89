#include "hardware/buses/bus_kind.h"

#include <gtest/gtest.h>

#include "hardware/protocols/ssc32.h"

namespace somato::devices {
namespace {

TEST(BusKind, EmulatedLimitsAreWithinTheReachOfTheBus) {
  for (const auto& [kind, name] : Choices<BusKind>::all()) {
    const BusTraits& bus = traits_of(kind);
    EXPECT_EQ(bus.kind, kind) << name;
    EXPECT_EQ(bus.name, name);
    EXPECT_GE(bus.middle - bus.swing, bus.lowest) << name;
    EXPECT_LE(bus.middle + bus.swing, bus.highest) << name;
    EXPECT_LT(bus.first_channel, bus.channels) << name;
  }
}

TEST(BusKind, ThePulsesOfAnSsc32AreThoseOfItsProtocol) {
  const BusTraits& bus = traits_of(BusKind::kSsc32);
  EXPECT_EQ(bus.lowest, wire::kSsc32LeastPulse);
  EXPECT_EQ(bus.highest, wire::kSsc32MostPulse);
  EXPECT_EQ(bus.channels, std::size_t{wire::kSsc32Channels});
  EXPECT_FALSE(bus.measures);
}

}  // namespace
}  // namespace somato::devices
