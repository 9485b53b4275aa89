#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "somato/bodies/placement.h"
#include "views/replay/played_exploration.h"
#include "views/session/losses.h"
#include "views/session/reading_sink.h"
#include "views/session/view_json.h"
#include "views/session/view_source.h"
#include "views/session/viewed_system.h"
#include "views/teaching/kept_explorations.h"

namespace somato::live {

/// The state that is sent to a page in addition to frames. It refers to its sources.
struct ViewState {
  const ViewSource& source;
  const SystemPicture& picture;
  const KeptExplorations& kept;
  const PlayedExploration* played = nullptr;  ///< Or nothing.
  std::vector<Label> labels = {};             ///< The labels of what is played.
  std::size_t first_frame = 0;                ///< The first that is kept.
  std::size_t frame = 0;
  bool playing = false;
  double speed = 1.0;
  std::size_t thing = 0;
  Placement placement = {};
  std::optional<std::size_t> system = {};
  std::string system_problem = {};
  bool teaches = false;  ///< Whether the selected system learns the names that are given.
  std::vector<TaughtName> taught = {};
  bool training = false;
  std::optional<std::size_t> demonstrated = {};  ///< Rounds of a demonstration.
  Json naming = {};                              ///< See naming_json().
  Losses losses = {};
  std::size_t clients = 0;
  bool awaits_start = false;  ///< Whether a real body moves only after a press of Start.
  std::string problem = {};
};

/// The state as docs/formats/view.md has it.
Json state_json(const ViewState& state);

}  // namespace somato::live
