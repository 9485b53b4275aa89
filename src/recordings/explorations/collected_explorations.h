#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "somato/recording/frame_sink.h"

namespace somato {

/// Collects the frames of each exploration in memory, and hands the complete ones to `take`.
class CollectedExplorations final : public FrameSink {
 public:
  using Take = std::function<Result<void>(Exploration)>;

  explicit CollectedExplorations(Take take) : take_(std::move(take)) {}

  Result<void> begin_exploration(const ExplorationStart& start) override;
  Result<void> frame(std::size_t channel, std::span<const float> values, double time,
                     std::span<const std::uint8_t> valid) override;
  Result<void> end_exploration() override;

 private:
  Take take_;
  ExplorationStart start_;
  std::vector<Channel> channels_;
};

}  // namespace somato
