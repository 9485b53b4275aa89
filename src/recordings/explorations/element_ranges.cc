#include "somato/recording/element_ranges.h"

#include <algorithm>
#include <cmath>

namespace somato {

void ElementRanges::add(std::span<const float> values, std::span<const std::uint8_t> valid) {
  if (elements_.size() < values.size()) elements_.resize(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    ElementRange& range = elements_[i];
    if (std::isnan(values[i]) || (!valid.empty() && valid[i] == 0)) {
      ++range.missing;
      continue;
    }
    ++range.readings;
    range.least = std::min(range.least, values[i]);
    range.most = std::max(range.most, values[i]);
  }
}

void ElementRanges::add(const Channel& channel) {
  for (std::size_t i = 0; i < channel.frames.rows(); ++i) {
    add(channel.frames.row(i),
        channel.valid.empty() ? std::span<const std::uint8_t>() : channel.valid.row(i));
  }
}

}  // namespace somato
