#include "somato/studies/study.h"

#include <algorithm>
#include <deque>
#include <utility>

#include "somato/core/threads.h"
#include "somato/recording/content_hash.h"
#include "studies/question.h"
#include "studies/settings.h"
#include "studies/system_runner.h"

namespace somato {
namespace {

// What decides the trainings: a study with the same text here has the same ones. More seeds have
// more of them.
std::string fingerprint(const StudyDescription& description, const StudyResults& results,
                        const std::vector<ProtocolPart>& parts) {
  StudyParameters study = description.study;
  study.seeds = 1;
  std::string text = parameters_to_toml(study) + to_toml(description.system) +
                     "data = " + results.data_hash + "\ntest_data = " + results.test_data_hash +
                     "\n";
  for (const ProtocolPart& part : parts) {
    text += choice_name(part.protocol) + " " + part.group + "\n";
  }
  return text;
}

// The classes of what was learned from alone: others have no neurons.
Classes learned_classes(const Question& question) {
  Classes classes = question.classes();
  classes.of_sample.resize(question.samples.samples);
  const auto last = std::max_element(classes.of_sample.begin(), classes.of_sample.end());
  classes.names.resize(*last + 1);
  return classes;
}

StudyOutcome outcome_of(const StudyDescription& description, const Question& question,
                        TrainedFold trained, std::vector<std::size_t> winners,
                        StudyResults results) {
  form_map(trained, question);
  StudyOutcome outcome{std::move(results), {std::move(trained.system), {}}, {}, {}};
  const System& system = outcome.model.system;
  const Som& som = *som_of(system, question.map);
  outcome.classes = learned_classes(question);
  outcome.winners = std::move(winners);
  outcome.model.answer = SystemAnswer{
      system.modules()[question.map].name, description.study.label, outcome.classes.names,
      NeuronLabels::by_majority(outcome.winners, outcome.classes.of_sample, som.neurons())};
  outcome.results.settings = study_settings(description, system);
  return outcome;
}

std::vector<ProtocolPart> parts_of(const StudyDescription& description, const Question& question) {
  std::vector<ProtocolPart> parts;
  for (const Protocol protocol : description.study.protocols) {
    if (protocol != Protocol::kLeaveGroupOut) {
      parts.push_back({protocol, {}});
      continue;
    }
    for (const std::string& group : description.study.groups) parts.push_back({protocol, group});
  }
  if (question.samples.test_samples > 0) parts.push_back({Protocol::kTestData, {}});
  return parts;
}

}  // namespace

const Som& StudyOutcome::map() const {
  return *som_of(model.system, *model.system.find(model.answer->map));
}

Result<StudyOutcome> run_study(const StudyDescription& description, const Recording& recording,
                               const StudyOptions& options) {
  auto question = make_question(description, recording, options.test_data, options.threads);
  if (!question) return fail(std::move(question.error()));
  StudyResults results{description.study.name, description.study.seeds, {}, {}, {}, {}};
  results.data_hash = content_hash(recording);
  if (options.test_data) results.test_data_hash = content_hash(*options.test_data);
  const std::vector<ProtocolPart> parts = parts_of(description, *question);
  Result<Journal> journal;
  if (!options.journal.empty()) {
    journal = Journal::open(options.journal, fingerprint(description, results, parts));
  }
  if (!journal) return fail(std::move(journal.error()));

  std::deque<SystemRunner> runners;
  std::uint64_t trainings = 1;
  for (const ProtocolPart& part : parts) {
    runners.emplace_back(description, *question, part, runners.size());
    trainings += runners.back().trainings() - runners.back().known(*journal);
  }
  Tally tally(options.progress, trainings);
  for (SystemRunner& runner : runners) {
    for_each_task(runner.trainings(), options.threads,
                  [&](std::size_t training) { runner.run(training, *journal, tally); });
    if (tally.stopped()) return fail(tally.error());
  }
  // On everything, for the picture and for use; last, since the journal does not keep it.
  const Fold all = folds(Protocol::kTrainIsTest, question->samples).front();
  auto trained = train_fold(description, *question, all, description.study.first_seed,
                            [&](std::uint64_t, std::uint64_t) { return tally.goes_on(); });
  if (!trained) {
    tally.failed(std::move(trained.error()));
    return fail(tally.error());
  }
  FoldOutcome tested = test_fold(*trained, *question, all, {});
  for (SystemRunner& runner : runners) {
    runner.take(*trained, tested);
    results.systems.push_back(runner.results());
  }
  tally.one_done();
  return outcome_of(description, *question, std::move(*trained), std::move(tested.training_winners),
                    std::move(results));
}

}  // namespace somato
