#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "views/replay/body_thread.h"
#include "views/replay/kept_scene.h"
#include "views/replay/played_exploration.h"

namespace somato::live {

/// The exploration of a body that still explores, as far as it has been shown: it is played like
/// any other, but its end moves, and its beginning as well where it takes too much memory. Used by
/// one thread.
class GrowingExploration {
 public:
  /// It will be the exploration with that index.
  GrowingExploration(std::size_t index, const BodyDescription& body,
                     std::shared_ptr<const Scene> scene);

  /// Takes a step. If its readings are recorded there is one moment more; that takes constant time
  /// on average.
  void append(BodyStep step);

  /// The memory of the moments that are kept, in bytes.
  std::size_t bytes() const;

  /// Drops the older half of the moments, but not the last one.
  void drop_half();

  /// The exploration has ended, and has these labels. Its frames are only what is kept.
  void end(std::vector<Label> labels) { exploration_.labels = std::move(labels); }

  /// Seconds from the last step to this one.
  double seconds_to(const BodyStep& step) const;

  /// The last step; its time counts from the first one. A sensor that read nothing during the step
  /// has its readings of before; NaN stands for a missing value.
  const BodyStep& last() const { return last_; }

  /// Valid as long as this lives.
  PlayedExploration played() const { return {index_, &exploration_, timeline_, scene_, false}; }

  /// The scenes of its moments.
  const std::shared_ptr<KeptScene>& scene() const { return scene_; }

 private:
  void append_frames(const BodyState& state);

  std::size_t index_;
  Exploration exploration_;
  std::shared_ptr<Timeline> timeline_;
  std::shared_ptr<KeptScene> scene_;
  std::vector<std::size_t> frames_;  // of each channel
  std::vector<bool> has_times_;      // likewise
  std::optional<double> begun_;      // by the body's clock
  BodyStep last_;
};

}  // namespace somato::live
