#include "hardware/boards/ssc32_board.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "somato/core/check.h"

namespace somato::emulation {
namespace {

constexpr double kSsc32Step = 20'000.0;  // us
constexpr std::uint8_t kCarriageReturn = '\r';

void require_channels(std::span<const int> channels) {
  std::array<bool, wire::kSsc32Channels> seen{};
  for (const int channel : channels) {
    require(channel >= 0 && channel < wire::kSsc32Channels, "a channel is outside 0 to 31");
    require(!std::exchange(seen[static_cast<std::size_t>(channel)], true),
            "a channel is given twice");
  }
}

}  // namespace

Ssc32Board::Ssc32Board(std::vector<int> channels, std::string version)
    : channels_(std::move(channels)), version_(std::move(version)) {
  require_channels(channels_);
}

void Ssc32Board::receive(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    if (!silenced_) take(byte);
  }
}

void Ssc32Board::take(std::uint8_t byte) {
  if (byte == wire::kSsc32Escape) {
    queued_ = 0;
  } else if (byte == kCarriageReturn) {
    take_line();
    queued_ = 0;
  } else {
    if (queued_ < queue_.size()) queue_[queued_] = static_cast<char>(byte);
    ++queued_;
  }
}

// The carriage return occupies a place of the queue too.
void Ssc32Board::take_line() {
  if (queued_ >= queue_.size()) {
    ++overflows_;
  } else if (const auto line = understood_by_ssc32({queue_.data(), queued_})) {
    execute(*line);
  }
}

void Ssc32Board::execute(const Ssc32Line& line) {
  if (line.type == Ssc32Line::Type::kMove) {
    move_group(line);
  } else {
    for (const Ssc32Line::Item& item : line.items) execute_item(line.type, item);
  }
}

void Ssc32Board::execute_item(Ssc32Line::Type type, const Ssc32Line::Item& item) {
  const auto index = static_cast<std::size_t>(item.channel);
  switch (type) {
    case Ssc32Line::Type::kNothing:
    case Ssc32Line::Type::kMove:
      break;
    case Ssc32Line::Type::kOffset:
      state(item.channel).offset = item.value;
      break;
    case Ssc32Line::Type::kOutput:
      outputs_.at(index) = static_cast<std::uint8_t>(item.value);
      break;
    case Ssc32Line::Type::kStop:
      state(item.channel).moves = false;
      break;
    case Ssc32Line::Type::kPulse:
      answer_pulse(item.channel);
      break;
    case Ssc32Line::Type::kAnalog:
      answers_.push_back(analog_.at(index));
      break;
    case Ssc32Line::Type::kDigital:
      answers_.push_back(digital_.at(index) ? '1' : '0');
      break;
    case Ssc32Line::Type::kMoving:
      answer_moving();
      break;
    case Ssc32Line::Type::kVersion:
      answer_version();
      break;
    case Ssc32Line::Type::kWrite:
      ++register_writes_;
      break;
    case Ssc32Line::Type::kBoot:
      silence();
      break;
  }
}

void Ssc32Board::silence() {
  states_ = {};
  silenced_ = true;
}

void Ssc32Board::move_group(const Ssc32Line& line) {
  const double duration = duration_of(line);
  for (Channel& channel : states_) channel.in_last_group = false;
  for (const Ssc32Line::Item& item : line.items) start_move(item, duration);
}

// All channels of a group take as long as the slowest. A channel without pulse has no way to go.
double Ssc32Board::duration_of(const Ssc32Line& line) const {
  double duration = line.milliseconds * 1e3;
  for (const Ssc32Line::Item& item : line.items) {
    const std::optional<double> pulse = state(item.channel).pulse;
    if (!pulse || item.speed == 0 || item.value == 0) continue;
    duration = std::max(duration, std::abs(item.value - *pulse) / item.speed * 1e6);
  }
  return duration;
}

void Ssc32Board::start_move(const Ssc32Line::Item& item, double duration) {
  Channel& channel = state(item.channel);
  const bool jumps = !channel.pulse || item.value == 0;
  channel.from = channel.pulse.value_or(0.0);
  channel.target = item.value;
  channel.begin = now_;
  channel.duration = duration;
  channel.moves = !jumps;
  channel.in_last_group = true;
  if (item.value == 0) {
    channel.pulse.reset();
  } else if (jumps) {
    channel.pulse = item.value;
  }
}

void Ssc32Board::advance(double now, std::vector<std::uint8_t>& sent) {
  require(now * 1e6 >= now_, "the time of an emulated board went back");
  now_ = now * 1e6;
  for (Channel& channel : states_) {
    if (channel.moves) step(channel);
  }
  sent.insert(sent.end(), answers_.begin(), answers_.end());
  answers_.clear();
}

// When the pulses changed last. The addend lets a step take place at its time in spite of rounding.
double Ssc32Board::last_step() const {
  return switched_on_ + std::floor((now_ - switched_on_) / kSsc32Step + 1e-6) * kSsc32Step;
}

void Ssc32Board::step(Channel& channel) const {
  const double elapsed = last_step() - channel.begin;
  if (elapsed < 1.0) return;
  channel.moves = elapsed < channel.duration - 1.0;
  channel.pulse = channel.target;
  if (channel.moves) {
    channel.pulse = channel.from + (channel.target - channel.from) * elapsed / channel.duration;
  }
}

void Ssc32Board::restart() {
  states_ = {};
  outputs_ = {};
  queued_ = 0;
  answers_.clear();
  switched_on_ = now_;
  silenced_ = false;
}

std::optional<double> Ssc32Board::driven_position(std::size_t servo) const {
  const Channel& channel = state(channels_.at(servo));
  if (!channel.pulse) return {};
  return *channel.pulse + channel.offset;
}

void Ssc32Board::set_measured(std::size_t /*servo*/, double /*position*/, double /*current*/) {}

void Ssc32Board::answer_pulse(int channel) {
  const double tens = std::floor(state(channel).pulse.value_or(0.0) / 10.0);
  answers_.push_back(static_cast<std::uint8_t>(tens));
}

void Ssc32Board::answer_moving() {
  const bool moving = std::any_of(states_.begin(), states_.end(), [](const Channel& channel) {
    return channel.in_last_group && channel.moves;
  });
  answers_.push_back(moving ? '+' : '.');
}

void Ssc32Board::answer_version() {
  answers_.insert(answers_.end(), version_.begin(), version_.end());
  answers_.push_back(kCarriageReturn);
}

}  // namespace somato::emulation
