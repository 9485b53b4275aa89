#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/result.h"

namespace somato {

/// The readings of one group of sensors during an exploration. The times of its frames are given by
/// `times` or by `rate`, or by neither if they are unknown.
struct Channel {
  std::string name;  ///< Such as "height", "wrist", "joints", "touch", "sound".
  std::string
      unit;  ///< The unit of all elements, such as "deg" or "counts"; empty if there is none.
  std::vector<std::string> element_names;  ///< One per element, or empty.
  Matrix<float> frames;                    ///< frames x elements, in order of time.
  std::vector<double> times;               ///< Seconds, one per frame; or empty.
  double rate = 0.0;                       ///< Frames per second, evenly spaced from 0 s; or 0.
  std::vector<std::size_t> shape =
      {};  ///< The shape of a frame, in row-major order, such as {5, 12}; empty: flat.
  Matrix<std::uint8_t> valid = {};  ///< frames x elements: 0 for a missing value (the value is then
                                    ///< 0), else 1; empty if all values are valid.

  /// The shape of a frame, with the default resolved.
  std::vector<std::size_t> frame_shape() const;

  /// Frames per second: `rate`, or the inverse of the median step between `times`, or 0 if neither
  /// is known.
  double frame_rate() const;

  bool operator==(const Channel&) const = default;
};

/// The properties of a channel that are known before its frames; see Channel.
struct ChannelDescription {
  std::string name;
  std::string unit;
  std::vector<std::string> element_names;
  std::vector<std::size_t> shape;
  double rate = 0.0;
  bool times_known =
      true;  ///< Whether the frames' times are meaningful; with a rate they are not used.

  bool operator==(const ChannelDescription&) const = default;
};

/// The description of `channel`.
inline ChannelDescription description_of(const Channel& channel) {
  return {channel.name,  channel.unit, channel.element_names,
          channel.shape, channel.rate, !channel.times.empty()};
}

/// A channel of that description with `frames`, without times and with all values valid.
inline Channel channel_of(const ChannelDescription& description, Matrix<float> frames) {
  return {.name = description.name,
          .unit = description.unit,
          .element_names = description.element_names,
          .frames = std::move(frames),
          .times = {},
          .rate = description.rate,
          .shape = description.shape,
          .valid = {}};
}

/// A property of an exploration, such as object, shape, material or trial.
struct Label {
  std::string name;
  std::string value;

  bool operator==(const Label&) const = default;
};

/// One exploration of one object or material: labels in order, and the readings of each channel.
struct Exploration {
  std::vector<Label> labels;
  std::string source;  ///< The file of the exploration, or another origin for messages.
  std::vector<Channel> channels;

  bool operator==(const Exploration&) const = default;
};

/// A list of explorations, simulated, read from files or recorded live. All explorations have the
/// same channels and the same names of labels; see validate().
struct Recording {
  std::vector<Exploration> explorations;

  bool operator==(const Recording&) const = default;
};

/// The channel with that name; an unknown name is an error (kUsage) with the nearest known one. The
/// pointer is valid as long as `exploration` is unchanged.
Result<const Channel*> find_channel(const Exploration& exploration, std::string_view name);

/// The value of the label with that name; an unknown name is an error (kUsage) with the nearest
/// known one.
Result<std::string> find_label(const Exploration& exploration, std::string_view name);

/// The distinct values of a label, in the order of first appearance; errors as find_label.
Result<std::vector<std::string>> label_values(const Recording& recording, std::string_view name);

/// Checks that `exploration` has the channels (name, unit, elements, shape) and names of labels of
/// `first`, the first one of the recording. Errors (kData, without a location) name the channel.
Result<void> check_alike(const Exploration& exploration, const Exploration& first);

/// Checks that there is an exploration and that each has channels with frames of finite values,
/// consistent names, times, rates, shapes and masks, and the same channels (name, unit, elements,
/// shape) and names of labels as the first one. Errors (kData) name exploration and channel.
Result<void> validate(const Recording& recording);

}  // namespace somato
