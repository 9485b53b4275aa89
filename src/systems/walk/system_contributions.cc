#include "somato/graph/system_contributions.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "base/core/threads.h"
#include "somato/graph/answers.h"
#include "systems/model/element_names.h"
#include "systems/model/weight_folding.h"

namespace somato {
namespace {

using detail::Folded;
using detail::FoldedWeights;
using detail::FoldingEnd;
using detail::WeightFolding;

// Whether distances are in the unit of the elements of the map's input.
bool has_unit_of_elements(const Som& som) {
  const SomParameters& p = som.parameters();
  return p.layers.empty() && p.relevances.empty() && p.similarity != Similarity::kDotProduct &&
         p.similarity != Similarity::kCosine && !p.normalize_input.value_or(false);
}

const Source* channel_at(const System& system, std::size_t module) {
  return dynamic_cast<const Source*>(system.modules()[module].module.get());
}

const ChannelLayout* channel_layout(const System& system, const std::string& channel) {
  const auto& channels = system.layout().channels;
  const auto found = std::find_if(channels.begin(), channels.end(),
                                  [&](const ChannelLayout& one) { return one.name == channel; });
  return found == channels.end() ? nullptr : &*found;
}

ContributionSource source_of(const System& system, std::size_t module) {
  const SystemModule& own = system.modules()[module];
  const std::size_t size = own.output.size();
  ContributionSource source{own.name, false, own.output.shape, {}, numbers_as_names(size)};
  for (std::size_t i = 0; i < size; ++i) source.places.push_back(i);
  return source;
}

void add_places(ContributionSource& source, const std::vector<std::size_t>& more) {
  std::set<std::size_t> places(source.places.begin(), source.places.end());
  places.insert(more.begin(), more.end());
  source.places.assign(places.begin(), places.end());
}

void name_elements(ContributionSource& source, const ChannelLayout* channel) {
  source.elements.clear();
  for (const std::size_t place : source.places) {
    const bool is_named = channel && place < channel->element_names.size();
    source.elements.push_back(is_named ? channel->element_names[place] : std::to_string(place + 1));
  }
}

bool two_classes(const NeuronLabels& labels) {
  std::set<std::size_t> classes;
  for (const std::size_t neuron : labels.labelled()) classes.insert(*labels[neuron]);
  return classes.size() > 1;
}

FoldedWeights folded_of(const Som& som, std::vector<double> values) {
  const auto listed = som.elements().listed();
  return {som.input_size(), {listed.begin(), listed.end()}, std::move(values)};
}

}  // namespace

struct ContributionReader::Tracing {
  // Where the projected contributions of an end belong.
  struct End {
    std::size_t source = 0;
    std::vector<std::size_t> elements;  // of the source
  };

  Tracing(std::shared_ptr<const SystemModel> the_model, std::size_t map)
      : model(std::move(the_model)),
        som(*som_of(model->system, map)),
        folding(model->system, model->system.modules()[map].inputs.front(),
                has_unit_of_elements(som), Folded::kContributions) {
    for (const bool channels : {true, false}) {
      for (const FoldingEnd& end : folding.ends()) {
        if ((channel_at(model->system, end.module) != nullptr) == channels) add(end.module);
      }
    }
    for (const FoldingEnd& end : folding.ends()) ends.push_back(end_of(end.module));
    unit = common_unit();
  }

  std::size_t place_of(const std::string& name, bool is_channel) const {
    const auto found = std::find_if(sources.begin(), sources.end(), [&](const auto& source) {
      return source.name == name && source.is_channel == is_channel;
    });
    return static_cast<std::size_t>(found - sources.begin());
  }

  void add(std::size_t module) {
    const System& system = model->system;
    const Source* channel = channel_at(system, module);
    const std::string& name = channel ? channel->channel() : system.modules()[module].name;
    const std::size_t place = place_of(name, channel != nullptr);
    if (!channel) {
      if (place == sources.size()) sources.push_back(source_of(system, module));
      return;
    }
    const ChannelLayout* layout = channel_layout(system, name);
    if (place == sources.size()) {
      const std::vector<std::size_t> flat{channel->channel_elements()};
      sources.push_back({name, true, layout ? layout->shape : flat, {}, {}});
    }
    add_places(sources[place], channel->elements());
    name_elements(sources[place], layout);
  }

  End end_of(std::size_t module) const {
    const Source* channel = channel_at(model->system, module);
    const std::string& name = channel ? channel->channel() : model->system.modules()[module].name;
    End end{place_of(name, channel != nullptr), {}};
    const std::vector<std::size_t>& places = sources[end.source].places;
    for (const std::size_t place : channel ? channel->elements() : places) {
      const auto found = std::lower_bound(places.begin(), places.end(), place);
      end.elements.push_back(static_cast<std::size_t>(found - places.begin()));
    }
    return end;
  }

  std::string common_unit() const {
    std::set<std::string> units;
    for (const FoldingEnd& end : folding.ends()) {
      const Source* channel = channel_at(model->system, end.module);
      const ChannelLayout* layout =
          channel ? channel_layout(model->system, channel->channel()) : nullptr;
      units.insert(end.unit && layout ? layout->unit : std::string());
    }
    return units.size() == 1 ? *units.begin() : std::string();
  }

  std::shared_ptr<const SystemModel> model;
  const Som& som;
  WeightFolding folding;
  std::vector<ContributionSource> sources;
  std::vector<End> ends;
  std::string unit;
};

ContributionReader::ContributionReader(std::shared_ptr<const Tracing> tracing)
    : tracing_(std::move(tracing)) {}

Result<ContributionReader> ContributionReader::build(std::shared_ptr<const SystemModel> model) {
  SOMATO_TRY(const auto map, answering_map(*model));
  if (!two_classes(model->answer->labels)) {
    return fail(ErrorKind::kData,
                "contributions compare two classes, but the neurons of the map have fewer", {},
                "train the system with explorations of two classes or more");
  }
  return ContributionReader(std::make_shared<const Tracing>(std::move(model), map));
}

const std::vector<ContributionSource>& ContributionReader::sources() const {
  return tracing_->sources;
}

const std::string& ContributionReader::unit() const {
  return tracing_->unit;
}

const Som& ContributionReader::som() const {
  return tracing_->som;
}

std::vector<DecidingNeurons> ContributionReader::deciding(const Samples& inputs,
                                                          std::size_t threads) const {
  return deciding_neurons(tracing_->som, tracing_->model->answer->labels, inputs, threads);
}

InputContributions ContributionReader::read(const SignalView& input,
                                            DecidingNeurons neurons) const {
  const NeuronLabels& labels = tracing_->model->answer->labels;
  Contributions of_elements = contributions(tracing_->som, input, neurons);
  InputContributions read{neurons,
                          labels[neurons.nearest].value(),
                          labels[neurons.other].value(),
                          of_elements.of_nearest,
                          of_elements.of_other,
                          {}};
  for (const ContributionSource& source : tracing_->sources) {
    read.values.emplace_back(source.places.size());
  }
  const auto rows = tracing_->folding.fold(folded_of(tracing_->som, std::move(of_elements.values)));
  for (std::size_t end = 0; end < rows.size(); ++end) {
    const Tracing::End& to = tracing_->ends[end];
    for (std::size_t i = 0; i < rows[end].size(); ++i) {
      read.values[to.source][to.elements[i]] += rows[end][i];
    }
  }
  return read;
}

InputContributions ContributionReader::read(const SignalView& input) const {
  SampleCollector one;
  one.add(input);
  return read(input, deciding(one.samples()).front());
}

std::vector<InputContributions> ContributionReader::read(const Samples& inputs,
                                                         std::size_t threads) const {
  const std::vector<DecidingNeurons> all = deciding(inputs, threads);
  std::vector<InputContributions> found(inputs.count());
  for_each_range(inputs.count(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) found[i] = read(inputs[i], all[i]);
  });
  return found;
}

}  // namespace somato
