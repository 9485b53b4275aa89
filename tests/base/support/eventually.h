#pragma once

#include <chrono>
#include <functional>
#include <thread>

namespace somato::testing {

/// Looks every 5 ms until it holds: true then, and false after two minutes, longer than a slow
/// machine takes for what a test waits for.
[[nodiscard]] inline bool eventually(const std::function<bool()>& holds) {
  constexpr auto kPatience = std::chrono::minutes(2);
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

}  // namespace somato::testing
