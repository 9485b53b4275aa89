#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "command_line.h"
#include "somato/core/read_ahead.h"
#include "somato/core/sample_source.h"
#include "somato/files/number_source.h"
#include "somato/graph/som_model.h"
#include "somato/maps/som_quality.h"

namespace somato::program {

/// Rows of numbers from a file, with a label a row if the command line names any: in memory, or
/// read in parts whenever they are gone through. All have been seen once and are sound.
class RowData {
 public:
  std::vector<std::string> features;  ///< Names of the columns, or empty.
  Classes classes;                    ///< Of the rows; empty without labels.
  std::string path;                   ///< Of the file.
  std::size_t count = 0;              ///< Rows.
  std::vector<float> low;             ///< The least number of each column.
  std::vector<float> high;            ///< The greatest.

  std::size_t size() const { return low.size(); }
  bool labelled() const { return !classes.of_sample.empty(); }

  /// All rows, or nothing when they are read in parts.
  const Samples* in_memory() const { return all_.get(); }

  SampleSource& samples() const { return *samples_; }

 private:
  friend Result<RowData> read_rows(const Arguments& arguments);

  std::unique_ptr<const Samples> all_;
  std::unique_ptr<NumberSource> file_;
  std::unique_ptr<SampleSource> samples_;
};

/// Reads the file that the positional `DATA` names, and its labels: in parts when it is a regular
/// file whose rows would take more than `--memory`. Errors: those of the files, kData when there
/// are not as many labels as rows, kInterrupted.
Result<RowData> read_rows(const Arguments& arguments);

/// Fails (kData) when a column has the same value in every row.
Result<void> refuse_constant_columns(const RowData& rows, const std::string& path);

/// A map and rows that fit each other.
struct MapAndRows {
  SomModel model;
  RowData rows;
};

/// Reads the positionals `MAP` and `DATA`; kData when the map takes another number of columns.
Result<MapAndRows> read_map_and_rows(const Arguments& arguments);

/// Samples as a map takes them, of a source that must outlive this. Errors (kData, with the row):
/// one is too large to be told apart from others in single precision.
class SamplesInRange final : public SampleSource {
 public:
  SamplesInRange(SampleSource& source, std::string path)
      : source_(source), path_(std::move(path)) {}

  std::size_t size() const override { return source_.size(); }
  Result<void> rewind() override {
    done_ = 0;
    return source_.rewind();
  }
  Result<SamplePart> next() override;

 private:
  SampleSource& source_;
  std::string path_;
  std::size_t done_ = 0;  // samples
};

/// Rows as the map of a model takes them, parts of a file read ahead. Both must outlive this.
/// Errors of the samples: those of the file, and of SamplesInRange.
class PreparedRows {
 public:
  PreparedRows(const SomModel& model, const RowData& rows);

  SampleSource& samples() { return ahead_; }

 private:
  ChangedSamples standardized_;
  SamplesInRange in_range_;
  ReadAhead ahead_;
};

/// Measures the model's map on the rows; winners are listed only for rows with labels. Shows a
/// person at a terminal how far it is. Errors: those of the file; kInterrupted.
Result<SomQuality> measure_rows(const SomModel& model, const RowData& rows, std::size_t threads);

}  // namespace somato::program
