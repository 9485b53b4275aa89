#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace somato {

/// What the real thing of a declared material looks like, more or less: red, green, blue, 0 to 1.
/// For looks alone, nothing that feels knows of it; none for other names.
std::optional<std::array<double, 3>> material_colour(std::string_view material);

}  // namespace somato
