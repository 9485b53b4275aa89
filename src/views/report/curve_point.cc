#include "views/report/curve_point.h"

#include <charconv>
#include <cmath>
#include <system_error>

namespace somato::detail {

std::optional<double> number_in(const std::string& text) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  if (read.ec != std::errc() || read.ptr != end || !std::isfinite(number)) return {};
  return number;
}

nlohmann::ordered_json point_json(double x, const Metric& metric) {
  return {{"x", x},
          {"mean", metric.mean()},
          {"sd", metric.standard_deviation()},
          {"values", metric.values}};
}

}  // namespace somato::detail
