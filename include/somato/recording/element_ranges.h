#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "somato/recording/recording.h"

namespace somato {

/// The least number of readings from which a sensor that never changes is named: one that gives
/// either of two values by chance gives the same ten times with a probability of 1 in 512.
inline constexpr std::uint64_t kFewestStillReadings = 10;

/// The readings of an element of a channel so far.
struct ElementRange {
  float least = std::numeric_limits<float>::infinity();
  float most = -std::numeric_limits<float>::infinity();
  std::uint64_t readings = 0;  ///< Without those that are missing.
  std::uint64_t missing = 0;

  /// Whether there were enough readings, and all were equal.
  bool is_still() const { return readings >= kFewestStillReadings && least == most; }

  bool operator==(const ElementRange&) const = default;
};

/// Finds the ranges of the elements of a channel, and with them sensors that are dead or missing.
class ElementRanges {
 public:
  /// Adds a frame. A reading is missing if it is NaN, or 0 in `valid`, which may be empty.
  void add(std::span<const float> values, std::span<const std::uint8_t> valid);

  /// Adds all frames.
  void add(const Channel& channel);

  /// One for each element; none before the first frame.
  const std::vector<ElementRange>& elements() const& { return elements_; }
  std::vector<ElementRange> elements() && { return std::move(elements_); }

 private:
  std::vector<ElementRange> elements_;
};

}  // namespace somato
