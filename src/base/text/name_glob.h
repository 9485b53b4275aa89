#pragma once

#include <string_view>

namespace somato {

/// Whether the complete `name` matches `pattern`, in which `*` matches any characters, including
/// none, and `?` one; all others match themselves. Both are UTF-8.
bool matches_glob(std::string_view pattern, std::string_view name);

}  // namespace somato
