#include "somato/studies/study.h"

#include <algorithm>
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

// What the description says of a module, and the defaults of what it does not say.
Settings settings_of(const ModuleDescription& module, const ModuleType& type) {
  Settings settings{"module." + module.name, {}};
  for (const Table::Entry& entry : module.settings.entries) {
    if (const auto* value = std::get_if<Value>(&entry.content)) {
      settings.settings.push_back({entry.name, to_toml(*value)});
    }
  }
  for (const ParameterInfo& parameter : type.parameters) {
    if (module.settings.find(parameter.name)) continue;
    settings.settings.push_back({parameter.name, parameter.default_text});
  }
  return settings;
}

StudyResults describe(const StudyDescription& description, const System& system) {
  StudyResults results;
  results.study = description.study.name;
  results.seeds = description.study.seeds;
  results.settings = {settings_of("study", description.study),
                      settings_of("recording", description.recording)};
  for (std::size_t i = 0; i < system.modules().size(); ++i) {
    results.settings.push_back(
        settings_of(description.system.modules[i], *system.modules()[i].type));
  }
  for (std::size_t i = 0; i < description.system.phases.size(); ++i) {
    results.settings.push_back(
        settings_of("phase." + std::to_string(i + 1), description.system.phases[i]));
  }
  return results;
}

// What decides the trainings: a study with the same text here has the same ones.
std::string fingerprint(const StudyDescription& description, const std::string& data_hash,
                        const std::vector<Protocol>& protocols) {
  std::string text = parameters_to_toml(description.study) + to_toml(description.system) +
                     "data = " + data_hash + "\n";
  for (const Protocol protocol : protocols) text += choice_name(protocol) + "\n";
  return text;
}

// A training on everything that is learned from, for the picture and for use.
Result<void> make_model(const StudyDescription& description, const Question& question,
                        const Progress& progress, StudyOutcome& outcome) {
  const Fold all = folds(Protocol::kTrainIsTest, question.samples).front();
  auto trained = train_fold(description, question, all, description.study.first_seed, progress);
  if (!trained) return fail(std::move(trained.error()));
  outcome.classes = question.classes;
  outcome.classes.of_sample.resize(all.training.size());
  outcome.model.system = std::move(trained->system);
  const System& system = outcome.model.system;
  const Som& som = *som_of(system, question.map);
  outcome.winners = winners_of(som, trained->inputs, 1);
  outcome.model.answer = SystemAnswer{
      system.modules()[question.map].name, description.study.label, outcome.classes.names,
      NeuronLabels::by_majority(outcome.winners, outcome.classes.of_sample, som.neurons())};
  return {};
}

std::vector<Protocol> protocols_of(const StudyDescription& description, const Question& question) {
  std::vector<Protocol> protocols = description.study.protocols;
  if (question.samples.test_samples > 0) protocols.push_back(Protocol::kTestData);
  return protocols;
}

Result<Journal> open_journal(const StudyOptions& options, const StudyDescription& description,
                             const std::string& data_hash, const std::vector<Protocol>& protocols) {
  if (options.journal.empty()) return Journal();
  return Journal::open(options.journal, fingerprint(description, data_hash, protocols));
}

}  // namespace

const Som& StudyOutcome::map() const {
  return *som_of(model.system, *model.system.find(model.answer->map));
}

Result<StudyOutcome> run_study(const StudyDescription& description, const Recording& recording,
                               const StudyOptions& options) {
  auto question = make_question(description, recording, options.test_data, options.threads);
  if (!question) return fail(std::move(question.error()));
  const auto whole = question->system(description);
  if (!whole) return fail(whole.error());
  StudyOutcome outcome{describe(description, *whole), {}, {}, {}};
  outcome.results.data_hash = content_hash(question->recording);
  const std::vector<Protocol> protocols = protocols_of(description, *question);
  auto journal = open_journal(options, description, outcome.results.data_hash, protocols);
  if (!journal) return fail(std::move(journal.error()));

  std::deque<SystemRunner> runners;
  std::uint64_t trainings = 1;
  for (const Protocol protocol : protocols) {
    runners.emplace_back(description, *question, protocol, runners.size());
    trainings += runners.back().trainings();
  }
  Tally tally(options.progress, trainings);
  auto made = make_model(
      description, *question, [&](std::uint64_t, std::uint64_t) { return tally.goes_on(); },
      outcome);
  if (!made) return fail(std::move(made.error()));
  tally.one_done();
  for (SystemRunner& runner : runners) {
    for_each_task(runner.trainings(), options.threads,
                  [&](std::size_t training) { runner.run(training, *journal, tally); });
    if (tally.stopped()) return fail(tally.error());
    outcome.results.systems.push_back(runner.results());
  }
  return outcome;
}

}  // namespace somato
