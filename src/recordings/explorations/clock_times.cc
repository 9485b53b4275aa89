#include "recordings/explorations/clock_times.h"

#include <fmt/format.h>

#include "base/text/text.h"

namespace somato {

Result<void> ClockTimes::check(std::string_view of) const {
  if (!of_epoch_ || !before_) return {};
  return fail(ErrorKind::kData,
              fmt::format("{} of {} times of {} {} before the year 2000, first {}; others are of "
                          "a clock that was set, such as {} ({})",
                          number_before_, number_before_ + number_of_epoch_, of,
                          number_before_ == 1 ? "is" : "are", shown(before_->text),
                          shown(of_epoch_->text), of_epoch_->where),
              before_->where,
              "the clock was not set, or the time is missing: correct these times, or remove them");
}

}  // namespace somato
