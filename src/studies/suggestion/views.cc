#include "studies/suggestion/views.h"

#include <algorithm>

namespace somato {
namespace {

struct Rows {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::size_t step = 1;
};

Rows rows_of(std::size_t frames, View view) {
  const std::size_t half = frames / 2;
  if (frames < 2 || view == View::kWhole) return {0, frames, 1};
  if (view == View::kOdd) return {0, frames, 2};
  if (view == View::kEven) return {1, frames, 2};
  return view == View::kFirst ? Rows{0, frames - half, 1} : Rows{half, frames, 1};
}

Channel seen_in(const Channel& channel, View view) {
  const Rows rows = rows_of(channel.frames.rows(), view);
  Channel seen{channel.name, channel.unit,         channel.element_names, {},
               {},           channel.frame_rate(), channel.shape};
  seen.frames = Matrix<float>(0, channel.frames.columns());
  for (std::size_t row = rows.begin; row < rows.end; row += rows.step) {
    std::ranges::copy(channel.frames.row(row), seen.frames.add_row().begin());
  }
  return seen;
}

}  // namespace

Recording seen_in(const Recording& recording, View view) {
  Recording seen;
  for (const Exploration& exploration : recording.explorations) {
    seen.explorations.push_back({{}, exploration.source, {}});
    for (const Channel& channel : exploration.channels) {
      seen.explorations.back().channels.push_back(seen_in(channel, view));
    }
  }
  return seen;
}

}  // namespace somato
