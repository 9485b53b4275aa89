#include "maps/analysis/paired_errors.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "somato/core/check.h"

namespace somato {

bool is_clearly_better(std::span<const double> errors, std::span<const double> others) {
  require(errors.size() == others.size() && !errors.empty(), "errors are compared in pairs");
  const auto count = static_cast<double>(errors.size());
  double mean = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) mean += (others[i] - errors[i]) / count;
  double squares = 0.0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double residual = others[i] - errors[i] - mean;
    squares += residual * residual;
  }
  return mean > std::sqrt(squares / std::max(1.0, count - 1.0) / count);
}

}  // namespace somato
