#include "bodies/probes/probe_poses.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "bodies/hands/played_frames.h"
#include "bodies/objects/exploration_source.h"
#include "bodies/probes/probe_scene.h"
#include "bodies/sensors/potentiometer.h"
#include "somato/bodies/explore_by.h"
#include "somato/simulation/simulation_parameters.h"

namespace somato {
namespace {

using detail::Probe;

const Channel* counted(const Exploration& exploration, const char* name) {
  const Channel* channel = detail::played_channel(exploration, name, 1);
  return channel != nullptr && channel->unit == "counts" ? channel : nullptr;
}

const Channel* sound_of(const Exploration& exploration) {
  const Channel* sound = counted(exploration, "sound");
  const double rate = TextureProbeParameters{}.sample_rate;
  return sound != nullptr && sound->rate == rate ? sound : nullptr;
}

const Channel* potentiometer_of(const Exploration& exploration) {
  return counted(exploration, "potentiometer");
}

std::optional<Probe> probe_of(const Exploration& exploration) {
  const bool strokes = sound_of(exploration) != nullptr;
  const bool presses = potentiometer_of(exploration) != nullptr;
  if (strokes && presses) return Probe::kBoth;
  if (strokes) return Probe::kTexture;
  if (presses) return Probe::kHardness;
  return {};
}

// deg, at the time of a frame of the stroke.
double lever_at(const Channel& sound, std::size_t frame) {
  const StrokeParameters stroke;
  const double per_frame = TextureProbeParameters{}.lever_speed / sound.rate;
  const double way = stroke.to - stroke.from;
  if (static_cast<double>(sound.frames.rows()) != std::round(way / per_frame)) return 0.0;
  return stroke.from + std::min(way, per_frame * static_cast<double>(frame + 1));
}

double stick_at(const Channel& potentiometer, std::size_t frame) {
  const float read = detail::played_value(potentiometer, frame, 0);
  return detail::stick_position(double{read}, {}).value_or(0.0);
}

class ProbePlayer : public ScenePlayer {
 public:
  ProbePlayer(Probe probe, const std::string& material)
      : probe_(probe), scene_(detail::probe_scene(probe, material)) {}

  const Scene& scene() const override { return scene_; }

  std::vector<ScenePose> poses(const Exploration& exploration, std::size_t frame) override {
    const auto row = [&](const Channel& channel) {
      return detail::played_row(exploration, channel, frame);
    };
    detail::ProbePlace place;
    if (const Channel* sound = sound_of(exploration)) place.lever = lever_at(*sound, row(*sound));
    if (const Channel* read = potentiometer_of(exploration))
      place.stick = stick_at(*read, row(*read));
    return detail::probe_poses(probe_, place);
  }

 private:
  Probe probe_;
  Scene scene_;
};

}  // namespace

std::unique_ptr<ScenePlayer> play_probes(const Exploration& exploration) {
  const auto probe = probe_of(exploration);
  if (!probe) return nullptr;
  const auto material = find_label(exploration, "material").value_or("");
  return std::make_unique<ProbePlayer>(
      *probe, is_of_built_in_things(exploration.source) ? material : std::string());
}

}  // namespace somato
