#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace somato::wire {

/// The type of the values of a frame. The numbers are part of the format.
enum class SensorValueType : std::uint8_t { kInt16 = 1, kFloat32 = 2 };

inline constexpr std::size_t kMostSensorValues = 1024;

/// A frame of our own format for sensor boards (docs/formats/sensor-frames.md).
struct SensorFrame {
  std::uint16_t sequence = 0;      ///< One more with each frame; 0 follows 65,535.
  std::uint32_t microseconds = 0;  ///< The board's clock; 0 follows 4,294,967,295.
  SensorValueType type = SensorValueType::kInt16;
  std::span<const float> values;
};

/// The most bytes of a frame with `values` values, with the zeros before and after it.
std::size_t sensor_frame_bytes(std::size_t values, SensorValueType type);

/// Writes the frame; returns the number of bytes, which depends on the values. Values of type
/// int16 are rounded; a NaN of type float32 is a missing value. Throws InvalidArgument for 0 or
/// more than kMostSensorValues values, for values that are infinite or that int16 cannot express,
/// and if `bytes` is smaller than sensor_frame_bytes(). Allocates nothing.
std::size_t encode_sensor_frame(const SensorFrame& frame, std::span<std::uint8_t> bytes);

/// Finds frames in a stream of bytes. It accepts a frame only whole: of the declared number of
/// values, with a correct CRC-32 and without infinite values. A NaN says that the board has no
/// reading. It allocates at its creation only, except for text.
class SensorFrameDecoder {
 public:
  /// For frames with `values` values, 1 to kMostSensorValues.
  explicit SensorFrameDecoder(std::size_t values);

  /// Takes the next byte; returns whether it completes a frame.
  bool take(std::uint8_t byte);

  /// The last whole frame; its values are valid until the next one is complete.
  const SensorFrame& frame() const { return frame_; }

  /// Pieces of the stream between zeros that were no frame.
  std::size_t rejected() const { return rejected_; }

  /// Why the last of these pieces was no frame; empty without one.
  std::string complaint() const;

 private:
  enum class Fault { kCut, kLength, kType, kChecksum, kInfinite };

  void unpack(std::uint8_t byte);
  void put(std::uint8_t byte);
  bool finish();
  std::optional<Fault> fault_in_whole() const;
  std::optional<Fault> read();

  std::vector<float> values_;
  std::vector<float> candidate_;
  std::vector<std::uint8_t> body_;
  std::size_t size_ = 0;
  std::size_t left_ = 0;       // Bytes of the present block that are to come.
  bool zero_follows_ = false;  // Whether a zero stands between the present block and the next.
  bool empty_ = true;
  SensorFrame frame_;
  std::size_t rejected_ = 0;
  Fault fault_ = Fault::kCut;    // That of the last piece that was rejected,
  std::size_t fault_bytes_ = 0;  // and its length.
};

}  // namespace somato::wire
