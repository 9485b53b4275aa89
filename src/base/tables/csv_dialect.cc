#include "base/tables/csv_dialect.h"

#include <string_view>

#include "base/text/flag_hint.h"

namespace somato {

// A single column needs no separator.
Result<char> begin_csv(CsvRecords& records, DecimalMark decimal, std::optional<char> given,
                       std::vector<CsvField>& fields) {
  const bool has_decimal_comma = decimal == DecimalMark::kComma;
  const char found = records.guess_separator(has_decimal_comma ? "\t; ," : "\t;, ");
  const char separator = given.value_or(found);
  SOMATO_TRY_VOID(records.next(separator, fields));
  if (!has_decimal_comma || separator != ',') return separator;
  if (fields.size() <= 1) return ';';
  return fail(ErrorKind::kUsage, "commas separate the fields, so they cannot be decimal separators",
              records.line_place(fields[0]),
              "separate the fields by semicolons or tabs, or read decimal points" +
                  flag_hint("decimal", "point"));
}

}  // namespace somato
