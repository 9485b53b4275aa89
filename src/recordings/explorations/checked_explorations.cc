#include "recordings/explorations/checked_explorations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace somato {

Result<void> CheckedExplorations::located(Result<void> checked) const {
  if (checked || current_.source.empty()) {
    if (!checked) checked.error().where = fmt::format("exploration {}", count_ + 1);
    return checked;
  }
  checked.error().where = fmt::format("{}, exploration {}", current_.source, count_ + 1);
  return checked;
}

// Until a channel has a frame, the first exploration states its number of elements.
Result<void> CheckedExplorations::begin_exploration(const ExplorationStart& start) {
  current_ = {start.labels, start.source, {}};
  frames_.assign(start.channels.size(), 0);
  current_.channels.reserve(start.channels.size());
  for (std::size_t i = 0; i < start.channels.size(); ++i) {
    const bool is_known = first_ && i < first_->channels.size();
    current_.channels.push_back(
        channel_of(start.channels[i], is_known ? first_->channels[i].frames : Matrix<float>()));
  }
  if (first_) SOMATO_TRY_VOID(located(check_alike(current_, *first_)));
  return to_->begin_exploration(start);
}

Result<void> CheckedExplorations::frame(std::size_t channel, std::span<const float> values,
                                        double time, std::span<const std::uint8_t> valid) {
  Channel& of = current_.channels[channel];
  if (frames_[channel]++ == 0) {
    of.frames = Matrix<float>(1, values.size(), std::vector<float>(values.begin(), values.end()));
  }
  const auto wrong =
      std::find_if(values.begin(), values.end(), [](float value) { return !std::isfinite(value); });
  if (wrong == values.end()) return to_->frame(channel, values, time, valid);
  return located(fail(ErrorKind::kData,
                      fmt::format("channel '{}', frame {}, element {}: {} is not a finite number",
                                  of.name, frames_[channel], wrong - values.begin() + 1, *wrong),
                      {}, "leave the exploration out, or repair it"));
}

Result<void> CheckedExplorations::end_exploration() {
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    if (frames_[i] == 0) current_.channels[i].frames = {};
  }
  SOMATO_TRY_VOID(located(validate({{current_}})));
  if (!first_) first_ = current_;
  SOMATO_TRY_VOID(located(check_alike(current_, *first_)));
  ++count_;
  return to_->end_exploration();
}

}  // namespace somato
