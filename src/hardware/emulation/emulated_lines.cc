#include "hardware/emulation/emulated_lines.h"

#include <algorithm>

namespace somato::emulation {
namespace {

tl::unexpected<Error> hung_up() {
  return fail(ErrorKind::kSystem, "the line has hung up", {},
              "check the cable and the power of the device");
}

}  // namespace

Result<std::size_t> EmulatedLines::read(std::size_t line, std::span<std::uint8_t> bytes) {
  if (wires_.at(line)->faults.hung_up) return hung_up();
  return wires_[line]->receive(bytes);
}

Result<std::size_t> EmulatedLines::write(std::size_t line, std::span<const std::uint8_t> bytes) {
  if (wires_.at(line)->faults.hung_up) return hung_up();
  return wires_[line]->send(bytes, now_);
}

bool EmulatedLines::has_news() const {
  return std::any_of(wires_.begin(), wires_.end(), [](const EmulatedWire* wire) {
    return wire->faults.hung_up || wire->has_arrived();
  });
}

void EmulatedLines::wait(double until) {
  while (now_ < until) {
    now_ = std::min(until, now_ + kTimeStep);
    if (world_) world_(now_);
    for (EmulatedWire* wire : wires_) wire->advance(now_);
    if (has_news()) return;
  }
}

Result<void> EmulatedLines::reopen(std::size_t line) {
  if (wires_.at(line)->faults.hung_up) return hung_up();
  return {};
}

}  // namespace somato::emulation
