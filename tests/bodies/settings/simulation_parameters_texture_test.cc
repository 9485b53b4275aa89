#include "somato/simulation/simulation_parameters.h"

#include <gtest/gtest.h>

#include <limits>

namespace somato {
namespace {

TEST(TextureProbeParameters, TheDefaultsFitEachOther) {
  EXPECT_TRUE(TextureProbeParameters{}.validate());
}

TEST(TextureProbeParameters, EveryParameterSaysWhatThePaperGives) {
  for (const auto& parameter : TextureProbeParameters::declarations().all()) {
    const std::string& text = parameter.info.text;
    EXPECT_TRUE(text.find("ot given in the paper") != std::string::npos ||
                text.find("P11") != std::string::npos)
        << parameter.info.name;
  }
}

void expect_refused(const TextureProbeParameters& parameters, const std::string& word) {
  const auto refused = parameters.validate();
  ASSERT_FALSE(refused) << word;
  EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
  EXPECT_NE(refused.error().what.find(word), std::string::npos) << refused.error().what;
}

TEST(TextureProbeParameters, WhatTheSimulationCannotCarryIsRefused) {
  TextureProbeParameters parameters;
  parameters.lever_speed = 25.0;
  parameters.sample_rate = 1000.0;
  parameters.oversampling = 4;  // up to 1800 Hz
  parameters.edge_resonance = 1700.0;
  parameters.resonance_rise = 0.0;
  parameters.servo_tone = 225.0;
  EXPECT_TRUE(parameters.validate());
  parameters.resonance_rise = 0.5;  // 2082 Hz
  expect_refused(parameters, "edge_resonance");
  parameters.resonance_rise = 0.0;
  parameters.servo_tone = 230.0;
  expect_refused(parameters, "servo_tone");
  parameters.servo_tone = 100.0;
  parameters.microphone_low = 2000.0;
  expect_refused(parameters, "microphone_low");
  parameters.microphone_low = 20.0;
  parameters.lever_speed = 26.0;  // 18.15 mm/s, and a height each 0.01 mm
  expect_refused(parameters, "lever_speed");
}

TEST(TextureProbeParameters, ValuesOutOfRangeAreRefused) {
  TextureProbeParameters parameters;
  parameters.adc_bits = 0;
  expect_refused(parameters, "adc_bits");
  parameters = {};
  parameters.sensitivity = std::numeric_limits<double>::quiet_NaN();
  expect_refused(parameters, "sensitivity");
}

}  // namespace
}  // namespace somato
