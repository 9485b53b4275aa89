#include "views/exports/recording_export.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "views/exports/bag_export.h"
#include "views/exports/csv_export.h"
#include "views/exports/foxglove_export.h"
#include "views/exports/npz_export.h"

namespace somato {
namespace {

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

}  // namespace

const std::vector<std::pair<ExportFormat, std::string>>& Choices<ExportFormat>::all() {
  static const std::vector<std::pair<ExportFormat, std::string>> choices{
      {ExportFormat::kCsv, "csv"},
      {ExportFormat::kNpz, "npz"},
      {ExportFormat::kBag, "bag"},
      {ExportFormat::kFoxglove, "foxglove"}};
  return choices;
}

Result<std::unique_ptr<RecordingExport>> begin_export(ExportFormat format, const std::string& path,
                                                      SceneFinder scenes) {
  switch (format) {
    case ExportFormat::kCsv:
      return CsvExport::begin(path);
    case ExportFormat::kNpz:
      return NpzExport::begin(path);
    case ExportFormat::kBag:
      return BagExport::begin(path);
    case ExportFormat::kFoxglove:
      return FoxgloveExport::begin(path, std::move(scenes));
  }
  return fail(ErrorKind::kUsage, "this format cannot be written");
}

Result<ExportFormat> export_format_of(const std::string& path) {
  std::string name = std::filesystem::path(path).filename().string();
  name.erase(0, name.find_last_of("._") + 1);  // All of it if there is neither.
  for (const auto& [format, ending] : Choices<ExportFormat>::all()) {
    if (name == ending) return format;
  }
  return fail(
      ErrorKind::kUsage, "the name does not state the format", path,
      "use a name that ends with .npz, _csv, _bag or _foxglove, or --format csv, npz, bag or "
      "foxglove");
}

std::string free_name(std::string name, std::set<std::string>& taken) {
  while (!taken.insert(name).second) name += '_';
  return name;
}

std::string plain_name(std::string name, std::string_view others) {
  std::replace_if(
      name.begin(), name.end(),
      [&](char c) { return !is_letter_or_digit(c) && others.find(c) == std::string_view::npos; },
      '_');
  return name;
}

}  // namespace somato
