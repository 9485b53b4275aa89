#include "studies/codes/codes.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "studies/codes/rounding.h"

namespace somato {
namespace {

using CodeSettings = std::vector<SystemBuilder::Setting>;

constexpr std::int64_t kPoints = 10;
constexpr std::int64_t kBins = 10;
constexpr std::int64_t kBands = 16;
constexpr std::int64_t kWideBands = 24;
constexpr std::size_t kLeastHalf = 32;       // frames, two for each band
constexpr std::size_t kLeastWideHalf = 256;  // frames: more than six octaves
constexpr std::size_t kLongestSegment = 4096;
constexpr double kHighest = 0.95;  // of half the frame rate, which may be lower in other recordings

Value text(const std::string& value) {
  return {value};
}

ModuleDescription module(const std::string& name, const std::string& type,
                         const CodeSettings& settings) {
  return SystemBuilder("").module(name, type, settings).description().modules.front();
}

Code single(const std::string& code, const std::string& type, const std::string& frames,
            CodeSettings settings = {}) {
  const std::string name = code + "_of_" + frames;
  settings.insert(settings.begin(), {"input", text(frames)});
  return {code, {module(name, type, settings)}, name, {}};
}

// The ranges are stated, because a range that is learned must not be empty in any training part.
ModuleDescription bins_of(const std::string& frames, const FrameFacts& facts) {
  Value::List low;
  Value::List high;
  for (std::size_t i = 0; i < facts.elements; ++i) {
    const double least = plain(facts.low[i]);
    const double most = plain(facts.high[i]);
    low.push_back({least});
    high.push_back({most > least ? most : least + std::max(1.0, std::fabs(least))});
  }
  return module("bins_of_" + frames, "one_hot",
                {{"input", text(frames)},
                 {"elements", {kBins}},
                 {"low", {low}},
                 {"high", {high}},
                 {"outside", text("clamp")}});
}

Code histogram(const std::string& frames, const FrameFacts& facts) {
  const std::string counts = "counts_of_" + frames;
  const std::string name = "histogram_of_" + frames;
  return {
      "histogram",
      {bins_of(frames, facts), module(counts, "accumulate", {{"input", text("bins_of_" + frames)}}),
       module(name, "normalization", {{"input", text(counts)}, {"norm", text("l1")}})},
      name,
      {}};
}

Code logarithm(const Code& spectrum) {
  Code code = spectrum;
  code.name = "log_" + spectrum.name;
  code.output = "log_" + spectrum.output;
  code.modules.front().name = code.output;
  code.modules.front().settings.entries.push_back({"scale", {}, text("logarithmic")});
  code.logarithm_of = spectrum.name;
  return code;
}

void add_with_logarithm(Code spectrum, std::vector<Code>& codes) {
  codes.push_back(std::move(spectrum));
  codes.push_back(logarithm(codes.back()));
}

Code even_bands(const std::string& frames, double rate) {
  return single("spectrum", "spectrum", frames,
                {{"bands", {kBands}}, {"high", {rounded(kHighest * rate / 2)}}});
}

// From two cycles in a segment to half the frame rate.
Code wide_bands(const std::string& frames, const FrameFacts& facts) {
  const std::size_t segment = std::min(std::bit_floor(facts.shortest_half), kLongestSegment);
  return single("wide_spectrum", "spectrum", frames,
                {{"segment_length", {static_cast<std::int64_t>(segment)}},
                 {"bands", {kWideBands}},
                 {"band_spacing", text("geometric")},
                 {"low", {rounded(2.0 * *facts.rate / static_cast<double>(segment))}},
                 {"high", {rounded(kHighest * *facts.rate / 2)}}});
}

Code bands_per_millimetre(const FrameSource& source, const FrameFacts& facts) {
  const double high = rounded(kHighest * *facts.rate / 2 / *facts.highest_speed);
  return single("stroke_spectrum", "spectrum", source.outputs[0],
                {{"speed", text(source.outputs[1])}, {"bands", {kBands}}, {"high", {high}}});
}

void add_ranges(const Matrix<float>& frames, FrameFacts& facts) {
  for (std::size_t row = 0; row < frames.rows(); ++row) {
    for (std::size_t i = 0; i < facts.elements; ++i) {
      facts.low[i] = std::min(facts.low[i], frames(row, i));
      facts.high[i] = std::max(facts.high[i], frames(row, i));
    }
  }
}

}  // namespace

FrameFacts facts_of(const Recording& frames, bool has_speed) {
  FrameFacts facts;
  const Exploration& first = frames.explorations.front();
  facts.elements = first.channels.front().frames.columns();
  facts.shortest_half = first.channels.front().frames.rows() / 2;
  facts.rate = first.channels.front().rate;
  facts.low.assign(facts.elements, std::numeric_limits<float>::max());
  facts.high.assign(facts.elements, std::numeric_limits<float>::lowest());
  double speed = 0.0;
  for (const Exploration& exploration : frames.explorations) {
    const Channel& channel = exploration.channels.front();
    facts.most_frames = std::max(facts.most_frames, channel.frames.rows());
    facts.shortest_half = std::min(facts.shortest_half, channel.frames.rows() / 2);
    facts.rate = std::min(*facts.rate, channel.rate);
    add_ranges(channel.frames, facts);
    if (!has_speed) continue;
    for (const float value : exploration.channels[1].frames.values()) {
      speed = std::max(speed, std::fabs(double{value}));
    }
  }
  if (*facts.rate <= 0.0) facts.rate.reset();
  if (speed > 0.0) facts.highest_speed = speed;
  return facts;
}

std::vector<Code> codes_of(const FrameSource& source, const FrameFacts& facts) {
  const std::string& frames = source.outputs.front();
  std::vector<Code> codes{single("last", "last", frames)};
  if (facts.most_frames < 2) return codes;
  codes.push_back(single("mean", "mean", frames));
  codes.push_back(single("change", "change", frames));
  codes.push_back(single("curve", "resampling", frames, {{"points", {kPoints}}}));
  codes.push_back(histogram(frames, facts));
  if (!facts.rate || facts.shortest_half < kLeastHalf) return codes;
  add_with_logarithm(even_bands(frames, *facts.rate), codes);
  if (facts.shortest_half >= kLeastWideHalf) add_with_logarithm(wide_bands(frames, facts), codes);
  if (facts.highest_speed) add_with_logarithm(bands_per_millimetre(source, facts), codes);
  return codes;
}

void set_floor(Code& code, double floor) {
  code.modules.front().settings.entries.push_back({"floor", {}, Value{floor}});
}

Code product_code(const FrameSource& source, const FrameFacts& facts) {
  const std::string& posture = source.outputs[0];
  const std::string name = posture + "_times_" + source.outputs[1];
  const std::string sum = "sum_of_" + name;
  return {"product",
          {bins_of(posture, facts),
           module(name, "tensor_product",
                  {{"inputs", {Value::List{text("bins_of_" + posture), text(source.outputs[1])}}}}),
           module(sum, "accumulate", {{"input", text(name)}})},
          sum,
          {}};
}

const std::vector<std::pair<Scaling, std::string>>& Choices<Scaling>::all() {
  static const std::vector<std::pair<Scaling, std::string>> choices{
      {Scaling::kNone, "none"}, {Scaling::kStandardized, "standardized"}, {Scaling::kUnit, "unit"}};
  return choices;
}

Code scaled(const Code& code, Scaling scaling) {
  if (scaling == Scaling::kNone) return code;
  Code result = code;
  result.output = choice_name(scaling) + "_" + code.output;
  if (scaling == Scaling::kUnit) {
    result.modules.push_back(
        module(result.output, "normalization", {{"input", text(code.output)}}));
  } else {
    result.modules.push_back(
        module(result.output, "standardization",
               {{"input", text(code.output)}, {"constant_columns", text("zero")}}));
  }
  return result;
}

}  // namespace somato
