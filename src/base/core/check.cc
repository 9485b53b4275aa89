#include "somato/core/check.h"

#include <cstdio>
#include <cstdlib>

namespace somato::detail {

void assertion_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "somato: internal error: '%s' does not hold at %s:%d\n", condition, file,
               line);
  std::abort();
}

}  // namespace somato::detail
