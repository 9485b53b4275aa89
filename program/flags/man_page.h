#pragma once

#include <string>
#include <vector>

#include "flags/command_line.h"

namespace somato::program {

/// The manual page somato(1), for `man`.
std::string man_page(const std::vector<Command>& commands);

}  // namespace somato::program
