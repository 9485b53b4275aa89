#include "hardware/emulation/pty_emulator.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <tuple>
#include <utility>

#include "hardware/emulation/emulated_wire.h"

namespace somato::emulation {
namespace {

constexpr int kPollMs = 1;
constexpr double kLongestStep = 0.02;        // s of the emulation
constexpr double kLongestAnswer = 0.1;       // s that a host waits without a look at other events
constexpr double kLastMoment = 0.1;          // s for what hosts have sent before the end
constexpr std::size_t kMostWaiting = 65536;  // A host that does not read loses the oldest bytes.

// Writes what the port accepts of what waits for it. Without a host everything is lost, as on a
// line without a reader.
void write_waiting(const wire::PseudoTerminal& terminal, std::vector<std::uint8_t>& waiting) {
  const auto count = wire::write_available(terminal.device.number(), waiting, terminal.port);
  if (!count) {
    waiting.clear();
    return;
  }
  waiting.erase(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(*count));
  if (waiting.size() > kMostWaiting) {
    waiting.erase(waiting.begin(), waiting.end() - static_cast<std::ptrdiff_t>(kMostWaiting));
  }
}

}  // namespace

PtyEmulator::PtyEmulator(devices::DeviceFile file, std::optional<double> clock, MakeBody make_body)
    : file_(std::move(file)), clock_(clock), make_body_(std::move(make_body)) {}

Result<std::unique_ptr<PtyEmulator>> PtyEmulator::create(devices::DeviceFile file,
                                                         std::optional<double> clock,
                                                         const std::string& first,
                                                         MakeBody make_body) {
  std::unique_ptr<PtyEmulator> emulator(
      new PtyEmulator(std::move(file), clock, std::move(make_body)));
  SOMATO_TRY(auto body, emulator->make_body_(first, 0));
  emulator->body_ = std::make_unique<EmulatedBody>(emulator->file_, std::move(body));
  SOMATO_TRY_VOID(emulator->open_ports());
  return emulator;
}

Result<void> PtyEmulator::open_ports() {
  for (std::size_t i = 0; i < body_->wires().size(); ++i) {
    SOMATO_TRY(auto terminal, wire::open_pseudo_terminal());
    ports_.push_back(terminal.port);
    terminals_.push_back(std::move(terminal));
  }
  waiting_.resize(terminals_.size());
  SOMATO_TRY(placing_, wire::open_pseudo_terminal());
  if (clock_) return {};
  SOMATO_TRY(host_clock_, wire::LineClockPort::open());
  return {};
}

// A simulation that is slower than the clock slows its time down: it never jumps.
double PtyEmulator::passed() {
  const auto now = std::chrono::steady_clock::now();
  const double passed = *clock_ * std::chrono::duration<double>(now - last_).count();
  last_ = now;
  return std::min(passed, kLongestStep);
}

Result<void> PtyEmulator::advance(double now) {
  now_ = now;
  return body_->advance(now_);
}

void PtyEmulator::take_from_host() {
  std::array<std::uint8_t, 4096> bytes{};
  const std::vector<EmulatedWire*> wires = body_->wires();
  for (std::size_t i = 0; i < wires.size(); ++i) {
    const auto read = [&] {
      return wire::read_available(terminals_[i].device.number(), bytes, terminals_[i].port);
    };
    for (auto count = read(); count && *count > 0; count = read()) {
      wires[i]->send(std::span(bytes).first(*count), now_);
    }
  }
}

bool PtyEmulator::has_arrived() const {
  const std::vector<EmulatedWire*> wires = body_->wires();
  return std::any_of(wires.begin(), wires.end(),
                     [](const EmulatedWire* wire) { return wire->has_arrived(); });
}

void PtyEmulator::give_to_host() {
  std::array<std::uint8_t, 4096> bytes{};
  const std::vector<EmulatedWire*> wires = body_->wires();
  for (std::size_t i = 0; i < wires.size(); ++i) {
    while (const std::size_t count = wires[i]->receive(bytes)) {
      waiting_[i].insert(waiting_[i].end(), bytes.begin(),
                         bytes.begin() + static_cast<std::ptrdiff_t>(count));
    }
    write_waiting(terminals_[i], waiting_[i]);
  }
}

std::string PtyEmulator::place(const std::string& line) {
  constexpr std::string_view kPlace = "place ";
  const std::size_t space = line.find(' ', kPlace.size());
  if (!line.starts_with(kPlace) || space == std::string::npos) return "error unknown command";
  const std::size_t trial = std::strtoull(line.c_str() + kPlace.size(), nullptr, 10);
  auto body = make_body_(line.substr(space + 1), trial);
  if (!body) return "error " + to_string(body.error());
  body_->replace(std::move(*body));
  return "placed";
}

void PtyEmulator::handle_placing() {
  std::array<std::uint8_t, 256> bytes{};
  const auto count = wire::read_available(placing_.device.number(), bytes, placing_.port);
  if (!count) return;
  placing_text_.append(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(*count));
  const std::size_t end = placing_text_.find('\n');
  if (end == std::string::npos) return;
  const std::string answer = place(placing_text_.substr(0, end)) + "\n";
  placing_text_.erase(0, end + 1);
  const std::vector<std::uint8_t> text(answer.begin(), answer.end());
  std::ignore = wire::write_available(placing_.device.number(), text, placing_.port);
}

// Until a host sends something, for at most a millisecond. A port without a host would always be
// ready.
void PtyEmulator::wait() const {
  std::vector<pollfd> ports{{placing_.device.number(), POLLIN, 0}};
  if (host_clock_) ports.push_back({host_clock_->descriptor(), POLLIN, 0});
  for (const wire::PseudoTerminal& terminal : terminals_) {
    ports.push_back({terminal.device.number(), POLLIN, 0});
  }
  poll(ports.data(), ports.size(), 0);
  for (pollfd& port : ports) {
    if ((port.revents & POLLHUP) != 0) port.fd = -1;
  }
  poll(ports.data(), ports.size(), kPollMs);
}

Result<void> PtyEmulator::follow_clock() {
  SOMATO_TRY_VOID(advance(now_ + passed()));
  take_from_host();
  give_to_host();
  return {};
}

// The host waits for the answer: neither side acts before the other.
Result<void> PtyEmulator::follow_host() {
  const auto until = host_clock_->requested();
  if (!until) return {};
  take_from_host();
  const double end = std::min(*until, now_ + kLongestAnswer);
  while (now_ < end && !has_arrived()) {
    SOMATO_TRY_VOID(advance(std::min(end, now_ + kTimeStep)));
  }
  give_to_host();
  host_clock_->answer(now_);
  return {};
}

Result<void> PtyEmulator::finish() {
  take_from_host();
  for (const double end = now_ + kLastMoment; now_ < end;) {
    SOMATO_TRY_VOID(advance(now_ + kTimeStep));
  }
  give_to_host();
  return {};
}

Result<void> PtyEmulator::run(const std::function<bool()>& should_continue) {
  last_ = std::chrono::steady_clock::now();
  while (should_continue()) {
    handle_placing();
    SOMATO_TRY_VOID(clock_ ? follow_clock() : follow_host());
    wait();
  }
  return finish();
}

}  // namespace somato::emulation
