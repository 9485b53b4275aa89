#include "somato/graph/module.h"

#include <fmt/format.h>

#include <limits>

namespace somato {

const std::vector<std::pair<Rate, std::string>>& Choices<Rate>::all() {
  static const std::vector<std::pair<Rate, std::string>> choices{
      {Rate::kFrame, "frames"}, {Rate::kExploration, "explorations"}};
  return choices;
}

std::size_t PortType::size() const {
  constexpr std::size_t kMost = std::numeric_limits<std::size_t>::max();
  std::size_t size = 1;
  for (const std::size_t length : shape) {
    if (length != 0 && size > kMost / length) return kMost;
    size *= length;
  }
  return size;
}

std::string to_string(const PortType& type) {
  return fmt::format("{}{}, every {}", fmt::join(type.shape, " x "), type.sparse ? ", sparse" : "",
                     type.rate == Rate::kFrame ? "frame" : "exploration");
}

}  // namespace somato
