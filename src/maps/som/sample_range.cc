#include "maps/som/sample_range.h"

namespace somato {

bool is_in_range(const SignalView& prepared) {
  return inner_product(prepared, prepared) <= kLongestSample * kLongestSample;
}

}  // namespace somato
