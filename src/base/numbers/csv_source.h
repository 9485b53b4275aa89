#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/files/text_window.h"
#include "base/files/unchanged_file.h"
#include "base/numbers/number_source.h"
#include "base/tables/csv_table_reader.h"

namespace somato {

/// The rows of a CSV file.
class CsvSource final : public NumberSource {
 public:
  /// Errors: those of parse_csv() up to the first row.
  static Result<std::unique_ptr<NumberSource>> begin(UnchangedFile file, const CsvOptions& options,
                                                     std::size_t part_bytes);

  CsvSource(UnchangedFile file, CsvOptions options, std::size_t part_bytes)
      : file_(std::move(file)),
        options_(std::move(options)),
        part_bytes_(part_bytes),
        end_(file_.size()) {}

  const TableColumns& columns() const override { return reader_->columns(); }
  std::size_t extent() const override { return file_.size(); }
  void take_places(std::size_t begin, std::size_t end) override;
  double memory_of_all() const override;
  double share_read() const override;
  Result<void> rewind() override;
  Result<std::shared_ptr<const NumberPart>> next_part() override;

 private:
  Result<void> go_to(const CsvRecords::Start& start);
  Result<void> go_to_first_row();

  UnchangedFile file_;
  CsvOptions options_;
  std::size_t part_bytes_;
  std::size_t begin_ = 0;
  std::size_t end_;
  std::optional<CsvRecords::Start> first_row_;  // once it has been found
  bool is_known_ = false;                       // read to its end before
  std::unique_ptr<TextWindow> window_;
  std::unique_ptr<CsvTableReader> reader_;
};

}  // namespace somato
