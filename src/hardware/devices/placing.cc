#include "hardware/devices/placing.h"

#include <fmt/format.h>

#include "hardware/lines/exchange.h"
#include "hardware/lines/serial_lines.h"

namespace somato::devices {

Result<void> place_by_emulator(const std::string& port, const std::string& thing, std::size_t trial,
                               double timeout, const std::function<bool()>& should_continue) {
  SOMATO_TRY(const auto lines, wire::SerialLines::open({{port, 115200}}));
  wire::Exchange exchange(*lines, 0);
  const std::string request = fmt::format("place {} {}\n", trial, thing);
  SOMATO_TRY_VOID(exchange.send(std::vector<std::uint8_t>(request.begin(), request.end())));
  std::string answer;
  const auto take = [&](std::span<const std::uint8_t> bytes) {
    answer.append(bytes.begin(), bytes.end());
    return answer.ends_with('\n');
  };
  constexpr double kPoll = 0.1;
  const double end = lines->now() + timeout;
  while (lines->now() < end) {
    if (!should_continue()) return fail(ErrorKind::kInterrupted, "exploring was interrupted");
    SOMATO_TRY(const auto complete, exchange.receive(kPoll, take));
    if (!complete) continue;
    if (answer == "placed\n") return {};
    return fail(ErrorKind::kData,
                fmt::format("the emulator cannot place '{}': {}", thing,
                            answer.substr(0, answer.size() - 1)),
                port, "explore objects that the emulator knows");
  }
  return fail(ErrorKind::kSystem, "the emulator does not answer", port,
              "start it again with 'somato emulate'");
}

}  // namespace somato::devices
