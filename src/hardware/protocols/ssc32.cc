#include "hardware/protocols/ssc32.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>

#include "hardware/protocols/ssc32_tokens.h"

namespace somato::wire {
namespace {

constexpr int kMostOffset = 100;          // us
constexpr int kMostSpeedOrTime = 65'535;  // us/s or ms

// A command, or the part of a line for one channel.
class Ssc32Text {
 public:
  Ssc32Text& add(std::string_view text) {
    std::copy(text.begin(), text.end(), characters_.begin() + size_);
    size_ += text.size();
    return *this;
  }

  Ssc32Text& add(int number) {
    char* const end = characters_.data() + characters_.size();
    const char* const written = std::to_chars(characters_.data() + size_, end, number).ptr;
    size_ = static_cast<std::size_t>(written - characters_.data());
    return *this;
  }

  std::string_view view() const { return {characters_.data(), size_}; }

 private:
  std::array<char, 40> characters_{};
  std::size_t size_ = 0;
};

auto refused(std::string what) {
  return fail(ErrorKind::kUsage, std::move(what), "SSC-32");
}

Result<void> check_channel(std::optional<int> channel) {
  if (channel && *channel >= 0 && *channel < kSsc32Channels) return {};
  return refused(channel ? fmt::format("channel {} is outside 0 to 31", *channel)
                         : "a channel has no number");
}

Result<void> check_pulse(std::optional<int> pulse) {
  if (pulse && *pulse >= kSsc32LeastPulse && *pulse <= kSsc32MostPulse) return {};
  return refused(pulse ? fmt::format("a pulse of {} us is outside 500 to 2500 us", *pulse)
                       : "a pulse has no number");
}

Result<void> check_offset(std::optional<int> offset) {
  if (offset && *offset >= -kMostOffset && *offset <= kMostOffset) return {};
  return refused(offset ? fmt::format("an offset of {} us is outside -100 to 100 us", *offset)
                        : "an offset has no number");
}

Result<void> check_speed_or_time(std::optional<int> number) {
  if (number && *number >= 0 && *number <= kMostSpeedOrTime) return {};
  return refused("a speed or time is outside 0 to 65535");
}

Result<void> check_move(const Ssc32Move& move) {
  SOMATO_TRY_VOID(check_channel(move.channel));
  SOMATO_TRY_VOID(check_pulse(move.pulse));
  return check_speed_or_time(move.speed);
}

Result<void> check_group(std::span<const Ssc32Move> moves) {
  std::uint32_t seen = 0;
  for (const Ssc32Move& move : moves) {
    SOMATO_TRY_VOID(check_move(move));
    const std::uint32_t bit = std::uint32_t{1} << static_cast<unsigned>(move.channel);
    if (seen & bit) return refused(fmt::format("channel {} is in the group twice", move.channel));
    seen |= bit;
  }
  return {};
}

Ssc32Text text_of(const Ssc32Move& move) {
  Ssc32Text text;
  text.add("#").add(move.channel).add("P").add(move.pulse);
  if (move.speed > 0) text.add("S").add(move.speed);
  return text;
}

bool silences_or_wears(std::string_view name) {
  return name.find("GOBOOT") != std::string_view::npos || name.starts_with("EE") ||
         (name.starts_with("R") && name.size() > 1);
}

Result<void> check_token(const Ssc32Token& token) {
  const std::string_view name = token.name();
  if (name == "#" || name == "STOP" || name == "QP") return check_channel(token.number);
  if (name == "P" && token.number != 0) return check_pulse(token.number);
  if (name == "PO") return check_offset(token.number);
  if (name == "S" || name == "T") return check_speed_or_time(token.number);
  if (name == "=") return refused("writing a register wears the board's memory");
  if (!silences_or_wears(name)) return {};
  return refused(fmt::format("{} silences the board or wears its memory", name));
}

}  // namespace

Result<void> Ssc32Commands::put(std::string_view text) {
  if (size_ + text.size() > kCapacity) return refused("the commands exceed the memory for them");
  std::copy(text.begin(), text.end(), bytes_.begin() + size_);
  size_ += text.size();
  return {};
}

Result<void> Ssc32Commands::put_group(std::span<const Ssc32Move> moves, std::string_view ending) {
  std::size_t begin = size_;
  for (const Ssc32Move& move : moves) {
    const Ssc32Text text = text_of(move);
    if (size_ - begin + text.view().size() + ending.size() > kSsc32Queue) {
      SOMATO_TRY_VOID(put(ending));
      begin = size_;
    }
    SOMATO_TRY_VOID(put(text.view()));
  }
  return put(ending);
}

Result<void> Ssc32Commands::move(std::span<const Ssc32Move> moves, int milliseconds) {
  SOMATO_TRY_VOID(check_group(moves));
  SOMATO_TRY_VOID(check_speed_or_time(milliseconds));
  if (moves.empty()) return {};
  Ssc32Text ending;
  if (milliseconds > 0) ending.add("T").add(milliseconds);
  const std::size_t before = size_;
  Result<void> done = put_group(moves, ending.add("\r").view());
  if (!done) size_ = before;
  return done;
}

Result<void> Ssc32Commands::put_for_channel(std::string_view before, int channel,
                                            std::string_view after) {
  SOMATO_TRY_VOID(check_channel(channel));
  return put(Ssc32Text().add(before).add(channel).add(after).view());
}

Result<void> Ssc32Commands::stop(int channel) {
  return put_for_channel("STOP", channel, "\r");
}

Result<void> Ssc32Commands::pulse_off(int channel) {
  return put_for_channel("#", channel, "P0\r");
}

Result<void> Ssc32Commands::offset(int channel, int microseconds) {
  SOMATO_TRY_VOID(check_offset(microseconds));
  return put_for_channel("#", channel, Ssc32Text().add("PO").add(microseconds).add("\r").view());
}

Result<void> Ssc32Commands::query_moving() {
  return put("Q\r");
}

Result<void> Ssc32Commands::query_pulse(int channel) {
  return put_for_channel("QP", channel, "\r");
}

Result<void> Ssc32Commands::query_version() {
  return put("VER\r");
}

Result<void> Ssc32Commands::resynchronize() {
  return put("\x1B\r");
}

Result<void> Ssc32Commands::line(std::string_view text) {
  if (text.size() + 1 > kSsc32Queue) return refused("the line exceeds the board's receive queue");
  const std::optional<Ssc32Tokens> tokens = Ssc32Tokens::of(text);
  if (!tokens) return refused("the line contains what the board does not read");
  for (const Ssc32Token& token : tokens->all()) SOMATO_TRY_VOID(check_token(token));
  if (size_ + text.size() + 1 > kCapacity) return refused("the commands exceed their memory");
  SOMATO_TRY_VOID(put(text));
  return put("\r");
}

std::optional<bool> ssc32_moving(std::uint8_t byte) {
  if (byte == '.') return false;
  if (byte == '+') return true;
  return {};
}

std::optional<int> ssc32_pulse(std::uint8_t byte) {
  const int pulse = byte * 10;
  if (pulse == 0 || (pulse >= kSsc32LeastPulse && pulse <= kSsc32MostPulse)) return pulse;
  return {};
}

bool Ssc32Version::take(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    if (!complete_) add(byte);
  }
  return complete_;
}

void Ssc32Version::add(std::uint8_t byte) {
  if (byte == '\r') {
    complete_ = true;
    return;
  }
  const bool printable = byte >= ' ' && byte <= '~';
  unreadable_ = unreadable_ || !printable;
  if (size_ < text_.size()) text_[size_++] = printable ? static_cast<char>(byte) : '?';
}

}  // namespace somato::wire
