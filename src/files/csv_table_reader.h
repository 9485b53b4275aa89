#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/column_precision.h"
#include "files/csv_records.h"
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

  /// Of the columns of numbers; empty when there are none.
  const std::vector<std::string>& names() const { return names_; }

  /// Columns of numbers.
  std::size_t columns() const { return width_ - (label_ ? 1 : 0); }

  bool has_labels() const { return label_.has_value(); }

  /// The next rows, at most `most`, which is above 0, without names; none when there are no more.
  Result<NumberTable> rows(std::size_t most);

 private:
  Result<void> next() { return records_.next(separator_, fields_); }
  bool is_label(std::size_t column) const { return label_ == column; }
  bool seems_header() const;
  Result<void> find_label_column();
  Result<void> read_first_record();
  Result<void> read_row(std::vector<float>& values, std::vector<std::string>& labels);
  Result<void> read_label(const CsvField& field, std::vector<std::string>& labels) const;
  Result<void> read_value(const CsvField& field, std::size_t column, std::vector<float>& values);
  Result<void> no_rows() const;

  CsvRecords records_;
  std::string where_;
  CsvOptions options_;
  char separator_ = ',';
  std::vector<CsvField> fields_;
  std::size_t width_ = 0;
  std::optional<std::size_t> label_;
  bool named_label_ = false;
  std::vector<std::string> names_;
  ColumnPrecision precision_;
  bool trusts_precision_ = false;
};

}  // namespace somato
