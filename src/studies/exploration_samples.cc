#include "studies/exploration_samples.h"

#include <algorithm>
#include <utility>

#include "somato/maps/labels.h"

namespace somato {

Result<std::vector<std::string>> labels_of(const Recording& recording, const std::string& name) {
  std::vector<std::string> labels;
  for (const Exploration& exploration : recording.explorations) {
    Result<std::string> label = find_label(exploration, name);
    if (!label) return fail(std::move(label.error()));
    labels.push_back(std::move(*label));
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

Samples single_values(const Activations& activations, std::size_t module,
                      const std::vector<std::size_t>& explorations) {
  std::vector<Signal> signals;
  signals.reserve(explorations.size());
  for (const std::size_t exploration : explorations) {
    const SignalView view = activations.find(module, exploration)->values[0];
    std::vector<float> values(view.values.begin(), view.values.end());
    signals.push_back(view.sparse
                          ? Signal::sparse({view.size}, {view.indices.begin(), view.indices.end()},
                                           std::move(values))
                          : Signal::dense(std::move(values)));
  }
  return Samples::from_signals(signals);
}

std::vector<std::size_t> ExplorationValues::places_of(
    const std::vector<std::size_t>& wanted) const {
  std::vector<std::size_t> places;
  places.reserve(wanted.size());
  for (const std::size_t one : wanted) {
    const auto place = std::lower_bound(explorations.begin(), explorations.end(), one);
    places.push_back(static_cast<std::size_t>(place - explorations.begin()));
  }
  return places;
}

ExplorationValues values_of(const Activations& activations, std::size_t module,
                            std::vector<std::size_t> explorations) {
  KnownSamples samples(single_values(activations, module, explorations));
  return {std::move(explorations), std::move(samples)};
}

}  // namespace somato
