#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "somato/core/result.h"

namespace somato {

/// Seconds from 1970 to 2000 and to 2100. No recording of touch is older, so that an earlier time
/// is that of a clock that has not been set, or no time at all, such as 0.
inline constexpr double kYear2000 = 946684800.0;
inline constexpr double kYear2100 = 4102444800.0;

/// Whether a time in seconds is one of the epoch: since 1970, and later than 2000.
inline bool is_of_epoch(double seconds) {
  return seconds >= kYear2000;
}

/// Looks for times before 2000 beside times of the epoch. Times that all count from another moment
/// are in order: they are all before 2000.
class ClockTimes {
 public:
  /// A time, as it stands in the data, and where.
  struct Example {
    std::string text;
    std::string where;
  };

  /// Takes the next time, in seconds; the functions give its text and its place, and are called for
  /// the first time of each kind.
  template <typename Text, typename Place>
  void take(double seconds, const Text& text, const Place& place) {
    std::optional<Example>& first = is_of_epoch(seconds) ? of_epoch_ : before_;
    if (!first) first = Example{text(), place()};
    (is_of_epoch(seconds) ? number_of_epoch_ : number_before_) += 1;
  }

  /// Whether any time was of the epoch, and whether any was not.
  bool holds_epoch() const { return number_of_epoch_ > 0; }
  bool holds_before() const { return number_before_ > 0; }

  /// The first time before 2000, if any.
  const std::optional<Example>& before() const { return before_; }

  /// Fails (kData, at the first time before 2000) if there are times of both kinds. `of` names what
  /// has the times, such as "column 'time'".
  Result<void> check(std::string_view of) const;

 private:
  std::optional<Example> of_epoch_;
  std::optional<Example> before_;
  std::size_t number_of_epoch_ = 0;
  std::size_t number_before_ = 0;
};

}  // namespace somato
