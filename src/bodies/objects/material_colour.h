#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace somato {

/// An approximate colour of a declared material: red, green, blue, 0 to 1. Only used for pictures,
/// not by sensors; empty for other names.
std::optional<std::array<double, 3>> material_colour(std::string_view material);

}  // namespace somato
