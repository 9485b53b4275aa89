#include "bodies/sensors/probe_truth.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "bodies/sensors/exact_values.h"

namespace somato::detail {
namespace {

constexpr const char* kEdge = "true_edge";
constexpr const char* kServo = "true_servo";
constexpr const char* kStick = "true_stick";

// All frames in one message, because reading a message of a file takes long.
template <typename Value>
Channel sound_channel(const char* name, const char* unit, const std::vector<TrueSound>& sounds,
                      std::size_t frames, const Value& value) {
  Channel channel;
  channel.name = name;
  channel.unit = unit;
  channel.shape = {frames, kParts};
  channel.frames = Matrix<float>(1, frames * kParts);
  auto to = channel.frames.row(0).begin();
  for (std::size_t i = 0; i < frames; ++i) {
    to = std::ranges::copy(parts_of(value(sounds[i])), to).out;
  }
  return channel;
}

}  // namespace

void SoundTruth::end_step(bool recorded) {
  if (recorded) {
    recorded_.insert(recorded_.end(), pending_.begin(), pending_.end());
  } else if (recorded_.empty()) {
    before_ += pending_.size();
  }
  pending_.clear();
}

void SoundTruth::add_to(Exploration& exploration, std::size_t frames) const {
  exploration.channels.push_back(sound_channel(kEdge, "mm/s", recorded_, frames,
                                               [](const TrueSound& sound) { return sound.edge; }));
  exploration.channels.push_back(sound_channel(kServo, "", recorded_, frames,
                                               [](const TrueSound& sound) { return sound.servo; }));
}

bool has_sound_truth(const Exploration& exploration) {
  return true_channel(exploration, kEdge) != nullptr;
}

Result<std::vector<TrueSound>> true_sounds(const Exploration& exploration, std::size_t count) {
  const Channel& edge = *true_channel(exploration, kEdge);
  const Channel* servo = true_channel(exploration, kServo);
  if (servo == nullptr) return bad_truth(edge, fmt::format("lacks the channel '{}'", kServo));
  for (const Channel* channel : {&edge, servo}) {
    SOMATO_TRY_VOID(check_truth(*channel, count * kParts));
  }
  const auto at = [](const Channel& channel, std::size_t i) {
    const std::span<const float> parts = channel.frames.row(0).subspan(i * kParts, kParts);
    return whole_of(parts[0], parts[1], parts[2]);
  };
  std::vector<TrueSound> sounds(count);
  for (std::size_t i = 0; i < count; ++i) sounds[i] = {at(edge, i), at(*servo, i)};
  return sounds;
}

void StickTruth::add_to(Exploration& exploration) const {
  Channel channel = exact_channel(kStick, "mm", {"stick"});
  add_exact(channel, std::array{position});
  exploration.channels.push_back(std::move(channel));
}

bool has_stick_truth(const Exploration& exploration) {
  return true_channel(exploration, kStick) != nullptr;
}

Result<double> true_stick(const Exploration& exploration) {
  const Channel& channel = *true_channel(exploration, kStick);
  SOMATO_TRY_VOID(check_truth(channel, kParts));
  return exact_row(channel, 0)[0];
}

}  // namespace somato::detail
