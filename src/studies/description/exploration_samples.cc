#include "studies/description/exploration_samples.h"

#include <utility>

#include "somato/maps/labels.h"

namespace somato {

Result<std::vector<std::string>> labels_of(const Recording& recording, const std::string& name) {
  std::vector<std::string> labels;
  for (const Exploration& exploration : recording.explorations) {
    SOMATO_TRY(std::string label, find_label(exploration, name));
    labels.push_back(std::move(label));
  }
  return labels;
}

Result<std::vector<std::size_t>> numbers_of(const Recording& recording, const std::string& name) {
  if (name.empty()) {
    std::vector<std::size_t> numbers(recording.explorations.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = i;
    return numbers;
  }
  return labels_of(recording, name).map([](const std::vector<std::string>& labels) {
    return Classes::from_names(labels).of_sample;
  });
}

}  // namespace somato
