#include "studies/run/merged_parts.h"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/files/whole_file.h"
#include "studies/run/checked_line.h"

namespace somato {
namespace {

constexpr const char* kJournal = ".journal";
constexpr const char* kStudy = ".found";

// With their line ends, up to the first that is truncated or damaged.
std::vector<std::string> valid_lines(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos || !checked_content(text.substr(0, end))) break;
    lines.emplace_back(text.substr(0, end + 1));
    text.remove_prefix(end + 1);
  }
  return lines;
}

Result<std::vector<std::string>> lines_of(const std::filesystem::path& file) {
  std::error_code missing;
  if (!std::filesystem::exists(file, missing)) return std::vector<std::string>();
  return read_whole(file.string()).map([](const std::string& text) { return valid_lines(text); });
}

Result<void> merge_file(const std::vector<std::string>& lines, const std::filesystem::path& to) {
  SOMATO_TRY(const auto present, lines_of(to));
  if (!present.empty() && present.front() != lines.front()) {
    return fail(ErrorKind::kData, "the folders contain different results of the same name",
                to.string(), "merge parts of one command and one version of Somato");
  }
  const std::set<std::string> known(present.begin(), present.end());
  std::string text;
  for (const std::string& line : present) text += line;
  for (const std::string& line : lines) {
    if (!known.contains(line)) text += line;
  }
  return save_whole(to.string(), text);
}

std::vector<std::filesystem::path> entries_of(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> entries;
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
    entries.push_back(entry.path());
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

bool has_results(const std::filesystem::path& file) {
  return file.extension() == kJournal || file.extension() == kStudy;
}

Result<void> merge_part(const std::filesystem::path& from, const std::filesystem::path& to,
                        MergedParts& merged) {
  for (const std::filesystem::path& file : entries_of(from)) {
    if (!has_results(file)) continue;
    const bool is_journal = file.extension() == kJournal;
    SOMATO_TRY(const auto lines, lines_of(file));
    if (lines.empty()) continue;
    SOMATO_TRY_VOID(merge_file(lines, to / file.filename()));
    if (is_journal) merged.trainings += lines.size() - 1;  // after the header
    if (!is_journal) ++merged.studies;
  }
  return {};
}

Result<void> make_folder(const std::filesystem::path& folder) {
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  if (!code) return {};
  return fail(ErrorKind::kSystem, "the folder cannot be created: " + code.message(),
              folder.string(), "use a writable folder");
}

}  // namespace

bool contains_parts(const std::filesystem::path& from) {
  for (const std::filesystem::path& part : entries_of(from)) {
    const std::vector<std::filesystem::path> files = entries_of(part);
    if (std::any_of(files.begin(), files.end(), has_results)) return true;
  }
  return false;
}

Result<MergedParts> merge_parts(const std::filesystem::path& from,
                                const std::filesystem::path& to) {
  MergedParts merged;
  std::error_code ignored;
  for (const std::filesystem::path& part : entries_of(from)) {
    if (!std::filesystem::is_directory(part, ignored)) continue;
    const std::filesystem::path own = to / part.filename();
    SOMATO_TRY_VOID(make_folder(own));
    SOMATO_TRY_VOID(merge_part(part, own, merged));
    ++merged.parts;
  }
  return merged;
}

}  // namespace somato
