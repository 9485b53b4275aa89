#include "hardware/lines/line_clock.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <tuple>
#include <utility>
#include <vector>

namespace somato::wire {
namespace {

constexpr std::size_t kLongestLine = 256;
constexpr int kPatienceMs = 60'000;  // far longer than an emulator takes

tl::unexpected<Error> no_answer(const char* what, const std::string& port) {
  return fail(ErrorKind::kSystem, what, port, "start it again with 'somato emulate'");
}

std::vector<std::uint8_t> line_of(const std::string& text) {
  std::vector<std::uint8_t> line(text.begin(), text.end());
  line.push_back('\n');
  return line;
}

// Appends what is there.
Result<void> append_available(const Descriptor& from, const std::string& port, std::string& text) {
  std::array<std::uint8_t, kLongestLine> bytes{};
  SOMATO_TRY(const auto count, read_available(from.number(), bytes, port));
  text.append(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
  return {};
}

// Takes the first whole line from the text.
std::optional<std::string> take_line(std::string& text) {
  const std::size_t end = text.find('\n');
  if (end == std::string::npos) return {};
  std::string line = text.substr(0, end);
  text.erase(0, end + 1);
  return line;
}

}  // namespace

Result<LineClock> LineClock::open(const std::string& port) {
  constexpr std::size_t kAnyBaud = 115200;
  SOMATO_TRY(auto emulator, open_serial_port(port, kAnyBaud));
  LineClock clock(std::move(emulator), port);
  SOMATO_TRY_VOID(clock.request(0.0));
  return clock;
}

Result<void> LineClock::wait(double until) {
  auto requested = request(until);
  if (!requested) now_ = std::max(now_, until);
  return requested;
}

// An answer to another request is one to a host that has ended.
Result<void> LineClock::request(double until) {
  const std::string request = fmt::format("{}", until);
  SOMATO_TRY_VOID(write_available(emulator_.number(), line_of(request), port_));
  std::string text;  // Two answers may arrive together.
  for (;;) {
    SOMATO_TRY(const auto line, answer(text));
    const std::size_t space = line.find(' ');
    if (line.substr(0, space) != request || space == std::string::npos) continue;
    now_ = std::max(now_, std::strtod(line.c_str() + space, nullptr));
    return {};
  }
}

Result<std::string> LineClock::answer(std::string& text) {
  for (;;) {
    if (auto line = take_line(text)) return *std::move(line);
    pollfd polled{emulator_.number(), POLLIN, 0};
    const int ready = ::poll(&polled, 1, kPatienceMs);
    if (ready == 0) return no_answer("the emulator does not answer", port_);
    if (ready < 0) continue;
    if ((polled.revents & (POLLHUP | POLLERR | POLLNVAL)) != 0) {
      return no_answer("the emulator has ended", port_);
    }
    SOMATO_TRY_VOID(append_available(emulator_, port_, text));
  }
}

Result<LineClockPort> LineClockPort::open() {
  SOMATO_TRY(auto terminal, open_pseudo_terminal());
  return LineClockPort(std::move(terminal));
}

std::optional<double> LineClockPort::requested() {
  if (!append_available(terminal_.device, terminal_.port, received_)) received_.clear();
  const auto line = take_line(received_);
  if (!line && received_.size() > kLongestLine) received_.clear();
  if (!line) return {};
  request_ = *line;
  return std::strtod(request_.c_str(), nullptr);
}

void LineClockPort::answer(double now) {
  std::ignore = write_available(terminal_.device.number(),
                                line_of(fmt::format("{} {}", request_, now)), terminal_.port);
}

}  // namespace somato::wire
