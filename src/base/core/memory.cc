#include "base/core/memory.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <sstream>

namespace somato {
namespace {

constexpr std::size_t kUnknown = std::numeric_limits<std::size_t>::max();

std::size_t page_size() {
  return static_cast<std::size_t>(std::max(1L, sysconf(_SC_PAGESIZE)));
}

std::size_t less(std::size_t whole, std::size_t part) {
  return whole == kUnknown ? kUnknown : whole - std::min(whole, part);
}

// The number that a file consists of, or nothing ("max", no such file).
std::optional<std::size_t> number_in(const std::string& path) {
  std::ifstream file(path);
  std::size_t number = 0;
  if (!(file >> number)) return std::nullopt;
  return number;
}

// The number after a key in a file of lines such as "MemAvailable:  1234 kB".
std::optional<std::size_t> number_after(const std::string& path, const std::string& word) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string first;
    std::size_t number = 0;
    if (words >> first >> number && first == word) return number;
  }
  return std::nullopt;
}

// The limit of one control group, minus its usage except for caches of files.
std::size_t of_group(const std::string& folder, bool free) {
  const auto limit = number_in(folder + "/memory.max");
  if (!limit || !free) return limit.value_or(kUnknown);
  const std::size_t used = number_in(folder + "/memory.current").value_or(0);
  const std::size_t cache = number_after(folder + "/memory.stat", "inactive_file").value_or(0);
  return less(*limit, less(used, cache));
}

std::size_t of_control_groups(bool free) {
  std::ifstream file("/proc/self/cgroup");
  const std::string groups{std::istreambuf_iterator<char>(file), {}};
  return detail::control_group_memory("/sys/fs/cgroup", groups, free);
}

std::size_t address_space_limit() {
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return kUnknown;
  return limit.rlim_cur;
}

std::size_t free_address_space() {
  const std::size_t pages = number_in("/proc/self/statm").value_or(0);
  return less(address_space_limit(), pages * page_size());
}

std::size_t free_on_machine() {
  constexpr std::size_t kKibibyte = 1024;
  const auto available = number_after("/proc/meminfo", "MemAvailable:");
  return available ? *available * kKibibyte : memory_of_machine();
}

}  // namespace

std::size_t memory_of_machine() {
  const long pages = sysconf(_SC_PHYS_PAGES);
  if (pages <= 0) return kUnknown;
  return static_cast<std::size_t>(pages) * page_size();
}

std::size_t memory_limit() {
  return std::min({memory_of_machine(), of_control_groups(false), free_address_space()});
}

std::size_t free_memory() {
  return std::min({free_on_machine(), of_control_groups(true), free_address_space()});
}

Result<void> check_free_memory(std::size_t count, std::size_t size, std::string_view where) {
  const double bytes = static_cast<double>(count) * static_cast<double>(size);
  if (bytes <= static_cast<double>(free_memory()) / 4.0) return {};
  return fail(ErrorKind::kSystem,
              fmt::format("its content takes {} of memory, more than a quarter of what is free",
                          memory_text(bytes)),
              std::string(where), "free memory, or use a machine with more of it");
}

std::string memory_text(double bytes) {
  constexpr double kStep = 1024.0;
  const std::array units{"B", "KiB", "MiB", "GiB", "TiB"};
  std::size_t unit = 0;
  for (; bytes >= kStep && unit + 1 < units.size(); ++unit) bytes /= kStep;
  return fmt::format("{:.{}f} {}", bytes, unit == 0 ? 0 : 1, units[unit]);
}

// Version 2 of control groups has a single line, "0::/path".
std::size_t detail::control_group_memory(const std::string& root, const std::string& groups,
                                         bool free) {
  const std::string start = "0::/";
  const std::size_t found = groups.find(start);
  if (found == std::string::npos) return kUnknown;
  const std::size_t begin = found + start.size() - 1;
  std::string path = groups.substr(begin, groups.find('\n', begin) - begin);
  std::size_t least = of_group(root, free);
  while (path.size() > 1) {
    least = std::min(least, of_group(root + path, free));
    path.resize(path.rfind('/'));
  }
  return least;
}

}  // namespace somato
