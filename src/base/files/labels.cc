#include "base/files/labels.h"

#include <fmt/format.h>

#include "base/files/whole_file.h"
#include "base/text/text.h"

namespace somato {
namespace {

// The next line without its end, taken off the front of `text`.
std::string_view take_line(std::string_view& text) {
  std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(text.size(), line.size() + 1));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return trimmed(line);
}

}  // namespace

Result<std::vector<std::string>> parse_labels(std::string_view text, std::string_view where) {
  SOMATO_TRY(std::string_view rest, text_of(text, where));
  std::vector<std::string> labels;
  std::size_t empty_line = 0;
  for (std::size_t line = 1; !rest.empty(); ++line) {
    const std::string_view label = take_line(rest);
    if (label.empty() && empty_line == 0) empty_line = line;
    if (label.empty()) continue;
    if (empty_line > 0) {
      return fail(ErrorKind::kData, "the line is empty", fmt::format("{}:{}", where, empty_line),
                  "write one label on every line");
    }
    labels.emplace_back(label);
  }
  if (labels.empty()) {
    return fail(ErrorKind::kData, "there are no labels", std::string(where),
                "write one label on every line");
  }
  return labels;
}

Result<std::vector<std::string>> read_labels(const std::string& path) {
  return read_whole(path).and_then(
      [&](const std::string& bytes) { return parse_labels(bytes, path); });
}

Result<std::vector<std::string>> read_labels(const std::string& path, std::size_t rows) {
  auto labels = read_labels(path);
  if (!labels || labels->size() == rows) return labels;
  return fail(ErrorKind::kData, fmt::format("{} labels for {} rows", labels->size(), rows), path,
              "write one label per line, in the order of the rows");
}

}  // namespace somato
