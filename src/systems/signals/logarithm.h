#pragma once

#include "somato/core/parameter.h"

namespace somato {

struct LogarithmParameters {
  double unit = 1.0;

  static const Declarations<LogarithmParameters>& declarations();
};

/// sign(x) log(1 + |x| / unit): nearly x / unit for values far below `unit`, which is above 0, and
/// a logarithm far above it. Increases with x; 0 for 0.
double signed_logarithm(double x, double unit);

/// The x whose signed_logarithm() is `y`: sign(y) (e^|y| - 1) unit; infinite for a large y.
double inverse_signed_logarithm(double y, double unit);

}  // namespace somato
