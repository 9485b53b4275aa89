#pragma once

#include <cstddef>
#include <vector>

#include "somato/bodies/body.h"
#include "somato/recording/recording.h"

namespace somato::live {

/// An exploration as far as a body has come with it.
class GrowingExploration {
 public:
  /// The end of a step whose readings belong to the exploration.
  struct Moment {
    double time = 0.0;                ///< s, by the body's clock.
    std::vector<std::size_t> frames;  ///< That each channel had given by then.
  };

  /// Of no body.
  GrowingExploration() = default;
  explicit GrowingExploration(const BodyDescription& body);

  /// Adds the frames that were taken during the last step: one moment.
  void append(const BodyState& state);

  const Exploration& so_far() const { return exploration_; }
  const std::vector<std::size_t>& frames() const { return frames_; }  ///< Of each channel.
  std::size_t moments() const { return moments_.size(); }
  const Moment& moment(std::size_t number) const { return moments_[number]; }

 private:
  Exploration exploration_;
  std::vector<std::size_t> frames_;
  std::vector<Moment> moments_;
};

}  // namespace somato::live
