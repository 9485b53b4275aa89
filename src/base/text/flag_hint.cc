#include "base/text/flag_hint.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace somato {
namespace {

std::vector<std::string>& named_flags() {
  static std::vector<std::string> flags;
  return flags;
}

}  // namespace

void name_flags_in_messages(std::vector<std::string> flags) {
  named_flags() = std::move(flags);
}

std::string flag_hint(std::string_view flag, std::string_view value) {
  const std::vector<std::string>& named = named_flags();
  if (std::find(named.begin(), named.end(), flag) == named.end()) return {};
  return fmt::format(" (--{}{}{})", flag, value.empty() ? "" : " ", value);
}

}  // namespace somato
