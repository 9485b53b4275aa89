#include "studies/run/checked_line.h"

#include <fmt/format.h>

#include <utility>

#include "base/archives/checksum.h"

namespace somato {

using LineJson = nlohmann::json;

std::string checked_line(const LineJson& content) {
  const std::string text = content.dump(-1, ' ', false, LineJson::error_handler_t::replace);
  return fmt::format("{:08x} {}\n", crc32c(text), text);
}

std::optional<LineJson> checked_content(std::string_view line) {
  constexpr std::size_t kChecksum = 9;
  if (line.size() <= kChecksum) return {};
  const std::string_view text = line.substr(kChecksum);
  if (line.substr(0, kChecksum) != fmt::format("{:08x} ", crc32c(text))) return {};
  LineJson content = LineJson::parse(text, nullptr, false);
  if (content.is_discarded()) return {};
  return content;
}

}  // namespace somato
