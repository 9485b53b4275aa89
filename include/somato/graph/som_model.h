#pragma once

#include <optional>
#include <string>
#include <vector>

#include "somato/codes/standardization.h"
#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/labels.h"
#include "somato/maps/som.h"

namespace somato {

/// A trained map with what is needed to use it on data: one file.
struct SomModel {
  Som som;
  std::vector<std::string> features;               ///< Names of the input elements, or empty.
  std::optional<Standardization> standardization;  ///< Applied to data before the map sees it.
  std::vector<std::string> classes;                ///< Names of the classes, or empty.
  NeuronLabels labels;                             ///< A class a neuron; empty without classes.
  /// Of the columns of the training data, over the rows that knew them, where missing values were
  /// filled with them; otherwise empty.
  std::vector<double> means = {};

  /// What a missing value of each column is replaced by: `means`, or those of the standardization;
  /// empty where the model has neither.
  std::vector<double> fill_values() const;

  /// The samples as the map takes them. Throws InvalidArgument when the sizes differ.
  Samples prepare(const Samples& samples) const;
};

/// Saves wholly or not at all (see save_whole); docs/formats/model-file.md describes the file.
/// Throws InvalidArgument when features, standardization, labels or means do not fit the map.
Result<void> save_som_model(const std::string& path, const SomModel& model);

/// The same model, bit by bit. Errors: kSystem for a file that cannot be read, kData for one that
/// is damaged or holds something else.
Result<SomModel> load_som_model(const std::string& path);

}  // namespace somato
