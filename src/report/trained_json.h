#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/evidence.h"

namespace somato::detail {

/// What only the trained system knows, as TrainedData of web/src/report/data.ts; null without one.
/// What cannot be told is added to the sentences of `evidence`.
nlohmann::ordered_json trained_json(Evidence& evidence, std::size_t threads);

/// For each input of a T-MPSOM of two axes what its neurons hear of each element, arbor times
/// weight, as ReceptiveFields; of so many neurons that it is at most 20000 numbers.
nlohmann::ordered_json receptive_fields_json(const System& system,
                                             std::vector<std::string>& missing);

}  // namespace somato::detail
