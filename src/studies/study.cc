#include "somato/studies/study.h"

#include <algorithm>
#include <deque>
#include <utility>

#include "core/threads.h"
#include "recording/content_hash.h"
#include "studies/prepared_study.h"
#include "studies/settings.h"
#include "studies/system_runner.h"

namespace somato {
namespace {

// A text that identifies the trainings: studies with the same text have the same trainings. More
// seeds add trainings.
std::string fingerprint(const StudyDescription& description, const PartResults& results,
                        const std::vector<ProtocolPart>& parts) {
  StudyParameters study = description.study;
  study.seeds = 1;
  std::string text =
      parameters_to_toml(study) + to_toml(description.altered) + to_toml(description.system);
  for (const RecordingInfo& one : results.recordings) text += "data = " + one.hash + "\n";
  for (const RecordingInfo& one : results.test_recordings) text += "test_data = " + one.hash + "\n";
  for (const ProtocolPart& part : parts) {
    text += choice_name(part.protocol) + " " + part.group + "\n";
  }
  return text;
}

// The classes of the training samples only: others have no neurons.
Classes learned_classes(const PreparedStudy& prepared) {
  Classes classes = prepared.classes();
  classes.of_sample.resize(prepared.samples.samples);
  const auto last = std::max_element(classes.of_sample.begin(), classes.of_sample.end());
  classes.names.resize(*last + 1);
  return classes;
}

StudyOutcome outcome_of(const StudyDescription& description, const PreparedStudy& prepared,
                        TrainedFold trained, std::vector<std::size_t> winners,
                        PartResults results) {
  StudyOutcome outcome{std::move(results), {std::move(trained.system), {}}, {}, {}};
  const System& system = outcome.model.system;
  const Som& som = *som_of(system, prepared.map);
  outcome.classes = learned_classes(prepared);
  outcome.winners = std::move(winners);
  outcome.model.answer = SystemAnswer{
      system.modules()[prepared.map].name, description.study.label, outcome.classes.names,
      NeuronLabels::by_majority(outcome.winners, outcome.classes.of_sample, som.neurons())};
  outcome.results.parameters = study_settings(description, system);
  return outcome;
}

// The caller adds names and sources of the recordings.
PartResults results_for(const StudyDescription& description, const Recording& recording,
                        const Recording* test_data) {
  const auto info = [](const Recording& one) {
    return RecordingInfo{{}, {}, 0, content_hash(one), one.explorations.size()};
  };
  PartResults results;
  results.system = description.study.name;
  results.study = description.text.empty() ? to_toml(description) : description.text;
  results.recordings = {info(recording)};
  if (test_data) results.test_recordings = {info(*test_data)};
  for (std::size_t i = 0; i < description.study.seeds; ++i) {
    results.pairs.push_back({0, description.study.first_seed + i});
  }
  return results;
}

std::vector<ProtocolPart> parts_of(const StudyDescription& description,
                                   const PreparedStudy& prepared) {
  std::vector<ProtocolPart> parts;
  for (const Protocol protocol : description.study.protocols) {
    if (protocol != Protocol::kLeaveGroupOut) {
      parts.push_back({protocol, {}});
      continue;
    }
    for (const std::string& group : description.study.groups) parts.push_back({protocol, group});
  }
  if (prepared.samples.test_samples > 0) parts.push_back({Protocol::kTestData, {}});
  return parts;
}

}  // namespace

const Som& StudyOutcome::map() const {
  return *som_of(model.system, *model.system.find(model.answer->map));
}

Result<StudyOutcome> run_study(const StudyDescription& description, const Recording& recording,
                               const StudyOptions& options) {
  SOMATO_TRY(auto prepared,
             prepare_study(description, recording, options.test_data, options.threads));
  PartResults results = results_for(description, recording, options.test_data);
  const std::vector<ProtocolPart> parts = parts_of(description, prepared);
  Result<Journal> journal;
  if (!options.journal.empty()) {
    journal = Journal::open(options.journal, fingerprint(description, results, parts));
  }
  if (!journal) return fail(std::move(journal.error()));

  std::deque<SystemRunner> runners;
  std::uint64_t trainings = 1;
  for (const ProtocolPart& part : parts) {
    runners.emplace_back(description, prepared, part, runners.size());
    trainings += runners.back().trainings() - runners.back().known(*journal);
  }
  Tally tally(options.progress, trainings);
  for (SystemRunner& runner : runners) {
    for_each_task(runner.trainings(), options.threads,
                  [&](std::size_t training) { runner.run(training, *journal, tally); });
    if (tally.stopped()) return fail(tally.error());
  }
  // On everything, for the picture and for use; last, since the journal does not keep it.
  const Fold all = folds(Protocol::kTrainIsTest, prepared.samples).front();
  auto trained = train_fold(description, prepared, all, description.study.first_seed,
                            [&](std::uint64_t, std::uint64_t) { return tally.should_continue(); });
  if (!trained) {
    tally.failed(std::move(trained.error()));
    return fail(tally.error());
  }
  FoldOutcome tested = test_fold(*trained, prepared, all, {});
  for (SystemRunner& runner : runners) {
    runner.take(*trained, tested);
    results.protocols.push_back(runner.results());
  }
  tally.one_done();
  return outcome_of(description, prepared, std::move(*trained), std::move(tested.training_winners),
                    std::move(results));
}

}  // namespace somato
