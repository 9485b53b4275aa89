#include "flags/memory_flag.h"

#include <fmt/format.h>

#include <charconv>
#include <utility>

#include "base/core/memory.h"

namespace somato::program {
namespace {

constexpr std::pair<std::string_view, double> kUnitsOfMemory[] = {{"B", 1.0},
                                                                  {"kB", 1e3},
                                                                  {"MB", 1e6},
                                                                  {"GB", 1e9},
                                                                  {"", 1.0},
                                                                  {"KiB", 1024.0},
                                                                  {"MiB", 1024.0 * 1024},
                                                                  {"GiB", 1024.0 * 1024 * 1024}};

Error no_amount(const std::string& text, const std::string& flag) {
  return {ErrorKind::kUsage, fmt::format("must be an amount of memory, not '{}'", text), flag,
          "write a number and a unit, such as 500MiB or 2GiB"};
}

}  // namespace

Result<std::size_t> bytes_in(const std::string& text, const std::string& flag) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc()) return fail(no_amount(text, flag));
  std::string_view unit(stop, static_cast<std::size_t>(end - stop));
  unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
  for (const auto& [name, bytes] : kUnitsOfMemory) {
    constexpr double kMost = 1e18;
    if (unit != name) continue;
    if (number * bytes >= 1.0 && number * bytes <= kMost) {
      return static_cast<std::size_t>(number * bytes);
    }
  }
  return fail(no_amount(text, flag));
}

Result<std::size_t> read_memory(const Arguments& arguments) {
  if (arguments.has("memory")) return bytes_in(arguments.text("memory"), "--memory");
  return free_memory() / 2;
}

Flag memory_flag() {
  return {"--memory",
          "Maximum memory for rows, such as 500MiB; a larger file is read in parts in every pass. "
          "Default: half of the free memory"};
}

}  // namespace somato::program
