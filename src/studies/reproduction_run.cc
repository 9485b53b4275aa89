#include "studies/reproduction_run.h"

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

Result<void> PartRunner::run_on(const PairedRecording& recording, const ReproductionPart& part,
                                Seeds seeds, const StudyOptions& options, const PartEvents& events,
                                PartResults& results) const {
  StudyDescription description = part.description;
  description.study.first_seed = seeds.first;
  description.study.seeds = seeds.count;
  const PairedRecording* test =
      options_.test_data ? options_.test_data.get() : recording.test.get();
  StudyOptions with_test = options;
  if (test) with_test.test_data = &test->recording;
  SOMATO_TRY(auto outcome, run_study(description, recording.recording, with_test));
  const std::size_t index = results.recordings.size();
  outcome.results.recordings = {recording.info};
  if (test) outcome.results.test_recordings = {test->info};
  SOMATO_TRY_VOID(add_results(outcome.results, results));
  return events.studied ? events.studied(index, description, outcome, results) : Result<void>();
}

Result<PartRun> PartRunner::run(const ReproductionPart& part, const PartEvents& events) {
  PartRun run = begun(part);
  const auto count = recordings_for(part);
  if (!count) {
    run.misfit = count.error();
    return run;
  }
  std::uint64_t first_seed = options_.seed;
  for (std::size_t i = 0; i < *count; ++i) {
    const std::size_t seeds = pairs_of(i, *count, pairs_for(part));
    SOMATO_TRY(const auto recording, recordings_.get(part, i));
    const StudyOptions options{options_.threads, events.progress(i, *count), nullptr,
                               events.journal(i)};
    auto ran = run_on(*recording, part, {first_seed, seeds}, options, events, run.results);
    if (!ran && is_misfit(ran.error())) {
      run.misfit = std::move(ran.error());
      return run;
    }
    if (!ran) return fail(std::move(ran.error()));
    first_seed += seeds;
  }
  if (!recordings_.is_given()) add_exploring(part, run.results);
  return run;
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

}  // namespace somato
