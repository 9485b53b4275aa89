#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "somato/bodies/scene.h"
#include "somato/bodies/watched_body.h"
#include "somato/graph/system_description.h"
#include "somato/graph/system_model.h"
#include "somato/recording/recording.h"

namespace somato {

/// A system that may be chosen: trained already, or to be trained on what is viewed.
struct ViewSystem {
  std::string name;
  std::string text;                            ///< One line.
  SystemDescription description = {};          ///< Of one that is still to be trained.
  std::string label = {};                      ///< That it is to tell, such as "object".
  std::string map = {};                        ///< The module that answers; empty: its last map.
  std::shared_ptr<const SystemModel> trained;  ///< Or nullptr.
};

/// What is viewed: a recording, or a body that explores.
struct ViewSource {
  std::string name;                   ///< The file's name, or the body's.
  Recording recording = {};           ///< Valid; of a body what was explored before, if any.
  std::unique_ptr<WatchedBody> body;  ///< Or nullptr.
  std::size_t thing = 0;              ///< That the body explores first.
  std::uint64_t seed = 1;             ///< Of what is trained.
  SceneFinder scenes = {};            ///< For recordings; may be empty.
  std::vector<ViewSystem> systems = {};
  std::optional<std::size_t> system = {};  ///< That is chosen first.
};

/// How it is viewed.
struct ViewSettings {
  bool wait_for_viewer = true;  ///< Begins to play when somebody looks on; else at once.
  double speed = 1.0;           ///< 0.05 to 100; 1: as fast as it was.
  /// Seconds between two looks at a map that is trained, of which there are a hundred: nobody could
  /// follow it at its own speed.
  double training_pause = 0.06;
};

}  // namespace somato
