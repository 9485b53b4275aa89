#include "recordings/explorations/growing_channel.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

void append_readings(Channel& channel, const Matrix<float>& readings) {
  std::vector<float> values(readings.columns());
  std::vector<std::uint8_t> valid(readings.columns());
  for (std::size_t frame = 0; frame < readings.rows(); ++frame) {
    const std::span<const float> read = readings.row(frame);
    for (std::size_t i = 0; i < read.size(); ++i) {
      valid[i] = std::isnan(read[i]) ? 0 : 1;
      values[i] = valid[i] == 0 ? 0.0F : read[i];
    }
    const bool is_whole = std::ranges::find(valid, 0) == valid.end();
    add_frame(channel, values, {}, is_whole ? std::span<const std::uint8_t>{} : valid);
  }
}

Matrix<float> readings_of(const Channel& channel, std::size_t first, std::size_t count) {
  const std::size_t columns = channel.frames.columns();
  const auto part = [&](auto all) { return all.subspan(first * columns, count * columns); };
  const std::span<const float> values = part(channel.frames.values());
  Matrix<float> readings(count, columns, {values.begin(), values.end()});
  if (channel.valid.empty()) return readings;
  const std::span<const std::uint8_t> valid = part(channel.valid.values());
  for (std::size_t i = 0; i < valid.size(); ++i) {
    if (valid[i] == 0) readings.values()[i] = std::numeric_limits<float>::quiet_NaN();
  }
  return readings;
}

std::span<const double> WaitingFrames::times() const {
  if (channel_.times.empty()) return {};
  return std::span(channel_.times).subspan(taken_);
}

// Half of the frames are dropped at once, so that the others are moved rarely.
Matrix<float> WaitingFrames::take(std::size_t count) {
  Matrix<float> frames = readings_of(channel_, taken_, count);
  taken_ += count;
  if (taken_ > 0 && 2 * taken_ >= channel_.frames.rows()) {
    drop_frames(channel_, std::exchange(taken_, 0));
  }
  return frames;
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
