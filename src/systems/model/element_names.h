#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/core/value.h"
#include "somato/graph/system.h"

namespace somato {

/// The elements that a module of type `channel` with these settings takes from those with the names
/// `all`, as the recording names them; empty if they have no names.
std::vector<std::string> taken_elements(const Table& settings, const std::vector<std::string>& all);

/// "1", "2", ... "count".
std::vector<std::string> numbers_as_names(std::size_t count);

/// A name for each element of the output of a module: that of the channel's element from which it
/// comes, after the name of the channel if there are several channels, or the number of the element
/// after the name of the module that computes it from several. Names of modules such as `last`,
/// `mean` and `standardization`, which change each element separately, do not appear.
std::vector<std::string> element_names(const System& system, std::size_t module);

}  // namespace somato
