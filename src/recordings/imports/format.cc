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
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

// A public data set: a row is all that the program knows of it.
struct DataSet {
  RecordingFormat format;
  const char* name;
  const char* pattern;  // of its files
  Result<Recording> (*import)(const std::filesystem::path& folder);
};

constexpr DataSet kDataSets[] = {
    {RecordingFormat::kIcubGrasp, "icub_grasp", kIcubGraspFiles, import_icub_grasp},
    {RecordingFormat::kFabricslide, "fabricslide", kFabricslideFiles, import_fabricslide},
    {RecordingFormat::kHkustPressSlide, "hkust_press_slide", kHkustPressSlideFiles,
     import_hkust_press_slide},
    {RecordingFormat::kAcousticHardness, "acoustic_hardness", kAcousticHardnessFiles,
     import_acoustic_hardness},
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

Result<Recording> load_recording(RecordingFormat format, const std::filesystem::path& path) {
  std::error_code missing;
  if (std::filesystem::is_regular_file(path, missing)) return read_recording(path.string());
  if (format == RecordingFormat::kAutomatic) {
    SOMATO_TRY(format, recognize_format(path));
  }
  const auto* const set = std::find_if(std::begin(kDataSets), std::end(kDataSets),
                                       [&](const DataSet& one) { return one.format == format; });
  return set->import(path);
}

}  // namespace somato
