#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace somato::wire {

/// Which numbers a magnetometer can report. Values outside are taken for damage. Three fields of
/// exactly 0 are no reading: the Earth's field is above 20 microtesla everywhere, and noise does
/// not hit 0 on three axes at once; a board sends them for a magnetometer that does not answer.
struct AnySkinLimits {
  float least_temperature = -20.0F;  ///< Degrees Celsius.
  float most_temperature = 85.0F;
  float least_field = 1e-6F;  ///< Microtesla, of a component that is not exactly 0.
  float most_field = 50'000.0F;
};

/// The bytes of a frame: 16 for each magnetometer, CR and LF.
constexpr std::size_t anyskin_frame_bytes(std::size_t magnetometers) {
  return 16 * magnetometers + 2;
}

/// Writes a frame with the temperature, x, y and z of each magnetometer; returns the number of its
/// bytes. Throws InvalidArgument unless there are four values for each, and if `bytes` is smaller
/// than the frame. Allocates nothing.
std::size_t encode_anyskin_frame(std::span<const float> values, std::span<std::uint8_t> bytes);

/// Finds frames in the stream of AnySkin, ReSkin and eFlesh: for each magnetometer its temperature,
/// x, y and z as little-endian float32; then CR LF. The format has no checksum and CR LF may occur
/// in values. A frame is therefore accepted only if CR LF stands both before and after it, if it
/// does not overlap the frame accepted before, and if all its values lie within the limits, or the
/// three fields of a magnetometer say that it has no reading: all 0, or all NaN. A byte that is
/// changed within a value, and leaves it within the limits, cannot be noticed. It allocates at its
/// creation only, except for text.
class AnySkinDecoder {
 public:
  explicit AnySkinDecoder(std::size_t magnetometers, const AnySkinLimits& limits = {});

  /// Takes the next byte; returns whether it completes a frame.
  bool take(std::uint8_t byte);

  /// Temperature, x, y and z of each magnetometer in the last frame; NaN for what it did not read.
  std::span<const float> values() const { return values_; }

  /// How many frames had room in the bytes that did not belong to an accepted one; the first frame
  /// after the beginning is among them, because nothing shows that it is whole.
  std::size_t rejected() const { return rejected_; }

  /// Why the last of them was no frame; empty without one.
  std::string complaint() const;

 private:
  void append(std::uint8_t byte);
  bool accepts();
  bool has_no_reading(std::size_t magnetometer) const;
  std::optional<std::size_t> implausible(std::size_t magnetometer) const;
  bool is_plausible(std::size_t value) const;
  void take_values();
  float read(std::size_t value) const;
  std::span<const std::uint8_t> window() const;

  AnySkinLimits limits_;
  std::vector<float> values_;
  std::vector<std::uint8_t> bytes_;  // Twice as long as a window, so that it seldom must be moved.
  std::size_t end_;
  std::size_t since_frame_ = 0;
  std::size_t rejected_ = 0;
  std::optional<std::size_t> wrong_;  // The value for which the last frame was rejected,
  float wrong_value_ = 0.0F;
};

}  // namespace somato::wire
