#include "studies/results/short_number.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string>

namespace somato::detail {
namespace {

using Json = nlohmann::ordered_json;

template <typename Real>
Json all(std::span<const Real> values) {
  Json json = Json::array();
  for (const Real value : values) json.push_back(short_number(double{value}));
  return json;
}

}  // namespace

Json short_number(double value) {
  constexpr double kExact = 1e6;
  if (!std::isfinite(value)) return nullptr;
  if (value == std::trunc(value) && std::abs(value) < kExact) {
    return static_cast<std::int64_t>(value);
  }
  const std::string text = fmt::format("{:.6g}", value);
  double rounded = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  return rounded;
}

Json short_numbers(std::span<const double> values) {
  return all(values);
}

Json short_numbers(std::span<const float> values) {
  return all(values);
}

}  // namespace somato::detail
