#include "studies/codes/codes.h"

#include <gtest/gtest.h>

#include "studies/support/made_senses.h"

namespace somato {
namespace {

using Names = std::vector<std::string>;

FrameSource touch_source() {
  return {{}, {"touch"}};
}

FrameFacts facts(std::size_t frames, double rate) {
  FrameFacts facts;
  facts.elements = 1;
  facts.most_frames = frames;
  facts.shortest_half = frames / 2;
  if (rate > 0.0) facts.rate = rate;
  facts.low = {0.0F};
  facts.high = {1.0F};
  return facts;
}

Names names_of(const std::vector<Code>& codes) {
  Names names;
  for (const Code& code : codes) names.push_back(code.name);
  return names;
}

Value setting_of(const Code& code, const std::string& key) {
  return std::get<Value>(code.modules.front().settings.find(key)->content);
}

TEST(Codes, DependOnTheNumberOfFramesAndTheRate) {
  const Names several{"last", "mean", "change", "curve", "histogram"};
  Names spectra = several;
  spectra.insert(spectra.end(), {"spectrum", "log_spectrum"});
  Names wide = spectra;
  wide.insert(wide.end(), {"wide_spectrum", "log_wide_spectrum"});
  EXPECT_EQ(names_of(codes_of(touch_source(), facts(1, 10))), (Names{"last"}));
  EXPECT_EQ(names_of(codes_of(touch_source(), facts(63, 10))), several);
  EXPECT_EQ(names_of(codes_of(touch_source(), facts(64, 10))), spectra);
  EXPECT_EQ(names_of(codes_of(touch_source(), facts(511, 10))), spectra);
  EXPECT_EQ(names_of(codes_of(touch_source(), facts(512, 10))), wide);
  EXPECT_EQ(names_of(codes_of(touch_source(), facts(512, 0))), several);
}

TEST(Codes, ASpeedAddsASpectrumInCyclesPerMillimetre) {
  FrameFacts moving = facts(64, 100);
  moving.highest_speed = 50.0;
  const auto codes = codes_of({{}, {"touch", "speed"}}, moving);
  ASSERT_EQ(codes.back().name, "log_stroke_spectrum");
  EXPECT_EQ(setting_of(codes.back(), "speed"), Value{std::string("speed")});
  EXPECT_EQ(setting_of(codes.back(), "high"), Value{0.95});  // 0.95 x 50 Hz by 50 mm/s
}

TEST(Codes, WideBandsBeginWithTwoCyclesInASegment) {
  const auto codes = codes_of(touch_source(), facts(20000, 8192));
  EXPECT_EQ(setting_of(codes[7], "segment_length"), Value{std::int64_t{4096}});
  EXPECT_EQ(setting_of(codes[7], "low"), Value{4.0});
  EXPECT_EQ(setting_of(codes[7], "high"), Value{3891.0});  // 0.95 x 4096 Hz
}

TEST(Codes, FactsAreThoseOfAllExplorations) {
  Recording frames = testing::frames_as_given("touch", {{1, 2, 3, 4}, {-7, 5}});
  frames.explorations[0].channels[0].rate = 20.0;
  frames.explorations[1].channels[0].rate = 10.0;
  const FrameFacts found = facts_of(frames, false);
  EXPECT_EQ(found.most_frames, 4U);
  EXPECT_EQ(found.shortest_half, 1U);
  EXPECT_EQ(found.rate, 10.0);
  EXPECT_EQ(found.low, std::vector<float>{-7.0F});
  EXPECT_EQ(found.high, std::vector<float>{5.0F});
  frames.explorations[1].channels[0].rate = 0.0;
  EXPECT_FALSE(facts_of(frames, false).rate.has_value());
}

TEST(Codes, TheRangeOfAConstantElementIsNotEmpty) {
  FrameFacts constant = facts(2, 0);
  constant.low = {3.0F};
  constant.high = {3.0F};
  const Code histogram = codes_of(touch_source(), constant).back();
  EXPECT_EQ(setting_of(histogram, "low"), Value{Value::List{{3.0}}});
  EXPECT_EQ(setting_of(histogram, "high"), Value{Value::List{{6.0}}});
}

TEST(Codes, AScalingIsAFurtherModule) {
  const Code last = codes_of(touch_source(), facts(1, 0)).front();
  EXPECT_EQ(scaled(last, Scaling::kNone).output, "last_of_touch");
  EXPECT_EQ(scaled(last, Scaling::kUnit).output, "unit_last_of_touch");
  EXPECT_EQ(scaled(last, Scaling::kStandardized).modules.size(), 2U);
}

}  // namespace
}  // namespace somato
