#include "part_runner.h"

#include <algorithm>
#include <utility>

#include "command_line.h"
#include "data.h"
#include "explore_table.h"
#include "somato/recording/content_hash.h"
#include "study_data.h"
#include "version.h"

namespace somato::program {
namespace {

Error nothing_to_run_on(const ReproductionPart& part) {
  const RecordingFormat format = part.description.recording.format;
  const bool files = format == RecordingFormat::kAutomatic;
  const std::string wanted = files ? "recordings" : "the data set " + choice_name(format);
  return {ErrorKind::kUsage, "this is run on " + wanted + ", and --data holds none",
          part.description.where,
          files ? "give --data a file or a folder of files" : "give --data its folder"};
}

// What a system and a recording have to say of each other, not the machine.
bool is_misfit(const Error& error) {
  return error.kind == ErrorKind::kUsage || error.kind == ErrorKind::kData;
}

void add_explore_settings(const ReproductionPart& part, PartResults& results) {
  const std::vector<Settings> explored = explore_settings(part.explore);
  results.settings.insert(results.settings.end(), explored.begin(), explored.end());
}

}  // namespace

Result<void> read_threads_and_data(const Arguments& arguments, PairsRequest& request) {
  auto threads = read_threads(arguments);
  if (!threads) return fail(std::move(threads.error()));
  request.threads = *threads;
  if (arguments.has("data")) {
    auto given = GivenRecordings::at(arguments.text("data"));
    if (!given) return fail(std::move(given.error()));
    request.given = std::move(*given);
  }
  if (!arguments.has("test-data")) return {};
  auto test = read_study_data(RecordingFormat::kAutomatic, arguments.text("test-data"));
  if (!test) return fail(std::move(test.error()));
  request.test_data = std::move(*test);
  return {};
}

Result<void> check_explorable(const ReproductionPart& part, bool given) {
  if (part.explore.entries.empty()) {
    if (given) return {};
    return fail(ErrorKind::kUsage, "'" + part.system + "' does not say what explores",
                part.description.where, "give --data, or add a table [explore]");
  }
  auto read = read_explore_table(part.explore);
  return read ? Result<void>() : fail(std::move(read.error()));
}

std::vector<std::size_t> PartRunner::given_for(const ReproductionPart& part) const {
  if (!request_.given) return {};
  return request_.given->of_format(part.description.recording.format);
}

std::size_t PartRunner::pairs_for(const ReproductionPart& part) const {
  return std::min(request_.pairs, part.pairs.value_or(request_.pairs));
}

std::size_t PartRunner::recordings_for(const ReproductionPart& part) const {
  const std::size_t most = request_.given ? given_for(part).size() : request_.recordings;
  return std::min(most, pairs_for(part));
}

Result<KeptRecordings::Kept> PartRunner::recording(const ReproductionPart& part,
                                                   std::size_t index) {
  if (request_.given) return request_.given->get(given_for(part)[index]);
  return read_explore_table(part.explore).and_then([&](const ExploreTable& table) {
    return explored_.get(table, index);
  });
}

Result<void> PartRunner::run_on(const PairedRecording& recording, const ReproductionPart& part,
                                std::size_t index, Seeds seeds, const PartEvents& events,
                                PartResults& results) const {
  StudyDescription description = part.description;
  description.study.first_seed = seeds.first;
  description.study.seeds = seeds.count;
  const Recording* test = request_.test_data ? &*request_.test_data
                          : recording.test   ? &*recording.test
                                             : nullptr;
  const StudyOptions options{request_.threads, events.progress(index, recordings_for(part)), test,
                             events.journal(index).string()};
  auto outcome = run_study(description, recording.recording, options);
  if (!outcome) return fail(std::move(outcome.error()));
  if (auto added = add_results(outcome->results, index, results); !added) return added;
  results.recordings.push_back(recording.info.name);
  return events.studied ? events.studied(index, recording, description, *outcome) : Result<void>();
}

Result<PartRun> PartRunner::run(const ReproductionPart& part, const PartEvents& events) {
  PartRun run{{part.question, part.system, part.variation, {}, {}, {}, {}}, {}};
  if (request_.given && given_for(part).empty()) {
    run.misfit = nothing_to_run_on(part);
    return run;
  }
  const std::size_t recordings = recordings_for(part);
  std::uint64_t first_seed = request_.seed;
  for (std::size_t i = 0; i < recordings; ++i) {
    const std::size_t seeds = pairs_of(i, recordings, pairs_for(part));
    const auto kept = recording(part, i);
    if (!kept) return fail(kept.error());
    auto ran = run_on(**kept, part, i, {first_seed, seeds}, events, run.results);
    if (!ran && request_.given && is_misfit(ran.error())) {
      run.misfit = std::move(ran.error());
      return run;
    }
    if (!ran) return fail(std::move(ran.error()));
    first_seed += seeds;
  }
  if (!request_.given) add_explore_settings(part, run.results);
  return run;
}

Result<std::string> PartRunner::recording_identity(const ReproductionPart& part,
                                                   std::size_t index) {
  if (!request_.given) {
    return read_explore_table(part.explore).and_then([&](const ExploreTable& table) {
      return explored_.identity(table, index);
    });
  }
  std::string& hash = given_hashes_[given_for(part)[index]];
  if (hash.empty()) {
    const auto kept = recording(part, index);
    if (!kept) return fail(kept.error());
    hash = (*kept)->info.name + " " + (*kept)->info.data_hash;
  }
  return hash;
}

Result<std::string> PartRunner::identity(const ReproductionPart& part) {
  std::string text =
      std::string(SOMATO_VERSION) + "\n" + parameters_to_toml(part.description.study) +
      parameters_to_toml(part.description.recording) + to_toml(part.description.system) +
      "variation = " + part.variation + "\npairs = " + std::to_string(pairs_for(part)) +
      "\nseed = " + std::to_string(request_.seed) + "\n";
  if (request_.test_data) text += "test_data = " + content_hash(*request_.test_data) + "\n";
  for (std::size_t i = 0; i < recordings_for(part); ++i) {
    const auto recording = recording_identity(part, i);
    if (!recording) return recording;
    text += *recording + "\n";
  }
  return text;
}

}  // namespace somato::program
