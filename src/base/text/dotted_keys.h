#pragma once

#include <cstddef>
#include <string_view>

namespace somato {

/// The line (from 1) of the first key of TOML `text` with more than `most` dots, or 0. A parser
/// makes a table of every part, and a key of a million parts would exhaust the stack.
std::size_t line_of_long_key(std::string_view text, std::size_t most);

}  // namespace somato
