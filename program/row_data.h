#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "command_line.h"
#include "somato/codes/missing_values.h"
#include "somato/core/sample_source.h"
#include "somato/core/samples.h"
#include "somato/files/number_source.h"
#include "somato/maps/labels.h"

namespace somato::program {

/// Rows of numbers from a file, with a label a row if the command line names any: in memory, or
/// read in parts whenever they are gone through. All have been seen once and are sound.
class RowData {
 public:
  TableColumns columns;                        ///< What the columns of the file are for.
  std::vector<std::string> features;           ///< Names of those that are features, or empty.
  Classes classes;                             ///< Of the rows; empty without labels.
  std::string path;                            ///< Of the file.
  std::size_t count = 0;                       ///< Rows.
  std::vector<float> low;                      ///< The least number of each feature.
  std::vector<float> high;                     ///< The greatest.
  MissingFill missing = MissingFill::kRefuse;  ///< What becomes of missing values.
  KnownValues known;           ///< Of the file; gathered unless missing values are refused.
  bool holds_missing = false;  ///< Whether samples() hold missing values, which are NaN.

  std::size_t size() const { return columns.features.size(); }
  bool labelled() const { return !classes.of_sample.empty(); }

  /// All rows, or nothing when they are read in parts.
  const Samples* in_memory() const { return all_.get(); }

  SampleSource& samples() const { return filled_ ? *filled_ : *samples_; }

  /// Fills in what is missing: with `means`, or from the nearest row, differences being divided by
  /// `scale` unless that is empty. Errors: kSystem when rows are read in parts and the nearest ones
  /// are to be found; those of filled_from_nearest().
  Result<void> fill(const std::vector<double>& means, const std::vector<double>& scale);

 private:
  friend class RowReader;

  void keep(Samples samples);

  std::unique_ptr<const Samples> all_;
  std::unique_ptr<NumberSource> file_;
  std::unique_ptr<SampleSource> samples_;
  std::unique_ptr<SampleSource> filled_;
};

/// Reads the file that the positional `DATA` names, and its labels: in parts when it is a regular
/// file whose rows would take more than `--memory`. Where columns have names, those of `features`
/// are picked in that order, unless it is empty. Shows a person at a terminal how far it is.
/// Errors: those of the files, kData when there are not as many labels as rows or nothing of a row
/// is known, kInterrupted.
Result<RowData> read_rows(const Arguments& arguments,
                          const std::vector<std::string>& features = {});

/// Fails (kData) when a column has the same value in every row.
Result<void> refuse_constant_columns(const RowData& rows, const std::string& path);

}  // namespace somato::program
