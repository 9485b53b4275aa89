#include "somato/maps/labels.h"

#include <algorithm>
#include <map>
#include <utility>

#include "somato/core/check.h"

namespace somato {

NeuronLabels::NeuronLabels(std::vector<std::optional<std::size_t>> class_of_neuron)
    : class_of_neuron_(std::move(class_of_neuron)) {
  for (std::size_t neuron = 0; neuron < class_of_neuron_.size(); ++neuron) {
    if (class_of_neuron_[neuron]) labelled_.push_back(neuron);
  }
}

NeuronLabels NeuronLabels::by_majority(const std::vector<std::size_t>& winners,
                                       const std::vector<std::size_t>& classes,
                                       std::size_t neurons) {
  require(winners.size() == classes.size(), "labels need a class for each winner");
  std::vector<std::map<std::size_t, std::size_t>> votes(neurons);  // class -> samples, ascending
  for (std::size_t i = 0; i < winners.size(); ++i) {
    require(winners[i] < neurons, "a winner is not on the map");
    ++votes[winners[i]][classes[i]];
  }
  std::vector<std::optional<std::size_t>> class_of_neuron(neurons);
  for (std::size_t neuron = 0; neuron < neurons; ++neuron) {
    const auto most =
        std::max_element(votes[neuron].begin(), votes[neuron].end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most != votes[neuron].end()) class_of_neuron[neuron] = most->first;
  }
  return NeuronLabels(std::move(class_of_neuron));
}

std::size_t NeuronLabels::classify(const Som& som, const SignalView& input,
                                   SomWorkspace& workspace) const {
  require(!labelled_.empty(), "classification requires at least one neuron with a label");
  return *class_of_neuron_[som.winner_among(labelled_, input, workspace)];
}

Classes Classes::from_names(const std::vector<std::string>& name_of_sample) {
  Classes classes;
  std::map<std::string, std::size_t> numbers;
  for (const std::string& name : name_of_sample) {
    const auto [found, is_new] = numbers.emplace(name, classes.names.size());
    if (is_new) classes.names.push_back(name);
    classes.of_sample.push_back(found->second);
  }
  return classes;
}

}  // namespace somato
