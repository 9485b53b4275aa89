#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/tables/column_precision.h"
#include "base/tables/csv_number.h"
#include "base/tables/csv_records.h"
#include "base/tables/table_columns.h"
#include "somato/core/result.h"
#include "somato/files/csv.h"

namespace somato {

/// Reads the table of a CSV file, all its rows or some at a time; see parse_csv().
class CsvTableReader {
 public:
  CsvTableReader(CsvRecords records, std::string_view where, CsvOptions options)
      : records_(std::move(records)), where_(where), options_(std::move(options)) {}

  /// Does not look again at what rounding loses, in a file that has been read to its end.
  void trust_precision() { trusts_precision_ = true; }

  /// Reads up to the first row of numbers, which has to be there.
  Result<void> begin();

  /// The roles of the columns.
  const TableColumns& columns() const { return columns_; }

  /// The beginning of the next row, or the end of the text.
  const CsvRecords::Start& start() const { return records_.start(); }

  /// Passes over the rows that begin before the byte `begin` of the file, without reading their
  /// numbers. Errors: kData.
  Result<void> skip_to(std::size_t begin);

  /// From now on a row that begins at the byte `end` of the file, or after it, is not there.
  void end_at(std::size_t end) { end_ = end; }

  /// Goes to the first of `records`, which is a row of the same table. Errors: kData.
  Result<void> continue_with(CsvRecords records);

  /// The next rows, at most `most`, which is above 0, without names; none when there are no more.
  Result<NumberTable> rows(std::size_t most);

 private:
  Result<void> next() { return records_.next(separator_, fields_); }
  bool has_row() const { return !fields_.empty() && start().place < end_; }
  bool is_label(std::size_t column) const { return columns_.label == column; }
  bool seems_header() const;
  Result<void> choose();
  Result<void> find_label_column();
  Result<void> read_first_record();
  Result<void> read_row(std::vector<float>& values, std::vector<std::string>& labels);
  Result<void> read_label(const CsvField& field, std::vector<std::string>& labels) const;
  Result<void> read_value(std::size_t column, float& value);
  Error no_number(std::size_t column, CsvMeaning meaning) const;
  std::string advice_for_text() const;
  Result<void> no_rows() const;

  CsvRecords records_;
  std::string where_;
  CsvOptions options_;
  char separator_ = ',';
  std::vector<CsvField> fields_;
  std::size_t end_ = static_cast<std::size_t>(-1);
  TableColumns columns_;
  bool named_label_ = false;
  bool is_first_row_ = true;
  ColumnPrecision precision_;
  bool trusts_precision_ = false;
};

}  // namespace somato
