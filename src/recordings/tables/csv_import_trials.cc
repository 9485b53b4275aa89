#include "somato/recording/csv_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/files/whole_file.h"
#include "base/tables/csv_number.h"
#include "base/text/text.h"
#include "recordings/tables/csv_import_check.h"
#include "recordings/tables/csv_trial_reader.h"
#include "recordings/tables/csv_windows.h"
#include "recordings/tables/trial_files.h"

namespace somato {
namespace {

// The decimal mark of a label: names of files have points.
DecimalMark decimal_of(const CsvTrials& trials, const std::string& label) {
  const auto& columns = trials.labels;
  const bool is_column = std::find(columns.begin(), columns.end(), label) != columns.end();
  return is_column ? trials.decimal : DecimalMark::kPoint;
}

// The frame of a channel that is made of a label.
Result<Matrix<float>> frame_of_label(const CsvChannel& channel, DecimalMark decimal,
                                     const Exploration& exploration) {
  SOMATO_TRY(const auto value, find_label(exploration, channel.from_label));
  const auto [meaning, number] = read_csv_number<double>(value, decimal);
  const auto kept =
      meaning == CsvMeaning::kNumber ? csv_value(channel, number) : std::optional<float>();
  if (kept) return Matrix<float>(1, 1, *kept);
  return fail(ErrorKind::kData,
              fmt::format("label '{}' is {}, which is not a number for channel '{}'",
                          channel.from_label, shown(value), channel.name),
              exploration.source, "rename or remove the file");
}

Result<void> fill_from_labels(const CsvImport& description, Exploration& exploration) {
  for (std::size_t c = 0; c < exploration.channels.size(); ++c) {
    const CsvChannel& channel = description.channels[c];
    if (channel.from_label.empty()) continue;
    SOMATO_TRY(
        auto frame,
        frame_of_label(channel, decimal_of(description.trials, channel.from_label), exploration));
    exploration.channels[c].frames = std::move(frame);
  }
  return {};
}

// The labels of the `number`th exploration of a file, whose columns give `values`.
std::vector<Label> labels_of(const CsvTrials& trials, const TrialFile& file,
                             const std::vector<std::string>& values, std::size_t number) {
  std::vector<Label> labels = file.labels;
  for (std::size_t i = 0; i < values.size(); ++i) labels.push_back({trials.labels[i], values[i]});
  if (!divides_files(trials)) return labels;
  labels.push_back({kFileLabel, file.name});
  labels.push_back({trials.window ? kWindowLabel : kRowLabel, std::to_string(number)});
  return labels;
}

Result<CsvTrial> read_trial(const CsvImport& description, const CsvLayout& layout,
                            CsvFilesInCommon& common, const TrialFile& file) {
  SOMATO_TRY(const std::string bytes, read_whole(file.path));
  return text_of(bytes, file.path).and_then([&](std::string_view text) {
    return read_csv_trial(description, layout, common, text, file.path);
  });
}

Result<std::vector<TrialFile>> files_at(const std::filesystem::path& path,
                                        const CsvTrials& trials) {
  if (trials.files.empty()) {
    if (is_one_file(path))
      return std::vector<TrialFile>{{path.string(), path.filename().string(), {}}};
    return fail(ErrorKind::kUsage, "'files' is missing, which is required for a folder",
                path.string(),
                "write for example files = \"{object}_{trial:number}.csv\", or import one file");
  }
  const NamePattern pattern = NamePattern::parse(trials.files, false).value();
  return find_trial_files(path, pattern, trials.other_files == Unmentioned::kIgnore);
}

Result<void> check_name(const CsvTrials& trials, const TrialFile& file) {
  if (!divides_files(trials) || is_name(file.name)) return {};
  return fail(ErrorKind::kData,
              "the name of the file, a label, is not 1 to 255 bytes of UTF-8 text", file.path,
              "rename the file or its folder");
}

// Files with something in common: their number, and the first.
struct FilesAlike {
  std::size_t count = 0;
  std::string first;

  void add(const std::string& path) {
    if (count++ == 0) first = path;
  }

  std::string text() const {
    return count == 1 ? first : fmt::format("{} files, such as {}", count, first);
  }
};

// Looks for clocks that were not set, from file to file.
class FileClocks {
 public:
  void add(const CsvClock& clock, const std::string& path) {
    if (clock.is_constant) constant_.add(path);
    if (clock.has_times) (clock.is_of_epoch ? of_epoch_ : before_).add(path);
  }

  std::vector<std::string> warnings() const {
    std::vector<std::string> warnings;
    if (constant_.count > 0) {
      warnings.push_back(fmt::format(
          "the time is the same in all rows of {}: import without times, or with a rate",
          constant_.text()));
    }
    if (of_epoch_.count > 0 && before_.count > 0) {
      warnings.push_back(
          fmt::format("the times of {} are before the year 2000, those of {} are not: the clock "
                      "may not have been set",
                      before_.text(), of_epoch_.text()));
    }
    return warnings;
  }

 private:
  FilesAlike constant_;
  FilesAlike of_epoch_;
  FilesAlike before_;
};

// Makes the explorations of one file after the other.
class TrialImport {
 public:
  TrialImport(const CsvImport& description, const CsvLayout& layout)
      : description_(description), layout_(layout) {}

  Result<void> add(const TrialFile& file) {
    SOMATO_TRY_VOID(check_name(description_.trials, file));
    SOMATO_TRY(auto trial, read_trial(description_, layout_, common_, file));
    const CsvWindows divided = windows_of(description_.trials, trial.parts);
    clocks_.add(trial.clock, file.path);
    report_.rows_left_out += divided.left_out;
    report_.files_left_out += divided.windows.empty() ? 1 : 0;
    longest_ = std::max(longest_, longest_part(trial.parts));
    Result<void> added;
    for (std::size_t i = 0; added && i < divided.windows.size(); ++i) {
      added = add_window(file, trial, divided.windows[i], i + 1);
    }
    return added;
  }

  Result<Recording> finish(const std::string& where) {
    SOMATO_TRY_VOID(common_.check_ignored(layout_, where));
    if (!recording_.explorations.empty()) return std::move(recording_);
    const bool labelled = !description_.trials.labels.empty();
    return fail(ErrorKind::kData,
                fmt::format("no file has {} rows{}; the most are {}",
                            description_.trials.window.value_or(1),
                            labelled ? " with the same labels one after the other" : "", longest_),
                where, "make 'window' smaller");
  }

  CsvImportReport report() const {
    CsvImportReport report = report_;
    report.warnings = clocks_.warnings();
    return report;
  }

 private:
  static std::size_t longest_part(const std::vector<LabelledRows>& parts) {
    std::size_t longest = 0;
    for (const LabelledRows& part : parts) longest = std::max(longest, part.rows);
    return longest;
  }

  Result<void> add_window(const TrialFile& file, const CsvTrial& trial, const CsvWindow& window,
                          std::size_t number) {
    const std::vector<std::string>& values = trial.parts[window.part].values;
    Exploration exploration{labels_of(description_.trials, file, values, number), file.path, {}};
    exploration.channels.reserve(trial.channels.size());
    for (const Channel& channel : trial.channels) {
      exploration.channels.push_back(cut(channel, window));
    }
    Result<void> filled = fill_from_labels(description_, exploration);
    if (filled) recording_.explorations.push_back(std::move(exploration));
    return filled;
  }

  const CsvImport& description_;
  const CsvLayout& layout_;
  CsvFilesInCommon common_;
  Recording recording_;
  CsvImportReport report_;
  FileClocks clocks_;
  std::size_t longest_ = 0;
};

}  // namespace

Result<Recording> import_csv_trials(const std::filesystem::path& folder,
                                    const CsvImport& description, CsvImportReport* report) {
  SOMATO_TRY_VOID(check_csv_import(description));
  SOMATO_TRY(const CsvLayout layout, csv_layout_of(description));
  SOMATO_TRY(const auto files, files_at(folder, description.trials));
  TrialImport import(description, layout);
  for (const TrialFile& file : files) {
    SOMATO_TRY_VOID(import.add(file));
  }
  if (report) *report = import.report();
  return import.finish(folder.string());
}

}  // namespace somato
