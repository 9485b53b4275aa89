#include "somato/recording/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <span>

#include "recordings/imports/acoustic_hardness.h"
#include "recordings/imports/data_sets.h"
#include "recordings/imports/fabricslide.h"
#include "recordings/imports/hkust_press_slide.h"
#include "recordings/imports/icub_grasp.h"
#include "recordings/tables/files_below.h"
#include "recordings/tables/name_pattern.h"
#include "recordings/tables/table_recording.h"
#include "somato/core/check.h"
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

// A public data set. How it is read is in import_data_set(): a program that only names the formats
// does not contain their importers.
struct DataSet {
  RecordingFormat format;
  const char* name;
  const char* pattern;  // of its files
};

constexpr DataSet kDataSets[] = {
    {RecordingFormat::kIcubGrasp, "icub_grasp", kIcubGraspFiles},
    {RecordingFormat::kFabricslide, "fabricslide", kFabricslideFiles},
    {RecordingFormat::kHkustPressSlide, "hkust_press_slide", kHkustPressSlideFiles},
    {RecordingFormat::kAcousticHardness, "acoustic_hardness", kAcousticHardnessFiles},
};

bool fits(const NamePattern& pattern, const std::string& file) {
  const auto labels = pattern.match(file);
  return labels && labels->has_value();
}

std::string described(const DataSet& set) {
  return fmt::format("{} ({})", set.name, set.pattern);
}

std::vector<DataSet> fitting(const std::vector<std::string>& files) {
  std::vector<DataSet> found;
  for (const DataSet& set : kDataSets) {
    const NamePattern pattern = NamePattern::parse(set.pattern).value();
    const auto fit = [&](const std::string& file) { return fits(pattern, file); };
    if (std::any_of(files.begin(), files.end(), fit)) found.push_back(set);
  }
  return found;
}

std::optional<std::string> first_recording(const std::vector<std::string>& files) {
  const auto found = std::find_if(files.begin(), files.end(), [](const std::string& file) {
    return std::filesystem::path(file).extension() == ".mcap";
  });
  return found == files.end() ? std::nullopt : std::optional(*found);
}

// The JSON files of a study are not recordings.
bool is_result(const std::string& file) {
  return std::filesystem::path(file).filename() == "results.json";
}

std::string listed(std::span<const DataSet> sets) {
  std::string text;
  for (const DataSet& set : sets) text += (text.empty() ? "" : ", ") + described(set);
  return text;
}

}  // namespace

const std::vector<std::pair<RecordingFormat, std::string>>& Choices<RecordingFormat>::all() {
  static const auto choices = [] {
    std::vector<std::pair<RecordingFormat, std::string>> all{
        {RecordingFormat::kAutomatic, "automatic"}};
    for (const DataSet& set : kDataSets) all.emplace_back(set.format, set.name);
    return all;
  }();
  return choices;
}

Result<RecordingFormat> recognize_format(const std::filesystem::path& folder) {
  SOMATO_TRY(auto files, files_below(folder, ""));
  if (const auto own = first_recording(files)) {
    return fail(ErrorKind::kData, fmt::format("the folder contains recordings, such as {}", *own),
                folder.string(), "use one of them");
  }
  std::erase_if(files, is_result);
  const std::vector<DataSet> found = fitting(files);
  if (found.size() == 1) return found.front().format;
  if (found.empty()) {
    return fail(ErrorKind::kData,
                "the folder contains none of the known formats: " + listed(kDataSets),
                folder.string(), "use another folder, or import it with a description");
  }
  return fail(ErrorKind::kData, "the folder contains more than one format: " + listed(found),
              folder.string(), "use a subfolder, or specify the format");
}

const Declarations<RecordingParameters>& RecordingParameters::declarations() {
  using P = RecordingParameters;
  static const auto declared =
      Declarations<P>()
          .add("format", &P::format, "", Range::any(),
               "Format of the study's data in a folder; automatic: by the names of the files.")
          .add("label_column", &P::label_column, "", Range::any(),
               "Column of a table with the labels, by name or number from 1. The following keys "
               "are for tables, too, whose rows are explorations.")
          .add("labels", &P::labels, "", Range::any(),
               "Text file with the labels of a table's rows, one per line, instead of a column; a "
               "relative path is one from the working folder, as in flags.")
          .add("columns_to_use", &P::columns_to_use, "", Range::any(),
               "Columns of a table to use as features: names or patterns such as 'tax_*', or "
               "numbers from 1 and ranges such as 2..17 of columns without names. Empty: all.")
          .add("skip", &P::skip, "", Range::any(), "Columns to leave out, in the same form.")
          .add("variable", &P::variable, "", Range::any(),
               "Array of an NPZ archive or a MAT-file with several.")
          .add("missing", &P::missing, "", Range::any(),
               "Whether a missing number is an error or marked as invalid, so that 'fill' of the "
               "module replaces it.")
          .add("decimal", &P::decimal, "", Range::any(), "Decimal separator in text.")
          .add("header", &P::header, "", Range::any(),
               "Whether the first line of a text file contains names; automatic: if it contains "
               "a field that is not a number.");
  return declared;
}

bool is_table(const std::filesystem::path& path) {
  std::error_code missing;
  if (!std::filesystem::is_regular_file(path, missing) || is_mcap_file(path.string())) return false;
  const std::string extension = path.extension().string();
  return extension != ".mcap" && extension != ".db3";
}

namespace {

Result<Recording> import_data_set(RecordingFormat format, const std::filesystem::path& folder) {
  switch (format) {
    case RecordingFormat::kIcubGrasp:
      return import_icub_grasp(folder);
    case RecordingFormat::kFabricslide:
      return import_fabricslide(folder);
    case RecordingFormat::kHkustPressSlide:
      return import_hkust_press_slide(folder);
    case RecordingFormat::kAcousticHardness:
    case RecordingFormat::kAutomatic:
      break;
  }
  SOMATO_ASSERT(format == RecordingFormat::kAcousticHardness);
  return import_acoustic_hardness(folder);
}

Result<Recording> read_without_table(RecordingFormat format, const std::filesystem::path& path) {
  std::error_code missing;
  if (std::filesystem::is_regular_file(path, missing)) return read_recording(path.string());
  if (format == RecordingFormat::kAutomatic) {
    SOMATO_TRY(format, recognize_format(path));
  }
  return import_data_set(format, path);
}

}  // namespace

Result<Recording> load_recording(const RecordingParameters& parameters,
                                 const std::filesystem::path& path) {
  if (is_table(path)) return read_table_recording(path.string(), parameters);
  auto recording = read_without_table(parameters.format, path);
  if (!recording) return recording;
  SOMATO_TRY_VOID(check_without_table(parameters, path.string()));
  return recording;
}

Result<Recording> load_recording(RecordingFormat format, const std::filesystem::path& path) {
  return load_recording(RecordingParameters{.format = format}, path);
}

}  // namespace somato
