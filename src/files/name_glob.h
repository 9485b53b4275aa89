#pragma once

#include <string_view>

namespace somato {

/// Whether all of `name` fits `pattern`, in which `*` stands for any characters, even none, and `?`
/// for one; all others stand for themselves. Both are UTF-8.
bool matches_glob(std::string_view pattern, std::string_view name);

}  // namespace somato
