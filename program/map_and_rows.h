#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "row_data.h"
#include "somato/core/read_ahead.h"
#include "somato/graph/som_model.h"
#include "somato/maps/som_quality.h"

namespace somato::program {

/// A map and rows that fit each other.
struct MapAndRows {
  SomModel model;
  RowData rows;
};

/// Reads the positionals `MAP` and `DATA`. Where both the map's features and the table's columns
/// have names, the features are picked by name. Errors: those of the files; kData when the map
/// takes another number of columns; kUsage when it cannot fill in missing values as they are to be.
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

/// Rows as the map of a model takes them, standardized and with missing values filled in, parts of
/// a file read ahead. Both must outlive this.
/// Errors of the samples: those of the file, and of SamplesInRange.
class PreparedRows {
 public:
  PreparedRows(const SomModel& model, const RowData& rows);

  SampleSource& samples() { return ahead_; }

 private:
  ChangedSamples prepared_;
  SamplesInRange in_range_;
  ReadAhead ahead_;
};

/// Measures the model's map on the rows; winners are listed only for rows with labels. Shows a
/// person at a terminal how far it is. Errors: those of the file; kInterrupted.
Result<SomQuality> measure_rows(const SomModel& model, const RowData& rows, std::size_t threads);

}  // namespace somato::program
