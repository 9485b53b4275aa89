#include "bodies/sensors/exact_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace somato::detail {

std::array<float, kParts> parts_of(double value) {
  std::array<float, kParts> parts{};
  for (float& part : parts) {
    part = static_cast<float>(value);
    value -= static_cast<double>(part);
  }
  return parts;
}

double whole_of(float first, float second, float third) {
  return (static_cast<double>(first) + static_cast<double>(second)) + static_cast<double>(third);
}

bool is_true_channel(const Channel& channel) {
  return channel.name.starts_with(kTruePrefix);
}

Channel exact_channel(std::string name, std::string unit, const std::vector<std::string>& names) {
  Channel channel;
  channel.name = std::move(name);
  channel.unit = std::move(unit);
  for (const char* part : {"", "_rest", "_rest_2"}) {
    for (const std::string& value : names) channel.element_names.push_back(value + part);
  }
  channel.frames = Matrix<float>(0, channel.element_names.size());
  return channel;
}

void add_exact(Channel& channel, std::span<const double> values) {
  const std::span<float> row = channel.frames.add_row();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto parts = parts_of(values[i]);
    for (std::size_t part = 0; part < kParts; ++part) row[part * values.size() + i] = parts[part];
  }
}

std::vector<double> exact_row(const Channel& channel, std::size_t frame) {
  const std::span<const float> row = channel.frames.row(frame);
  const std::size_t count = row.size() / kParts;
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = whole_of(row[i], row[count + i], row[2 * count + i]);
  }
  return values;
}

const Channel* true_channel(const Exploration& exploration, std::string_view name) {
  const auto found = std::find_if(exploration.channels.begin(), exploration.channels.end(),
                                  [&](const Channel& channel) { return channel.name == name; });
  return found == exploration.channels.end() ? nullptr : &*found;
}

bool is_count(double value, double most) {
  return value >= 0.0 && value <= most && value == std::floor(value);
}

tl::unexpected<Error> bad_truth(const Channel& channel, const std::string& what) {
  return fail(ErrorKind::kData, fmt::format("the channel '{}' {}", channel.name, what),
              channel.name, "use a recording of 'explore' with true values that nothing changed");
}

Result<void> check_truth(const Channel& channel, std::size_t elements) {
  if (channel.frames.rows() == 0 || channel.frames.columns() != elements) {
    return bad_truth(channel,
                     fmt::format("has {} frames of {} elements, not frames of {}",
                                 channel.frames.rows(), channel.frames.columns(), elements));
  }
  const auto marks = channel.valid.values();
  if (std::find(marks.begin(), marks.end(), std::uint8_t{0}) != marks.end()) {
    return bad_truth(channel, "lacks values");
  }
  const auto values = channel.frames.values();
  if (std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); })) {
    return {};
  }
  return bad_truth(channel, "has values that are not finite");
}

}  // namespace somato::detail
