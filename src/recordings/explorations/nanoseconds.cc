#include "recordings/explorations/nanoseconds.h"

#include <fmt/format.h>

#include <chrono>

namespace somato {

std::string words_of_time(std::int64_t nanoseconds) {
  if (!is_of_epoch(nanoseconds)) return fmt::format("{:.6g} s", seconds_of(nanoseconds));
  using std::chrono::days;
  const std::chrono::sys_seconds time(std::chrono::seconds(nanoseconds / kNanosecondsASecond));
  const auto midnight = std::chrono::floor<days>(time);
  const std::chrono::year_month_day date(midnight);
  const std::chrono::hh_mm_ss clock(time - midnight);
  return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}:{:02} UTC", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     clock.hours().count(), clock.minutes().count(), clock.seconds().count());
}

}  // namespace somato
