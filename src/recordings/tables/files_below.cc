#include "recordings/tables/files_below.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace somato {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 16;

bool is_digit(char c) {
  return '0' <= c && c <= '9';
}

// Cuts the digits at the start of `text` off, and returns them without leading zeros.
std::string_view take_number(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
  std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(digits.size());
  digits.remove_prefix(std::min(digits.find_first_not_of('0'), digits.size()));
  return digits;
}

// Below, at or above zero as `a` comes before, with or after `b`.
int compared(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    if (is_digit(a[0]) && is_digit(b[0])) {
      const std::string_view x = take_number(a);
      const std::string_view y = take_number(b);
      if (x.size() != y.size()) return x.size() < y.size() ? -1 : 1;
      if (const int order = x.compare(y); order != 0) return order;
    } else {
      if (a[0] != b[0]) return a.substr(0, 1).compare(b.substr(0, 1));
      a.remove_prefix(1);
      b.remove_prefix(1);
    }
  }
  return static_cast<int>(!a.empty()) - static_cast<int>(!b.empty());
}

bool ends_in(std::string_view name, std::string_view extension) {
  const auto lower = [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return name.size() >= extension.size() &&
         std::equal(extension.rbegin(), extension.rend(), name.rbegin(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

tl::unexpected<Error> unreadable(const fs::path& folder, const std::error_code& failure) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(folder, ignored))) {
    return fail(ErrorKind::kSystem, "there is no such file or folder", folder.string(),
                "check the path");
  }
  return fail(ErrorKind::kSystem, fmt::format("cannot be read ({})", failure.message()),
              folder.string(), "use the folder with the recorded files");
}

}  // namespace

bool naturally_before(std::string_view a, std::string_view b) {
  const int order = compared(a, b);
  return order != 0 ? order < 0 : a < b;
}

Result<std::vector<std::string>> files_below(const fs::path& folder, std::string_view extension) {
  std::error_code failure;
  std::vector<std::string> files;
  const auto follow = fs::directory_options::follow_directory_symlink;
  fs::recursive_directory_iterator entry(folder, follow, failure);
  for (; !failure && entry != fs::recursive_directory_iterator(); entry.increment(failure)) {
    const bool is_folder = entry->is_directory(failure);
    if (failure) return unreadable(entry->path(), failure);
    if (is_folder && entry.depth() == kDeepest) {
      return fail(ErrorKind::kData,
                  fmt::format("there are more than {} levels of folders", kDeepest),
                  entry->path().string(), "check for a loop of links");
    }
    const std::string path = entry->path().lexically_relative(folder).generic_string();
    if (is_folder || !ends_in(path, extension)) continue;
    if (entry->exists(failure) && !entry->is_regular_file(failure)) {
      return fail(ErrorKind::kData, "it is not a regular file", entry->path().string(),
                  "remove it from the folder");
    }
    files.push_back(path);
  }
  if (failure) return unreadable(folder, failure);
  std::sort(files.begin(), files.end(), naturally_before);
  return files;
}

}  // namespace somato
