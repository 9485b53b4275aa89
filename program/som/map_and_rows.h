#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "base/core/read_ahead.h"
#include "som/row_data.h"
#include "somato/graph/som_model.h"
#include "somato/maps/som_features.h"
#include "somato/maps/som_measures.h"
#include "somato/maps/som_quality.h"

namespace somato::program {

/// A map and matching rows.
struct MapAndRows {
  SomModel model;
  RowData rows;
};

/// Whether the model, read from `path`, takes rows of which values are missing, in the way that
/// they name. Errors (kUsage): it does not, and a value is missing.
Result<void> check_fills_of(const SomModel& model, const RowData& rows, const std::string& path);

/// Reads the positionals `MAP` and `DATA`. If both the map's features and the table's columns
/// have names, the features are selected by name. Errors: those of the files; kData if the map
/// takes another number of columns; kUsage if it cannot fill missing values in the requested way.
/// Processes share the rows as in read_rows().
Result<MapAndRows> read_map_and_rows(const Arguments& arguments,
                                     JoinedProcesses* processes = nullptr);

/// The samples of a source, which must outlive this object, checked for the map's range; there are
/// `first` rows before them. Errors (kData, with the row): a sample is too large for distances in
/// single precision.
class SamplesInRange final : public SampleSource {
 public:
  SamplesInRange(SampleSource& source, std::string path, std::size_t first)
      : source_(source), path_(std::move(path)), first_(first) {}

  std::size_t size() const override { return source_.size(); }
  Result<void> rewind() override {
    done_ = 0;
    return source_.rewind();
  }
  Result<SamplePart> next() override;

 private:
  SampleSource& source_;
  std::string path_;
  std::size_t first_;
  std::size_t done_ = 0;  // samples
};

/// Rows as inputs of a model's map, standardized and with missing values filled; parts of
/// a file are read ahead. Both must outlive this object.
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

/// Calls `visit` with all samples of the source in blocks of at most `most`, which are not copied.
/// Errors: those of the source and of `visit`; kInterrupted.
Result<void> for_each_block(SampleSource& source, std::size_t most,
                            const std::function<Result<void>(const Samples&)>& visit);

/// Measures the model's map on the rows; winners are listed only for rows with labels. Shows
/// progress on a terminal. Processes that share the rows get the same measures, or the same error.
/// Errors: those of the file; kInterrupted.
Result<SomQuality> measure_rows(const SomModel& model, const RowData& rows, std::size_t threads,
                                JoinedProcesses* processes = nullptr);

/// The chosen measures of the model's map for the rows, of their classes, and of each neuron.
/// Errors: those of the file; kInterrupted.
Result<SomMeasures> measure_rows(const MapAndRows& both, std::vector<SomMeasure> chosen,
                                 const MeasureParameters& parameters, std::size_t threads);

/// Reads the rows once more, whose winners are known, to measure their features. Values that are
/// missing in the rows, and that their winners would fill, are left out.
/// Errors: those of the file; kInterrupted.
Result<void> measure_features(const MapAndRows& both, const std::vector<std::size_t>& winners,
                              FeatureMeasurement& measurement);

/// The samples that each neuron wins.
std::vector<std::size_t> hits_of(const SomMeasures& measures);

/// The name of a feature, or its number from 1 if the map has no names.
std::string feature_name(const SomModel& model, std::size_t feature);

}  // namespace somato::program
