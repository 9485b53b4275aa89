#pragma once

#include <cstddef>
#include <memory>

#include "somato/bodies/scene.h"
#include "somato/recording/recording.h"
#include "views/replay/timeline.h"

namespace somato::live {

/// An exploration that is played moment by moment. Its end may still move.
struct PlayedExploration {
  std::size_t index = 0;  ///< That it has in the recording, or will have.
  const Exploration* exploration = nullptr;
  std::shared_ptr<const Timeline> timeline;
  std::shared_ptr<ScenePlayer> scene;  ///< Or nullptr: what it looked like is not known.
  bool has_ended = true;               ///< Or more moments may come.
};

}  // namespace somato::live
