#pragma once

#include <string>

#include "somato/core/result.h"

namespace somato::program {

/// The width in mm that a text such as "85mm", "8.5cm" or "3.3in" states. Errors (kUsage, at
/// --width): another text, or a width that is not from 20 to 500 mm.
Result<double> figure_width(const std::string& text);

}  // namespace somato::program
