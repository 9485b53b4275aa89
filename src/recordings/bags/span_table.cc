#include "recordings/bags/span_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/files/whole_file.h"
#include "base/tables/csv_dialect.h"
#include "base/tables/csv_header.h"
#include "base/tables/csv_number.h"
#include "base/tables/csv_records.h"
#include "base/tables/csv_text.h"
#include "base/text/text.h"
#include "recordings/explorations/nanoseconds.h"

namespace somato {
namespace {

// The column of that name in the head of the table.
Result<std::size_t> column_named(const std::vector<std::string>& head, std::string_view name,
                                 const std::string& path) {
  const auto found = std::find(head.begin(), head.end(), name);
  if (found != head.end()) return static_cast<std::size_t>(found - head.begin());
  return fail(ErrorKind::kData, fmt::format("there is no column '{}'", name), path,
              "write the columns begin and end, in seconds since the first message of the bag");
}

Result<void> refuse_nameless(const std::vector<std::string>& head, const std::string& path) {
  for (std::size_t i = 0; i < head.size(); ++i) {
    if (is_nameless(head[i], i)) return fail(nameless_columns({i}, head.size(), path, "name it"));
  }
  return {};
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
  std::vector<CsvField> fields;
  SOMATO_TRY(const char separator, begin_csv(records, DecimalMark::kPoint, {}, fields));
  const std::vector<std::string> head = names_in_header(fields);
  SOMATO_TRY_VOID(refuse_nameless(head, path));
  SOMATO_TRY(const std::size_t begin, column_named(head, "begin", path));
  SOMATO_TRY(const std::size_t end, column_named(head, "end", path));
  std::vector<BagSpan> spans;
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
      if (i != begin && i != end) span.labels.push_back({head[i], unguarded_text(fields[i].text)});
    }
    spans.push_back(std::move(span));
  }
  if (!spans.empty()) return spans;
  return fail(ErrorKind::kData, "the table has no rows", path);
}

}  // namespace somato
