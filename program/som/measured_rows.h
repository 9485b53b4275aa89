#pragma once

#include <cstddef>
#include <vector>

#include "som/map_and_rows.h"
#include "somato/maps/clusters.h"
#include "somato/maps/som_measures.h"

namespace somato::program {

/// The chosen measures of the model's map for the rows, of their classes, and of each neuron.
/// Errors: those of the file; kInterrupted.
Result<SomMeasures> measure_rows(const MapAndRows& both, std::vector<SomMeasure> chosen,
                                 const MeasureParameters& parameters, std::size_t threads);

/// Reads the rows once more, whose winners are known, to measure their features.
/// Errors: those of the file; kInterrupted.
Result<void> measure_features(const MapAndRows& both, const std::vector<std::size_t>& winners,
                              FeatureMeasurement& measurement);

/// The samples that each neuron wins.
std::vector<std::size_t> hits_of(const SomMeasures& measures);

/// The name of a feature, or its number from 1 if the map has no names.
std::string feature_name(const SomModel& model, std::size_t feature);

}  // namespace somato::program
