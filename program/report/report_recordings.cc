#include "report/report_recordings.h"

#include <iterator>
#include <memory>
#include <system_error>

#include "base/core/contains.h"
#include "base/files/toml_file.h"
#include "somato/studies/study_parameters.h"

namespace somato::program {

Result<void> ReportRecordings::add_named(const std::string& path) {
  SOMATO_TRY(auto given, GivenRecordings::at(path));
  given_.push_back(std::move(given));
  for (std::size_t i = 0; i < given_.back().count(); ++i) {
    SOMATO_TRY_VOID(look_at({given_.size() - 1, i}));
  }
  return {};
}

Result<void> ReportRecordings::add_table(const std::string& path,
                                         const std::vector<ReportFile>& files) {
  std::vector<RecordingParameters> ways;
  for (const ReportFile& file : files) {
    for (const PartResults& part : file.results.parts) {
      SOMATO_TRY(const auto table, parse_toml(part.study, file.path));
      SOMATO_TRY(const auto study, read_study(table));
      if (!contains(ways, study.recording)) ways.push_back(study.recording);
    }
  }
  Result<void> first;
  bool is_read = false;
  for (const RecordingParameters& way : ways) {
    given_.push_back(GivenRecordings::one(path, way));
    auto looked = look_at({given_.size() - 1, 0});
    is_read = is_read || looked.has_value();
    if (!looked && first) first = fail(std::move(looked.error()));
  }
  return is_read ? Result<void>() : first;
}

std::vector<GivenRecordings> recordings_beside(const std::filesystem::path& results) {
  const std::filesystem::path folder = std::filesystem::absolute(results).parent_path();
  std::vector<GivenRecordings> found;
  for (const auto& place : {folder, folder / "recordings"}) {
    std::error_code missing;
    if (std::filesystem::is_directory(place, missing)) {
      found.push_back(GivenRecordings::files_in(place));
    }
  }
  return found;
}

void ReportRecordings::add_beside(const std::filesystem::path& results) {
  for (GivenRecordings& given : recordings_beside(results)) {
    for (std::size_t i = 0; i < given.count(); ++i) unread_.push_back({given_.size(), i});
    given_.push_back(std::move(given));
  }
}

std::shared_ptr<const Recording> ReportRecordings::find(const std::string& hash) {
  if (const auto known = known_.find(hash); known != known_.end()) return take(known->second);
  while (!unread_.empty()) {
    const Place place = unread_.front();
    unread_.erase(unread_.begin());
    const auto found = look_at(place);
    if (found && *found == hash) return take(place);
  }
  return {};
}

std::string ReportRecordings::path(const std::string& hash) const {
  const auto known = known_.find(hash);
  if (known == known_.end()) return {};
  const auto& path = given_[known->second.given].path(known->second.number);
  const auto inside = path.lexically_proximate(std::filesystem::current_path());
  return path.is_absolute() && !inside.string().starts_with("..") ? inside.string() : path.string();
}

Result<std::string> ReportRecordings::look_at(Place place) {
  SOMATO_TRY(auto kept, given_[place.given].get(place.number));
  known_.emplace(kept->info.hash, place);
  return kept->info.hash;
}

std::shared_ptr<const Recording> ReportRecordings::take(Place place) {
  const auto kept = given_[place.given].get(place.number);
  if (!kept) return {};
  return {*kept, &(*kept)->recording};
}

}  // namespace somato::program
