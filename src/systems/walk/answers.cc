#include "somato/graph/answers.h"

#include <fmt/format.h>

#include <numeric>
#include <optional>

#include "maps/som/sample_range.h"
#include "somato/graph/evaluation.h"
#include "systems/walk/answer_reader.h"

namespace somato {

bool InputAnswer::is_unknown() const {
  return novelty && somato::is_unknown(*novelty);
}

std::string InputAnswer::name(const std::vector<std::string>& classes) const {
  return is_unknown() ? std::string(kUnknownAnswer) : classes[nearest];
}

InputAnswer answer_to(const SystemModel& model, const SignalView& input) {
  return AnswerReader(model).answer(input);
}

std::vector<InputAnswer> answers_to(const SystemModel& model, const Samples& inputs,
                                    std::size_t threads) {
  return AnswerReader(model).answers(inputs, threads);
}

Result<std::size_t> answering_map(const SystemModel& model) {
  const auto refuse = [](const std::string& what) {
    return fail(ErrorKind::kData, what, {}, "save one with 'somato run'");
  };
  if (!model.answer) return refuse("the system has no output map");
  auto map = model.system.find(model.answer->map);
  if (map && model.system.modules()[*map].output.rate == Rate::kFrame) {
    return refuse("the output map takes one input per frame; it needs one per exploration");
  }
  return map;
}

Result<Samples> inputs_to_answer(const SystemModel& model, const Recording& recording,
                                 std::size_t threads) {
  SOMATO_TRY(const auto map, answering_map(model));
  std::vector<std::size_t> all(recording.explorations.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Activations activations(model.system.modules().size(), all.size());
  const std::size_t input = model.system.modules()[map].inputs.front();
  SOMATO_TRY_VOID(evaluate(model.system, recording, all, {input}, threads, activations));
  SampleCollector inputs;
  for (const std::size_t exploration : all) {
    const SignalView seen = activations.find(input, exploration)->values[0];
    if (!is_in_range(seen)) {
      return fail(ErrorKind::kData,
                  fmt::format("exploration {} has values too large for the map, which computes "
                              "distances in single precision",
                              exploration + 1),
                  recording.explorations[exploration].source, "leave the exploration out");
    }
    inputs.add(seen);
  }
  return inputs.samples();
}

Result<std::vector<InputAnswer>> answers(const SystemModel& model, const Recording& recording,
                                         std::size_t threads) {
  return inputs_to_answer(model, recording, threads).map([&](const Samples& inputs) {
    return answers_to(model, inputs, threads);
  });
}

}  // namespace somato
