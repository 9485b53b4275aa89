#include "hardware/emulation/emulated_wire.h"

#include <algorithm>

namespace somato::emulation {
namespace {

constexpr std::size_t kBuffer = 4096;
constexpr double kBitsPerByte = 10.0;

}  // namespace

EmulatedWire::EmulatedWire(EmulatedBoard& board, double baud, std::uint64_t seed)
    : board_(board), baud_(baud), random_(seed, Stream::kHandSensors) {}

std::size_t EmulatedWire::send(std::span<const std::uint8_t> bytes, double now) {
  const std::size_t room = kBuffer - std::min(kBuffer, to_board_.bytes.size());
  const std::span<const std::uint8_t> taken = bytes.first(std::min(bytes.size(), room));
  put(to_board_, taken, now);
  if (faults.echo) put(to_host_, taken, now);
  return taken.size();
}

void EmulatedWire::put(Way& way, std::span<const std::uint8_t> bytes, double now) {
  const double each = baud_ > 0.0 ? kBitsPerByte / baud_ * faults.slowness : 0.0;
  way.free = std::max(way.free, now);
  for (std::uint8_t byte : bytes) {
    if (faults.flipped > 0.0 && random_.uniform() < faults.flipped) {
      byte ^= static_cast<std::uint8_t>(1U << static_cast<unsigned>(8.0 * random_.uniform()));
    }
    way.free += each;
    way.bytes.push_back({way.free, byte});
  }
}

std::vector<std::uint8_t> EmulatedWire::take(Way& way, double now) {
  std::vector<std::uint8_t> bytes;
  while (!way.bytes.empty() && way.bytes.front().arrival <= now) {
    bytes.push_back(way.bytes.front().value);
    way.bytes.pop_front();
  }
  return bytes;
}

void EmulatedWire::advance(double now) {
  const std::vector<std::uint8_t> from_host = take(to_board_, now);
  if (!from_host.empty() && !faults.deaf && !faults.hung_up) board_.receive(from_host);
  std::vector<std::uint8_t> sent;
  board_.advance(now, sent);
  put(to_host_, faults.garbage, now);
  faults.garbage.clear();
  if (!faults.silent) put(to_host_, sent, now);
  const std::vector<std::uint8_t> bytes = take(to_host_, now);
  if (!faults.hung_up) arrived_.insert(arrived_.end(), bytes.begin(), bytes.end());
}

std::size_t EmulatedWire::receive(std::span<std::uint8_t> bytes) {
  const std::size_t count = std::min(bytes.size(), arrived_.size());
  const auto end = arrived_.begin() + static_cast<std::ptrdiff_t>(count);
  std::copy(arrived_.begin(), end, bytes.begin());
  arrived_.erase(arrived_.begin(), end);
  return count;
}

}  // namespace somato::emulation
