#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/samples.h"

namespace somato {

/// How often a port has a new value.
enum class Rate {
  kFrame,        ///< With every frame of an exploration.
  kExploration,  ///< Once, when an exploration is over.
};

template <>
struct Choices<Rate> {
  static const std::vector<std::pair<Rate, std::string>>& all();
};

/// What goes through a port.
struct PortType {
  Rate rate = Rate::kFrame;
  std::vector<std::size_t> shape;  ///< Of one value, row-major.
  bool sparse = false;             ///< Only the elements that are not zero are kept.
  /// Whose frames these are: frames go together when this is the same. Empty for a value an
  /// exploration.
  std::string clock;

  /// The number of elements; 2^64 - 1 stands for more than can be counted.
  std::size_t size() const;

  bool operator==(const PortType&) const = default;
};

/// "9 x 10, sparse, every frame".
std::string to_string(const PortType& type);

/// What a port carried during one exploration: flat values in the order of time, a single one for a
/// port of Rate::kExploration.
struct Sequence {
  Samples values;
  double rate = 0.0;  ///< Frames a second; 0 where unknown.
};

}  // namespace somato
