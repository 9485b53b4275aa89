#include "hardware/buses/ssc32_bus.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "somato/core/check.h"

namespace somato::devices {
namespace {

constexpr double kNoPulse = std::numeric_limits<double>::quiet_NaN();
constexpr double kSsc32Timeout = 0.2;  // s; the board answers within some ms
constexpr std::size_t kSsc32Attempts = 3;
constexpr int kMostMilliseconds = 65'535;

std::vector<int> checked_channels(std::vector<int> channels) {
  require(!channels.empty(), "an SSC-32 without channels");
  std::array<bool, wire::kSsc32Channels> seen{};
  for (const int channel : channels) {
    require(channel >= 0 && channel < wire::kSsc32Channels, "a channel is outside 0 to 31");
    require(!std::exchange(seen[static_cast<std::size_t>(channel)], true),
            "a channel is given twice");
  }
  return channels;
}

// Empty: the protocol cannot express the position.
std::optional<int> pulse_of(double position) {
  const double rounded = std::round(position);
  const bool fits = rounded >= wire::kSsc32LeastPulse && rounded <= wire::kSsc32MostPulse;
  if (!fits) return {};  // NaN does not.
  return static_cast<int>(rounded);
}

int milliseconds_of(double seconds) {
  return static_cast<int>(std::clamp(std::round(seconds * 1e3), 1.0, double{kMostMilliseconds}));
}

double position_of(int pulse) {
  return pulse == 0 ? kNoPulse : pulse;
}

auto no_ssc32(ErrorKind kind, std::string what, std::string advice) {
  return fail(kind, std::move(what), "SSC-32", std::move(advice));
}

auto nothing_answers() {
  return no_ssc32(ErrorKind::kSystem, "nothing answers",
                  "check the port, the cable, the board's power supply and its baud rate");
}

auto unreadable() {
  return no_ssc32(ErrorKind::kSystem, "the answer is unreadable",
                  "the baud rate differs from that of the board's jumpers");
}

Result<void> check_text(const wire::Ssc32Version& version) {
  if (version.unreadable()) return unreadable();
  if (version.text().starts_with("SSC32")) return {};
  return no_ssc32(ErrorKind::kData, fmt::format("the device answers '{}'", version.text()),
                  "another device is at this port");
}

}  // namespace

Ssc32Bus::Ssc32Bus(std::vector<int> channels)
    : ServoBus(channels.size()),
      channels_(checked_channels(std::move(channels))),
      sent_(channels_.size()) {
  moves_.reserve(channels_.size());
  bool fits = relax_.resynchronize().has_value();
  for (const int channel : channels_) fits = fits && relax_.pulse_off(channel).has_value();
  SOMATO_ASSERT(fits);
}

Result<void> Ssc32Bus::start(wire::Exchange& exchange) {
  state_ = State::kIdle;
  answers_ = 0;
  resynchronizations_ = 0;
  unmoved_ = 0.0;
  is_unheard_ = false;
  std::fill(sent_.begin(), sent_.end(), std::nullopt);
  SOMATO_TRY_VOID(check_version(exchange));
  return read_pulses(exchange);
}

// The first attempts may read the rest of older answers; then the last text counts.
Result<void> Ssc32Bus::check_version(wire::Exchange& exchange) {
  commands_.clear();
  SOMATO_TRY_VOID(commands_.resynchronize());
  SOMATO_TRY_VOID(commands_.query_version());
  wire::Ssc32Version version;
  for (std::size_t attempt = 0; attempt < kSsc32Attempts; ++attempt) {
    wire::Ssc32Version text;
    SOMATO_TRY_VOID(exchange.request(commands_.bytes(), kSsc32Timeout, 1,
                                     [&](auto bytes) { return text.take(bytes); }));
    if (text.complete() && check_text(text)) return {};
    if (text.complete() || !text.text().empty()) version = text;
  }
  if (version.unreadable()) return unreadable();
  if (!version.complete() && version.text().empty()) return nothing_answers();
  return check_text(version);
}

Result<int> Ssc32Bus::read_pulse(wire::Exchange& exchange, int channel) {
  commands_.clear();
  SOMATO_TRY_VOID(commands_.resynchronize());
  SOMATO_TRY_VOID(commands_.query_pulse(channel));
  std::optional<int> pulse;
  const auto take = [&](std::span<const std::uint8_t> bytes) {
    pulse = bytes.size() == 1 ? wire::ssc32_pulse(bytes.front()) : std::nullopt;
    return pulse.has_value();
  };
  SOMATO_TRY_VOID(exchange.request(commands_.bytes(), kSsc32Timeout, kSsc32Attempts, take));
  if (pulse) return *pulse;
  return no_ssc32(ErrorKind::kSystem,
                  fmt::format("the board does not state the pulse of channel {}", channel),
                  "check the cable and the board's power supply; the firmware must know QP");
}

Result<void> Ssc32Bus::read_pulses(wire::Exchange& exchange) {
  for (std::size_t servo = 0; servo < channels_.size(); ++servo) {
    SOMATO_TRY(const int pulse, read_pulse(exchange, channels_[servo]));
    reports_[servo].position = position_of(pulse);
    reports_[servo].error = 0;
  }
  for (ServoReport& report : reports_) report.time = exchange.now();
  return {};
}

std::span<const std::uint8_t> Ssc32Bus::tick(std::span<const double> positions, double seconds) {
  require(positions.size() == channels_.size(), "as many positions as servos are required");
  require(seconds > 0.0, "a tick has a positive duration");
  commands_.clear();
  has_moved_ = false;
  waited_ += seconds;
  unmoved_ += seconds;
  if (state_ == State::kAnswered) take_answer();
  if (state_ == State::kAsked && waited_ > kPatience) state_ = State::kFailed;
  if (state_ == State::kQuiet && waited_ > kQuiet) state_ = State::kIdle;
  if (state_ == State::kFailed) resynchronize();
  if (state_ != State::kIdle) return commands_.bytes();
  query();  // before the moves, so that the answer shows a board that restarted
  if (!has_restarted() && !is_unheard_) add_moves(positions, std::exchange(unmoved_, 0.0));
  return commands_.bytes();
}

void Ssc32Bus::add_moves(std::span<const double> positions, double seconds) {
  moves_.clear();
  for (std::size_t servo = 0; servo < channels_.size(); ++servo) {
    const std::optional<int> pulse = pulse_of(positions[servo]);
    if (pulse && pulse != sent_[servo]) moves_.push_back({channels_[servo], *pulse, 0});
    sent_[servo] = pulse;
  }
  SOMATO_ASSERT(commands_.move(moves_, milliseconds_of(seconds)).has_value());
  has_moved_ = true;
}

void Ssc32Bus::query() {
  queried_ = (queried_ + 1) % channels_.size();
  SOMATO_ASSERT(commands_.query_pulse(channels_[queried_]).has_value());
  state_ = State::kAsked;
  waited_ = 0.0;
}

// The board may not have understood the last lines, so every position is sent anew.
void Ssc32Bus::resynchronize() {
  SOMATO_ASSERT(commands_.resynchronize().has_value());
  std::fill(sent_.begin(), sent_.end(), std::nullopt);
  state_ = State::kQuiet;
  is_unheard_ = true;
  waited_ = 0.0;
  ++resynchronizations_;
}

void Ssc32Bus::receive(std::span<const std::uint8_t> bytes, double now) {
  for (const std::uint8_t byte : bytes) take(byte, now);
}

void Ssc32Bus::take(std::uint8_t byte, double now) {
  if (state_ == State::kQuiet) return;
  const std::optional<int> pulse = wire::ssc32_pulse(byte);
  if (state_ == State::kAsked && pulse) {
    answer_ = *pulse;
    answer_time_ = now;
    state_ = State::kAnswered;
  } else {
    state_ = State::kFailed;
  }
}

bool Ssc32Bus::has_restarted() const {
  return std::any_of(reports_.begin(), reports_.end(),
                     [](const ServoReport& report) { return report.error != 0; });
}

void Ssc32Bus::take_answer() {
  state_ = State::kIdle;
  is_unheard_ = false;
  ++answers_;
  ServoReport& report = reports_[queried_];
  if (answer_ == 0 && !std::isnan(report.position)) report.error = kRestarted;
  report.position = position_of(answer_);
  if (answer_ == 0) sent_[queried_].reset();
  for (ServoReport& each : reports_) each.time = answer_time_;
}

Error Ssc32Bus::explain(std::uint8_t /*error*/) const {
  return {ErrorKind::kSystem,
          "has lost its pulse: the controller has restarted",
          {},
          "check the supply of the controller and of the servos: its voltage drops if they draw "
          "too much current"};
}

std::size_t Ssc32Bus::bytes_per_tick() const {
  wire::Ssc32Commands longest;
  std::vector<wire::Ssc32Move> moves;
  moves.reserve(channels_.size());
  for (const int channel : channels_) moves.push_back({channel, wire::kSsc32MostPulse, 0});
  SOMATO_ASSERT(longest.move(moves, kMostMilliseconds).has_value());
  return longest.bytes().size() + std::size_t{5} + 1;  // "QP31", CR and its answer
}

}  // namespace somato::devices
