#include "views/curves/curve_point.h"

#include <cmath>

#include "base/text/number_of_text.h"

namespace somato::detail {

std::optional<double> number_in(const std::string& text) {
  const auto number = number_of_text<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

nlohmann::ordered_json point_json(double x, const Metric& metric) {
  return {{"x", x},
          {"mean", metric.mean()},
          {"sd", metric.standard_deviation()},
          {"values", metric.values}};
}

}  // namespace somato::detail
