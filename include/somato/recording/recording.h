#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/result.h"

namespace somato {

/// What one group of sensors reported during an exploration. When its frames were taken is told by
/// `times`, by `rate`, or by neither where nobody knows.
struct Channel {
  std::string name;  ///< Such as "height", "wrist", "joints", "touch", "sound".
  std::string unit;  ///< Of all elements, such as "deg" or "counts"; empty where there is none.
  std::vector<std::string> element_names;  ///< One an element, or empty.
  Matrix<float> frames;                    ///< frames x elements, in the order they were taken.
  std::vector<double> times;               ///< Seconds, one a frame; or empty.
  double rate = 0.0;                       ///< Frames a second, evenly spaced from 0 s; or 0.
  std::vector<std::size_t> shape = {};     ///< Of a frame, row-major, such as {5, 12}; empty: flat.
  Matrix<std::uint8_t> valid = {};  ///< frames x elements: 0 where the sensor told nothing (the
                                    ///< value is then 0), else 1; empty when all is valid.

  /// The shape of a frame, written out.
  std::vector<std::size_t> frame_shape() const;

  /// Frames a second: `rate`, or one divided by the median step between `times`, or 0 where neither
  /// is known.
  double frame_rate() const;

  bool operator==(const Channel&) const = default;
};

/// What is known about an exploration, such as object, shape, material or trial.
struct Label {
  std::string name;
  std::string value;

  bool operator==(const Label&) const = default;
};

/// One exploration of one thing: labels in their order, and what each channel reported.
struct Exploration {
  std::vector<Label> labels;
  std::string source;  ///< The file it came from, or another place to point at.
  std::vector<Channel> channels;

  bool operator==(const Exploration&) const = default;
};

/// What exploring yields, the same whether it was simulated, read from files or taken live. All
/// explorations have the same channels and the same names of labels; see validate().
struct Recording {
  std::vector<Exploration> explorations;

  bool operator==(const Recording&) const = default;
};

/// The channel of that name; an unknown name is an error (kUsage) with the nearest known one. The
/// pointer is valid as long as `exploration` stays as it is.
Result<const Channel*> find_channel(const Exploration& exploration, std::string_view name);

/// The value of the label of that name; an unknown name is an error (kUsage) with the nearest known
/// one.
Result<std::string> find_label(const Exploration& exploration, std::string_view name);

/// The distinct values of a label, in the order in which they first appear; errors as find_label.
Result<std::vector<std::string>> label_values(const Recording& recording, std::string_view name);

/// Checks that `exploration` has the channels (name, unit, elements, shape) and names of labels of
/// `first`, the first one of the recording. Errors (kData, without a place) name the channel.
Result<void> check_alike(const Exploration& exploration, const Exploration& first);

/// Checks that there is an exploration and that each has channels with frames of finite values,
/// names, times, rates, shapes and masks that fit, and the same channels (name, unit, elements,
/// shape) and names of labels as the first one. Errors (kData) name exploration and channel.
Result<void> validate(const Recording& recording);

}  // namespace somato
