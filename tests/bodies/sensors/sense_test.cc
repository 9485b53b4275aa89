#include "somato/simulation/sense.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bodies/objects/exploration_source.h"
#include "bodies/sensors/sensor_parameters.h"
#include "bodies/support/things.h"
#include "somato/simulation/simulated_explorer.h"

namespace somato {
namespace {

Object of_first_material(std::string name, Object object) {
  object.name = std::move(name);
  object.material = declared_materials().front();
  return object;
}

ObjectTable one_of_each() {
  return {{of_first_material("tube", cylinder_thing())}, {declared_materials()[1]}};
}

// One grasp instead of nine; with true values.
ExploringParameters keeping() {
  ExploringParameters parameters;
  parameters.plan.grasps = 1;
  parameters.simulation.true_values = true;
  return parameters;
}

ExploringParameters plain(ExploringParameters parameters) {
  parameters.simulation.true_values = false;
  return parameters;
}

Exploration felt_by(ExploringBody body, const ExploringParameters& parameters,
                    std::uint64_t seed = 3, std::size_t trial = 1) {
  const ObjectTable things = is_probe(body) ? ObjectTable{{}, one_of_each().materials}
                                            : ObjectTable{one_of_each().objects, {}};
  const auto explorer = simulated_explorer(body, things, parameters, seed);
  EXPECT_TRUE(explorer) << to_string(explorer.error());
  auto exploration = (*explorer)->explore(0, trial);
  EXPECT_TRUE(exploration) << to_string(exploration.error());
  return exploration.value_or(Exploration{});
}

const Matrix<float>& frames_of(const Exploration& exploration, const std::string& name) {
  return (*find_channel(exploration, name))->frames;
}

// The result of sense(), but with the source of the exploration: the source states that the sensors
// are played.
Exploration played_readings(const Exploration& explored, const ExploringParameters& parameters,
                            std::optional<std::uint64_t> seed = {}) {
  Exploration sensed = sense(explored, parameters, seed).value();
  sensed.source = explored.source;
  return sensed;
}

std::string sensing_error(const Exploration& exploration, const ExploringParameters& parameters) {
  const auto sensed = sense(exploration, parameters);
  return sensed ? "none" : to_string(sensed.error());
}

Channel& channel_in(Exploration& exploration, const std::string& name) {
  return *std::ranges::find(exploration.channels, name, &Channel::name);
}

class EveryBody : public ::testing::TestWithParam<ExploringBody> {};

TEST_P(EveryBody, IsPlayedBitForBitWithTheSettingsOfTheExploration) {
  ExploringParameters parameters = keeping();
  parameters.simulation.taxels = GetParam() == ExploringBody::kLucs3;
  const Exploration kept = felt_by(GetParam(), parameters);
  const Exploration without = felt_by(GetParam(), plain(parameters));
  EXPECT_NE(kept, without);
  EXPECT_EQ(played_readings(kept, plain(parameters)), without);
  EXPECT_EQ(played_readings(kept, parameters), kept);
  EXPECT_EQ(played_readings(kept, parameters, 3), kept);
}

TEST_P(EveryBody, HasOtherNoiseWithAnotherSeedAndTheSameAgain) {
  const ExploringParameters parameters = keeping();
  const Exploration kept = felt_by(GetParam(), parameters);
  const Exploration other = sense(kept, parameters, 4).value();
  EXPECT_NE(other.channels, kept.channels);
  EXPECT_EQ(sense(kept, parameters, 4).value(), other);
  EXPECT_EQ(sense(other, parameters).value(), other);
  EXPECT_EQ(sense(other, parameters, 3).value().channels, kept.channels);
}

INSTANTIATE_TEST_SUITE_P(Sense, EveryBody,
                         ::testing::Values(ExploringBody::kLucs2, ExploringBody::kLucs3,
                                           ExploringBody::kProbes, ExploringBody::kAllSenses));

// The servos of Hand II follow `touch` only, and a stroke follows no sensor.
TEST(Sense, SettingsOfSensorsWithoutInfluenceOnTheBodyAreAsInAnExploration) {
  ExploringParameters parameters = keeping();
  const Exploration hand = felt_by(ExploringBody::kLucs2, parameters);
  const Exploration stroke = felt_by(ExploringBody::kTexture, parameters);
  parameters.simulation.piezo_time = 0.03;
  parameters.simulation.piezo_converter = PiezoConverter::kBipolar;
  parameters.texture_probe.sensitivity = 40.0;
  parameters.texture_probe.servo_noise = 0.5;
  parameters.texture_probe.microphone_noise = 3.0;
  parameters.texture_probe.ambient_sound = 6.0;
  parameters.texture_probe.adc_bits = 16;
  EXPECT_EQ(played_readings(hand, parameters), felt_by(ExploringBody::kLucs2, parameters));
  EXPECT_EQ(played_readings(stroke, parameters), felt_by(ExploringBody::kTexture, parameters));
}

TEST(Sense, IdealSensorsReadTheTrueValues) {
  ExploringParameters parameters = keeping();
  parameters.simulation.taxels = true;
  const Exploration kept = felt_by(ExploringBody::kAllSenses, parameters);
  parameters.simulation.sensor_noise = 0.0;
  parameters.simulation.joint_noise = 0.0;
  parameters.simulation.touch_threshold = 0.0;
  parameters.simulation.piezo_time = 10.0;
  const Exploration ideal = sense(kept, parameters).value();
  EXPECT_EQ(frames_of(ideal, "touch"), frames_of(kept, "true_force"));
  const auto touch = frames_of(ideal, "touch").values();
  EXPECT_GT(*std::max_element(touch.begin(), touch.end()), 0.5F);
  const Matrix<float>& joints = frames_of(ideal, "joints");
  const Matrix<float>& angles = frames_of(kept, "true_joints");
  ASSERT_EQ(angles.columns(), 3 * joints.columns());
  for (std::size_t i = 0; i < joints.rows(); ++i) {
    for (std::size_t j = 0; j < joints.columns(); ++j) EXPECT_EQ(joints(i, j), angles(i, j));
  }
}

// The counts by the definitions of the parameters.
TEST(Sense, ConvertersQuantizeTheTrueValues) {
  ExploringParameters parameters = keeping();
  const Exploration press = felt_by(ExploringBody::kHardness, parameters);
  const Exploration hand = felt_by(ExploringBody::kLucs2, parameters);
  parameters.hardness_probe.potentiometer_bits = 8;
  parameters.hardness_probe.potentiometer_noise = 0.0;
  parameters.hardness_probe.potentiometer_path = 80.0;
  parameters.hardness_probe.potentiometer_offset = 0.25;
  const double position = double{frames_of(press, "true_stick")(0, 0)};
  EXPECT_EQ(frames_of(sense(press, parameters).value(), "potentiometer")(0, 0),
            static_cast<float>(std::round(255.0 * (position / 80.0 + 0.25))));

  parameters.simulation.sensor_noise = 0.0;
  parameters.simulation.touch_threshold = 0.0;
  parameters.simulation.touch_bits = 4;
  parameters.simulation.touch_range = 3.0;  // 0, 0.2, ... 3.0
  const Exploration coarse = sense(hand, parameters).value();
  const auto touch = frames_of(coarse, "touch").values();
  const auto force = frames_of(hand, "true_force").values();
  for (std::size_t i = 0; i < touch.size(); ++i) {
    const double steps = std::min(15.0, std::round(double{force[i]} * 5.0));
    EXPECT_NEAR(touch[i], 0.2 * steps, 1e-6);
  }
}

TEST(Sense, PressesOfOneStickSpreadAsDeclared) {
  ExploringParameters parameters = keeping();
  const Exploration press = felt_by(ExploringBody::kHardness, parameters);
  parameters.hardness_probe.potentiometer_noise = 0.0;
  parameters.hardness_probe.press_spread = 0.1;
  constexpr int kPresses = 400;
  double sum = 0.0;
  double squares = 0.0;
  const double position = double{frames_of(press, "true_stick")(0, 0)};
  for (int seed = 0; seed < kPresses; ++seed) {
    const auto sensed = sense(press, parameters, static_cast<std::uint64_t>(seed)).value();
    const double away =
        double{frames_of(sensed, "potentiometer")(0, 0)} * 10.0 / 262143.0 - position;
    sum += away;
    squares += away * away;
  }
  const double mean = sum / kPresses;
  EXPECT_NEAR(mean, 0.0, 4.0 * 0.1 / std::sqrt(kPresses));
  EXPECT_NEAR(std::sqrt(squares / kPresses - mean * mean), 0.1, 0.015);
}

// Without other deviations than the spread of gains, each taxel reads its force times a constant of
// its own, in all explorations of a hand.
TEST(Sense, SensorsOfAHandDifferInTheSameWayInAllExplorations) {
  ExploringParameters parameters = keeping();
  const Exploration first = felt_by(ExploringBody::kLucs2, parameters, 3, 0);
  const Exploration second = felt_by(ExploringBody::kLucs2, parameters, 3, 1);
  parameters.simulation.sensor_noise = 0.0;
  parameters.simulation.touch_threshold = 0.0;
  parameters.simulation.touch_gain_spread = 0.3;
  std::vector<double> gains(45, 0.0);
  std::size_t compared = 0;
  for (const Exploration& explored : {first, second}) {
    const Exploration sensed = sense(explored, parameters).value();
    const Matrix<float>& touch = frames_of(sensed, "touch");
    const Matrix<float>& force = frames_of(explored, "true_force");
    for (std::size_t i = 0; i < touch.rows(); ++i) {
      for (std::size_t taxel = 0; taxel < gains.size(); ++taxel) {
        if (force(i, taxel) == 0.0F) continue;
        const double gain = double{touch(i, taxel)} / double{force(i, taxel)};
        if (gains[taxel] == 0.0) gains[taxel] = gain;
        EXPECT_NEAR(gain, gains[taxel], 1e-5);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 20U);
  EXPECT_GT(std::ranges::count_if(gains, [](double g) { return g != 0.0 && g != 1.0; }), 2);
}

TEST(Sense, ARestingLevelIsReadWithoutContact) {
  ExploringParameters parameters = keeping();
  const Exploration hand = felt_by(ExploringBody::kLucs2, parameters);
  parameters.simulation.sensor_noise = 0.0;
  parameters.simulation.touch_rest = 0.5;
  const Exploration equal = sense(hand, parameters).value();
  EXPECT_EQ(frames_of(equal, "touch")(0, 0), 0.5F);
  EXPECT_EQ(frames_of(equal, "touch_change")(0, 44), 0.5F);
  parameters.simulation.touch_rest_spread = 0.3;
  const Exploration spread = sense(hand, parameters).value();
  const auto levels = frames_of(spread, "touch").row(0);
  const auto [least, most] = std::minmax_element(levels.begin(), levels.end());
  EXPECT_LT(*least, 0.4F);
  EXPECT_GT(*most, 0.6F);
}

// Neighbouring samples of white noise through a low-pass of first order correlate by exp(-2 pi f /
// rate).
TEST(Sense, TheSoundOfTheRoomHasItsLoudnessAndItsColour) {
  ExploringParameters parameters = keeping();
  const Exploration stroke = felt_by(ExploringBody::kTexture, parameters);
  parameters.texture_probe.sensitivity = 0.0;
  parameters.texture_probe.servo_noise = 0.0;
  parameters.texture_probe.microphone_noise = 0.0;
  parameters.texture_probe.ambient_sound = 50.0;
  parameters.texture_probe.ambient_cutoff = 600.0;
  parameters.texture_probe.adc_bits = 24;
  double square = 0.0;
  double neighbours = 0.0;
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    const Exploration sensed = sense(stroke, parameters, seed).value();
    const Matrix<float>& sound = frames_of(sensed, "sound");
    for (std::size_t i = 1; i < sound.rows(); ++i) {
      square += double{sound(i, 0)} * double{sound(i, 0)};
      neighbours += double{sound(i, 0)} * double{sound(i - 1, 0)};
    }
  }
  const double millivolts = 1000.0 / (1 << 23);
  EXPECT_NEAR(std::sqrt(square / (4 * 8191)) * millivolts, 50.0, 2.0);
  EXPECT_NEAR(neighbours / square, std::exp(-2.0 * std::acos(-1.0) * 600.0 / 8192.0), 0.02);
}

TEST(Sense, ExplorationsWithoutTrueValuesAreRefused) {
  EXPECT_EQ(sensing_error(felt_by(ExploringBody::kHardness, {}), {}),
            "the exploration has no true values, which sensors could measure; explore again with "
            "true_values = true in the table [simulation]");
}

TEST(Sense, TrueValuesThatAnotherProgramChangedAreRefused) {
  const ExploringParameters parameters = keeping();
  const Exploration grasp = felt_by(ExploringBody::kLucs2, parameters);
  const auto changed = [&](ExploringBody body, const auto& change) {
    Exploration exploration = body == ExploringBody::kLucs2 ? grasp : felt_by(body, parameters);
    change(exploration);
    return sensing_error(exploration, parameters);
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::string not_finite = "has values that are not finite";
  for (const char* name : {"true_contacts", "true_readings", "true_draws"}) {
    EXPECT_NE(changed(ExploringBody::kLucs2,
                      [&](Exploration& e) { channel_in(e, name).frames(0, 0) = nan; })
                  .find(not_finite),
              std::string::npos);
  }
  const auto hand = [&](const auto& change) { return changed(ExploringBody::kLucs2, change); };
  EXPECT_NE(hand([](Exploration& e) {
              channel_in(e, "true_contacts").frames(0, 1) = 99.0F;
            }).find("does not fit its true values"),
            std::string::npos);
  EXPECT_NE(hand([](Exploration& e) {
              channel_in(e, "true_contacts").frames(0, 0) = 0.5F;
            }).find("other numbers than steps and taxels"),
            std::string::npos);
  EXPECT_NE(hand([](Exploration& e) {
              channel_in(e, "true_contacts").frames(0, 0) = 0.0F;
            }).find("has a row in step 0"),
            std::string::npos);
  EXPECT_NE(hand([](Exploration& e) {
              Matrix<float>& rows = channel_in(e, "true_contacts").frames;
              rows(0, 5) = 0.0F;
              rows(0, 6) = rows(0, 1);
            }).find("has two rows of taxel "),
            std::string::npos);
  EXPECT_NE(hand([](Exploration& e) {
              channel_in(e, "true_contacts").frames = {1, 3};
            }).find("has 1 frames of 3 elements"),
            std::string::npos);
  EXPECT_NE(hand([](Exploration& e) {
              channel_in(e, "true_readings").frames(1, 0) = 0.0F;
            }).find("do not increase"),
            std::string::npos);
  EXPECT_NE(hand([](Exploration& e) {
              channel_in(e, "true_readings").frames(1, 0) = 3e9F;
            }).find("other numbers than counts"),
            std::string::npos);
  EXPECT_NE(hand([](Exploration& e) {
              std::erase_if(e.channels, [](const Channel& one) { return one.name == "touch"; });
            }).find("the channel 'touch' is missing"),
            std::string::npos);
  EXPECT_NE(changed(ExploringBody::kTexture,
                    [](Exploration& e) { channel_in(e, "sound").frames = {10, 1}; })
                .find("'true_edge' has 1 frames of 24576 elements, not frames of 30"),
            std::string::npos);
  EXPECT_NE(changed(ExploringBody::kTexture,
                    [](Exploration& e) {
                      std::erase_if(e.channels,
                                    [](const Channel& one) { return one.name == "true_servo"; });
                    })
                .find("lacks the channel 'true_servo'"),
            std::string::npos);
  EXPECT_NE(changed(ExploringBody::kHardness,
                    [](Exploration& e) { channel_in(e, "true_draws").frames(0, 5) = -1.0F; })
                .find("other numbers than counts"),
            std::string::npos);
}

TEST(Sense, TheSourceStatesThatSensorsArePlayed) {
  const Exploration press = felt_by(ExploringBody::kHardness, keeping());
  EXPECT_EQ(sense(press, {})->source, played_source(press.source, 3));
  EXPECT_EQ(sense(press, {}, 8)->source, played_source(press.source, 8));
  EXPECT_NE(sense(press, {}, 8)->source, press.source);
}

TEST(Sense, ANoteSaysThatTheDefaultSensorsAreNotThoseOfTheExploration) {
  const ExploringParameters defaults = keeping();
  ExploringParameters others = defaults;
  others.hardness_probe.potentiometer_bits = 12;
  others.texture_probe.sensitivity = 40.0;
  for (const ExploringBody body : {ExploringBody::kHardness, ExploringBody::kAllSenses}) {
    const Exploration explored = felt_by(body, defaults);
    EXPECT_EQ(note_of_other_sensors(explored).value(), "");
    EXPECT_EQ(note_of_other_sensors(sense(explored, defaults, 8).value()).value(), "");
    EXPECT_NE(note_of_other_sensors(felt_by(body, others)).value().find("other sensors"),
              std::string::npos);
  }
  EXPECT_FALSE(note_of_other_sensors(felt_by(ExploringBody::kHardness, {})));
}

TEST(Sense, ParametersOutOfRangeAreRefused) {
  const Exploration press = felt_by(ExploringBody::kHardness, keeping());
  ExploringParameters parameters;
  parameters.hardness_probe.potentiometer_bits = 0;
  EXPECT_NE(sensing_error(press, parameters).find("'potentiometer_bits' must be"),
            std::string::npos);
}

TEST(Sense, ARecordingIsPlayedAlikeByAnyNumberOfThreads) {
  Recording recording;
  for (const std::size_t trial : {0U, 1U, 2U}) {
    recording.explorations.push_back(felt_by(ExploringBody::kHardness, keeping(), 3, trial));
  }
  const Recording sensed = sense(recording, {}, 9).value();
  EXPECT_EQ(sense(recording, {}, 9, 3).value(), sensed);
  EXPECT_EQ(sense(recording.explorations[1], {}, 9).value(), sensed.explorations[1]);
  recording.explorations[1].channels.resize(1);
  EXPECT_EQ(to_string(sense(recording, {}).error()).rfind("exploration 2: ", 0), 0U);
}

}  // namespace
}  // namespace somato
