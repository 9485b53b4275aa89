#include "systems/model/labels_part.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "maps/som/map_parts.h"

namespace somato {
namespace {

constexpr std::int64_t kNoLabel = -1;
constexpr std::int64_t kMostVotes = std::int64_t{1} << 53;

}  // namespace

Array<std::int64_t> labels_array(const NeuronLabels& labels) {
  Array<std::int64_t> array{{labels.neurons()}, {}};
  for (std::size_t neuron = 0; neuron < labels.neurons(); ++neuron) {
    array.values.push_back(labels[neuron] ? static_cast<std::int64_t>(*labels[neuron]) : kNoLabel);
  }
  return array;
}

Result<NeuronLabels> labels_from(const Archive& archive, std::size_t neurons, std::size_t classes,
                                 const std::string& where) {
  SOMATO_TRY(const auto array, archive.get<Array<std::int64_t>>("labels", where));
  if (array->shape != std::vector<std::uint64_t>{neurons}) {
    return damaged_model("the labels do not fit the map", where);
  }
  std::vector<std::optional<std::size_t>> class_of_neuron;
  for (const std::int64_t label : array->values) {
    if (label < kNoLabel || std::cmp_greater_equal(label, classes)) {
      return damaged_model("a neuron has the label of an unknown class", where);
    }
    class_of_neuron.push_back(label == kNoLabel ? std::optional<std::size_t>{}
                                                : static_cast<std::size_t>(label));
  }
  NeuronLabels labels(std::move(class_of_neuron));
  if (labels.labelled().empty()) return damaged_model("no neuron has a label", where);
  return labels;
}

Array<std::int64_t> votes_array(const NeuronVotes& votes, std::size_t classes) {
  Array<std::int64_t> array{{votes.neurons(), classes}, {}};
  array.values.reserve(votes.neurons() * classes);
  for (std::size_t neuron = 0; neuron < votes.neurons(); ++neuron) {
    for (std::size_t c = 0; c < classes; ++c) {
      array.values.push_back(static_cast<std::int64_t>(votes.of(neuron, c)));
    }
  }
  return array;
}

Result<NeuronVotes> votes_from(const Archive& archive, std::size_t neurons, std::size_t classes,
                               const std::string& where) {
  SOMATO_TRY(const auto array, archive.get<Array<std::int64_t>>("votes", where));
  if (array->shape != std::vector<std::uint64_t>{neurons, classes}) {
    return damaged_model("the votes do not fit the map", where);
  }
  NeuronVotes votes(neurons);
  for (std::size_t i = 0; i < array->values.size(); ++i) {
    const std::int64_t count = array->values[i];
    if (count < 0 || count > kMostVotes) {
      return damaged_model("a neuron has an invalid number of votes", where);
    }
    votes.add(i / classes, i % classes, static_cast<std::size_t>(count));
  }
  return votes;
}

}  // namespace somato
