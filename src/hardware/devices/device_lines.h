#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "hardware/device_files/device_file.h"

namespace somato::devices {

/// One of the lines of a device: a serial port, or the source of a microphone.
struct LineSettings {
  std::string port;
  std::size_t baud = 0;  ///< 0: not a serial port, but a source of sound.
  double rate = 0.0;     ///< Samples per second of a source of sound.
};

/// The numbers of the lines of a device, in the order of lines_of(); see wire::Lines.
struct DeviceLines {
  std::optional<std::size_t> servos;
  std::optional<std::size_t> frames;
  std::optional<std::size_t> microphone;

  explicit DeviceLines(const DeviceFile& file) {
    std::size_t count = 0;
    if (file.servo_line) servos = count++;
    if (file.frame_line) frames = count++;
    if (file.microphone) microphone = count++;
  }
};

/// The lines of a device, in order.
inline std::vector<LineSettings> lines_of(const DeviceFile& file) {
  std::vector<LineSettings> lines;
  if (file.servo_line) lines.push_back({file.servo_line->port, file.servo_line->baud});
  if (file.frame_line) lines.push_back({file.frame_line->port, file.frame_line->baud});
  if (file.microphone) lines.push_back({file.microphone->source, 0, file.microphone->rate});
  return lines;
}

}  // namespace somato::devices
