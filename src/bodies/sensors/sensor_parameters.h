#pragma once

#include <string>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/core/value.h"
#include "somato/recording/recording.h"
#include "somato/simulation/simulation_parameters.h"

namespace somato {

/// The parameters of the sensors, of those in ExploringParameters: the ones that sense() uses. All
/// have different names.
const std::vector<ParameterInfo>& sensor_parameters();

/// `parameters` with the sensor parameters that `given` states by their names. `true_values` is
/// false unless `given` states it: the settings of every exploration that can be played have it,
/// but played readings are to be learned. Errors (kUsage) with their location: unknown names,
/// values out of range.
Result<ExploringParameters> read_sensor_parameters(const Table& given,
                                                   ExploringParameters parameters);

/// Whether all `given` sensor parameters have an effect on the readings of an exploration. Errors
/// (kUsage): the first that has none, at its location.
Result<void> check_sensor_effect(const Table& given, const Exploration& exploration);

/// A note for users who play the sensors without the settings of the exploration: not empty if the
/// default parameters with the seed of the exploration do not give its readings, bit by bit.
/// Errors: those of sense().
Result<std::string> note_of_other_sensors(const Exploration& explored);

}  // namespace somato
