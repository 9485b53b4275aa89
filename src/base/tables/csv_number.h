#pragma once

#include <string>

#include "base/tables/csv_records.h"
#include "somato/core/result.h"
#include "somato/files/csv.h"

namespace somato {

/// The meaning of a field of a CSV file.
enum class CsvMeaning {
  kNumber,    ///< A finite number.
  kMissing,   ///< Empty, or a marker of a missing number: NA, NaN, null, none, ?, -.
  kInfinite,  ///< A number that is not finite.
  kTooLarge,  ///< A number beyond what T holds.
  kText,      ///< Anything else.
};

/// The meaning of a field, and its number rounded to T (float or double), otherwise 0. With a
/// decimal comma a field with a point is text, because the point may separate thousands.
template <typename T>
struct CsvReading {
  CsvMeaning meaning;
  T number = T{0};
};

template <typename T>
CsvReading<T> read_csv_number(std::string_view field, DecimalMark decimal = DecimalMark::kPoint);

/// Whether a field is a number once its only comma is a point, such as 1,5 (or 1,000).
bool has_decimal_comma(std::string_view field);

/// Whether a field contains neither a number nor a marker of a missing one.
bool is_csv_text(std::string_view field);

/// The advice for a field with text that is a number with another decimal mark; empty for others.
std::string decimal_advice(std::string_view field, DecimalMark decimal);

/// Why the field at `place` is no number of its column. `advice_for_text` is for text for which
/// there is no decimal_advice(). Caller mistake (asserted): it is a number.
tl::unexpected<Error> no_csv_number(const CsvField& field, CsvMeaning meaning, DecimalMark decimal,
                                    const std::string& place, const std::string& advice_for_text);

}  // namespace somato
