#pragma once

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace somato::testing {

/// The numbers of PackedNumbers or PackedRows of web/schema/report.json, written separately from
/// the library; NaN for missing ones.
inline std::vector<double> unpacked(const nlohmann::ordered_json& json) {
  const std::string letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::uint32_t kept = 0;
  int bits_kept = 0;
  std::vector<std::uint32_t> bytes;
  for (const char letter : json["packed"].get<std::string>()) {
    if (letter == '=') break;
    kept = kept << 6U | static_cast<std::uint32_t>(letters.find(letter));
    bits_kept += 6;
    if (bits_kept < 8) continue;
    bits_kept -= 8;
    bytes.push_back(kept >> static_cast<unsigned>(bits_kept) & 0xFFU);
  }
  const bool is_wide = json["bits"] == 16;
  const double steps = is_wide ? 65534.0 : 254.0;
  const auto low = json["low"].get<double>();
  const auto high = json["high"].get<double>();
  std::vector<double> numbers;
  numbers.reserve(bytes.size());
  for (std::size_t i = 0; i < bytes.size(); i += is_wide ? 2 : 1) {
    const double integer = is_wide ? bytes[i] + 256.0 * bytes[i + 1] : bytes[i];
    numbers.push_back(integer > steps ? std::nan("") : low + integer * (high - low) / steps);
  }
  return numbers;
}

/// Row `row` of PackedRows.
inline std::vector<double> unpacked_row(const nlohmann::ordered_json& json, std::size_t row) {
  const std::vector<double> all = unpacked(json);
  const auto columns = json["columns"].get<std::size_t>();
  const auto from = all.begin() + static_cast<std::ptrdiff_t>(row * columns);
  return {from, from + static_cast<std::ptrdiff_t>(columns)};
}

}  // namespace somato::testing
