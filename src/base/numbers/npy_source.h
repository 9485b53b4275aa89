#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "base/arrays/npy_layout.h"
#include "base/files/unchanged_file.h"
#include "base/numbers/number_source.h"
#include "base/tables/column_precision.h"

namespace somato {

/// The rows of an NPY file.
class NpySource final : public NumberSource {
 public:
  /// Errors: kData for another or a damaged file; those of npy_reading().
  static Result<std::unique_ptr<NumberSource>> begin(UnchangedFile file, const CsvOptions& options,
                                                     std::size_t part_bytes);

  NpySource(UnchangedFile file, const NpyLayout& layout, NpyReading reading, std::size_t part_rows)
      : file_(std::move(file)),
        layout_(layout),
        reading_(std::move(reading)),
        part_rows_(part_rows),
        end_(layout.rows),
        precision_(reading_.columns.scales) {}

  const TableColumns& columns() const override { return reading_.columns; }
  double memory_of_all() const override;
  std::size_t extent() const override { return layout_.rows * row_bytes(); }
  void take_places(std::size_t begin, std::size_t end) override;
  double share_read() const override;
  Result<void> rewind() override;
  Result<std::shared_ptr<const NumberPart>> next_part() override;

 private:
  std::size_t row_bytes() const { return layout_.columns * layout_.type->size; }
  Result<Matrix<float>> rows(std::size_t count);
  Result<void> fetch(std::size_t count, char* bytes) const;

  UnchangedFile file_;
  NpyLayout layout_;
  NpyReading reading_;
  std::size_t part_rows_;
  std::size_t begin_ = 0;
  std::size_t end_;
  std::size_t row_ = 0;
  std::string bytes_;
  ColumnPrecision precision_;
  bool is_known_ = false;  // read to its end before
};

}  // namespace somato
