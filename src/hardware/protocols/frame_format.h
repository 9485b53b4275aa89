#pragma once

#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"

namespace somato::devices {

/// The formats in which boards send the values of sensors.
enum class FrameFormat {
  kFrames,   ///< docs/formats/sensor-frames.md: checked, numbered, with the time of the device.
  kLines,    ///< Lines of numbers, or of names and numbers.
  kAnyskin,  ///< Frames of AnySkin, ReSkin and eFlesh: x, y and z of each magnetometer.
};

}  // namespace somato::devices

namespace somato {

template <>
struct Choices<devices::FrameFormat> {
  static const std::vector<std::pair<devices::FrameFormat, std::string>>& all();
};

}  // namespace somato
