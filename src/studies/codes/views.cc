#include "studies/codes/views.h"

#include <algorithm>
#include <utility>

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

Samples seen_in(const Samples& vectors, View view) {
  if (vectors.is_sparse()) return vectors;
  const Rows chosen = rows_of(vectors.size(), view);
  Matrix<float> seen(vectors.count(), (chosen.end - chosen.begin + chosen.step - 1) / chosen.step);
  for (std::size_t i = 0; i < vectors.count(); ++i) {
    for (std::size_t k = 0; k < seen.columns(); ++k) {
      seen(i, k) = vectors[i].values[chosen.begin + k * chosen.step];
    }
  }
  return Samples(std::move(seen));
}

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
