#include "bodies/hands/played_frames.h"

#include <algorithm>

namespace somato::detail {

const Channel* played_channel(const Exploration& exploration, std::string_view name,
                              std::size_t elements) {
  for (const Channel& channel : exploration.channels) {
    const Matrix<float>& frames = channel.frames;
    if (channel.name == name && frames.columns() == elements && frames.rows() > 0) return &channel;
  }
  return nullptr;
}

std::size_t most_frames(const Exploration& exploration) {
  std::size_t frames = 0;
  for (const Channel& channel : exploration.channels) {
    frames = std::max(frames, channel.frames.rows());
  }
  return frames;
}

std::size_t played_row(const Exploration& exploration, const Channel& channel, std::size_t frame) {
  const std::size_t most = most_frames(exploration);
  return std::min(frame, most - 1) * channel.frames.rows() / most;
}

float played_value(const Channel& channel, std::size_t row, std::size_t element) {
  const auto is_known = [&](std::size_t at) {
    return channel.valid.empty() || channel.valid(at, element) != 0;
  };
  for (std::size_t at = row + 1; at-- > 0;) {
    if (is_known(at)) return channel.frames(at, element);
  }
  for (std::size_t at = row + 1; at < channel.frames.rows(); ++at) {
    if (is_known(at)) return channel.frames(at, element);
  }
  return 0.0F;
}

}  // namespace somato::detail
