#include "views/exports/npz_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include "base/archives/little_endian.h"
#include "base/arrays/npy_header.h"
#include "recordings/explorations/growing_channel.h"

namespace somato {
namespace {

// The code points of a text in UTF-8.
std::vector<std::uint32_t> code_points(std::string_view text) {
  std::vector<std::uint32_t> points;
  points.reserve(text.size());
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool continues = (byte & 0xC0U) == 0x80U;
    if (continues && !points.empty()) {
      points.back() = points.back() << 6U | (byte & 0x3FU);
    } else {
      const std::uint32_t lead = byte < 0x80   ? 0x7FU
                                 : byte < 0xE0 ? 0x1FU
                                 : byte < 0xF0 ? 0x0FU
                                               : 7U;
      points.push_back(byte & lead);
    }
  }
  return points;
}

std::string text_array(const std::vector<std::string>& texts, std::span<const std::size_t> shape) {
  std::vector<std::vector<std::uint32_t>> points;
  points.reserve(texts.size());
  std::size_t longest = 1;  // numpy has no texts of no length.
  for (const std::string& text : texts) {
    points.push_back(code_points(text));
    longest = std::max(longest, points.back().size());
  }
  std::string bytes = npy_file_start(fmt::format("<U{}", longest), shape);
  for (std::vector<std::uint32_t>& text : points) {
    text.resize(longest, 0);
    for (const std::uint32_t point : text) append_little_endian(bytes, point);
  }
  return bytes;
}

std::string text_array(const std::vector<std::string>& texts) {
  return text_array(texts, std::array{texts.size()});
}

std::string double_array(const std::vector<double>& numbers) {
  std::string bytes = npy_file_start("<f8", std::array{numbers.size()});
  for (const double number : numbers) append_little_endian(bytes, number);
  return bytes;
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
  return add_member("times/" + place, double_array(times));
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
    SOMATO_TRY_VOID(add_member("labels/" + label.name, text_array(label.values)));
  }
  for (const ChannelNotes& channel : channels_) {
    const std::string& name = channel.description.name;
    SOMATO_TRY_VOID(add_member("rates/" + name, double_array(channel.rates)));
    SOMATO_TRY_VOID(add_member("unit/" + name, text_array({channel.description.unit}, {})));
    if (channel.description.element_names.empty()) continue;
    SOMATO_TRY_VOID(add_member("elements/" + name, text_array(channel.description.element_names)));
  }
  return zip_.finish().and_then([&] { return file_.commit(); });
}

}  // namespace somato
