#include "somato/recording/csv_trials.h"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "files/csv_number.h"
#include "files/text.h"
#include "recording/csv_trial_reader.h"
#include "recording/trial_files.h"
#include "somato/files/whole_file.h"

namespace somato {
namespace {

// The frame of a channel that is made of a label.
Result<Matrix<float>> frame_of_label(const CsvChannel& channel, const TrialFile& trial) {
  for (const Label& label : trial.labels) {
    if (label.name != channel.from_label) continue;
    const auto [meaning, number] = read_csv_number<double>(label.value);
    const auto value =
        meaning == CsvMeaning::kNumber ? csv_value(channel, number) : std::optional<float>();
    if (value) return Matrix<float>(1, 1, *value);
    return fail(ErrorKind::kData,
                fmt::format("label '{}' is {}, which is no number for channel '{}'", label.name,
                            shown(label.value), channel.name),
                trial.path, "rename the file or take it out");
  }
  return fail(unknown_name("label", channel.from_label, trial.path, {}));
}

Result<Exploration> read_trial(const CsvImport& description, const CsvLayout& layout,
                               const TrialFile& trial) {
  const Result<std::string> bytes = read_whole(trial.path);
  if (!bytes) return fail(bytes.error());
  auto channels = text_of(*bytes, trial.path).and_then([&](std::string_view text) {
    return read_csv_trial(description, layout, text, trial.path);
  });
  if (!channels) return fail(std::move(channels.error()));
  for (std::size_t c = 0; c < channels->size(); ++c) {
    if (description.channels[c].from_label.empty()) continue;
    auto frame = frame_of_label(description.channels[c], trial);
    if (!frame) return fail(std::move(frame.error()));
    (*channels)[c].frames = std::move(*frame);
  }
  return Exploration{trial.labels, trial.path, std::move(*channels)};
}

}  // namespace

Result<Recording> import_csv_trials(const std::filesystem::path& folder,
                                    const CsvImport& description) {
  if (auto checked = check_csv_import(description); !checked) return fail(checked.error());
  const Result<CsvLayout> layout = csv_layout_of(description);
  if (!layout) return fail(layout.error());
  const NamePattern pattern = NamePattern::parse(description.trials.files).value();
  const bool ignore_others = description.trials.other_files == Unmentioned::kIgnore;
  const auto trials = find_trial_files(folder, pattern, ignore_others);
  if (!trials) return fail(trials.error());
  Recording recording;
  recording.explorations.reserve(trials->size());
  for (const TrialFile& trial : *trials) {
    auto exploration = read_trial(description, *layout, trial);
    if (!exploration) return fail(std::move(exploration.error()));
    recording.explorations.push_back(std::move(*exploration));
  }
  return recording;
}

}  // namespace somato
