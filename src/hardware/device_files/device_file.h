#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bodies/body/kept_frames.h"
#include "hardware/buses/bus_kind.h"
#include "hardware/protocols/frame_format.h"
#include "somato/bodies/body.h"
#include "somato/core/parameter.h"

namespace somato::devices {

/// Values of each magnetometer in a frame of AnySkin: x, y and z, without its temperature.
inline constexpr std::size_t kAnyskinAxes = 3;

/// The origin of the values of a sensor.
enum class SensorOrigin {
  kDriver,      ///< The positions to which the servos have been driven so far.
  kServos,      ///< The positions that the servos measure themselves.
  kCurrents,    ///< The currents of the servos.
  kFrames,      ///< Elements of the sensor line's frames.
  kMicrophone,  ///< Samples of the microphone.
};

/// The way in which the body explores.
enum class ExploringMethod {
  kGrasping,  ///< explore_by_grasping().
  kClosing,   ///< explore_by_closing().
  kStroking,  ///< explore_by_stroking().
  kPressing,  ///< explore_by_pressing().
  kHolding,  ///< It stays at rest and records for a given time: others move the object or the skin.
};

/// The table [servos]: the line of the servos.
struct ServoLine {
  BusKind bus = BusKind::kSsc32;
  std::string port;
  std::size_t baud = 115200;

  static const Declarations<ServoLine>& declarations();
};

/// A table [servo.NAME]. Its position on the bus is zero + scale x position.
struct ServoSettings {
  std::string name;
  std::size_t channel = 0;
  std::string unit = "deg";
  double zero = 1500.0;
  double scale = 10.0;
  double least = 0.0;
  double most = 0.0;
  double fastest = 60.0;
  std::optional<double> rest;

  static const Declarations<ServoSettings>& declarations();

  double on_bus(double position) const { return zero + scale * position; }
  double from_bus(double position) const { return (position - zero) / scale; }

  /// The position between explorations: `rest`, or the least.
  double resting() const { return rest.value_or(least); }
};

/// The table [frames]: the line of the sensors.
struct FrameLine {
  FrameFormat format = FrameFormat::kFrames;
  std::string port;
  std::size_t baud = 115200;
  std::size_t elements = 0;
  double rate = 100.0;
  KeptFrames keep = KeptFrames::kLatest;

  static const Declarations<FrameLine>& declarations();
};

/// A table [sensor.NAME]. A value is offset + gain x what its origin gives.
struct SensorSettings {
  std::string name;
  std::string unit;
  SensorOrigin from = SensorOrigin::kFrames;
  std::vector<std::string> elements;
  std::vector<std::string> servos;
  std::size_t first = 0;
  double gain = 1.0;
  double offset = 0.0;

  static const Declarations<SensorSettings>& declarations();

  /// The value for what its origin gives.
  float read(double given) const { return static_cast<float>(offset + gain * given); }
};

/// The table [microphone].
struct MicrophoneSettings {
  std::string source;
  double rate = 8192.0;

  static const Declarations<MicrophoneSettings>& declarations();
};

/// The table [safety].
struct SafetySettings {
  std::string sensor;
  std::optional<double> limit;
  std::size_t missed = 3;
  double hold = 1.0;
  double deviation = 0.1;
  double unmoved = 0.5;
  double beyond = 0.05;
  double hottest = 70.0;
  double pause = 0.5;

  static const Declarations<SafetySettings>& declarations();
};

/// The keys of a device file outside of its tables.
struct DeviceSettings {
  std::string name;
  std::string body;
  ExploringMethod explore = ExploringMethod::kClosing;
  double period = 0.02;
  double duration = 5.0;
  std::string placing;
  double clock = 1.0;
  std::string clock_port;

  static const Declarations<DeviceSettings>& declarations();
};

/// A body made of servos and sensors at serial lines (docs/your-hand.md).
struct DeviceFile {
  DeviceSettings settings;
  std::optional<ServoLine> servo_line;
  std::vector<ServoSettings> servos;
  std::optional<FrameLine> frame_line;
  std::optional<MicrophoneSettings> microphone;
  std::vector<SensorSettings> sensors;
  SafetySettings safety;

  /// The servos in the unit of their bus.
  std::vector<BusServo> bus_servos() const;
};

/// The device described by the TOML `text` from the source `where`. Errors (kUsage) with file and
/// line: those of parse_toml(); unknown tables and keys; values out of range; limits of a servo
/// that are no range, or beyond what its bus can express; two servos on one channel; sensors
/// without an origin, or beyond the end of a frame; a missing line.
Result<DeviceFile> parse_device_file(std::string_view text, std::string_view where);

/// The device file at `path`; see parse_device_file() and read_whole().
Result<DeviceFile> read_device_file(const std::string& path);

/// The built-in device file with that name, such as "lucs2": a file of `devices/`.
Result<DeviceFile> own_device_file(std::string_view name);

/// Seconds without an answer or a frame after which the body stops, on a bus that answers each
/// period.
double patience_of(const DeviceFile& file);

/// The body that it makes.
BodyDescription describe(const DeviceFile& file);

/// The number of elements of a sensor.
std::size_t elements_of(const SensorSettings& sensor);

/// Checks that the device can stand for `body`: it has the same servos, with limits inside of the
/// body's, and the same sensors with the same units and elements. Errors (kUsage) name the first
/// difference. A sensor that the device lacks is an error only if `needed` contains its name.
Result<void> check_against(const DeviceFile& file, const BodyDescription& body,
                           const std::vector<std::string>& needed, const std::string& where);

}  // namespace somato::devices

namespace somato {

template <>
struct Choices<devices::SensorOrigin> {
  static const std::vector<std::pair<devices::SensorOrigin, std::string>>& all();
};
template <>
struct Choices<devices::ExploringMethod> {
  static const std::vector<std::pair<devices::ExploringMethod, std::string>>& all();
};

}  // namespace somato
