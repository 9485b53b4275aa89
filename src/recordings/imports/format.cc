#include "somato/recording/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

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

struct KnownFiles {
  RecordingFormat format;
  const char* pattern;
};

constexpr KnownFiles kKnown[] = {
    {RecordingFormat::kIcubGrasp, kIcubGraspFiles},
    {RecordingFormat::kFabricslide, kFabricslideFiles},
    {RecordingFormat::kHkustPressSlide, kHkustPressSlideFiles},
    {RecordingFormat::kAcousticHardness, kAcousticHardnessFiles},
};

bool fits(const NamePattern& pattern, const std::string& file) {
  const auto labels = pattern.match(file);
  return labels && labels->has_value();
}

std::string described(const KnownFiles& known) {
  return fmt::format("{} ({})", choice_name(known.format), known.pattern);
}

std::vector<KnownFiles> fitting(const std::vector<std::string>& files) {
  std::vector<KnownFiles> found;
  for (const KnownFiles& known : kKnown) {
    const NamePattern pattern = NamePattern::parse(known.pattern).value();
    const auto fit = [&](const std::string& file) { return fits(pattern, file); };
    if (std::any_of(files.begin(), files.end(), fit)) found.push_back(known);
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

template <typename Formats>
std::string listed(const Formats& formats) {
  std::string text;
  for (const KnownFiles& known : formats) text += (text.empty() ? "" : ", ") + described(known);
  return text;
}

Result<Recording> load_folder(RecordingFormat format, const std::filesystem::path& folder) {
  switch (format) {
    case RecordingFormat::kAutomatic:
      return recognize_format(folder).and_then(
          [&](RecordingFormat found) { return load_folder(found, folder); });
    case RecordingFormat::kIcubGrasp:
      return import_icub_grasp(folder);
    case RecordingFormat::kFabricslide:
      return import_fabricslide(folder);
    case RecordingFormat::kHkustPressSlide:
      return import_hkust_press_slide(folder);
    case RecordingFormat::kAcousticHardness:
      return import_acoustic_hardness(folder);
  }
  return fail(ErrorKind::kUsage, "this recording format cannot be read");
}

}  // namespace

const std::vector<std::pair<RecordingFormat, std::string>>& Choices<RecordingFormat>::all() {
  static const std::vector<std::pair<RecordingFormat, std::string>> choices{
      {RecordingFormat::kAutomatic, "automatic"},
      {RecordingFormat::kIcubGrasp, "icub_grasp"},
      {RecordingFormat::kFabricslide, "fabricslide"},
      {RecordingFormat::kHkustPressSlide, "hkust_press_slide"},
      {RecordingFormat::kAcousticHardness, "acoustic_hardness"}};
  return choices;
}

Result<RecordingFormat> recognize_format(const std::filesystem::path& folder) {
  SOMATO_TRY(auto files, files_below(folder, ""));
  if (const auto own = first_recording(files)) {
    return fail(ErrorKind::kData, fmt::format("the folder contains recordings, such as {}", *own),
                folder.string(), "use one of them");
  }
  std::erase_if(files, is_result);
  const std::vector<KnownFiles> found = fitting(files);
  if (found.size() == 1) return found.front().format;
  if (found.empty()) {
    return fail(ErrorKind::kData,
                "the folder contains none of the known formats: " + listed(kKnown), folder.string(),
                "use another folder, or import it with a description");
  }
  return fail(ErrorKind::kData, "the folder contains more than one format: " + listed(found),
              folder.string(), "use a subfolder, or specify the format");
}

Result<Recording> load_recording(RecordingFormat format, const std::filesystem::path& path) {
  std::error_code missing;
  if (std::filesystem::is_regular_file(path, missing)) return read_recording(path.string());
  return load_folder(format, path);
}

}  // namespace somato
