#include "reproduce/part_recordings.h"

#include <utility>

#include "explore/explore_table.h"
#include "flags/command_line.h"
#include "recordings/study_data.h"
#include "som/data.h"

namespace somato::program {
namespace {

Error nothing_to_run_on(const ReproductionPart& part) {
  const RecordingFormat format = part.description.recording.format;
  const bool files = format == RecordingFormat::kAutomatic;
  const std::string wanted = files ? "recordings" : "the data set " + choice_name(format);
  return {ErrorKind::kUsage, "the system needs " + wanted + ", and --data contains none",
          part.description.where,
          files ? "use --data with a file or a folder of files" : "use --data with its folder"};
}

}  // namespace

Flag given_recordings_flag() {
  return input_flag("--data",
                    "Recordings to use instead of exploring: a file, a folder of files, a data "
                    "set, or a folder of data sets");
}

Flag test_recording_flag() {
  return input_flag("--test-data", "Separate test recording, used for every training recording");
}

Result<void> read_threads_and_data(const Arguments& arguments, PairsRequest& request) {
  SOMATO_TRY(auto threads, read_threads(arguments));
  request.threads = threads;
  if (arguments.has("data")) {
    SOMATO_TRY(auto given, GivenRecordings::at(arguments.text("data")));
    request.given = std::move(given);
  }
  if (!arguments.has("test-data")) return {};
  SOMATO_TRY(auto test, read_given({}, arguments.text("test-data")));
  request.test_data = std::make_shared<const PairedRecording>(std::move(test));
  return {};
}

Result<void> check_explorable(const ReproductionPart& part, bool given) {
  if (part.explore.entries.empty()) {
    if (given) return {};
    return fail(ErrorKind::kUsage, "'" + part.system + "' does not define an exploration",
                part.description.where, "use --data, or add a table [explore]");
  }
  auto read = read_explore_table(part.explore);
  return read ? Result<void>() : fail(std::move(read.error()));
}

std::vector<std::size_t> PartRecordings::given_for(const ReproductionPart& part) const {
  return request_.given->of_format(part.description.recording.format);
}

Result<std::size_t> PartRecordings::count(const ReproductionPart& part) const {
  if (!request_.given) return request_.recordings;
  const std::size_t found = given_for(part).size();
  if (found == 0) return fail(nothing_to_run_on(part));
  return found;
}

StockedRecording PartRecordings::stocked(const ReproductionPart& part, std::size_t index) const {
  return {part.explore, stock_point_.explored.at(title_of(part)), stock_point_.first + index,
          request_.seed + index};
}

Result<KeptRecordings::Kept> PartRecordings::get(const ReproductionPart& part, std::size_t index) {
  if (request_.given) return request_.given->get(given_for(part)[index]);
  if (stock_) return stock_->get(stocked(part, index));
  return read_explore_table(part.explore).and_then([&](const ExploreTable& table) {
    return explored_.get(table, index);
  });
}

Result<void> PartRecordings::remove_explored(const ReproductionPart& part) {
  if (request_.given || stock_) return {};
  SOMATO_TRY(const auto table, read_explore_table(part.explore));
  for (std::size_t index = 0; index < request_.recordings; ++index) {
    SOMATO_TRY_VOID(explored_.remove(table, index));
  }
  return {};
}

Result<std::string> PartRecordings::identity(const ReproductionPart& part, std::size_t index) {
  if (stock_) return stock_->identity(stocked(part, index));
  if (!request_.given) {
    return read_explore_table(part.explore).and_then([&](const ExploreTable& table) {
      return explored_.identity(table, index);
    });
  }
  std::string& hash = given_hashes_[given_for(part)[index]];
  if (hash.empty()) {
    SOMATO_TRY(const auto kept, get(part, index));
    hash = kept->info.name + " " + kept->info.hash;
  }
  return hash;
}

}  // namespace somato::program
