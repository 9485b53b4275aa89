#include "systems/modules/finite.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace somato {

Result<void> check_finite(const SignalView& output) {
  const bool finite = std::all_of(output.values.begin(), output.values.end(),
                                  [](float value) { return std::isfinite(value); });
  if (finite) return {};
  return fail(ErrorKind::kData, "its output is too large for single precision", {},
              "scale its input");
}

Result<void> check_finite(const Sequence& output) {
  for (std::size_t frame = 0; frame < output.values.count(); ++frame) {
    Result<void> finite = check_finite(output.values[frame]);
    if (finite) continue;
    if (output.values.count() > 1) finite.error().what += fmt::format(" (frame {})", frame + 1);
    return finite;
  }
  return {};
}

}  // namespace somato
