#pragma once

#include <nlohmann/json.hpp>
#include <span>

namespace somato::detail {

/// The number with six significant digits, which is what a picture can show; null for NaN.
nlohmann::ordered_json short_number(double value);

/// All of them as a list.
nlohmann::ordered_json short_numbers(std::span<const double> values);
nlohmann::ordered_json short_numbers(std::span<const float> values);

}  // namespace somato::detail
