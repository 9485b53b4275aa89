#pragma once

#include <string>
#include <vector>

#include "somato/core/parameter.h"

namespace somato::program {

/// A text as the cell of a table in Markdown.
std::string markdown_cell(const std::string& text);

/// The values of a parameter: type or choices, range and unit.
std::string permitted_values(const ParameterInfo& info);

/// Parameters as a table in Markdown: key, values, default, meaning.
std::string parameter_table(const std::vector<ParameterInfo>& parameters);

}  // namespace somato::program
