#include "base/tables/csv_header.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/tables/csv_text.h"

namespace somato {
namespace {

constexpr std::string_view kPandas = "Unnamed: ";
constexpr std::string_view kReadr = "...";

std::string name_by_number(std::size_t column) {
  return fmt::format("(column {})", column + 1);
}

// Blanks, ends of lines and the space that does not break.
bool is_blank(std::string_view name) {
  constexpr std::string_view kBlanks = " \t\r\n\v\f\xC2\xA0";
  return name.find_first_not_of(kBlanks) == std::string_view::npos;
}

bool is_numbered(std::string_view name, std::string_view start) {
  return name.size() > start.size() && name.starts_with(start) && '0' <= name[start.size()] &&
         name[start.size()] <= '9';
}

// Whether `columns` are the last ones, and not all.
bool end_the_table(const std::vector<std::size_t>& columns, std::size_t width) {
  return columns.size() < width && columns.front() == width - columns.size();
}

}  // namespace

std::vector<std::string> names_in_header(const std::vector<CsvField>& header) {
  std::vector<std::string> names;
  names.reserve(header.size());
  for (const CsvField& field : header) {
    names.push_back(is_blank(field.text) ? name_by_number(names.size())
                                         : unguarded_text(field.text));
  }
  return names;
}

bool is_nameless(std::string_view name, std::size_t column) {
  return name == name_by_number(column) || is_numbered(name, kPandas) ||
         (is_numbered(name, kReadr) &&
          name.substr(kReadr.size()).find_first_not_of("0123456789") == std::string_view::npos);
}

std::string columns_by_number(const std::vector<std::string>& names,
                              const std::vector<std::size_t>& columns) {
  std::vector<std::string> selectors;
  selectors.reserve(columns.size());
  bool is_quoted = false;
  for (const std::size_t column : columns) {
    selectors.push_back(std::to_string(column + 1));
    if (std::find(names.begin(), names.end(), selectors.back()) == names.end()) continue;
    selectors.back() = names[column];
    is_quoted = true;
  }
  return fmt::format("{0}{1}{0}", is_quoted ? "'" : "", fmt::join(selectors, ","));
}

Error nameless_columns(const std::vector<std::size_t>& columns, std::size_t width,
                       std::string_view where, std::string_view alternative) {
  std::vector<std::size_t> numbers = columns;
  for (std::size_t& number : numbers) ++number;
  const bool is_one = columns.size() == 1;
  const bool is_end = end_the_table(columns, width);
  const char* advice = is_end ? "a separator ends the line of names: remove it from every line"
                              : "usually this is the index of pandas or the row names of R: write "
                                "the table without it (index=False, row.names=FALSE)";
  return {ErrorKind::kData,
          is_one ? fmt::format("column {} has no name", numbers.front())
                 : fmt::format("columns {} have no names", fmt::join(numbers, ", ")),
          std::string(where), fmt::format("{}, or {}", advice, alternative)};
}

Error wrong_number_of_fields(const std::vector<CsvField>& fields, std::size_t width,
                             bool follows_header, std::string place, std::string_view advice) {
  Error error{ErrorKind::kData, fmt::format("expected {} fields, found {}", width, fields.size()),
              std::move(place), std::string(advice)};
  if (!follows_header || fields.size() != width + 1) return error;
  error.what += ", one more than names";
  error.advice = fields.back().text.empty()
                     ? "a separator ends the line: remove it from every line, or name the last "
                       "column"
                     : "if the first column has no name, as R writes row names, write the table "
                       "without it (row.names=FALSE), or name it";
  return error;
}

}  // namespace somato
