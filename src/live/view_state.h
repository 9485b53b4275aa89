#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "live/view_json.h"
#include "live/viewed_system.h"
#include "somato/bodies/placement.h"
#include "somato/live/view_source.h"

namespace somato::live {

/// What a page is told besides frames. It refers to what it is made of.
struct ViewState {
  const ViewSource& source;
  const SystemPicture& picture;
  const Exploration* shown = nullptr;  ///< That plays or grows, or nullptr.
  std::optional<std::size_t> exploration = {};
  std::size_t frame = 0;
  std::optional<std::size_t> frames = {};
  std::optional<double> duration = {};  ///< s.
  bool playing = false;
  double speed = 1.0;
  bool live = false;
  std::size_t thing = 0;
  Placement placement = {};
  std::optional<std::size_t> system = {};
  std::string system_problem = {};
  bool training = false;
  std::size_t clients = 0;
  std::string problem = {};
};

/// The state as docs/formats/view.md has it.
Json state_json(const ViewState& state);

}  // namespace somato::live
