#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hardware/boards/emulated_board.h"
#include "hardware/lines/lines.h"

namespace somato::testing {

/// One emulated board at line 0, without transmission times. Time passes only in wait(), and ends
/// early when the board has sent something.
class BoardLine : public wire::Lines {
 public:
  explicit BoardLine(emulation::EmulatedBoard& board) : board_(board) {}

  /// All that was written, and all that the board has sent.
  std::vector<std::uint8_t> written;
  std::vector<std::uint8_t> sent;

  double now() const override { return now_; }

  Result<std::size_t> read(std::size_t, std::span<std::uint8_t> bytes) override {
    const std::size_t count = std::min(bytes.size(), sent.size() - taken_);
    std::copy_n(sent.begin() + static_cast<std::ptrdiff_t>(taken_), count, bytes.begin());
    taken_ += count;
    return count;
  }

  Result<std::size_t> write(std::size_t, std::span<const std::uint8_t> bytes) override {
    written.insert(written.end(), bytes.begin(), bytes.end());
    board_.receive(bytes);
    return bytes.size();
  }

  void wait(double until) override {
    do {
      now_ = std::min(until, now_ + 0.0005);
      board_.advance(now_, sent);
    } while (now_ < until && taken_ == sent.size());
  }

  Result<void> reopen(std::size_t) override { return {}; }

 private:
  emulation::EmulatedBoard& board_;
  double now_ = 0.0;
  std::size_t taken_ = 0;
};

}  // namespace somato::testing
