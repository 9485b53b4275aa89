#include "somato/studies/study.h"

#include <algorithm>
#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "base/core/threads.h"
#include "recordings/explorations/content_hash.h"
#include "studies/folds/prepared_study.h"
#include "studies/lifelong/novelty_run.h"
#include "studies/results/fold_comparison.h"
#include "studies/results/settings.h"
#include "studies/run/journal.h"
#include "studies/run/system_runner.h"

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

// The threshold of the system that is returned, with the classes of the training samples only.
Result<std::optional<Novelty>> novelty_of(const StudyDescription& description,
                                          const PreparedStudy& prepared, const TrainedFold& trained,
                                          const Fold& all, const Progress& progress) {
  if (!description.study.unknown) return std::optional<Novelty>{};
  SOMATO_TRY(auto novelty, find_novelty(description, prepared, trained, all.training,
                                        description.study.first_seed, progress));
  novelty.scales.resize(learned_classes(prepared).names.size());
  return std::optional(std::move(novelty));
}

StudyOutcome outcome_of(const StudyDescription& description, const PreparedStudy& prepared,
                        TrainedFold trained, std::vector<std::size_t> winners,
                        std::optional<Novelty> novelty, PartResults results) {
  StudyOutcome outcome{std::move(results), {std::move(trained.system), {}}, {}, {}};
  const System& system = outcome.model.system;
  outcome.classes = learned_classes(prepared);
  outcome.winners = std::move(winners);
  outcome.model.answer =
      answer_of(system, prepared.map, description.study.label, outcome.classes.names,
                outcome.winners, outcome.classes.of_sample, std::move(novelty));
  // Other data may have another format.
  outcome.model.recording = description.recording;
  outcome.model.recording.format = RecordingFormat::kAutomatic;
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

// Whether its folds are chosen, and tested samples can be named.
bool chooses_folds(Protocol protocol, const StudyParameters& study) {
  return study.test_last == 0 &&
         (protocol == Protocol::kFolds || protocol == Protocol::kObjectAfterObject);
}

// The trainings of all protocols, numbered one protocol after the other, then those that compare
// the fold choices.
class Trainings {
 public:
  // Both must outlive it.
  Trainings(const StudyDescription& description, const PreparedStudy& prepared,
            const std::vector<ProtocolPart>& parts, bool compare_folds)
      : choice_(prepared.samples.choice) {
    add_protocols(description, prepared, parts);
    if (!compare_folds) return;
    FoldSamples blocks = prepared.samples;
    blocks.choice = FoldChoice::kBlocks;
    for (std::size_t i = 0; i < protocols_; ++i) {
      if (!chooses_folds(parts[i].protocol, description.study)) continue;
      comparisons_[i] = {};
      largest_block_ = largest_block(blocks);
      if (largest_block_ < 2) continue;
      comparisons_[i] = runners_.size();
      add(description, prepared, parts[i], OtherFolds{other_choice(choice_)});
    }
  }

  std::size_t count() const { return count_; }
  std::size_t known(const Journal& journal) const {
    std::size_t known = 0;
    for (const SystemRunner& runner : runners_) known += runner.known(journal);
    return known;
  }

  std::vector<std::size_t> missing(const Journal& journal, const StudyPart& part) const {
    std::vector<std::size_t> missing;
    std::size_t number = 0;
    for (const SystemRunner& runner : runners_) {
      for (std::size_t i = 0; i < runner.trainings(); ++i, ++number) {
        const bool own = number % part.of == part.number - 1;
        if (own && !runner.is_known(i, journal)) missing.push_back(number);
      }
    }
    return missing;
  }

  // From any thread.
  void run(std::size_t number, Journal& journal, Tally& tally) {
    auto runner = runners_.begin();
    for (; number >= runner->trainings(); ++runner) number -= runner->trainings();
    runner->run(number, journal, tally);
  }

  // After all trainings; `trained` is on all samples with the first seed, tested without a
  // baseline.
  std::vector<ProtocolResults> results(const TrainedFold& trained, const FoldOutcome& tested) {
    std::vector<ProtocolResults> all;
    for (std::size_t i = 0; i < protocols_; ++i) {
      runners_[i].take(trained, tested);
      all.push_back(runners_[i].results());
      const auto found = comparisons_.find(i);
      if (found != comparisons_.end()) all.back().fold_comparison = comparison(i, found->second);
    }
    return all;
  }

 private:
  void add_protocols(const StudyDescription& description, const PreparedStudy& prepared,
                     const std::vector<ProtocolPart>& parts) {
    for (const ProtocolPart& part : parts) add(description, prepared, part, {});
    protocols_ = runners_.size();
  }

  void add(const StudyDescription& description, const PreparedStudy& prepared,
           const ProtocolPart& part, const std::optional<OtherFolds>& other) {
    runners_.emplace_back(description, prepared, part, runners_.size(), other);
    count_ += runners_.back().trainings();
  }

  FoldComparison comparison(std::size_t own, std::optional<std::size_t> other) const {
    FoldComparison comparison{choice_name(choice_), choice_name(other_choice(choice_)),
                              largest_block_};
    if (!other) return comparison;
    const auto mine = runners_[own].first_named();
    count_right(mine.labels, mine.named, runners_[*other].first_named().named, comparison);
    return comparison;
  }

  FoldChoice choice_;
  std::deque<SystemRunner> runners_;
  std::size_t protocols_ = 0;  // the first runners
  // The runner by the other choice for each protocol that chooses folds; none if every block is a
  // single exploration.
  std::map<std::size_t, std::optional<std::size_t>> comparisons_;
  std::size_t largest_block_ = 0;
  std::size_t count_ = 0;
};

}  // namespace

std::string StudyPart::folder_name() const {
  return std::to_string(number) + "-of-" + std::to_string(of);
}

const Som& StudyOutcome::map() const {
  return *som_of(model.system, *model.system.find(model.answer->map));
}

Result<StudyOutcome> run_study(const StudyDescription& description, const Recording& recording,
                               const StudyOptions& options) {
  SOMATO_TRY(auto prepared,
             prepare_study(description, recording, options.test_data, options.threads));
  PartResults results = results_for(description, recording, options.test_data);
  const std::vector<ProtocolPart> parts = parts_of(description, prepared);
  const std::string study = fingerprint(description, results, parts);
  Result<Journal> journal;
  if (!options.journal.empty()) journal = Journal::open(options.journal, study);
  if (!journal) return fail(std::move(journal.error()));
  if (!options.parts.empty()) journal->look(options.parts, study);

  Trainings trainings(description, prepared, parts, options.compare_folds);
  Tally tally("the study", options.progress, trainings.count() - trainings.known(*journal) + 1);
  for_each_task(trainings.count(), options.threads,
                [&](std::size_t number) { trainings.run(number, *journal, tally); });
  if (tally.stopped()) return fail(tally.error());
  // On everything, for the picture and for use; last, since the journal does not keep it.
  const Fold all = folds(Protocol::kTrainIsTest, prepared.samples).front();
  const Progress progress = [&](std::uint64_t, std::uint64_t) { return tally.should_continue(); };
  auto trained = train_fold(description, prepared, all, description.study.first_seed, progress);
  auto novelty = trained.and_then([&](const TrainedFold& fold) {
    return novelty_of(description, prepared, fold, all, progress);
  });
  if (!novelty) {
    tally.failed(std::move(novelty.error()));
    return fail(tally.error());
  }
  FoldOutcome tested = test_fold(*trained, prepared, all, {});
  results.protocols = trainings.results(*trained, tested);
  tally.one_done();
  return outcome_of(description, prepared, std::move(*trained), std::move(tested.training_winners),
                    std::move(*novelty), std::move(results));
}

Result<StudyProgress> run_part_of_study(const StudyDescription& description,
                                        const Recording& recording, const StudyOptions& options,
                                        const StudyPart& part) {
  SOMATO_TRY(auto prepared,
             prepare_study(description, recording, options.test_data, options.threads));
  const std::vector<ProtocolPart> parts = parts_of(description, prepared);
  const std::string study =
      fingerprint(description, results_for(description, recording, options.test_data), parts);
  const std::filesystem::path folder = options.parts;
  SOMATO_TRY(auto journal, Journal::open_part(folder / part.folder_name(), study));
  journal.look(folder, study);

  Trainings trainings(description, prepared, parts, options.compare_folds);
  const std::vector<std::size_t> missing = trainings.missing(journal, part);
  Tally tally("the study", options.progress, missing.size());
  for_each_task(missing.size(), options.threads,
                [&](std::size_t i) { trainings.run(missing[i], journal, tally); });
  if (tally.stopped()) return fail(tally.error());
  journal.look(folder, study);  // other parts may have ended meanwhile
  return StudyProgress{trainings.known(journal), trainings.count()};
}

}  // namespace somato
