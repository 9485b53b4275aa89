#include "studies/suggestion/channel_roles.h"

#include <algorithm>

namespace somato {
namespace {

bool all_rows_equal(const Matrix<float>& frames, std::span<const float> row) {
  for (std::size_t i = 0; i < frames.rows(); ++i) {
    if (!std::ranges::equal(frames.row(i), row)) return false;
  }
  return true;
}

ChannelRole role_of(const Recording& recording, std::size_t channel) {
  const auto frames_of = [&](const Exploration& exploration) -> const Matrix<float>& {
    return exploration.channels[channel].frames;
  };
  const std::span<const float> first = frames_of(recording.explorations.front()).row(0);
  const auto equals_first = [&](const Exploration& exploration) {
    return all_rows_equal(frames_of(exploration), first);
  };
  const auto is_still = [&](const Exploration& exploration) {
    return all_rows_equal(frames_of(exploration), frames_of(exploration).row(0));
  };
  const auto has_frames = [&](const Exploration& exploration) {
    return frames_of(exploration).rows() > 1;
  };
  const auto& explorations = recording.explorations;
  if (std::ranges::all_of(explorations, equals_first)) return ChannelRole::kConstant;
  if (std::ranges::none_of(explorations, has_frames)) return ChannelRole::kSense;
  return std::ranges::all_of(explorations, is_still) ? ChannelRole::kSetting : ChannelRole::kSense;
}

}  // namespace

std::vector<ChannelRole> roles_of(const Recording& recording) {
  std::vector<ChannelRole> roles;
  roles.reserve(recording.explorations.front().channels.size());
  for (std::size_t i = 0; i < recording.explorations.front().channels.size(); ++i) {
    roles.push_back(role_of(recording, i));
  }
  if (const auto speed = find_speed(recording)) roles[*speed] = ChannelRole::kSetting;
  if (std::ranges::find(roles, ChannelRole::kSense) == roles.end()) {
    std::ranges::replace(roles, ChannelRole::kSetting, ChannelRole::kSense);
  }
  return roles;
}

std::optional<std::size_t> find_speed(const Recording& recording) {
  const std::vector<Channel>& channels = recording.explorations.front().channels;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const bool is_speed = channels[i].unit == "mm/s" && channels[i].frames.columns() == 1;
    if (is_speed && role_of(recording, i) != ChannelRole::kConstant) return i;
  }
  return std::nullopt;
}

}  // namespace somato
