#include "studies/codes/rounding.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string>

namespace somato {

double rounded(double value) {
  if (value == 0.0 || !std::isfinite(value)) return value;
  constexpr double kDigits = 1000.0;  // the least number with four digits
  double up = 1.0;
  while (std::fabs(value) * up < kDigits && up < 1e22) up *= 10.0;
  double down = 1.0;
  while (std::fabs(value) / down >= 10.0 * kDigits && down < 1e22) down *= 10.0;
  return std::trunc(value * up / down) / up * down;
}

double plain(float value) {
  const std::string text = fmt::format("{}", value);
  auto number = double{value};
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

}  // namespace somato
