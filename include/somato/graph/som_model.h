#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "somato/codes/standardization.h"
#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/files/csv.h"
#include "somato/maps/labels.h"
#include "somato/maps/som.h"

namespace somato {

/// A trained map with everything required to use it on data, in one file.
struct SomModel {
  Som som;
  std::vector<std::string> features;               ///< Names of the input elements, or empty.
  std::optional<Standardization> standardization;  ///< Applied to data before the map.
  std::vector<std::string> classes;                ///< Names of the classes, or empty.
  NeuronLabels labels;                             ///< One class per neuron; empty without classes.
  /// Means of the columns of the training data, over the rows with a value, if missing values were
  /// replaced by them; otherwise empty.
  std::vector<double> means = {};
  /// Samples that online training has learned since the map began, if these are not the
  /// `iterations` of its parameters.
  std::optional<std::uint64_t> samples_seen = {};

  /// The replacement for a missing value of each column: `means`, or those of the standardization;
  /// empty if the model has neither.
  std::vector<double> fill_values() const;

  /// The samples as inputs of the map. Throws InvalidArgument if the sizes differ.
  Samples prepare(const Samples& samples) const;

  /// The scale of each column of data for the map: offsets of a standardization, and the
  /// deviations of the training data or, without a standardization, of the weights. Those of a map
  /// that scales its inputs to length 1 are not known.
  std::vector<ColumnScale> scales() const;

  /// Adapts the model to data from which the offsets of scales() have been subtracted.
  void subtract_offsets();

  /// The number of samples that the training has learned.
  std::uint64_t seen() const;
};

/// The bytes of a model file; docs/formats/model-file.md describes them. Throws like
/// save_som_model().
std::string encode_som_model(const SomModel& model);

/// The model in `bytes`, from the source `where`. Errors: kData for bytes that are damaged or
/// contain something else.
Result<SomModel> decode_som_model(std::string_view bytes, const std::string& where);

/// Saves atomically (see save_whole); docs/formats/model-file.md describes the file. Throws
/// InvalidArgument if features, standardization, labels or means do not fit the map.
Result<void> save_som_model(const std::string& path, const SomModel& model);

/// Reads the same model, bit by bit. Errors: kSystem for a file that cannot be read, kData for one
/// that is damaged or contains something else.
Result<SomModel> load_som_model(const std::string& path);

}  // namespace somato
