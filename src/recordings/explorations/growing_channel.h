#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "somato/recording/recording.h"

namespace somato {

/// Adds a frame to a channel whose frames come one after the other; before the first frame it may
/// have another number of columns. `time` is empty where times are not known, `valid` if all values
/// are valid. Throws InvalidArgument if a frame has another number of elements than those before.
void add_frame(Channel& channel, std::span<const float> values, std::optional<double> time,
               std::span<const std::uint8_t> valid = {});

/// Adds frames in which NaN stands for a missing value; times are not added. Throws as add_frame().
void append_readings(Channel& channel, const Matrix<float>& readings);

/// `count` frames of a channel from `first` on, with NaN in the place of missing values.
Matrix<float> readings_of(const Channel& channel, std::size_t first, std::size_t count);

/// Frames that are added one after the other, and taken from the oldest on.
class WaitingFrames {
 public:
  /// Before the first frame, frames have so many elements.
  explicit WaitingFrames(std::size_t elements = 0) { channel_.frames = {0, elements}; }

  /// See add_frame(). All frames have a time, or none has one.
  void add(std::span<const float> values, std::optional<double> time,
           std::span<const std::uint8_t> valid = {}) {
    add_frame(channel_, values, time, valid);
  }

  std::size_t count() const { return channel_.frames.rows() - taken_; }
  std::size_t elements() const { return channel_.frames.columns(); }

  /// The times of the frames, if they have times.
  std::span<const double> times() const;

  /// Takes the oldest `count` frames, with NaN in the place of missing values.
  Matrix<float> take(std::size_t count);

 private:
  Channel channel_;
  std::size_t taken_ = 0;  // frames at the beginning of the channel
};

/// The channel of that description, of `elements` elements, with the frames of `collected`: their
/// times only if the description states that they are known.
Channel described(Channel collected, const ChannelDescription& description, std::size_t elements);

/// Drops the oldest `frames` of a channel.
void drop_frames(Channel& channel, std::size_t frames);

/// The memory of the frames of a channel, with their times and marks, in bytes.
std::size_t bytes_of(const Channel& channel);

}  // namespace somato
