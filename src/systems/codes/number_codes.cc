#include "somato/codes/number_codes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ranges>

#include "somato/core/check.h"

namespace somato {
namespace {

constexpr std::size_t kMostBits = std::size_t{1} << 20;
constexpr std::size_t kMostDigits = 24;  // of the significand of a single-precision number

bool has_digits(NumberCodeKind code) {
  return code != NumberCodeKind::kThermometer;
}

float digit(std::uint32_t number, std::size_t place_from_the_right) {
  return static_cast<float>((number >> place_from_the_right) & 1U);
}

}  // namespace

const std::vector<std::pair<NumberCodeKind, std::string>>& Choices<NumberCodeKind>::all() {
  static const std::vector<std::pair<NumberCodeKind, std::string>> kAll{
      {NumberCodeKind::kBinary, "binary"},
      {NumberCodeKind::kGray, "gray"},
      {NumberCodeKind::kThermometer, "thermometer"}};
  return kAll;
}

const Declarations<NumberCodeParameters>& NumberCodeParameters::declarations() {
  using P = NumberCodeParameters;
  static const Declarations<P> kAll =
      Declarations<P>()
          .add("code", &P::code, "", Range::any(),
               "Code of a level: its binary digits (P11's raw bits), a Gray code, or "
               "a thermometer code.")
          .add("low", &P::low, "unit of the value", Range::any(),
               "Lower end of the first level. Not given in the paper.")
          .add("high", &P::high, "unit of the value", Range::any(),
               "Upper end of the last level. Not given in the paper.")
          .add("bits", &P::bits, "", Range::between(1, static_cast<double>(kMostBits)),
               "Number of elements, most significant first; 18 in P11, at most 24 except for a "
               "thermometer.")
          .add("outside", &P::outside, "", Range::any(),
               "Treatment of a value outside the range: an error, or the nearest level. Not given "
               "in the paper.");
  return kAll;
}

Result<void> NumberCodeParameters::validate() const {
  const std::size_t most = has_digits(code) ? kMostDigits : kMostBits;
  if (bits < 1 || bits > most) {
    return fail(ErrorKind::kUsage,
                fmt::format("a {} code has 1 to {} bits, not {}", choice_name(code), most, bits),
                {}, "change 'bits'");
  }
  const auto first = static_cast<float>(low);
  const auto last = static_cast<float>(high);
  if (std::isfinite(first) && std::isfinite(last) && first < last) return {};
  return fail(ErrorKind::kUsage,
              fmt::format("a number code cannot range from 'low' {} to 'high' {}", low, high), {},
              "both must be finite, with 'low' below 'high'");
}

NumberCode::NumberCode(const NumberCodeParameters& parameters) : parameters_(parameters) {
  const Result<void> valid = parameters.validate();
  if (!valid) throw InvalidArgument(to_string(valid.error()));
}

std::uint32_t NumberCode::levels() const {
  const auto bits = static_cast<std::uint32_t>(parameters_.bits);
  return has_digits(parameters_.code) ? std::uint32_t{1} << bits : bits + 1;
}

float NumberCode::edge(std::uint32_t level) const {
  const double width = parameters_.high - parameters_.low;
  return static_cast<float>(parameters_.low +
                            width * static_cast<double>(level) / static_cast<double>(levels()));
}

Result<std::uint32_t> NumberCode::level(float value) const {
  if (std::isnan(value)) {
    return fail(ErrorKind::kData, "the value to be encoded is not a number", {},
                "remove the frame from the recording, or repair it");
  }
  const bool outside =
      value < static_cast<float>(parameters_.low) || value > static_cast<float>(parameters_.high);
  if (outside && parameters_.outside == OutsideRange::kRefuse) {
    return fail(ErrorKind::kData,
                fmt::format("the value {} is outside the range {} to {} of its {} code", value,
                            parameters_.low, parameters_.high, choice_name(parameters_.code)),
                {}, "widen 'low' and 'high', or set outside = \"clamp\"");
  }
  const auto inner_edges = std::views::iota(std::uint32_t{1}, levels());
  const auto above = std::ranges::partition_point(
      inner_edges, [&](std::uint32_t level) { return edge(level) <= value; });
  return static_cast<std::uint32_t>(above - inner_edges.begin());
}

Result<Signal> NumberCode::encode(float value) const {
  std::vector<float> elements(bits());
  SOMATO_TRY_VOID(encode(value, elements));
  return Signal::dense(std::move(elements));
}

Result<void> NumberCode::encode(float value, std::span<float> out) const {
  require(out.size() == bits(), "a number code needs room for its bits");
  SOMATO_TRY(const auto level, this->level(value));
  const bool gray = parameters_.code == NumberCodeKind::kGray;
  const std::uint32_t number = gray ? level ^ (level >> 1U) : level;
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = has_digits(parameters_.code) ? digit(number, out.size() - 1 - i)
                                          : static_cast<float>(i < level);
  }
  return {};
}

}  // namespace somato
