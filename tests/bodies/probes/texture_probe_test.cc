#include "bodies/probes/texture_probe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstring>
#include <numbers>

#include "base/archives/checksum.h"
#include "somato/bodies/explore_by.h"

namespace somato {
namespace {

using Sound = std::vector<float>;

// 40 mm times 36 degrees in a second.
constexpr double kSpeed = 40.0 * std::numbers::pi / 5.0;  // mm/s

Material plain_material() {
  Material material;
  material.name = "plain";
  return material;
}

// Only the edge, recorded with 24 bits.
TextureProbeParameters noiseless_texture() {
  TextureProbeParameters parameters;
  parameters.placement_noise = 0.0;
  parameters.microphone_noise = 0.0;
  parameters.servo_noise = 0.0;
  parameters.adc_bits = 24;
  return parameters;
}

// Nothing of the edge.
TextureProbeParameters deaf() {
  TextureProbeParameters parameters = noiseless_texture();
  parameters.sensitivity = 0.0;
  return parameters;
}

Sound stroke(const Material& material, const TextureProbeParameters& parameters,
             const ProbeSeeds& seeds) {
  auto probe = make_texture_probe(material, parameters, seeds);
  EXPECT_TRUE(probe);
  const auto exploration = explore_by_stroking(**probe);
  EXPECT_TRUE(exploration);
  if (!exploration) return Sound(8192, 0.0F);
  const auto values = exploration->channels.at(0).frames.values();
  return {values.begin(), values.end()};
}

double root_mean_square(const Sound& sound) {
  double sum = 0.0;
  for (const float value : sound) sum += static_cast<double>(value) * value;
  return std::sqrt(sum / static_cast<double>(sound.size()));
}

// Counts of a 24-bit converter in mV.
double millivolts(double counts) {
  return counts * 1000.0 / (1 << 23);
}

// The power at a whole frequency, every term of the transform written out.
double power_at(const Sound& sound, int frequency) {
  std::complex<double> sum = 0.0;
  for (std::size_t i = 0; i < sound.size(); ++i) {
    const double turns = frequency * static_cast<double>(i) / 8192.0;
    sum += static_cast<double>(sound[i]) *
           std::polar(1.0, -2.0 * std::numbers::pi * (turns - std::floor(turns)));
  }
  return std::norm(sum);
}

double power_around(const Sound& sound, int frequency, int width) {
  double sum = 0.0;
  for (int f = frequency - width; f <= frequency + width; ++f) sum += power_at(sound, f);
  return sum;
}

double correlation(const Sound& a, const Sound& b) {
  double product = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) product += static_cast<double>(a[i]) * b[i];
  return product / (root_mean_square(a) * root_mean_square(b) * static_cast<double>(a.size()));
}

Sound passing(const TextureProbeParameters& parameters, const std::vector<double>& steps) {
  auto probe = make_texture_probe(plain_material(), parameters, {1, 2});
  EXPECT_TRUE((*probe)->command(std::vector<double>{36.0}));
  Sound all;
  for (const double seconds : steps) {
    EXPECT_TRUE((*probe)->step(seconds));
    const auto values = (*probe)->state().readings.at(0).values();
    all.insert(all.end(), values.begin(), values.end());
  }
  return all;
}

TEST(TextureProbe, AStrokeHasASecondOfSoundAndNothingElse) {
  auto probe = make_texture_probe(plain_material(), {}, {1, 1});
  ASSERT_TRUE(probe);
  const auto exploration = explore_by_stroking(**probe);
  ASSERT_TRUE(exploration);
  ASSERT_EQ(exploration->channels.size(), 1U);
  const Channel& sound = exploration->channels[0];
  EXPECT_EQ(sound.name, "sound");
  EXPECT_EQ(sound.unit, "counts");
  EXPECT_EQ(sound.rate, 8192.0);
  EXPECT_EQ(sound.frames.rows(), 8192U);
  EXPECT_EQ(sound.frames.columns(), 1U);
  EXPECT_EQ((*probe)->state().positions, std::vector<double>{36.0});
}

TEST(TextureProbe, TheCuttingOfTimeChangesNoFrame) {
  const Sound whole = passing({}, {1.0});
  ASSERT_EQ(whole.size(), 8192U);
  EXPECT_EQ(passing({}, std::vector<double>(10, 0.1)), whole);
  EXPECT_EQ(passing({}, std::vector<double>(8192, 1.0 / 8192.0)), whole);
  EXPECT_EQ(passing({}, {0.3333, 0.00001, 0.6, 0.06669}), whole);
}

TEST(TextureProbe, TheEdgeRingsAtItsRaisedResonance) {
  Material material = plain_material();
  material.stiffness = 3.0;  // a grip of 3 / 4
  material.loss = 0.0;
  material.hurst = 0.5;  // whose slope is white noise
  TextureProbeParameters parameters = noiseless_texture();
  parameters.edge_damping = 0.005;
  parameters.edge_width = 0.001;
  const double expected = 900.0 * std::sqrt(1.0 + 0.5 * 0.75);  // 1055.3
  const Sound sound = stroke(material, parameters, {3, 1});
  int peak = 0;
  double most = 0.0;
  for (int frequency = 700; frequency < 1400; frequency += 5) {
    const double power = power_around(sound, frequency, 5);
    if (power > most) peak = frequency;
    most = std::max(most, power);
  }
  EXPECT_NEAR(peak, expected, 12.0);
}

TEST(TextureProbe, LossTakesTheRingingAway) {
  Material material = plain_material();
  material.loss = 0.02;  // with the edge's own, a damping ratio of 0.06
  const Sound ringing = stroke(material, noiseless_texture(), {3, 1});
  material.loss = 0.26;  // 0.18
  const Sound damped = stroke(material, noiseless_texture(), {3, 1});
  const int resonance = 1100;  // 900 sqrt(1 + 0.5 * 50 / 51) = 1098.7
  EXPECT_NEAR(power_around(ringing, resonance, 4) / power_around(damped, resonance, 4), 9.0, 0.5);
  EXPECT_NEAR(power_around(ringing, 120, 20) / power_around(damped, 120, 20), 1.0, 0.05);
}

TEST(TextureProbe, AWeaveIsALineAtSpeedOverPeriod) {
  Material cloth = plain_material();
  cloth.roughness = 0.0;
  cloth.weave_period = 0.5;
  cloth.weave_height = 100.0;
  const Sound sound = stroke(cloth, noiseless_texture(), {4, 1});
  int peak = 0;
  for (int frequency = 1; frequency < 400; ++frequency) {
    if (power_at(sound, frequency) > power_at(sound, peak)) peak = frequency;
  }
  const double frequency = kSpeed / 0.5;  // 50.27 Hz
  EXPECT_NEAR(peak, frequency, 0.6);
  // Amplitude of the slope, friction, grip, microphone (its lower end at 20 Hz), root mean square.
  const double edge = 0.05 * 2.0 * std::numbers::pi * frequency * 0.5 * (50.0 / 51.0);
  const double microphone = 15.0 / std::sqrt(1.0 + std::pow(20.0 / frequency, 4.0));
  EXPECT_NEAR(millivolts(root_mean_square(sound)) / (edge * microphone / std::sqrt(2.0)), 1.0,
              0.02);
}

TEST(TextureProbe, WhatTheSampleRateCannotCarryIsWeakenedBeforeItIsTaken) {
  Material cloth = plain_material();
  cloth.roughness = 0.0;
  cloth.weave_height = 1.0;
  TextureProbeParameters parameters = noiseless_texture();
  parameters.edge_width = 0.001;
  parameters.edge_resonance = 20000.0;
  parameters.edge_damping = 1.0 / std::sqrt(2.0);
  cloth.loss = 0.0;
  const auto loudness = [&](double frequency) {
    cloth.weave_period = kSpeed / frequency;
    return root_mean_square(stroke(cloth, parameters, {4, 1})) / frequency;
  };
  const auto warped = [](double frequency) {
    return std::tan(std::numbers::pi * frequency / 65536.0);
  };
  // A Butterworth low-pass of order 8 at 0.4 of 8192 Hz.
  const double expected = std::pow(warped(0.4 * 8192.0) / warped(5500.0), 8.0);
  EXPECT_NEAR(loudness(5500.0) / loudness(500.0) / expected, 1.0, 0.05);
}

TEST(TextureProbe, SoundGrowsWithRoughnessFrictionAndGrip) {
  Material material = plain_material();
  const double once = root_mean_square(stroke(material, noiseless_texture(), {5, 1}));
  material.roughness *= 3.0;
  EXPECT_NEAR(root_mean_square(stroke(material, noiseless_texture(), {5, 1})) / once, 3.0, 1e-3);
  material = plain_material();
  material.friction *= 0.5;
  EXPECT_NEAR(root_mean_square(stroke(material, noiseless_texture(), {5, 1})) / once, 0.5, 1e-3);
  material = plain_material();
  TextureProbeParameters parameters = noiseless_texture();
  parameters.resonance_rise = 0.0;
  const double rigid = root_mean_square(stroke(material, parameters, {5, 1}));
  material.stiffness = 1.0;  // grip 1 / 2 instead of 50 / 51
  EXPECT_NEAR(root_mean_square(stroke(material, parameters, {5, 1})) / rigid, 51.0 / 100.0, 1e-3);
}

// A weave shows by the phase of its line where a stroke began.
TEST(TextureProbe, PlacementNoiseHasItsSpread) {
  Material cloth = plain_material();
  cloth.roughness = 0.0;
  cloth.weave_period = kSpeed / 50.0;
  cloth.weave_height = 100.0;
  const auto line = [&](double placement_noise, std::uint64_t seed) {
    TextureProbeParameters parameters = noiseless_texture();
    parameters.stroke = 3.6;  // five periods
    parameters.placement_noise = placement_noise;
    auto probe = make_texture_probe(cloth, parameters, {4, seed});
    StrokeParameters shorter;
    shorter.to = 3.6;
    const auto exploration = explore_by_stroking(**probe, shorter);
    std::complex<double> sum = 0.0;
    for (std::size_t i = 0; i < 819; ++i) {
      const double turns = 50.0 * static_cast<double>(i) / 8192.0;
      sum += static_cast<double>(exploration->channels[0].frames(i, 0)) *
             std::polar(1.0, -2.0 * std::numbers::pi * turns);
    }
    return sum;
  };
  const std::complex<double> placed = line(0.0, 0);
  double squares = 0.0;
  constexpr int kSeeds = 150;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const double turned = std::arg(line(0.03, static_cast<std::uint64_t>(seed)) / placed);
    const double shift = turned / (2.0 * std::numbers::pi) * cloth.weave_period;
    squares += shift * shift;
  }
  EXPECT_NEAR(std::sqrt(squares / kSeeds), 0.03, 0.006);
}

TEST(TextureProbe, TheConverterRoundsAndSaturates) {
  TextureProbeParameters parameters;
  parameters.sensitivity = 1e4;
  const Sound loud = stroke(plain_material(), parameters, {6, 1});
  EXPECT_EQ(*std::min_element(loud.begin(), loud.end()), -2048.0F);
  EXPECT_EQ(*std::max_element(loud.begin(), loud.end()), 2047.0F);
  for (const float value : loud) ASSERT_EQ(value, std::round(value));
}

TEST(TextureProbe, MicrophoneNoiseHasItsSpread) {
  TextureProbeParameters parameters = deaf();
  parameters.microphone_noise = 2.0;
  const Sound noise = stroke(plain_material(), parameters, {7, 1});
  EXPECT_NEAR(millivolts(root_mean_square(noise)), 2.0, 4.0 * 2.0 / std::sqrt(2.0 * 8192.0));
  EXPECT_NEAR(correlation(noise, stroke(plain_material(), parameters, {7, 2})), 0.0, 0.05);
}

TEST(TextureProbe, TheServoWhinesWhileItTurns) {
  TextureProbeParameters parameters = deaf();
  parameters.servo_noise = 4.0;
  parameters.servo_tone_spread = 0.0;
  const Sound whine = stroke(plain_material(), parameters, {8, 1});
  EXPECT_NEAR(millivolts(root_mean_square(whine)), 4.0, 0.05);
  // 1 : 1/4 : 1/9 : 1/16 of the power, and none where there is no harmonic.
  const double fundamental = power_at(whine, 210);
  EXPECT_NEAR(power_at(whine, 420) / fundamental, 1.0 / 4.0, 0.02);
  EXPECT_NEAR(power_at(whine, 840) / fundamental, 1.0 / 16.0, 0.005);
  EXPECT_LT(power_at(whine, 1050) / fundamental, 1e-4);
}

TEST(TextureProbe, AStillLeverIsSilent) {
  TextureProbeParameters parameters = noiseless_texture();
  parameters.servo_noise = 3.0;
  auto probe = make_texture_probe(plain_material(), parameters, {9, 1});
  ASSERT_TRUE((*probe)->step(0.5));
  const auto still = (*probe)->state().readings[0].values();
  EXPECT_EQ(still.size(), 4096U);
  EXPECT_TRUE(std::all_of(still.begin(), still.end(), [](float v) { return v == 0.0F; }));
}

TEST(TextureProbe, RepeatsMeetTheSamePatchAndOtherWorldsAnother) {
  TextureProbeParameters parameters;
  parameters.placement_noise = 0.0;
  const Sound first = stroke(plain_material(), parameters, {10, 1});
  EXPECT_GT(correlation(first, stroke(plain_material(), parameters, {10, 2})), 0.9);
  EXPECT_LT(std::abs(correlation(first, stroke(plain_material(), parameters, {11, 1}))), 0.2);
  parameters.placement_noise = 0.5;
  const Sound beside = stroke(plain_material(), parameters, {10, 3});
  EXPECT_LT(std::abs(correlation(first, beside)), 0.5);
}

TEST(TextureProbe, OneSeedGivesTheSameBits) {
  const Sound sound = stroke(plain_material(), {}, {12, 34});
  EXPECT_EQ(sound, stroke(plain_material(), {}, {12, 34}));
  EXPECT_NE(sound, stroke(plain_material(), {}, {12, 35}));
  std::string bytes(sound.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), sound.data(), bytes.size());
  EXPECT_EQ(crc32c(bytes), 1128419554U);  // two compilers agree on it
}

TEST(TextureProbe, WhatLiesBeyondItsLimitsIsRefused) {
  auto probe = make_texture_probe(plain_material(), {}, {1, 1});
  for (const double target : {-0.1, 36.1}) {
    const auto refused = (*probe)->command(std::vector<double>{target});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().where, "lever");
  }
  StrokeParameters far;
  far.to = 40.0;
  EXPECT_FALSE(explore_by_stroking(**probe, far));
}

TEST(TextureProbe, WhatDoesNotFitIsRefusedBeforeAnythingMoves) {
  Material half_woven = plain_material();
  half_woven.weave_period = 1.0;
  EXPECT_FALSE(make_texture_probe(half_woven, {}, {}));
  Material negative = plain_material();
  negative.stiffness = -1.0;
  EXPECT_FALSE(make_texture_probe(negative, {}, {}));
  TextureProbeParameters parameters;
  parameters.edge_resonance = 1e5;
  EXPECT_FALSE(make_texture_probe(plain_material(), parameters, {}));
}

}  // namespace
}  // namespace somato
