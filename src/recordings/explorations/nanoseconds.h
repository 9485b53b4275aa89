#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "recordings/explorations/clock_times.h"

namespace somato {

inline constexpr double kLatestSecond = 9e9;  // About 285 years; nanoseconds fit into 63 bits.
inline constexpr std::int64_t kNanosecondsASecond = 1'000'000'000;

/// Empty outside +-kLatestSecond. Whole seconds and fraction are converted separately, so that
/// large times keep their last digits.
inline std::optional<std::int64_t> nanoseconds_of(double seconds) {
  if (!(std::abs(seconds) <= kLatestSecond)) return std::nullopt;
  const double whole = std::floor(seconds);
  return static_cast<std::int64_t>(whole) * kNanosecondsASecond +
         std::llround((seconds - whole) * 1e9);
}

/// The double nearest to the time; nanoseconds_of() leads back.
inline double seconds_of(std::int64_t nanoseconds) {
  constexpr std::int64_t kExact = std::int64_t{1} << std::numeric_limits<double>::digits;
  if (nanoseconds > -kExact && nanoseconds < kExact) return static_cast<double>(nanoseconds) / 1e9;
  const std::int64_t whole = nanoseconds / kNanosecondsASecond;
  return static_cast<double>(whole) + static_cast<double>(nanoseconds % kNanosecondsASecond) / 1e9;
}

/// is_of_epoch() for nanoseconds: clocks that were not set, and those of simulations, count from
/// 1970 or from a start.
constexpr bool is_of_epoch(std::int64_t nanoseconds) {
  return nanoseconds >= static_cast<std::int64_t>(kYear2000) * kNanosecondsASecond;
}

/// A time since 1970 in words: "2023-11-14 22:13:20 UTC" for one of the epoch, "12.5 s" for
/// another.
std::string words_of_time(std::int64_t nanoseconds);

}  // namespace somato
