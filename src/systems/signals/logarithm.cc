#include "systems/signals/logarithm.h"

#include <cmath>

#include "base/core/elementary.h"

namespace somato {

const Declarations<LogarithmParameters>& LogarithmParameters::declarations() {
  using P = LogarithmParameters;
  static const Declarations<P> kAll = Declarations<P>().add(
      "unit", &P::unit, "unit of the input", Range::between(1e-9, 1e9),
      "Magnitude above which values are compressed, about that of the noise of an element. Not in "
      "the papers.");
  return kAll;
}

double signed_logarithm(double x, double unit) {
  return std::copysign(natural_log(1.0 + std::fabs(x) / unit), x);
}

double inverse_signed_logarithm(double y, double unit) {
  return std::copysign((exponential(std::fabs(y)) - 1.0) * unit, y);
}

}  // namespace somato
