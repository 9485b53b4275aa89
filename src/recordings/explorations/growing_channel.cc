#include "recordings/explorations/growing_channel.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "somato/core/check.h"

namespace somato {
namespace {

template <typename T>
Matrix<T> without_first(const Matrix<T>& matrix, std::size_t rows) {
  const std::span<const T> left = matrix.values().subspan(rows * matrix.columns());
  return Matrix<T>(matrix.rows() - rows, matrix.columns(),
                   std::vector<T>(left.begin(), left.end()));
}

}  // namespace

// Marks begin with the first value that is not valid.
void add_frame(Channel& channel, std::span<const float> values, std::optional<double> time,
               std::span<const std::uint8_t> valid) {
  Matrix<float>& frames = channel.frames;
  if (frames.rows() == 0) frames = Matrix<float>(0, values.size());
  require(frames.columns() == values.size(), "add_frame: another number of elements");
  if (!valid.empty() && channel.valid.empty()) {
    channel.valid = Matrix<std::uint8_t>(frames.rows(), values.size(), 1);
  }
  std::copy(values.begin(), values.end(), frames.add_row().begin());
  if (time) channel.times.push_back(*time);
  if (channel.valid.columns() == 0) return;
  const std::span<std::uint8_t> marks = channel.valid.add_row();
  std::fill(marks.begin(), marks.end(), std::uint8_t{1});
  std::copy(valid.begin(), valid.end(), marks.begin());
}

Channel described(Channel collected, const ChannelDescription& description, std::size_t elements) {
  if (collected.frames.rows() == 0) collected.frames = Matrix<float>(0, elements);
  Channel channel = channel_of(description, std::move(collected.frames));
  channel.valid = std::move(collected.valid);
  if (description.times_known) channel.times = std::move(collected.times);
  return channel;
}

void drop_frames(Channel& channel, std::size_t frames) {
  channel.frames = without_first(channel.frames, frames);
  if (channel.valid.rows() > 0) channel.valid = without_first(channel.valid, frames);
  if (channel.times.empty()) return;
  channel.times.erase(channel.times.begin(),
                      channel.times.begin() + static_cast<std::ptrdiff_t>(frames));
}

std::size_t bytes_of(const Channel& channel) {
  return channel.frames.values().size_bytes() + channel.valid.values().size_bytes() +
         channel.times.size() * sizeof(double);
}

}  // namespace somato
