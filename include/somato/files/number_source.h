#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/sample_source.h"
#include "somato/files/csv.h"

namespace somato {

class FileSystem;

/// Some rows of a file of numbers.
struct NumberPart {
  Samples samples;
  std::vector<std::string> labels;  ///< One a row; empty when there is no label column.
};

/// The rows of a file of numbers, read in parts whenever they are gone through: for a file that is
/// larger than memory. It is what read_numbers() reads, errors included, except that of several
/// faults the first in the file is told.
///
/// The file has to stay as it is: one that has got another length or date fails (kData).
class NumberSource : public SampleSource {
 public:
  /// What the columns of the file are for.
  virtual const TableColumns& columns() const = 0;

  std::size_t size() const final { return columns().features.size(); }

  /// The bytes that gathering all samples in a list that grows, and changing them once, takes at
  /// most.
  virtual double memory_of_all() const = 0;

  /// How much of the file has been read since rewind(), 0 to 1.
  virtual double share_read() const = 0;

  /// What next() is to give, with labels; nothing when there are no more rows.
  virtual Result<std::shared_ptr<const NumberPart>> next_part() = 0;

  Result<SamplePart> next() final;
};

/// Opens the file at `path`, which must be a regular one, NPY when it begins as NPY does, otherwise
/// CSV; the samples of a part take at most `part_bytes`, but a row is not parted. Errors:
/// see read_numbers(); kSystem for what is not a regular file.
Result<std::unique_ptr<NumberSource>> open_numbers(const std::string& path,
                                                   const CsvOptions& options,
                                                   std::size_t part_bytes);

/// The same for a file that has been read into `bytes`, which are `where`: all rows are one part.
Result<std::unique_ptr<NumberSource>> numbers_in(const std::string& bytes, const std::string& where,
                                                 const CsvOptions& options);

namespace detail {

/// The same on the given file system, for tests.
Result<std::unique_ptr<NumberSource>> open_numbers(FileSystem& files, const std::string& path,
                                                   const CsvOptions& options,
                                                   std::size_t part_bytes);

}  // namespace detail

}  // namespace somato
