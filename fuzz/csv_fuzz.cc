#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "somato/core/check.h"
#include "somato/files/csv.h"

namespace {

// An accepted table is finite, and reads back when it is written.
void check(std::string_view text, const somato::CsvOptions& options) {
  const somato::Result<somato::NumberTable> table = somato::parse_csv(text, "input", options);
  if (!table) return;
  for (const float value : table->values.values()) SOMATO_ASSERT(std::isfinite(value));
  somato::CsvOptions again;
  again.columns.features = table->names;
  if (!table->labels.empty()) again.label_column = std::to_string(table->values.columns() + 1);
  SOMATO_ASSERT(somato::parse_csv(somato::format_csv(*table), "again", again) == *table);
}

// All numbers of an accepted table are finite or missing; none is infinite.
void check_missing(std::string_view text, const somato::CsvOptions& options) {
  const somato::Result<somato::NumberTable> table = somato::parse_csv(text, "input", options);
  if (!table) return;
  for (const float value : table->values.values()) SOMATO_ASSERT(!std::isinf(value));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  somato::CsvOptions options;
  check(text, options);
  options.label_column = "1";
  check(text, options);
  options.label_column = "kind";
  check(text, options);
  options = {' ', false, ""};
  check(text, options);
  options = {};
  options.decimal = somato::DecimalMark::kComma;
  check(text, options);
  options.decimal = somato::DecimalMark::kPoint;
  options.columns.skip = {"a*"};
  check(text, options);
  options.columns.skip = {"1", "3..4"};
  check(text, options);
  options.columns = {{}, {}, {"b", "a"}};
  check(text, options);
  options = {};
  options.keeps_missing = true;
  check_missing(text, options);
  return 0;
}
