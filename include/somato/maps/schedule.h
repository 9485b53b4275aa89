#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"

namespace somato {

/// Course of a value from start to end.
enum class ScheduleShape {
  kConstant,     ///< Constant at the start value.
  kLinear,       ///< Linear: equal differences.
  kExponential,  ///< Exponential: equal ratios.
};

template <>
struct Choices<ScheduleShape> {
  static const std::vector<std::pair<ScheduleShape, std::string>>& all();
};

/// A value during training: the learning rate or the neighbourhood radius.
///
/// It is `start` at step 0, reaches `end` at step `reached_at` and then remains constant. Steps are
/// iterations (one sample each) or, in batch training, epochs.
struct Schedule {
  ScheduleShape shape = ScheduleShape::kLinear;
  double start = 1.0;
  double end = 1.0;
  std::uint64_t reached_at = 1;

  /// The value at `step`. An exponential schedule requires a start and an end above 0.
  double at(std::uint64_t step) const;

  /// Fails (kUsage) for an exponential schedule that starts or ends at 0; `name` is the name of the
  /// value in the message.
  Result<void> validate(const std::string& name) const;
};

}  // namespace somato
