#pragma once

#include "hardware/lines/lines.h"

namespace somato::testing {

/// Lines that another object owns.
class LentLines : public wire::Lines {
 public:
  explicit LentLines(wire::Lines& lines) : lines_(lines) {}

  double now() const override { return lines_.now(); }
  Result<std::size_t> read(std::size_t line, std::span<std::uint8_t> bytes) override {
    return lines_.read(line, bytes);
  }
  Result<std::size_t> write(std::size_t line, std::span<const std::uint8_t> bytes) override {
    return lines_.write(line, bytes);
  }
  void wait(double until) override { lines_.wait(until); }
  Result<void> reopen(std::size_t line) override { return lines_.reopen(line); }

 private:
  wire::Lines& lines_;
};

}  // namespace somato::testing
