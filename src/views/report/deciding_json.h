#pragma once

#include <nlohmann/json.hpp>

#include "views/report/evidence.h"

namespace somato::detail {

/// The contributions of sensors to decisions of the trained system, as DecidingData of
/// web/schema/report.json: for one sample of each of the 8 most frequent confusions of the tests
/// those that separate the two classes, and for the 4 other samples whose two distances differ
/// least, relative to their sum, those that separate the class of the answer from the next one.
/// Null without the inputs of the samples, without samples, and for maps whose neurons have fewer
/// than two classes.
nlohmann::ordered_json deciding_json(const Evidence& evidence, std::size_t threads);

}  // namespace somato::detail
