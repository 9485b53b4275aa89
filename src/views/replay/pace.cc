#include "views/replay/pace.h"

#include <algorithm>

namespace somato::live {

Pace::Clock::time_point Pace::due(double seconds) const {
  return shown_at_ + std::chrono::duration_cast<Clock::duration>(
                         std::chrono::duration<double>(seconds / speed));
}

void Pace::keep(Clock::time_point due) {
  constexpr auto kMostLate = std::chrono::milliseconds(250);
  shown_at_ = std::max(due, Clock::now() - kMostLate);
}

}  // namespace somato::live
