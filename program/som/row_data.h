#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "base/mpi/joined_processes.h"
#include "base/numbers/number_source.h"
#include "flags/command_line.h"
#include "somato/core/samples.h"
#include "somato/maps/labels.h"
#include "systems/signals/missing_values.h"
#include "terminal/terminal.h"

namespace somato::program {

inline tl::unexpected<Error> reading_stopped() {
  return fail(ErrorKind::kInterrupted, "reading was stopped before its end");
}

/// The samples of a source, which must outlive this object, until Ctrl-C.
class StoppableRows final : public SampleSource {
 public:
  explicit StoppableRows(SampleSource& rows) : rows_(rows) {}

  std::size_t size() const override { return rows_.size(); }
  Result<void> rewind() override { return rows_.rewind(); }
  Result<SamplePart> next() override {
    if (stop_requested()) return reading_stopped();
    return rows_.next();
  }

 private:
  SampleSource& rows_;
};

/// Rows of numbers from a file, with a label per row if the command line names labels: in memory,
/// or read in parts in every pass. All rows have been validated.
class RowData {
 public:
  TableColumns columns;                        ///< The roles of the file's columns.
  std::vector<std::string> features;           ///< Names of the feature columns, or empty.
  std::vector<std::string> rounded;            ///< NumberSource::rounded().
  Classes classes;                             ///< The classes of the rows; empty without labels.
  std::string path;                            ///< The path of the file, or of the first.
  std::size_t count = 0;                       ///< Rows, of all processes that share the file.
  std::size_t first = 0;                       ///< Rows of the processes before this one.
  std::size_t own_count = 0;                   ///< Rows of this process, which samples() are.
  std::vector<float> low;                      ///< The minimum of each feature.
  std::vector<float> high;                     ///< The maximum of each feature.
  MissingFill missing = MissingFill::kRefuse;  ///< Treatment of missing values.
  KnownValues known;  ///< The values of the file; collected unless missing values are refused.
  bool holds_missing = false;  ///< Whether samples() contain missing values, which are NaN.
  /// The content of a file that can be read only once; otherwise nullptr.
  std::shared_ptr<const std::string> text;

  std::size_t size() const { return columns.features.size(); }
  bool labelled() const { return !classes.of_sample.empty(); }

  /// All rows, or nothing if they are read in parts.
  const Samples* in_memory() const { return all_.get(); }

  SampleSource& samples() const { return filled_ ? *filled_ : *samples_; }

  /// Fills missing values with `means`, or from the nearest row, with differences divided by
  /// `scale` unless that is empty; values that are left out remain. Errors: kSystem if rows are
  /// read in parts and all are required; those of filled_from_nearest().
  Result<void> fill(const std::vector<double>& means, const std::vector<double>& scale);

 private:
  friend class RowReader;

  void keep(Samples samples);

  std::unique_ptr<const Samples> all_;
  std::unique_ptr<NumberSource> file_;
  std::unique_ptr<SampleSource> samples_;
  std::unique_ptr<SampleSource> filled_;
};

/// Reads the files that the positional `DATA` names, one after the other, and their labels: in
/// parts if they are regular files whose rows would take more than `--memory`. If columns have
/// names, those of `features` are selected in that order, unless it is empty. `scales` are those of
/// ColumnChoice; `text` is that of RowData if the file was read before. Shows progress on a
/// terminal. Errors: those of the files, kData if the numbers of labels and rows differ or a row
/// has no known value, kInterrupted.
///
/// Each of `processes` reads a part of the rows, and all return the same error; nullptr: only this
/// process. Also fails (kUsage) for files and flags that several processes cannot share.
Result<RowData> read_rows(const Arguments& arguments, const std::vector<std::string>& features = {},
                          JoinedProcesses* processes = nullptr,
                          const std::vector<ColumnScale>& scales = {},
                          std::shared_ptr<const std::string> text = nullptr);

/// Fails (kData) if a column has the same value in every row.
Result<void> refuse_constant_columns(const RowData& rows, const std::string& path);

}  // namespace somato::program
