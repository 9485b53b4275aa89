#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "views/report/evidence.h"

namespace somato::detail {

/// The data of the trained system, as TrainedData of web/schema/report.json; null without one.
/// Missing data are reported in the sentences of `evidence`.
nlohmann::ordered_json trained_json(Evidence& evidence, std::size_t threads);

/// For each input of a T-MPSOM of two axes the product of arbor and weight for each neuron and
/// element, as ReceptiveFields; limited to a number of neurons with at most 20000 numbers.
nlohmann::ordered_json receptive_fields_json(const System& system,
                                             std::vector<std::string>& missing);

}  // namespace somato::detail
