#include "somato/simulation/sense.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/core/threads.h"
#include "bodies/objects/exploration_source.h"
#include "bodies/sensors/exact_values.h"
#include "bodies/sensors/exploration_draws.h"
#include "bodies/sensors/hand_sensors.h"
#include "bodies/sensors/hand_truth.h"
#include "bodies/sensors/potentiometer.h"
#include "bodies/sensors/probe_truth.h"

namespace somato {
namespace {

using detail::Draws;
using detail::ExplorationDraws;

tl::unexpected<Error> no_true_values() {
  return fail(ErrorKind::kUsage, "the exploration has no true values, which sensors could measure",
              {}, "explore again with true_values = true in the table [simulation]");
}

// The channel of a sensor that has true values. Errors: there is none.
Result<Channel*> sensed_channel(Exploration& exploration, std::string_view name) {
  for (Channel& channel : exploration.channels) {
    if (channel.name == name && !channel.frames.empty()) return &channel;
  }
  return fail(ErrorKind::kData,
              fmt::format("the channel '{}' is missing, but its true values are not", name),
              std::string(name), "use a recording of 'explore' that nothing changed");
}

// The exploration with the channels that sense() returns.
Exploration prepared(const Exploration& explored, std::uint64_t seed, bool with_truth) {
  Exploration exploration;
  exploration.labels = explored.labels;
  exploration.source = played_source(explored.source, seed);
  for (const Channel& channel : explored.channels) {
    if (with_truth || !detail::is_true_channel(channel)) exploration.channels.push_back(channel);
  }
  return exploration;
}

// A hand's channels of sensors with noise, in the order of HandSensors::read().
struct HandChannels {
  Channel* joints = nullptr;  // nullptr: not measured
  Channel* touch = nullptr;
  Channel* change = nullptr;

  std::vector<Channel*> all() const {
    std::vector<Channel*> channels{joints, touch, change};
    std::erase(channels, nullptr);
    return channels;
  }

  detail::HandSensorCounts counts() const {
    return {joints == nullptr ? 0 : joints->frames.columns(),
            touch == nullptr ? 0 : touch->frames.columns()};
  }
};

Result<HandChannels> hand_channels(const Exploration& explored, Exploration& exploration) {
  HandChannels channels;
  if (detail::true_channel(explored, "true_joints") != nullptr) {
    SOMATO_TRY(channels.joints, sensed_channel(exploration, "joints"));
  }
  if (detail::true_channel(explored, "true_contacts") != nullptr) {
    SOMATO_TRY(channels.touch, sensed_channel(exploration, "touch"));
    SOMATO_TRY(channels.change, sensed_channel(exploration, "touch_change"));
  }
  return channels;
}

Result<void> check_fits(const HandChannels& channels, const detail::HandTruth& truth) {
  const detail::HandSensorCounts counts = channels.counts();
  const auto refuse = [](const Channel& channel) {
    return fail(ErrorKind::kData,
                fmt::format("the channel '{}' does not fit its true values", channel.name),
                channel.name, "use a recording of 'explore' that nothing changed");
  };
  for (const Channel* channel : channels.all()) {
    const bool is_joints = channel == channels.joints;
    const std::size_t elements = is_joints ? truth.moments().front().joints.size() : counts.taxels;
    if (channel->frames.rows() != truth.moments().size() || channel->frames.columns() != elements) {
      return refuse(*channel);
    }
  }
  const bool fits =
      std::all_of(truth.contacts().begin(), truth.contacts().end(),
                  [&](const detail::HandTruth::Contact& one) { return one.taxel < counts.taxels; });
  return fits || channels.touch == nullptr ? Result<void>() : refuse(*channels.touch);
}

// Brings the piezo elements through the contacts up to a step of the physics.
class PlayedContacts {
 public:
  PlayedContacts(const std::vector<detail::HandTruth::Contact>& contacts, std::size_t taxels,
                 double time_step)
      : contacts_(contacts), steps_(taxels, 0), time_step_(time_step) {}

  void play_to(std::uint64_t step, detail::PiezoElements& piezo) {
    for (; next_ < contacts_.size() && contacts_[next_].step <= step; ++next_) {
      const auto& [at, taxel, force] = contacts_[next_];
      piezo.advance(taxel, at - steps_[taxel] - 1, force, time_step_);
      steps_[taxel] = at;
    }
    for (std::size_t taxel = 0; taxel < steps_.size(); ++taxel) {
      piezo.rest(taxel, step - steps_[taxel], time_step_);
      steps_[taxel] = step;
    }
  }

 private:
  const std::vector<detail::HandTruth::Contact>& contacts_;
  std::vector<std::uint64_t> steps_;  // of each taxel so far
  double time_step_;
  std::size_t next_ = 0;
};

Result<void> sense_hand(const Exploration& explored, const ExploringParameters& parameters,
                        const ExplorationDraws& draws, Exploration& exploration) {
  SOMATO_TRY_VOID(check_ranges(parameters.simulation));
  SOMATO_TRY(const auto truth, detail::HandTruth::of(explored));
  SOMATO_TRY(const auto channels, hand_channels(explored, exploration));
  SOMATO_TRY_VOID(check_fits(channels, truth));
  detail::HandSensors sensors(parameters.simulation, channels.counts(), draws.seed_of(Draws::kHand),
                              draws.seed);
  PlayedContacts contacts(truth.contacts(), channels.counts().taxels, draws.time_step);
  const std::vector<Channel*> sensed = channels.all();
  std::uint64_t read = 0;
  for (std::size_t frame = 0; frame < truth.moments().size(); ++frame) {
    const detail::HandTruth::Moment& moment = truth.moments()[frame];
    sensors.skip(moment.readings - read);
    read = moment.readings + 1;
    contacts.play_to(moment.steps, sensors.piezo());
    const std::vector<Matrix<float>> readings = sensors.read(moment.joints);
    for (std::size_t i = 0; i < sensed.size(); ++i) {
      std::ranges::copy(readings[i].row(0), sensed[i]->frames.row(frame).begin());
    }
  }
  return {};
}

Result<void> sense_sound(const Exploration& explored, const ExploringParameters& parameters,
                         const ExplorationDraws& draws, Exploration& exploration) {
  SOMATO_TRY_VOID(check_ranges(parameters.texture_probe));
  SOMATO_TRY(Channel* const sound, sensed_channel(exploration, "sound"));
  SOMATO_TRY(const auto sounds, detail::true_sounds(explored, sound->frames.rows()));
  const std::uint64_t seed = draws.seed_of(Draws::kTexture);
  Random noise(seed, Stream::kTextureProbe);
  static_cast<void>(detail::draw_stroke(noise));
  detail::Microphone microphone(parameters.texture_probe, sound->rate, seed);
  microphone.skip(draws.sound_before, noise);
  for (std::size_t frame = 0; frame < sounds.size(); ++frame) {
    sound->frames(frame, 0) = microphone.read(sounds[frame], noise);
  }
  return {};
}

Result<void> sense_stick(const Exploration& explored, const ExploringParameters& parameters,
                         const ExplorationDraws& draws, Exploration& exploration) {
  SOMATO_TRY_VOID(check_ranges(parameters.hardness_probe));
  SOMATO_TRY(Channel* const potentiometer, sensed_channel(exploration, "potentiometer"));
  SOMATO_TRY(const double position, detail::true_stick(explored));
  const std::uint64_t seed = draws.seed_of(Draws::kHardness);
  Random noise(seed, Stream::kHardnessProbe);
  static_cast<void>(detail::draw_press(noise));
  double deviation = 0.0;
  for (std::uint64_t tick = 0; tick < draws.stick_before; ++tick) deviation = noise.normal();
  potentiometer->frames(0, 0) =
      detail::Potentiometer(parameters.hardness_probe, seed).read(position, deviation);
  return {};
}

}  // namespace

Result<Exploration> sense(const Exploration& explored, const ExploringParameters& parameters,
                          std::optional<std::uint64_t> seed) {
  SOMATO_TRY(auto draws, detail::draws_of(explored));
  if (!draws) return no_true_values();
  draws->seed = seed.value_or(draws->seed);
  const bool with_truth = parameters.simulation.true_values;
  Exploration exploration = prepared(explored, draws->seed, with_truth);
  if (detail::has_hand_truth(explored)) {
    SOMATO_TRY_VOID(sense_hand(explored, parameters, *draws, exploration));
  }
  if (detail::has_sound_truth(explored)) {
    SOMATO_TRY_VOID(sense_sound(explored, parameters, *draws, exploration));
  }
  if (detail::has_stick_truth(explored)) {
    SOMATO_TRY_VOID(sense_stick(explored, parameters, *draws, exploration));
  }
  if (with_truth) detail::put_draws(*draws, exploration);
  return exploration;
}

Result<Recording> sense(const Recording& explored, const ExploringParameters& parameters,
                        std::optional<std::uint64_t> seed, std::size_t threads) {
  std::vector<Result<Exploration>> sensed(explored.explorations.size());
  for_each_task(sensed.size(), threads, [&](std::size_t i) {
    sensed[i] = sense(explored.explorations[i], parameters, seed);
  });
  Recording recording;
  recording.explorations.reserve(sensed.size());
  for (std::size_t i = 0; i < sensed.size(); ++i) {
    if (!sensed[i]) {
      Error error = std::move(sensed[i].error());
      error.where = error.where.empty() ? fmt::format("exploration {}", i + 1)
                                        : fmt::format("exploration {}, {}", i + 1, error.where);
      return fail(std::move(error));
    }
    recording.explorations.push_back(std::move(*sensed[i]));
  }
  return recording;
}

}  // namespace somato
