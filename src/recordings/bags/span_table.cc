#include "recordings/bags/span_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/files/whole_file.h"
#include "base/tables/csv_number.h"
#include "base/tables/csv_records.h"
#include "base/text/text.h"
#include "recordings/explorations/nanoseconds.h"

namespace somato {
namespace {

// The column of that name in the head of the table.
Result<std::size_t> column_named(const std::vector<CsvField>& head, std::string_view name,
                                 const std::string& path) {
  const auto found = std::find_if(head.begin(), head.end(),
                                  [&](const CsvField& field) { return field.text == name; });
  if (found != head.end()) return static_cast<std::size_t>(found - head.begin());
  return fail(ErrorKind::kData, fmt::format("there is no column '{}'", name), path,
              "write the columns begin and end, in seconds since the first message of the bag");
}

Result<std::int64_t> time_in(const CsvField& field, const CsvRecords& records) {
  const auto number = read_csv_number<double>(field.text);
  const std::optional<std::int64_t> time =
      number.meaning == CsvMeaning::kNumber ? nanoseconds_of(number.number) : std::nullopt;
  if (time) return *time;
  return fail(ErrorKind::kData, fmt::format("{} is no time in seconds", shown(field.text)),
              records.place(field));
}

}  // namespace

Result<std::vector<BagSpan>> read_span_table(const std::string& path) {
  SOMATO_TRY(const std::string bytes, read_whole(path));
  SOMATO_TRY(const std::string_view text, text_of(bytes, path));
  CsvRecords records(text, path);
  const char separator = records.guess_separator();
  std::vector<CsvField> head;
  SOMATO_TRY_VOID(records.next(separator, head));
  SOMATO_TRY(const std::size_t begin, column_named(head, "begin", path));
  SOMATO_TRY(const std::size_t end, column_named(head, "end", path));
  std::vector<BagSpan> spans;
  std::vector<CsvField> fields;
  std::int64_t latest = std::numeric_limits<std::int64_t>::min();
  for (;;) {
    SOMATO_TRY_VOID(records.next(separator, fields));
    if (fields.empty()) break;
    if (fields.size() != head.size()) {
      return fail(ErrorKind::kData,
                  fmt::format("the row has {} fields, the header {}", fields.size(), head.size()),
                  records.place(fields.front()));
    }
    BagSpan span;
    SOMATO_TRY(span.begin, time_in(fields[begin], records));
    SOMATO_TRY(span.end, time_in(fields[end], records));
    if (span.begin < latest || span.end <= span.begin) {
      return fail(ErrorKind::kData, "the span is empty, or begins before the preceding one ends",
                  records.place(fields[begin]));
    }
    latest = span.end;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (i != begin && i != end) span.labels.push_back({head[i].text, fields[i].text});
    }
    spans.push_back(std::move(span));
  }
  if (!spans.empty()) return spans;
  return fail(ErrorKind::kData, "the table has no rows", path);
}

}  // namespace somato
