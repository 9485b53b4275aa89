#include "views/exports/npz_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "base/archives/little_endian.h"
#include "base/arrays/npy_header.h"
#include "base/arrays/npy_numbers.h"
#include "base/arrays/npy_texts.h"
#include "recordings/explorations/growing_channel.h"

namespace somato {
namespace {

std::string npy_of_list(const std::vector<double>& numbers) {
  return npy_of_numbers<double>(numbers, std::array{numbers.size()});
}

std::string frame_array(const Channel& channel) {
  std::vector<std::size_t> shape = channel.frame_shape();
  shape.insert(shape.begin(), channel.frames.rows());
  std::string bytes = npy_file_start("<f4", shape);
  const Matrix<float> readings = readings_of(channel, 0, channel.frames.rows());
  bytes.reserve(bytes.size() + readings.values().size_bytes());
  for (const float value : readings.values()) append_little_endian(bytes, value);
  return bytes;
}

// The times of the frames, or nothing if they are unknown.
std::vector<double> known_times(const Channel& channel) {
  std::vector<double> times = channel.times;
  if (!times.empty() || channel.rate == 0.0) return times;
  times.reserve(channel.frames.rows());
  for (std::size_t frame = 0; frame < channel.frames.rows(); ++frame) {
    times.push_back(static_cast<double>(frame) / channel.rate);
  }
  return times;
}

}  // namespace

Result<std::unique_ptr<RecordingExport>> NpzExport::begin(const std::string& path) {
  SOMATO_TRY(FileWriter file, FileWriter::begin(path));
  return std::make_unique<NpzExport>(std::move(file));
}

Result<void> NpzExport::add_member(const std::string& name, const std::string& bytes) {
  return zip_.add(name + ".npy", bytes);
}

Result<void> NpzExport::add_frames(const Channel& channel) {
  const std::string place = fmt::format("{}/{}", channel.name, explorations_);
  SOMATO_TRY_VOID(add_member("frames/" + place, frame_array(channel)));
  const std::vector<double> times = known_times(channel);
  if (times.empty()) return {};
  return add_member("times/" + place, npy_of_list(times));
}

Result<void> NpzExport::add(const Exploration& exploration) {
  if (explorations_ == 0) {
    labels_.reserve(exploration.labels.size());
    for (const Label& label : exploration.labels) labels_.push_back({label.name, {}});
    channels_.reserve(exploration.channels.size());
    for (const Channel& channel : exploration.channels) {
      channels_.push_back({description_of(channel), {}});
    }
  }
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    labels_[i].values.push_back(exploration.labels[i].value);
  }
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    channels_[i].rates.push_back(exploration.channels[i].rate);
    SOMATO_TRY_VOID(add_frames(exploration.channels[i]));
  }
  ++explorations_;
  return {};
}

Result<void> NpzExport::finish() {
  for (const LabelValues& label : labels_) {
    SOMATO_TRY_VOID(add_member("labels/" + label.name, npy_of_texts(label.values)));
  }
  for (const ChannelNotes& channel : channels_) {
    const std::string& name = channel.description.name;
    SOMATO_TRY_VOID(add_member("rates/" + name, npy_of_list(channel.rates)));
    SOMATO_TRY_VOID(add_member("unit/" + name, npy_of_texts({channel.description.unit}, {})));
    if (channel.description.element_names.empty()) continue;
    SOMATO_TRY_VOID(
        add_member("elements/" + name, npy_of_texts(channel.description.element_names)));
  }
  return zip_.finish().and_then([&] { return file_.commit(); });
}

}  // namespace somato
