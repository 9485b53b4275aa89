#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <vector>

#include "hardware/boards/ssc32_board.h"
#include "hardware/protocols/anyskin_frame.h"
#include "hardware/protocols/number_line.h"
#include "hardware/protocols/sensor_frame.h"
#include "hardware/protocols/ssc32.h"
#include "somato/core/check.h"

namespace {

using Bytes = std::span<const std::uint8_t>;

bool same(std::span<const float> a, std::span<const float> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

template <typename Decoder>
void expect_same(Decoder decoder, Bytes bytes, std::span<const float> values) {
  bool complete = false;
  for (const std::uint8_t byte : bytes) complete = decoder.take(byte);
  SOMATO_ASSERT(complete);
  SOMATO_ASSERT(same(decoder.values(), values));
}

// An accepted frame has no infinite value, and reads back when it is written after the end of a
// frame or line.
template <typename Decoder, typename Encode>
void expect_round_trips(const Decoder& fresh, Bytes ending, Bytes stream, const Encode& encode) {
  Decoder decoder = fresh;
  std::vector<std::uint8_t> bytes(ending.size() + 1000);
  std::copy(ending.begin(), ending.end(), bytes.begin());
  for (const std::uint8_t byte : stream) {
    if (!decoder.take(byte)) continue;
    for (const float value : decoder.values()) SOMATO_ASSERT(!std::isinf(value));
    const std::size_t size = encode(decoder.values(), std::span(bytes).subspan(ending.size()));
    expect_same(fresh, std::span(bytes).first(ending.size() + size), decoder.values());
  }
}

void sensor_frames(Bytes stream) {
  somato::wire::SensorFrameDecoder decoder(3);
  std::array<std::uint8_t, 64> bytes{};
  for (const std::uint8_t byte : stream) {
    if (!decoder.take(byte)) continue;
    const auto frame = decoder.frame();
    somato::wire::SensorFrameDecoder again(3);
    bool complete = false;
    const std::size_t size = somato::wire::encode_sensor_frame(frame, bytes);
    for (std::size_t i = 0; i < size; ++i) complete = again.take(bytes[i]);
    SOMATO_ASSERT(complete && same(again.frame().values, frame.values));
    SOMATO_ASSERT(again.frame().sequence == frame.sequence);
  }
}

void anyskin_frames(Bytes stream) {
  constexpr std::array<std::uint8_t, 2> kEnding{'\r', '\n'};
  expect_round_trips(somato::wire::AnySkinDecoder(1), kEnding, stream,
                     somato::wire::encode_anyskin_frame);
}

void number_lines(Bytes stream) {
  constexpr std::array<std::uint8_t, 1> kEnding{'\n'};
  expect_round_trips(somato::wire::NumberLineDecoder(3), kEnding, stream,
                     somato::wire::encode_number_line);
}

void version(Bytes stream) {
  somato::wire::Ssc32Version version;
  version.take(stream);
  for (const char c : version.text()) SOMATO_ASSERT(c >= ' ' && c <= '~');
}

// A line that is accepted for sending neither silences the board nor wears it.
void commands(Bytes stream) {
  somato::wire::Ssc32Commands commands;
  const std::string_view text(reinterpret_cast<const char*>(stream.data()), stream.size());
  const bool accepted = commands.line(text).has_value();
  SOMATO_ASSERT(accepted != commands.bytes().empty());
  somato::emulation::Ssc32Board board({0, 1});
  board.receive(commands.bytes());
  SOMATO_ASSERT(!board.silenced() && board.register_writes() == 0 && board.overflows() == 0);
}

// The board drives no pulse outside its range, whatever it receives.
void board(Bytes stream) {
  somato::emulation::Ssc32Board board({0, 1});
  std::vector<std::uint8_t> sent;
  double now = 0.0;
  for (const std::uint8_t byte : stream) {
    board.receive(std::span(&byte, 1));
    board.advance(now += 0.005, sent);
    for (std::size_t servo = 0; servo < 2; ++servo) {
      const double pulse = board.driven_position(servo).value_or(1500.0);
      SOMATO_ASSERT(pulse >= 400.0 && pulse <= 2600.0);  // With an offset of up to 100 us.
    }
  }
}

}  // namespace

// The first byte chooses a decoder, the others are what it receives.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::array kDecoders{sensor_frames, anyskin_frames, number_lines,
                                 version,       commands,       board};
  if (size == 0) return 0;
  kDecoders[data[0] % kDecoders.size()](Bytes(data + 1, size - 1));
  return 0;
}
