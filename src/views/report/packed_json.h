#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <span>

namespace somato::detail {

/// The integers of packed numbers: 8 bits are what a colour can show, 16 bits are five significant
/// digits of the largest number.
enum class PackedBits { k8 = 8, k16 = 16 };

/// The numbers as PackedNumbers of web/schema/report.json: the nearest of 2^bits - 1 evenly spaced
/// values from the least to the greatest of them, as integers in base64; NaN and infinity are
/// missing.
nlohmann::ordered_json packed_numbers(std::span<const double> numbers, PackedBits bits);

/// Rows of `columns` numbers, one after the other, as PackedRows.
nlohmann::ordered_json packed_rows(std::span<const double> numbers, std::size_t columns,
                                   PackedBits bits);

}  // namespace somato::detail
