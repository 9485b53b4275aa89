#include "base/tables/csv_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/text/flag_hint.h"
#include "base/text/text.h"
#include "somato/core/check.h"

namespace somato {
namespace {

std::string lower_case(std::string_view text) {
  std::string word(text);
  for (char& c : word) c = 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return word;
}

bool is_missing_word(std::string_view text) {
  const std::string word = lower_case(text);
  for (const char* missing : {"", "na", "n/a", "none", "null", "?", "-"}) {
    if (word == missing) return true;
  }
  return false;
}

bool has_point(std::string_view field) {
  return field.find('.') != std::string_view::npos;
}

// from_chars takes no plus sign.
std::string_view without_plus(std::string_view text) {
  const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  return plus ? text.substr(1) : text;
}

// Numbers too small for T are rounded to zero; numbers too large are errors.
template <typename T>
CsvReading<T> out_of_range(std::string_view text) {
  double number = 0.0;
  const auto error = std::from_chars(text.data(), text.data() + text.size(), number).ec;
  if (error != std::errc() || std::fabs(number) > 1.0) return {CsvMeaning::kTooLarge};
  return {CsvMeaning::kNumber, static_cast<T>(number)};
}

}  // namespace

bool has_decimal_comma(std::string_view field) {
  const std::size_t comma = field.find(',');
  if (comma == std::string_view::npos || field.find('.') != std::string_view::npos) return false;
  std::string with_point(field);
  with_point[comma] = '.';
  return read_csv_number<double>(with_point).meaning == CsvMeaning::kNumber;
}

bool is_csv_text(std::string_view field) {
  return read_csv_number<float>(field).meaning == CsvMeaning::kText;
}

std::string decimal_advice(std::string_view field, DecimalMark decimal) {
  if (decimal == DecimalMark::kComma) {
    return has_point(field) ? "numbers are read with a decimal comma: write them without a point"
                            : "";
  }
  return has_decimal_comma(field)
             ? "write decimals with a point and thousands without a separator, or read decimal "
               "commas" +
                   flag_hint("decimal", "comma")
             : "";
}

template <typename T>
CsvReading<T> read_csv_number(std::string_view field, DecimalMark decimal) {
  if (decimal == DecimalMark::kComma) {
    if (has_point(field)) return {CsvMeaning::kText};
    std::string with_point(field);
    std::replace(with_point.begin(), with_point.end(), ',', '.');
    return read_csv_number<T>(with_point);
  }
  const std::string_view text = without_plus(field);
  const char* const end = text.data() + text.size();
  T number{};
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (stop != end || error == std::errc::invalid_argument) {
    return {is_missing_word(field) ? CsvMeaning::kMissing : CsvMeaning::kText};
  }
  if (error == std::errc::result_out_of_range) return out_of_range<T>(text);
  if (std::isnan(number)) return {CsvMeaning::kMissing};
  if (!std::isfinite(number)) return {CsvMeaning::kInfinite};
  return {CsvMeaning::kNumber, number};
}

template CsvReading<float> read_csv_number<float>(std::string_view field, DecimalMark decimal);
template CsvReading<double> read_csv_number<double>(std::string_view field, DecimalMark decimal);

tl::unexpected<Error> no_csv_number(const CsvField& field, CsvMeaning meaning, DecimalMark decimal,
                                    const std::string& place, const std::string& advice_for_text) {
  SOMATO_ASSERT(meaning != CsvMeaning::kNumber);
  switch (meaning) {
    case CsvMeaning::kMissing:
    case CsvMeaning::kInfinite:
      return fail(ErrorKind::kData,
                  field.text.empty() ? "the field is empty"
                                     : fmt::format("{} is not a finite number", shown(field.text)),
                  place, "leave the row out or fill in a number");
    case CsvMeaning::kTooLarge:
      return fail(ErrorKind::kData,
                  fmt::format("{} exceeds the range of 32-bit numbers", shown(field.text)), place,
                  "scale the column");
    case CsvMeaning::kNumber:
    case CsvMeaning::kText:
      break;
  }
  const std::string advice = decimal_advice(field.text, decimal);
  return fail(ErrorKind::kData, fmt::format("{} is not a number", shown(field.text)), place,
              advice.empty() ? advice_for_text : advice);
}

}  // namespace somato
