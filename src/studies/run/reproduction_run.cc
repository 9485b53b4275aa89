#include "studies/run/reproduction_run.h"

#include <algorithm>
#include <utility>

#include "somato/studies/reproduction.h"

namespace somato {
namespace {

// The text generated for the results does not contain a table [explore] yet.
void add_exploring(const ReproductionPart& part, PartResults& results) {
  for (Settings& settings : explore_settings(part.explore)) {
    if (part.description.text.empty()) results.study += to_toml(settings);
    results.parameters.push_back(std::move(settings));
  }
}

PartRun begun(const ReproductionPart& part) {
  PartRun run;
  run.results.question = part.question;
  run.results.system = part.system;
  run.results.variation = part.variation;
  return run;
}

}  // namespace

std::size_t PartRunner::pairs_for(const ReproductionPart& part) const {
  return std::min(options_.pairs, part.pairs.value_or(options_.pairs));
}

Result<std::size_t> PartRunner::recordings_for(const ReproductionPart& part) const {
  return recordings_.count(part).map(
      [&](std::size_t count) { return std::min(count, pairs_for(part)); });
}

// Errors of the system and the recording, not of the machine.
bool PartRunner::is_misfit(const Error& error) const {
  return recordings_.is_given() &&
         (error.kind == ErrorKind::kUsage || error.kind == ErrorKind::kData);
}

const PairedRecording* PartRunner::test_of(const PairedRecording& recording) const {
  return options_.test_data ? options_.test_data.get() : recording.test.get();
}

Result<std::optional<Error>> PartRunner::for_each_study(const ReproductionPart& part,
                                                        const PartEvents& events,
                                                        const RunStudy& run) {
  const auto count = recordings_for(part);
  if (!count) return count.error();
  StudyDescription description = part.description;
  description.study.first_seed = options_.seed;
  for (std::size_t i = 0; i < *count; ++i) {
    description.study.seeds = pairs_of(i, *count, pairs_for(part));
    SOMATO_TRY(const auto recording, recordings_.get(part, i));
    const PairedRecording* const test = test_of(*recording);
    const StudyOptions options{options_.threads,
                               events.progress(i, *count),
                               test ? &test->recording : nullptr,
                               events.journal(i),
                               events.parts,
                               options_.compare_folds};
    auto ran = run(description, *recording, options);
    if (!ran && is_misfit(ran.error())) return std::move(ran.error());
    if (!ran) return fail(std::move(ran.error()));
    description.study.first_seed += description.study.seeds;
  }
  return std::optional<Error>{};
}

Result<PartRun> PartRunner::run(const ReproductionPart& part, const PartEvents& events) {
  PartRun run = begun(part);
  const auto run_one = [&](const StudyDescription& description, const PairedRecording& recording,
                           const StudyOptions& options) -> Result<void> {
    SOMATO_TRY(auto outcome, run_study(description, recording.recording, options));
    const std::size_t index = run.results.recordings.size();
    outcome.results.recordings = {recording.info};
    if (const PairedRecording* test = test_of(recording)) {
      outcome.results.test_recordings = {test->info};
    }
    SOMATO_TRY_VOID(add_results(outcome.results, run.results));
    return events.studied ? events.studied(index, description, outcome, run.results)
                          : Result<void>();
  };
  SOMATO_TRY(run.misfit, for_each_study(part, events, run_one));
  if (!run.misfit && !recordings_.is_given()) add_exploring(part, run.results);
  return run;
}

Result<StudyProgress> PartRunner::run_part(const ReproductionPart& part, const StudyPart& share,
                                           const PartEvents& events) {
  StudyProgress sum;
  const auto run_one = [&](const StudyDescription& description, const PairedRecording& recording,
                           const StudyOptions& options) -> Result<void> {
    SOMATO_TRY(const auto progress,
               run_part_of_study(description, recording.recording, options, share));
    sum.done += progress.done;
    sum.trainings += progress.trainings;
    return {};
  };
  return for_each_study(part, events, run_one).map([&](const auto&) { return sum; });
}

Result<std::string> PartRunner::identity(const ReproductionPart& part) {
  std::string text =
      parameters_to_toml(part.description.study) + parameters_to_toml(part.description.recording) +
      to_toml(part.description.altered) + to_toml(part.description.system) +
      "variation = " + part.variation + "\npairs = " + std::to_string(pairs_for(part)) +
      "\nseed = " + std::to_string(options_.seed) + "\n";
  if (options_.test_data) text += "test_data = " + options_.test_data->info.hash + "\n";
  const auto count = recordings_for(part);
  for (std::size_t i = 0; i < count.value_or(0); ++i) {
    const auto recording = recordings_.identity(part, i);
    if (!recording) return recording;
    text += *recording + "\n";
  }
  return text;
}

std::string title_of(const ReproductionPart& part) {
  std::string title = part.question.empty() ? part.system : part.question + ": " + part.system;
  if (!part.variation.empty()) title += ", " + part.variation;
  return title;
}

Result<Results> run_reproduction(const ReproductionPlan& plan, PartRunner& runner,
                                 bool pass_over_misfits,
                                 const std::function<PartEvents(std::size_t part)>& events) {
  Results results;
  for (std::size_t i = 0; i < plan.parts.size(); ++i) {
    SOMATO_TRY(auto ran, runner.run(plan.parts[i], events(i)));
    if (!ran.misfit) {
      results.parts.push_back(std::move(ran.results));
    } else if (pass_over_misfits) {
      results.not_applicable.push_back({title_of(plan.parts[i]), to_string(*ran.misfit)});
    } else {
      return fail(std::move(*ran.misfit));
    }
  }
  results.claims = judge(plan.claims, results.parts);
  return results;
}

Result<StudyProgress> run_part_of_reproduction(
    const ReproductionPlan& plan, PartRunner& runner, const StudyPart& share,
    const std::function<PartEvents(std::size_t part)>& events) {
  StudyProgress sum;
  for (std::size_t i = 0; i < plan.parts.size(); ++i) {
    SOMATO_TRY(const auto progress, runner.run_part(plan.parts[i], share, events(i)));
    sum.done += progress.done;
    sum.trainings += progress.trainings;
  }
  return sum;
}

}  // namespace somato
