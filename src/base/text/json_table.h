#pragma once

#include <string>

#include "somato/core/value.h"

namespace somato {

/// A table as a JSON object, its keys in their order, indented by two spaces, with a line end.
/// Numbers are written so that reading them gives the same bits; a number that is not finite, which
/// JSON does not have, becomes null. Text that is not UTF-8 has its wrong bytes replaced.
std::string to_json(const Table& table);

}  // namespace somato
