#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "files/csv_table_reader.h"
#include "files/number_source.h"
#include "files/text_window.h"
#include "files/unchanged_file.h"

namespace somato {

/// The rows of a CSV file.
class CsvSource final : public NumberSource {
 public:
  /// Errors: those of parse_csv() up to the first row.
  static Result<std::unique_ptr<NumberSource>> begin(UnchangedFile file, const CsvOptions& options,
                                                     std::size_t part_bytes);

  CsvSource(UnchangedFile file, CsvOptions options, std::size_t part_bytes)
      : file_(std::move(file)), options_(std::move(options)), part_bytes_(part_bytes) {}

  const TableColumns& columns() const override { return reader_->columns(); }
  double memory_of_all() const override;
  double share_read() const override;
  Result<void> rewind() override;
  Result<std::shared_ptr<const NumberPart>> next_part() override;

 private:
  UnchangedFile file_;
  CsvOptions options_;
  std::size_t part_bytes_;
  bool is_known_ = false;  // read to its end before
  std::unique_ptr<TextWindow> window_;
  std::unique_ptr<CsvTableReader> reader_;
};

}  // namespace somato
