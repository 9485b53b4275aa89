#include "base/text/flag_hint.h"

#include <fmt/format.h>

#include <atomic>

namespace somato {
namespace {

std::atomic<bool> names_flags = false;

}  // namespace

void name_flags_in_messages(bool flags) {
  names_flags = flags;
}

std::string flag_hint(std::string_view flag, std::string_view value) {
  if (!names_flags) return {};
  return fmt::format(" (--{}{}{})", flag, value.empty() ? "" : " ", value);
}

}  // namespace somato
