#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hardware/boards/emulated_board.h"
#include "hardware/lines/lines.h"

namespace somato::testing {

/// One line to an emulated board in the same process. Time passes only in wait(), by at most a
/// millisecond at once.
class EmulatedLine : public wire::Lines {
 public:
  explicit EmulatedLine(emulation::EmulatedBoard& board) : board_(board) {}

  double now() const override { return now_; }

  Result<std::size_t> read(std::size_t /*line*/, std::span<std::uint8_t> bytes) override {
    const std::size_t count = std::min(bytes.size(), arrived_.size());
    std::copy_n(arrived_.begin(), count, bytes.begin());
    arrived_.erase(arrived_.begin(), arrived_.begin() + static_cast<std::ptrdiff_t>(count));
    return count;
  }

  Result<std::size_t> write(std::size_t /*line*/, std::span<const std::uint8_t> bytes) override {
    written_.insert(written_.end(), bytes.begin(), bytes.end());
    if (is_connected) board_.receive(bytes);
    return bytes.size();
  }

  void wait(double until) override {
    constexpr double kStep = 0.001;
    do {
      now_ = std::min(until, now_ + kStep);
      board_.advance(now_, arrived_);
    } while (now_ < until && arrived_.empty());
  }

  Result<void> reopen(std::size_t /*line*/) override { return {}; }

  /// Whether the board receives what is written.
  bool is_connected = true;

  /// All bytes written so far.
  std::span<const std::uint8_t> written() const { return written_; }

 private:
  emulation::EmulatedBoard& board_;
  double now_ = 0.0;
  std::vector<std::uint8_t> arrived_;
  std::vector<std::uint8_t> written_;
};

}  // namespace somato::testing
