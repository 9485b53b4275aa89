#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "views/replay/played_exploration.h"

namespace somato::live {

/// The data of the strips over time for an exploration: all moments or an evenly spaced selection,
/// in the form of frames. Channels with several samples per moment are left out.
struct Strips {
  struct Channel {
    std::string name;
    std::vector<std::vector<float>>
        values;  ///< At each moment; empty before its first frame. NaN: missing.
  };

  std::size_t exploration = 0;
  std::optional<std::size_t> frames = {};  ///< None while a body still explores.
  std::vector<std::size_t> frame = {};     ///< The frame of each moment.
  std::vector<double> time = {};           ///< The time of each moment, s.
  std::vector<Channel> channels = {};
};

/// Those of an exploration, as far as it has come.
Strips strips_of(const PlayedExploration& played);

/// As docs/formats/view.md has it.
std::string strips_text(const Strips& strips);

}  // namespace somato::live
