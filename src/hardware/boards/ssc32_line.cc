#include "hardware/boards/ssc32_line.h"

#include <algorithm>
#include <array>

#include "hardware/protocols/ssc32.h"
#include "hardware/protocols/ssc32_tokens.h"

namespace somato::emulation {
namespace {

using Type = Ssc32Line::Type;
using wire::Ssc32Token;

bool is_within(std::optional<int> number, int least, int most) {
  return number && *number >= least && *number <= most;
}

int clipped_pulse(int pulse) {
  return pulse == 0 ? 0 : std::clamp(pulse, wire::kSsc32LeastPulse, wire::kSsc32MostPulse);
}

// Reads one token after the other; each function returns whether the board understands it.
class Ssc32Reader {
 public:
  bool take(const Ssc32Token& token) {
    if (token.name() == "#") return take_channel(token);
    if (token.name() == "R") return take_register(token);
    if (token.name() == "=") return take_write(token);
    return take_for_channel(token) || take_numbered(token) || take_plain(token);
  }

  Ssc32Line& line() { return line_; }

 private:
  bool add(Type type, int channel, int value) {
    if (line_.type != type) line_ = {type, {}, 0};
    line_.items.push_back({channel, value, 0});
    return true;
  }

  bool take_channel(const Ssc32Token& token) {
    channel_ = token.number;
    return is_within(channel_, 0, wire::kSsc32Channels - 1);
  }

  bool take_register(const Ssc32Token& token) {
    register_ = token.number;
    return register_.has_value();
  }

  bool take_write(const Ssc32Token& token) {
    return register_ && token.number && add(Type::kWrite, *register_, *token.number);
  }

  // P, L, PO and : belong to the channel before them, S and T to the P before them.
  bool take_for_channel(const Ssc32Token& token) {
    if (token.name() == "S" || token.name() == "T") return take_speed_or_time(token);
    if (!channel_) return false;
    if (token.name() == "P") return token.number && take_pulse(*token.number);
    if (token.name() == "L") return !token.number && take_pulse(0);
    if (token.name() == "PO") return take_offset(token);
    return token.name() == ":" && take_output(token);
  }

  bool take_pulse(int pulse) { return add(Type::kMove, *channel_, clipped_pulse(pulse)); }

  bool take_offset(const Ssc32Token& token) {
    return is_within(token.number, -100, 100) && add(Type::kOffset, *channel_, *token.number);
  }

  bool take_output(const Ssc32Token& token) {
    return *channel_ < 4 && is_within(token.number, 0, 255) &&
           add(Type::kOutput, *channel_, *token.number);
  }

  bool take_speed_or_time(const Ssc32Token& token) {
    if (line_.type != Type::kMove || !is_within(token.number, 0, 65'535)) return false;
    (token.name() == "S" ? line_.items.back().speed : line_.milliseconds) = *token.number;
    return true;
  }

  bool take_numbered(const Ssc32Token& token) {
    if (!is_within(token.number, 0, wire::kSsc32Channels - 1)) return false;
    if (token.name() == "STOP") return add(Type::kStop, *token.number, 0);
    return token.name() == "QP" && add(Type::kPulse, *token.number, 0);
  }

  bool take_plain(const Ssc32Token& token) {
    constexpr std::array kAnalog{"VA", "VB", "VC", "VD"};
    constexpr std::array kDigital{"A", "B", "C", "D"};
    if (token.number) return false;
    for (int input = 0; input < 4; ++input) {
      const auto index = static_cast<std::size_t>(input);
      if (token.name() == kAnalog[index]) return add(Type::kAnalog, input, 0);
      if (token.name() == kDigital[index]) return add(Type::kDigital, input, 0);
    }
    return take_word(token);
  }

  bool take_word(const Ssc32Token& token) {
    if (token.name() == "Q") return add(Type::kMoving, 0, 0);
    if (token.name() == "VER") return add(Type::kVersion, 0, 0);
    return token.name() == "GOBOOT" && add(Type::kBoot, 0, 0);
  }

  Ssc32Line line_;
  std::optional<int> channel_;
  std::optional<int> register_;
};

}  // namespace

std::optional<Ssc32Line> understood_by_ssc32(std::string_view text) {
  const std::optional<wire::Ssc32Tokens> tokens = wire::Ssc32Tokens::of(text);
  if (!tokens) return {};
  Ssc32Reader reader;
  for (const Ssc32Token& token : tokens->all()) {
    if (!reader.take(token)) return {};
  }
  return std::move(reader.line());
}

}  // namespace somato::emulation
