#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "hardware/buses/bus_kind.h"
#include "hardware/protocols/frame_format.h"

namespace somato::testing {

/// All kinds of the table, so that a new one takes part in the laws of all buses.
inline std::vector<devices::BusKind> every_bus() {
  std::vector<devices::BusKind> kinds;
  for (const auto& choice : Choices<devices::BusKind>::all()) kinds.push_back(choice.first);
  return kinds;
}

/// The same of the formats of sensor frames.
inline std::vector<devices::FrameFormat> every_format() {
  std::vector<devices::FrameFormat> formats;
  for (const auto& choice : Choices<devices::FrameFormat>::all()) formats.push_back(choice.first);
  return formats;
}

inline std::string name_of_bus(const ::testing::TestParamInfo<devices::BusKind>& info) {
  return devices::traits_of(info.param).name;
}

}  // namespace somato::testing
