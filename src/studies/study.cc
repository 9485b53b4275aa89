#include "somato/studies/study.h"

#include <deque>
#include <utility>

#include "somato/core/threads.h"
#include "somato/maps/som_training.h"
#include "somato/recording/content_hash.h"
#include "studies/question.h"
#include "studies/system_runner.h"

namespace somato {
namespace {

template <typename Parameters>
Settings settings_of(std::string part, const Parameters& parameters) {
  Settings settings{std::move(part), {}};
  for (const auto& parameter : Parameters::declarations().all()) {
    settings.settings.push_back({parameter.info.name, to_toml(parameter.read(parameters))});
  }
  return settings;
}

StudyResults describe(const StudyDescription& description, const Recording& recording) {
  StudyResults results;
  results.study = description.study.name;
  results.seeds = description.study.seeds;
  results.settings = {
      settings_of("study", description.study), settings_of("recording", description.recording),
      settings_of("vector", description.vector), settings_of("map", description.map)};
  results.data_hash = content_hash(recording);
  return results;
}

Result<void> make_map(const StudyDescription& description, const Question& question,
                      StudyOutcome& outcome) {
  auto folds = prepare_folds(question, description.vector, Protocol::kTrainIsTest);
  if (!folds) return fail(std::move(folds.error()));
  SomParameters parameters = description.map;
  parameters.seed = description.study.first_seed;
  auto som = train_som(parameters, folds->front().samples);
  if (!som) return fail(std::move(som.error()));
  outcome.map = std::move(*som);
  outcome.winners = winners_of(outcome.map, folds->front().samples, 1);
  outcome.classes = question.classes;
  return {};
}

}  // namespace

Result<StudyOutcome> run_study(const StudyDescription& given, const Recording& recording,
                               const StudyOptions& options) {
  auto question = make_question(given, recording);
  if (!question) return fail(std::move(question.error()));
  // Decided once on all samples, so that every fold is trained alike.
  StudyDescription description = given;
  const Samples& samples = question->vectors.samples;
  auto map = resolve(given.map, samples.count(), samples.size());
  if (!map) return fail(std::move(map.error()));
  description.map = *map;
  StudyOutcome outcome;
  if (auto made = make_map(description, *question, outcome); !made) {
    return fail(std::move(made.error()));
  }
  std::deque<SystemRunner> runners;
  std::uint64_t trainings = 0;
  for (const Protocol protocol : description.study.protocols) {
    auto folds = prepare_folds(*question, description.vector, protocol);
    if (!folds) return fail(std::move(folds.error()));
    runners.emplace_back(description, *question, protocol, std::move(*folds));
    trainings += runners.back().trainings();
  }
  outcome.results = describe(description, recording);
  Tally tally(options.progress, trainings);
  for (SystemRunner& runner : runners) {
    for_each_task(runner.trainings(), options.threads,
                  [&](std::size_t training) { runner.run(training, tally); });
    if (tally.stopped()) return fail(tally.error());
    outcome.results.systems.push_back(runner.results());
  }
  return outcome;
}

}  // namespace somato
