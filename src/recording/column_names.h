#pragma once

#include <string_view>

namespace somato {

/// Whether `column` is a pattern of names: it holds a star.
bool is_column_pattern(std::string_view column);

/// Whether `name` fits `pattern`, whose stars stand for any text, also for none.
bool fits_column_pattern(std::string_view pattern, std::string_view name);

}  // namespace somato
