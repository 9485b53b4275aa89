#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "live/growing_exploration.h"
#include "live/timeline.h"
#include "somato/recording/recording.h"

namespace somato::live {

/// What the strips over time show of an exploration: moments of it, all or evenly chosen, as frames
/// tell them. Channels that come in stretches are left out.
struct Strips {
  struct Channel {
    std::string name;
    std::vector<std::vector<float>> values;  ///< At each moment; empty before its first frame.
  };

  std::size_t exploration = 0;
  std::optional<std::size_t> frames = {};  ///< None while it goes on.
  std::vector<std::size_t> frame = {};     ///< Of each moment.
  std::vector<double> time = {};           ///< Of each moment, s.
  std::vector<Channel> channels = {};
};

/// All of an exploration; `number` is what it is called by.
Strips strips_of(const Exploration& exploration, std::size_t number, const Timeline& timeline);

/// What a body has felt so far; `begun` is the time of its clock that counts as 0.
Strips strips_of(const GrowingExploration& growing, std::size_t number, double begun);

/// As docs/formats/view.md has it.
std::string strips_text(const Strips& strips);

}  // namespace somato::live
