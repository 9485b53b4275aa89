#include "systems/model/channel_planes.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "somato/core/check.h"
#include "somato/graph/system_model.h"
#include "systems/model/element_names.h"
#include "systems/model/weight_folding.h"

namespace somato {
namespace {

constexpr std::size_t kShort = 64;
constexpr std::size_t kMostPlaneElements = 256;
constexpr std::size_t kMostGroups = 128;

ChannelPlanes of_channel(const System& system, std::size_t module, const Source& source) {
  const SystemModule& own = system.modules()[module];
  ChannelPlanes planes{source.channel(), {}, own.output.shape, {}, {}, {}};
  for (const ChannelLayout& channel : system.layout().channels) {
    if (channel.name != source.channel()) continue;
    planes.unit = channel.unit;
    planes.elements =
        taken_elements(system.description().modules[module].settings, channel.element_names);
  }
  if (planes.elements.size() != own.output.size()) {
    planes.elements = numbers_as_names(own.output.size());
  }
  return planes;
}

ChannelPlanes frame_of(const System& system, std::size_t module) {
  const SystemModule& own = system.modules()[module];
  const auto* source = dynamic_cast<const Source*>(own.module.get());
  if (source) return of_channel(system, module, *source);
  return {own.name, {}, own.output.shape, numbers_as_names(own.output.size()), {}, {}};
}

// Too many elements to display: means of neighbours.
void group(ChannelPlanes& planes) {
  const std::size_t all = planes.elements.size();
  if (all <= kMostPlaneElements) return;
  const std::size_t each = (all + kMostGroups - 1) / kMostGroups;
  const std::size_t groups = (all + each - 1) / each;
  Matrix<double> means(planes.values.rows(), groups);
  for (std::size_t neuron = 0; neuron < means.rows(); ++neuron) {
    for (std::size_t i = 0; i < all; ++i) means(neuron, i / each) += planes.values(neuron, i);
    for (std::size_t g = 0; g < groups; ++g) {
      means(neuron, g) /= static_cast<double>(std::min(each, all - g * each));
    }
  }
  std::vector<std::string> names;
  names.reserve(groups);
  for (std::size_t g = 0; g < groups; ++g) {
    names.push_back(planes.elements[g * each] + "-" +
                    planes.elements[std::min(all, (g + 1) * each) - 1]);
  }
  planes.shape = {groups};
  planes.elements = std::move(names);
  planes.values = std::move(means);
}

detail::FoldedWeights weights_of(const Som& som, std::size_t neuron) {
  const auto listed = som.elements().listed();
  detail::FoldedWeights weights{som.input_size(), {listed.begin(), listed.end()}, {}};
  const std::size_t count = som.elements().count();
  weights.values.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t element = som.elements().all() ? i : listed[i];
    weights.values.push_back(double{som.weight(neuron, element)});
  }
  return weights;
}

// All elements of the map's input.
ChannelPlanes input_planes(const System& system, std::size_t input, const Som& som) {
  const SystemModule& module = system.modules()[input];
  ChannelPlanes planes{module.name, {}, module.output.shape, numbers_as_names(som.input_size()),
                       {},          {}};
  planes.values = Matrix<double>(som.neurons(), som.input_size());
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    for (std::size_t element = 0; element < som.input_size(); ++element) {
      planes.values(neuron, element) = double{som.weight(neuron, element)};
    }
  }
  return planes;
}

bool keeps_units(const Som& som) {
  const SomParameters& p = som.parameters();
  return p.similarity != Similarity::kDotProduct && !p.normalize_input.value_or(false);
}

}  // namespace

std::vector<ChannelPlanes> channel_planes(const System& system, std::size_t map) {
  const Som* som = som_of(system, map);
  require(som != nullptr && som->neurons() > 0, "planes need a trained map");
  const std::size_t input = system.modules()[map].inputs.front();
  const detail::WeightFolding folding(system, input, keeps_units(*som));
  std::vector<ChannelPlanes> all;
  if (som->input_size() <= kShort && !folding.is_plain()) {
    all.push_back(input_planes(system, input, *som));
  }
  const std::size_t first = all.size();
  for (const detail::FoldingEnd& end : folding.ends()) {
    all.push_back(frame_of(system, end.module));
    if (end.unit) all.back().value_unit = all.back().unit;
    all.back().values = Matrix<double>(som->neurons(), all.back().elements.size());
  }
  for (std::size_t neuron = 0; neuron < som->neurons(); ++neuron) {
    const auto rows = folding.fold(weights_of(*som, neuron));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      std::copy(rows[i].begin(), rows[i].end(), all[first + i].values.row(neuron).begin());
    }
  }
  for (ChannelPlanes& planes : all) group(planes);
  return all;
}

}  // namespace somato
