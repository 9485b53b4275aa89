#include "somato/maps/labels.h"

#include <algorithm>
#include <map>
#include <utility>

#include "maps/reading/sample_reader.h"
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
  NeuronVotes votes(neurons);
  votes.add_all(winners, classes);
  return votes.labels();
}

std::size_t NeuronLabels::classify(const Som& som, const SignalView& input,
                                   SomWorkspace& workspace) const {
  require_labels();
  return *class_of_neuron_[som.winner_among(labelled_, input, workspace)];
}

std::vector<std::size_t> NeuronLabels::classify(const Som& som, const Samples& samples,
                                                std::size_t threads) const {
  require_labels();
  return classes_of(SampleReader(som, threads, labelled_).read(samples).nearest);
}

std::vector<std::size_t> NeuronLabels::classes_of(const std::vector<std::size_t>& labelled) const {
  std::vector<std::size_t> classes;
  classes.reserve(labelled.size());
  for (const std::size_t neuron : labelled) classes.push_back(*class_of_neuron_[neuron]);
  return classes;
}

void NeuronLabels::require_labels() const {
  require(!labelled_.empty(), "classification requires at least one neuron with a label");
}

std::size_t NeuronVotes::classes() const {
  std::size_t classes = 0;
  for (const auto& of_neuron : votes_) {
    if (!of_neuron.empty()) classes = std::max(classes, of_neuron.rbegin()->first + 1);
  }
  return classes;
}

std::size_t NeuronVotes::of(std::size_t neuron, std::size_t the_class) const {
  const auto found = votes_[neuron].find(the_class);
  return found == votes_[neuron].end() ? 0 : found->second;
}

void NeuronVotes::add(std::size_t neuron, std::size_t the_class, std::size_t votes) {
  require(neuron < neurons(), "a winner is not on the map");
  if (votes > 0) votes_[neuron][the_class] += votes;
}

void NeuronVotes::add_all(const std::vector<std::size_t>& winners,
                          const std::vector<std::size_t>& classes) {
  require(winners.size() == classes.size(), "labels need a class for each winner");
  for (std::size_t i = 0; i < winners.size(); ++i) add(winners[i], classes[i]);
}

NeuronVotes NeuronVotes::moved_to(const NeuronOrigins& origins) const {
  NeuronVotes moved(origins.size());
  for (std::size_t neuron = 0; neuron < origins.size(); ++neuron) {
    if (!origins[neuron]) continue;
    require(*origins[neuron] < neurons(), "the origin of a neuron is not on the map");
    moved.votes_[neuron] = votes_[*origins[neuron]];
  }
  return moved;
}

NeuronLabels NeuronVotes::labels() const {
  std::vector<std::optional<std::size_t>> class_of_neuron(neurons());
  for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
    const auto& of_neuron = votes_[neuron];
    const auto most =
        std::max_element(of_neuron.begin(), of_neuron.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    if (most != of_neuron.end()) class_of_neuron[neuron] = most->first;
  }
  return NeuronLabels(std::move(class_of_neuron));
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
