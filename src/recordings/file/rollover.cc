#include "recordings/file/rollover.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <chrono>
#include <ctime>

namespace somato {

double Rollover::time() const {
  if (now) return now();
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

std::string path_at(std::string path, double time, std::size_t copy) {
  const std::size_t place = path.find(kTimePlace);
  if (place == std::string::npos) return path;
  std::string text =
      fmt::format("{:%Y-%m-%dT%H-%M-%SZ}", fmt::gmtime(static_cast<std::time_t>(time)));
  if (copy > 1) text += fmt::format("-{}", copy);
  return path.replace(place, kTimePlace.size(), text);
}

}  // namespace somato
