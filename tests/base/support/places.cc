#include "base/support/places.h"

namespace somato {

std::string source_path(std::string_view name) {
  return SOMATO_SOURCE_DIR "/" + std::string(name);
}

std::string build_path(std::string_view name) {
  return SOMATO_BUILD_DIR "/" + std::string(name);
}

}  // namespace somato
