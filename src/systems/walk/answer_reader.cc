#include "systems/walk/answer_reader.h"

#include <algorithm>
#include <tuple>

#include "base/core/threads.h"
#include "maps/reading/sample_reader.h"
#include "somato/core/check.h"

namespace somato {
namespace {

const SystemAnswer& answer_in(const SystemModel& model) {
  require(model.answer.has_value(), "a model without an answer cannot answer");
  return *model.answer;
}

std::vector<std::vector<std::size_t>> neurons_by_class(const SystemAnswer& answer) {
  std::vector<std::vector<std::size_t>> neurons(answer.classes.size());
  for (const std::size_t neuron : answer.labels.labelled()) {
    neurons[*answer.labels[neuron]].push_back(neuron);
  }
  return neurons;
}

}  // namespace

AnswerReader::AnswerReader(const SystemModel& model)
    : answer_(answer_in(model)),
      som_(*som_of(model.system, *model.system.find(answer_.map))),
      neurons_of_class_(neurons_by_class(answer_)) {
  const bool has_names = !answer_.labels.labelled().empty();
  if (answer_.novelty && has_names) novelty_.emplace(*answer_.novelty, som_, answer_.labels);
}

InputAnswer AnswerReader::answer(const SignalView& input, std::size_t winner,
                                 double winner_distance, std::size_t named,
                                 SomWorkspace& workspace) const {
  const NearestOfClass nearest{*answer_.labels[named], som_.distance(input, named, workspace),
                               named};
  return {winner, winner_distance, nearest.number, nearest.distance, novelty(input, nearest)};
}

InputAnswer AnswerReader::answer(const SignalView& input) const {
  SomWorkspace workspace;
  return answer(input, workspace);
}

InputAnswer AnswerReader::answer(const SignalView& input, SomWorkspace& workspace) const {
  const std::vector<std::size_t>& labelled = answer_.labels.labelled();
  require(!labelled.empty(), "an answer needs a neuron with a name");
  const std::size_t winner = som_.winner(input, workspace);
  const std::size_t named = som_.winner_among(labelled, input, workspace);
  return answer(input, winner, som_.distance(input, winner, workspace), named, workspace);
}

std::vector<InputAnswer> AnswerReader::answers(const Samples& inputs, std::size_t threads) const {
  require(!answer_.labels.labelled().empty(), "an answer needs a neuron with a name");
  if (inputs.count() == 0) return {};
  const SampleReadings readings =
      SampleReader(som_, threads, answer_.labels.labelled()).read(inputs, {false, true});
  std::vector<InputAnswer> given(inputs.count());
  for_each_range(inputs.count(), threads, [&](std::size_t begin, std::size_t end) {
    SomWorkspace workspace;
    for (std::size_t i = begin; i < end; ++i) {
      given[i] = answer(inputs[i], readings.winners[i].first, readings.distances[i],
                        readings.nearest[i], workspace);
    }
  });
  return given;
}

std::vector<NearestOfClass> AnswerReader::classes(const SignalView& input) const {
  if (answer_.labels.labelled().empty()) return {};
  SomWorkspace workspace;
  const std::size_t first = answer_.labels.classify(som_, input, workspace);
  std::vector<NearestOfClass> classes;
  for (std::size_t number = 0; number < neurons_of_class_.size(); ++number) {
    if (neurons_of_class_[number].empty()) continue;
    const std::size_t nearest = som_.winner_among(neurons_of_class_[number], input, workspace);
    classes.push_back({number, som_.distance(input, nearest, workspace), nearest});
  }
  std::ranges::sort(classes, {}, [&](const NearestOfClass& one) {
    return std::tuple(one.number != first, one.distance, one.number);
  });
  return classes;
}

std::optional<double> AnswerReader::novelty(const SignalView& input,
                                            const NearestOfClass& nearest) const {
  if (!novelty_) return {};
  return novelty_->of(input, nearest.number, nearest.distance);
}

}  // namespace somato
