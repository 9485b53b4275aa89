#include "base/files/embedded.h"

#include <algorithm>

#include "somato/core/check.h"

namespace somato::detail {

std::string_view embedded_text(std::string_view path) {
  const auto& files = embedded_files();
  const auto found = std::find_if(files.begin(), files.end(),
                                  [&](const EmbeddedFile& file) { return file.path == path; });
  SOMATO_ASSERT(found != files.end());
  return found->text;
}

}  // namespace somato::detail
