#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "base/tables/table_columns.h"
#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/files/csv.h"

namespace somato {

class FileSystem;

/// Some rows of a file of numbers.
struct NumberPart {
  Samples samples;
  std::vector<std::string> labels;  ///< One a row; empty when there is no label column.
};

/// The rows of a file of numbers, read in parts in every pass, for a file that is larger than
/// memory. The numbers and errors are those of read_numbers(), except that of several errors the
/// first in the file is reported.
///
/// The file must not change: a different length or date is an error (kData).
class NumberSource : public SampleSource {
 public:
  /// The roles of the file's columns.
  virtual const TableColumns& columns() const = 0;

  std::size_t size() const final { return columns().features.size(); }

  /// After the last row of a pass: TableColumns::rounded of all files.
  virtual std::vector<std::string> rounded() const { return columns().rounded; }

  /// Every row begins at a place below this, in the order of the rows: a byte of the text, or of
  /// the array.
  virtual std::size_t extent() const = 0;

  /// From now on reads only the rows that begin at a place from `begin` to before `end`, at most
  /// extent(). To be called at most once, before the first part.
  virtual void take_places(std::size_t begin, std::size_t end) = 0;

  /// The bytes that gathering all samples in a list that grows, and changing them once, takes at
  /// most.
  virtual double memory_of_all() const = 0;

  /// Share of the file that was read since rewind(), 0 to 1.
  virtual double share_read() const = 0;

  /// The next part, with labels; nothing at the end.
  virtual Result<std::shared_ptr<const NumberPart>> next_part() = 0;

  Result<SamplePart> next() final;
};

/// Opens the file at `path`, which must be regular: NPY, NPZ and MAT are recognized by their first
/// bytes, all others are CSV. The samples of a part take at most `part_bytes`, but a row is not
/// divided, and NPZ and MAT files are one part. Errors: see
/// read_numbers(); kSystem for a file that is not regular.
Result<std::unique_ptr<NumberSource>> open_numbers(const std::string& path,
                                                   const CsvOptions& options,
                                                   std::size_t part_bytes);

/// The same for the rows of several files, one file after the other. Also fails (kData) if a file
/// has other columns than the first. Throws InvalidArgument without files.
Result<std::unique_ptr<NumberSource>> open_numbers(const std::vector<std::string>& paths,
                                                   const CsvOptions& options,
                                                   std::size_t part_bytes);

/// The source reads only part `part`, from 0, of `of` parts that follow one another and are nearly
/// equal in places.
void take_part(NumberSource& source, std::size_t part, std::size_t of);

/// The first of rows of `row_bytes` each that begins at `place` or after it.
inline std::size_t first_row_at(std::size_t place, std::size_t row_bytes) {
  return place / row_bytes + (place % row_bytes == 0 ? 0 : 1);
}

/// The same for a file that was read into `bytes`, from the source `where`: all rows are one part.
Result<std::unique_ptr<NumberSource>> numbers_in(const std::string& bytes, const std::string& where,
                                                 const CsvOptions& options);

namespace detail {

/// The same on the given file system, for tests.
Result<std::unique_ptr<NumberSource>> open_numbers(FileSystem& files, const std::string& path,
                                                   const CsvOptions& options,
                                                   std::size_t part_bytes);

}  // namespace detail

}  // namespace somato
