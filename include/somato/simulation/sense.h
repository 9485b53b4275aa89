#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "somato/core/result.h"
#include "somato/recording/recording.h"
#include "somato/simulation/simulation_parameters.h"

namespace somato {

/// Plays the sensors of a simulated body: the exploration with the readings that these sensors make
/// of its true values, which explore with SimulationParameters::true_values keeps (channels with
/// names that begin with `true_`). What the body did remains as it was, although it may have
/// depended on readings. The parameters and the seed of the exploration give its readings, bit by
/// bit; `seed` replaces that seed for the noise and for the differences between sensors, and not
/// for the movements. Parameters of anything but sensors have no effect, except
/// `hardness_probe.stroke`, which is the default path of the potentiometer.
///
/// The result has the true channels only with `true_values` of these parameters. Its source states
/// that the sensors are played, and their seed.
///
/// Errors: kUsage for an exploration without true values and parameters out of range; kData for
/// true values that `explore` does not write.
Result<Exploration> sense(const Exploration& explored, const ExploringParameters& parameters,
                          std::optional<std::uint64_t> seed = {});

/// The same for all explorations, in `threads` threads, with the same result for any number of
/// them. Errors name the exploration by its number, from 1.
Result<Recording> sense(const Recording& explored, const ExploringParameters& parameters,
                        std::optional<std::uint64_t> seed = {}, std::size_t threads = 1);

}  // namespace somato
