#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "hardware/lines/lines.h"

namespace somato::emulation {

/// An event of the lines: bytes that were read, or the end of waiting.
struct LineEvent {
  double now = 0.0;
  std::vector<std::uint8_t> bytes;
};

/// Other lines, of which it records what happened. They must outlive it.
class RecordedLines : public wire::Lines {
 public:
  explicit RecordedLines(wire::Lines& lines) : lines_(lines) {}

  double now() const override { return lines_.now(); }
  Result<std::size_t> read(std::size_t line, std::span<std::uint8_t> bytes) override {
    auto count = lines_.read(line, bytes);
    if (!count) return count;
    events_.push_back(
        {now(), {bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(*count)}});
    return count;
  }
  Result<std::size_t> write(std::size_t line, std::span<const std::uint8_t> bytes) override {
    return lines_.write(line, bytes);
  }
  void wait(double until) override {
    lines_.wait(until);
    events_.push_back({now(), {}});
  }
  Result<void> reopen(std::size_t line) override { return lines_.reopen(line); }

  const std::vector<LineEvent>& events() const { return events_; }

 private:
  wire::Lines& lines_;
  std::vector<LineEvent> events_;
};

/// The same events again for the same host, from memory: for measuring what the host does itself.
/// Throws std::out_of_range after the last event.
class ReplayedLines : public wire::Lines {
 public:
  explicit ReplayedLines(std::vector<LineEvent> events) : events_(std::move(events)) {}

  double now() const override { return now_; }
  Result<std::size_t> read(std::size_t /*line*/, std::span<std::uint8_t> bytes) override {
    const LineEvent& event = next();
    std::copy(event.bytes.begin(), event.bytes.end(), bytes.begin());
    return event.bytes.size();
  }
  Result<std::size_t> write(std::size_t /*line*/, std::span<const std::uint8_t> bytes) override {
    return bytes.size();
  }
  void wait(double /*until*/) override { next(); }
  Result<void> reopen(std::size_t /*line*/) override { return {}; }

 private:
  const LineEvent& next() {
    const LineEvent& event = events_.at(next_++);
    now_ = event.now;
    return event;
  }

  std::vector<LineEvent> events_;
  std::size_t next_ = 0;
  double now_ = 0.0;
};

}  // namespace somato::emulation
