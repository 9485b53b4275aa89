#include "recordings/imports/mcap_trials.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "base/text/text.h"
#include "recordings/tables/name_pattern.h"
#include "recordings/tables/trial_files.h"
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

Result<void> add_labels(const TrialFile& file, Exploration& exploration) {
  for (const Label& label : file.labels) {
    std::vector<Label>& labels = exploration.labels;
    const auto own = std::find_if(labels.begin(), labels.end(),
                                  [&](const Label& other) { return other.name == label.name; });
    if (own == labels.end()) {
      labels.push_back(label);
    } else if (own->value != label.value) {
      return fail(ErrorKind::kData,
                  fmt::format("label '{}' is {} in the recording, but {} in the file name",
                              label.name, shown(own->value), shown(label.value)),
                  file.path, "rename the file, or rename the label in its name");
    }
  }
  return {};
}

// Adds an exploration of `file` to those that were read before.
Result<void> add_exploration(const TrialFile& file, Exploration exploration, Recording& recording) {
  SOMATO_TRY_VOID(add_labels(file, exploration));
  if (exploration.source.empty()) exploration.source = file.path;
  recording.explorations.push_back(std::move(exploration));
  auto alike = check_alike(recording.explorations.back(), recording.explorations.front());
  if (!alike) alike.error().where = file.path;
  return alike;
}

Result<void> add_file(const TrialFile& file, Recording& recording) {
  SOMATO_TRY(auto read, read_recording(file.path));
  if (read.explorations.empty()) {
    return fail(ErrorKind::kData, "the recording has no explorations", file.path,
                "remove it from the folder");
  }
  for (Exploration& exploration : read.explorations) {
    auto added = add_exploration(file, std::move(exploration), recording);
    if (!added) return added;
  }
  return {};
}

}  // namespace

Result<Recording> import_mcap_trials(const std::filesystem::path& folder, const std::string& files,
                                     bool pass_over_others) {
  auto pattern = NamePattern::parse(files);
  if (!pattern) {
    pattern.error().what = "'files': " + pattern.error().what;
    return fail(std::move(pattern.error()));
  }
  SOMATO_TRY(const auto found, find_trial_files(folder, *pattern, pass_over_others));
  Recording recording;
  for (const TrialFile& file : found) {
    SOMATO_TRY_VOID(add_file(file, recording));
  }
  return recording;
}

}  // namespace somato
