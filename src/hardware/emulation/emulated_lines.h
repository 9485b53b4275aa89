#pragma once

#include <functional>
#include <vector>

#include "hardware/emulation/emulated_wire.h"
#include "hardware/lines/lines.h"

namespace somato::emulation {

/// Emulated boards as the lines of a host in the same process. Time passes only while the host
/// waits, so that the same program always gives the same result, at any speed of the machine.
class EmulatedLines : public wire::Lines {
 public:
  /// The wires, in the order of their numbers, must outlive it. `world` is called with the time
  /// after each millisecond, before the wires advance.
  EmulatedLines(std::vector<EmulatedWire*> wires, std::function<void(double now)> world)
      : wires_(std::move(wires)), world_(std::move(world)) {}

  double now() const override { return now_; }
  Result<std::size_t> read(std::size_t line, std::span<std::uint8_t> bytes) override;
  Result<std::size_t> write(std::size_t line, std::span<const std::uint8_t> bytes) override;
  void wait(double until) override;
  Result<void> reopen(std::size_t line) override;

 private:
  bool has_news() const;

  std::vector<EmulatedWire*> wires_;
  std::function<void(double now)> world_;
  double now_ = 0.0;
};

}  // namespace somato::emulation
