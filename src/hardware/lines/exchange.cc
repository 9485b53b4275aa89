#include "hardware/lines/exchange.h"

#include <algorithm>
#include <array>

namespace somato::wire {

Result<void> Exchange::clear() {
  std::array<std::uint8_t, 256> bytes{};
  for (;;) {
    SOMATO_TRY(const auto count, lines_.read(line_, bytes));
    if (count == 0) return {};
  }
}

Result<void> Exchange::send(std::span<const std::uint8_t> bytes, double timeout) {
  constexpr double kPause = 0.001;
  const double until = now() + lengthened(timeout);
  while (!bytes.empty()) {
    SOMATO_TRY(const auto count, lines_.write(line_, bytes));
    bytes = bytes.subspan(count);
    if (bytes.empty()) break;
    if (now() >= until) {
      return fail(ErrorKind::kSystem, "the line does not accept data", {},
                  "check the cable and the power of the device");
    }
    pause(kPause);
  }
  return {};
}

Result<bool> Exchange::receive(double timeout, const Take& take) {
  const double until = now() + lengthened(timeout);
  std::array<std::uint8_t, 256> bytes{};
  for (;;) {
    SOMATO_TRY(const auto count, lines_.read(line_, bytes));
    if (count > 0 && take(std::span(bytes).first(count))) return true;
    if (count > 0) continue;
    if (now() >= until) return false;
    lines_.wait(until);
  }
}

Result<bool> Exchange::request(std::span<const std::uint8_t> bytes, double timeout,
                               std::size_t attempts, const Take& take) {
  for (std::size_t attempt = 0; attempt < attempts; ++attempt) {
    SOMATO_TRY_VOID(clear());
    SOMATO_TRY_VOID(send(bytes));
    SOMATO_TRY(const auto complete, receive(timeout, take));
    if (!complete) continue;
    // The answers to the attempts before may only be late, and must not be those to what follows.
    if (attempt > 0) SOMATO_TRY_VOID(let_late_answers_pass(timeout));
    return true;
  }
  return false;
}

Result<void> Exchange::let_late_answers_pass(double timeout) {
  pause(lengthened(timeout));
  return clear();
}

double Exchange::lengthened(double timeout) const {
  return std::max(timeout * std::max(1.0, lines_.clock()), patience_);
}

void Exchange::pause(double seconds) {
  const double until = now() + seconds;
  while (now() < until) lines_.wait(until);
}

}  // namespace somato::wire
