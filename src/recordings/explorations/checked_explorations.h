#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "somato/recording/frame_sink.h"

namespace somato {

/// Passes explorations on to another sink, checked as validate() checks a recording, except for
/// what every sink checks. An error (kData) names the exploration.
class CheckedExplorations final : public FrameSink {
 public:
  explicit CheckedExplorations(FrameSink& to) : to_(&to) {}

  Result<void> begin_exploration(const ExplorationStart& start) override;
  Result<void> frame(std::size_t channel, std::span<const float> values, double time,
                     std::span<const std::uint8_t> valid) override;
  Result<void> end_exploration() override;

  /// The number of complete explorations.
  std::size_t count() const { return count_; }

  /// The first exploration, with one frame of each channel.
  const Exploration& first() const { return *first_; }

 private:
  Result<void> located(Result<void> checked) const;

  FrameSink* to_;
  std::size_t count_ = 0;
  std::optional<Exploration> first_;
  Exploration current_;              // With the first frame of each channel.
  std::vector<std::size_t> frames_;  // For each channel, the number of them.
};

}  // namespace somato
