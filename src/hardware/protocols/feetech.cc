#include "hardware/protocols/feetech.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "somato/core/check.h"

namespace somato::wire {
namespace {

constexpr std::size_t kFeetechFixedSize = 6;  // of a packet without parameters
constexpr std::size_t kFeetechLongestLength = 0xFF;

std::uint8_t feetech_sum(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint8_t>(~std::accumulate(bytes.begin(), bytes.end(), 0U));
}

// Where two bytes FF and an id begin, or what may become them.
std::size_t find_feetech_start(std::span<const std::uint8_t> bytes) {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const bool second = i + 1 == bytes.size() || bytes[i + 1] == 0xFF;
    const bool third = i + 2 >= bytes.size() || bytes[i + 2] != 0xFF;
    if (bytes[i] == 0xFF && second && third) return i;
  }
  return bytes.size();
}

}  // namespace

std::uint16_t feetech_word(std::span<const std::uint8_t> bytes, ByteOrder order) {
  const bool low_first = order == ByteOrder::kLowFirst;
  const unsigned low = bytes[low_first ? 0 : 1];
  const unsigned high = bytes[low_first ? 1 : 0];
  return static_cast<std::uint16_t>(high << 8 | low);
}

int feetech_signed(std::uint16_t word) {
  const int size = word & ~feetech::kNegative;
  return (word & feetech::kNegative) != 0 ? -size : size;
}

std::uint16_t feetech_unsigned(int value) {
  const int size = std::min(std::abs(value), 0x7FFF);
  return static_cast<std::uint16_t>(value < 0 ? size | feetech::kNegative : size);
}

void FeetechWriter::append_header(std::uint8_t id) {
  for (const std::uint8_t byte : {std::uint8_t{0xFF}, std::uint8_t{0xFF}, id}) append(byte);
  append(0);
}

void FeetechWriter::complete() {
  const auto bytes = packet();
  const std::size_t length = bytes.size() - 3;  // code, parameters and sum
  require(length <= kFeetechLongestLength, "the packet is too long");
  bytes[3] = static_cast<std::uint8_t>(length);
  append(feetech_sum(bytes.subspan(2)));
}

void FeetechWriter::status(std::uint8_t id, std::uint8_t error,
                           std::span<const std::uint8_t> parameters) {
  begin(id, error);
  put(parameters);
  end();
}

void FeetechDecoder::expect_echo(std::span<const std::uint8_t> sent) {
  echo_.clear();
  echo_.put(sent);
}

void FeetechDecoder::clear() {
  buffer_.clear();
  echo_.clear();
}

// The size of the complete packet at the beginning of the buffer; nothing if more must arrive.
std::optional<std::size_t> FeetechDecoder::complete() {
  for (;;) {
    buffer_.drop(find_feetech_start(buffer_.bytes()));
    const auto bytes = buffer_.bytes();
    if (bytes.size() < 4) return std::nullopt;
    const std::size_t size = bytes[3] + std::size_t{4};
    const std::size_t most = bytes[2] == kEveryone ? kLongest : longest_;
    const bool possible = size >= kFeetechFixedSize && size <= most;
    if (possible && bytes.size() < size) return std::nullopt;
    if (possible && feetech_sum(bytes.subspan(2, size - 3)) == bytes[size - 1]) return size;
    buffer_.drop(1);
  }
}

// Whether the packet at the beginning of the buffer is one of those that were sent. The echo of
// those before it was lost then.
bool FeetechDecoder::skip_echo(std::size_t size) {
  const auto packet = buffer_.bytes().first(size);
  auto sent = echo_.bytes();
  while (sent.size() >= kFeetechFixedSize) {
    const std::size_t sent_size = std::min(sent[3] + std::size_t{4}, sent.size());
    const auto candidate = sent.first(sent_size);
    sent = sent.subspan(sent_size);
    if (!std::equal(packet.begin(), packet.end(), candidate.begin(), candidate.end())) continue;
    echo_.drop(echo_.bytes().size() - sent.size());
    buffer_.drop(size);
    return true;
  }
  return false;
}

std::optional<Packet> FeetechDecoder::next() {
  for (;;) {
    const auto size = complete();
    if (!size) return std::nullopt;
    if (skip_echo(*size)) continue;
    std::copy_n(buffer_.bytes().begin(), *size, body_.begin());
    buffer_.drop(*size);
    const auto parameters =
        std::span<const std::uint8_t>(body_).subspan(5, *size - kFeetechFixedSize);
    return Packet{body_[2], static_cast<PacketInstruction>(body_[4]), body_[4], parameters};
  }
}

}  // namespace somato::wire
