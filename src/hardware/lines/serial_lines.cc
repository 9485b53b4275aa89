#include "hardware/lines/serial_lines.h"

#include <poll.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>

#include "somato/core/check.h"

namespace somato::wire {
namespace {

constexpr std::size_t kMostLines = 8;

tl::unexpected<Error> hung_up(const std::string& port) {
  return fail(ErrorKind::kSystem, "the line has hung up", port,
              "check the cable and the power of the device");
}

}  // namespace

Result<std::unique_ptr<SerialLines>> SerialLines::open(std::vector<Port> ports, double clock,
                                                       const std::string& clock_port) {
  require(ports.size() <= kMostLines, "SerialLines: too many ports");
  std::unique_ptr<SerialLines> lines(new SerialLines(std::move(ports), clock));
  for (std::size_t i = 0; i < lines->ports_.size(); ++i) {
    SOMATO_TRY_VOID(lines->reopen(i));
  }
  if (!clock_port.empty()) {
    SOMATO_TRY(lines->emulator_clock_, LineClock::open(clock_port));
  }
  return lines;
}

double SerialLines::now() const {
  if (emulator_clock_) return emulator_clock_->now();
  return clock_ * std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

Result<std::size_t> SerialLines::read(std::size_t line, std::span<std::uint8_t> bytes) {
  const bool is_sound = ports_.at(line).baud == 0;
  if (is_sound) SOMATO_TRY_VOID(check_words(line));
  if (hung_up_[line] != 0) {
    return is_sound ? fail(ended_sound(words_[line], ports_[line].path))
                    : hung_up(ports_[line].path);
  }
  return read_available(open_[line].number(), bytes, ports_[line].path);
}

// A fault of which a recorder speaks lasts until the line is opened again.
Result<void> SerialLines::check_words(std::size_t line) {
  constexpr std::size_t kKept = 4096;
  if (!sounds_[line].words.is_open()) return {};
  std::array<std::uint8_t, 512> part{};
  std::string& words = words_[line];
  for (;;) {
    const auto count = read_available(sounds_[line].words.number(), part, ports_[line].path);
    if (!count || *count == 0) break;
    words.append(reinterpret_cast<const char*>(part.data()), *count);
  }
  if (words.size() > kKept) words.erase(0, words.size() - kKept);
  if (auto fault = fault_in_words(words, ports_[line].path)) return fail(std::move(*fault));
  return {};
}

Result<std::size_t> SerialLines::write(std::size_t line, std::span<const std::uint8_t> bytes) {
  return write_available(open_.at(line).number(), bytes, ports_[line].path);
}

// All ports of an emulator that has ended have hung up.
void SerialLines::wait(double until) {
  if (!emulator_clock_) return wait_at_ports(until);
  if (!emulator_clock_->wait(until)) std::fill(hung_up_.begin(), hung_up_.end(), 1);
}

void SerialLines::wait_at_ports(double until) {
  std::array<pollfd, kMostLines> polled{};
  // A line that has hung up would end each wait at once, and others are still to be driven.
  for (std::size_t i = 0; i < open_.size(); ++i) {
    polled[i] = {hung_up_[i] != 0 ? -1 : open_[i].number(), POLLIN, 0};
  }
  const double left = std::max(0.0, until - now()) / clock_;
  const double whole = std::floor(left);
  const timespec timeout{static_cast<time_t>(whole), static_cast<long>((left - whole) * 1e9)};
  if (ppoll(polled.data(), open_.size(), &timeout, nullptr) <= 0) return;
  for (std::size_t i = 0; i < open_.size(); ++i) {
    if ((polled[i].revents & (POLLHUP | POLLERR | POLLNVAL)) != 0) hung_up_[i] = 1;
  }
}

Result<void> SerialLines::reopen(std::size_t line) {
  open_.at(line) = Descriptor();
  hung_up_[line] = 1;
  const Port& port = ports_[line];
  if (port.baud > 0) {
    SOMATO_TRY(open_[line], open_serial_port(port.path, port.baud));
  } else {
    words_[line].clear();
    sounds_[line] = SoundSource();
    SOMATO_TRY(sounds_[line], open_sound(port.path, port.rate));
    open_[line] = std::move(sounds_[line].samples);
  }
  hung_up_[line] = 0;
  return {};
}

}  // namespace somato::wire
