#pragma once

#include <cstddef>
#include <optional>

namespace somato::live {

/// Counts the rounds of a demonstration: its explorations are made in turn and then played again
/// until a viewer takes over.
class Demonstration {
 public:
  explicit Demonstration(bool runs) : runs_(runs) {}

  bool runs() const { return runs_; }

  /// The complete rounds, or nothing without a demonstration.
  std::optional<std::size_t> rounds() const {
    return runs_ ? std::optional<std::size_t>(rounds_) : std::nullopt;
  }

  void complete_round() { ++rounds_; }

  /// A viewer takes over.
  void end() { runs_ = false; }

 private:
  bool runs_;
  std::size_t rounds_ = 0;
};

}  // namespace somato::live
