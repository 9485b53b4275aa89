#include "systems/signals/channel_features.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "somato/core/random.h"

namespace somato {
namespace {

using Series = std::vector<double>;

Channel touched(std::size_t frames, std::size_t elements, std::uint64_t seed) {
  Random random(seed);
  Channel channel;
  channel.name = "touch";
  channel.frames = Matrix<float>(frames, elements);
  for (float& value : channel.frames.values()) {
    value = static_cast<float>(5.0 + random.normal());
  }
  return channel;
}

std::map<std::string, double> named_features(const FeaturedChannel& featured,
                                             const Channel& channel) {
  const std::vector<std::string> names = channel_feature_names(featured);
  const std::vector<double> features = channel_features(featured, channel);
  EXPECT_EQ(names.size(), features.size());
  EXPECT_EQ(names[kMeanFeature], "mean");
  EXPECT_EQ(names[kSpreadFeature], "spread of all values");
  std::map<std::string, double> found;
  for (std::size_t i = 0; i < names.size(); ++i) found[names[i]] = features[i];
  EXPECT_EQ(found.size(), names.size()) << "names are distinct";
  return found;
}

double plain_mean(const Series& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double plain_variance(const Series& values) {
  double sum = 0.0;
  for (const double value : values)
    sum += (value - plain_mean(values)) * (value - plain_mean(values));
  return sum / static_cast<double>(values.size());
}

double plain_correlation(const Series& a, const Series& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - plain_mean(a)) * (b[i] - plain_mean(b));
  return sum / static_cast<double>(a.size()) / std::sqrt(plain_variance(a) * plain_variance(b));
}

Series element_series(const Channel& channel, std::size_t element) {
  Series values;
  for (std::size_t i = 0; i < channel.frames.rows(); ++i)
    values.push_back(channel.frames(i, element));
  return values;
}

TEST(ChannelFeatures, AreThoseOfPlainSums) {
  const Channel channel = touched(13, 3, 1);
  const auto found = named_features({"touch", 3, true, 0}, channel);
  Series all;
  Series means;
  double variance = 0.0;
  for (std::size_t e = 0; e < 3; ++e) {
    const Series one = element_series(channel, e);
    all.insert(all.end(), one.begin(), one.end());
    means.push_back(plain_mean(one));
    variance += plain_variance(one) / 3.0;
    EXPECT_NEAR(found.at("mean of element " + std::to_string(e + 1)), plain_mean(one), 1e-12);
    EXPECT_NEAR(found.at("spread of element " + std::to_string(e + 1) + " within explorations"),
                std::sqrt(plain_variance(one)), 1e-12);
  }
  EXPECT_NEAR(found.at("mean"), plain_mean(all), 1e-12);
  EXPECT_NEAR(found.at("spread of all values"), std::sqrt(plain_variance(all)), 1e-12);
  EXPECT_NEAR(found.at("spread between elements"), std::sqrt(plain_variance(means)), 1e-12);
  EXPECT_NEAR(found.at("spread within explorations"), std::sqrt(variance), 1e-12);
  std::sort(all.begin(), all.end());
  EXPECT_NEAR(found.at("median"), all[19], 1e-12);                             // 38 / 2
  EXPECT_NEAR(found.at("quantile 0.05"), 0.1 * all[1] + 0.9 * all[2], 1e-12);  // 38 x 0.05 = 1.9
  EXPECT_NEAR(found.at("quantile 0.95"), 0.9 * all[36] + 0.1 * all[37], 1e-12);
  double second_differences = 0.0;
  for (std::size_t e = 0; e < 3; ++e) {
    const Series one = element_series(channel, e);
    for (std::size_t i = 1; i < 12; ++i)
      second_differences += std::pow(one[i - 1] - 2.0 * one[i] + one[i + 1], 2.0);
  }
  EXPECT_NEAR(found.at("roughness over three frames"), std::sqrt(second_differences / 33.0 / 6.0),
              1e-12);
  // Frames 3 to 5 of 13: from 13 / 4 to 26 / 4, rounded down.
  Series second;
  for (std::size_t i = 3; i < 6; ++i) {
    for (std::size_t e = 0; e < 3; ++e) second.push_back(channel.frames(i, e));
  }
  EXPECT_NEAR(found.at("mean of quarter 2"), plain_mean(second), 1e-12);
  const double pairs = plain_correlation(element_series(channel, 0), element_series(channel, 1)) +
                       plain_correlation(element_series(channel, 0), element_series(channel, 2)) +
                       plain_correlation(element_series(channel, 1), element_series(channel, 2));
  EXPECT_NEAR(found.at("correlation of elements"), pairs / 3.0, 1e-12);
}

TEST(ChannelFeatures, OfManyElementsAreOfAllTogether) {
  const auto names = channel_feature_names({"touch", 9, true, 0});
  EXPECT_EQ(std::count_if(names.begin(), names.end(),
                          [](const std::string& name) {
                            return name.find("of element ") != std::string::npos;
                          }),
            0);
}

// A sine of amplitude a has the mean square a^2 / 2, in the octave of its frequency.
TEST(ChannelFeatures, HaveTheRootMeanSquareOfEachOctave) {
  Channel channel;
  channel.frames = Matrix<float>(150, 1);
  for (std::size_t i = 0; i < 150; ++i) {
    const double turns = 5.0 * static_cast<double>(i) / 64.0;
    channel.frames(i, 0) = static_cast<float>(7.0 + 3.0 * std::sin(2.0 * std::numbers::pi * turns));
  }
  const auto found = named_features({"sound", 1, true, 64}, channel);
  EXPECT_NEAR(found.at("spectrum, octave 3"), 3.0 / std::sqrt(2.0), 1e-5);  // bins 4 to 7
  for (const char* other :
       {"spectrum, octave 1", "spectrum, octave 2", "spectrum, octave 4", "spectrum, octave 5"}) {
    EXPECT_NEAR(found.at(other), 0.0, 1e-5) << other;
  }
  EXPECT_FALSE(found.contains("spectrum, octave 6"));
}

TEST(ChannelFeatures, LeaveMissingValuesOut) {
  Channel channel = touched(8, 2, 2);
  const Series kept{channel.frames(1, 0), channel.frames(4, 0)};
  channel.valid = Matrix<std::uint8_t>(8, 2, 0);
  channel.valid(1, 0) = 1;
  channel.valid(4, 0) = 1;
  const auto found = named_features({"touch", 2, true, 0}, channel);
  EXPECT_NEAR(found.at("mean"), plain_mean(kept), 1e-12);
  EXPECT_TRUE(std::isnan(found.at("mean of element 2")));
  EXPECT_TRUE(std::isnan(found.at("mean of quarter 2")));
  EXPECT_EQ(found.at("correlation of elements"), 0.0);
  channel.valid = Matrix<std::uint8_t>(8, 2, 0);
  EXPECT_TRUE(std::isnan(named_features({"touch", 2, true, 0}, channel).at("mean")));
}

TEST(ChannelFeatures, OfAConstantChannelAreItsValue) {
  Channel channel;
  channel.frames = Matrix<float>(40, 2, 0.1F);
  const auto found = named_features({"touch", 2, true, 32}, channel);
  EXPECT_FLOAT_EQ(static_cast<float>(found.at("median")), 0.1F);
  EXPECT_EQ(found.at("spread of all values"), 0.0);
  EXPECT_EQ(found.at("correlation of elements"), 0.0);
  EXPECT_EQ(found.at("spectrum, octave 1"), 0.0);
}

TEST(ChannelFeatures, OfOneFrameAreItsMean) {
  const auto found = named_features({"potentiometer", 1, false, 0}, touched(1, 1, 3));
  EXPECT_EQ(found.size(), 2U);
  EXPECT_EQ(found.at("spread of all values"), 0.0);
}

// A shorter exploration of a simulation has zeros after its frames.
TEST(ChannelFeatures, OfAShorterExplorationHaveASpectrum) {
  const auto found = named_features({"sound", 1, true, 64}, touched(5, 1, 4));
  EXPECT_GT(found.at("spectrum, octave 5"), 0.0);
}

}  // namespace
}  // namespace somato
