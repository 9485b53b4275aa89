#include "views/report/packed_json.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/text/base64.h"
#include "studies/results/short_number.h"

namespace somato::detail {
namespace {

using Json = nlohmann::ordered_json;

struct Range {
  double low = 0.0;
  double high = 0.0;
};

Range range_of(std::span<const double> numbers) {
  Range range{INFINITY, -INFINITY};
  for (const double number : numbers) {
    if (!std::isfinite(number)) continue;
    range.low = std::min(range.low, number);
    range.high = std::max(range.high, number);
  }
  return range.low <= range.high ? range : Range{};
}

// The lower byte first.
std::string integers_of(std::span<const double> numbers, const Range& range, PackedBits bits) {
  const std::uint32_t missing = bits == PackedBits::k8 ? 0xFF : 0xFFFF;
  const double scale = range.high > range.low ? (missing - 1) / (range.high - range.low) : 0.0;
  std::string bytes;
  bytes.reserve(numbers.size() * (bits == PackedBits::k8 ? 1 : 2));
  for (const double number : numbers) {
    std::uint32_t integer = missing;
    if (std::isfinite(number)) {
      integer = static_cast<std::uint32_t>(std::floor((number - range.low) * scale + 0.5));
    }
    bytes += static_cast<char>(integer & 0xFFU);
    if (bits == PackedBits::k16) bytes += static_cast<char>(integer >> 8U);
  }
  return bytes;
}

}  // namespace

Json packed_numbers(std::span<const double> numbers, PackedBits bits) {
  // The ends of the range are those that a reader finds in the file.
  const Range exact = range_of(numbers);
  const Json low = short_number(exact.low);
  const Json high = short_number(exact.high);
  const Range range{low.get<double>(), high.get<double>()};
  std::vector<double> inside(numbers.begin(), numbers.end());
  for (double& number : inside) {
    if (std::isfinite(number))
      number = std::clamp(number, range.low, std::max(range.low, range.high));
  }
  return {{"bits", static_cast<int>(bits)},
          {"low", low},
          {"high", high},
          {"packed", base64(integers_of(inside, range, bits))}};
}

Json packed_rows(std::span<const double> numbers, std::size_t columns, PackedBits bits) {
  Json json = {{"columns", columns}};
  json.update(packed_numbers(numbers, bits));
  return json;
}

}  // namespace somato::detail
