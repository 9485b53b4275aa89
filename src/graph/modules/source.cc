#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "graph/modules/support.h"

namespace somato {

Result<SignalView> Stepper::advance(std::span<const SignalView> inputs) {
  return step(inputs).map([this](Signal output) {
    stepped_ = std::move(output);
    return stepped_.view();
  });
}

Result<Sequence> Source::run(std::span<const Sequence* const> /*inputs*/) const {
  return fail(ErrorKind::kUsage, "a source has no inputs to run on");
}

namespace modules {
namespace {

/// What happens to an element that the sensor told nothing about.
enum class Invalid { kRefuse, kZero, kHold };

}  // namespace
}  // namespace modules

template <>
struct Choices<modules::Invalid> {
  static const std::vector<std::pair<modules::Invalid, std::string>>& all() {
    static const std::vector<std::pair<modules::Invalid, std::string>> choices{
        {modules::Invalid::kRefuse, "refuse"},
        {modules::Invalid::kZero, "zero"},
        {modules::Invalid::kHold, "hold"}};
    return choices;
  }
};

namespace modules {
namespace {

struct ChannelParameters {
  std::string channel;
  std::vector<std::size_t> shape;
  std::vector<std::string> elements;
  Invalid invalid = Invalid::kRefuse;

  static const Declarations<ChannelParameters>& declarations() {
    using P = ChannelParameters;
    static const auto declared =
        Declarations<P>()
            .add("channel", &P::channel, "", Range::any(),
                 "Name of the recording's channel. Has to be given.")
            .add("shape", &P::shape, "", Range::between(1, 1 << 24),
                 "Shape of a frame, which the recording must have; none: whatever it has.")
            .add("elements", &P::elements, "", Range::any(),
                 "The elements to take, by name or by number from 1; none: all of them.")
            .add("invalid", &P::invalid, "", Range::any(),
                 "What becomes of a value that the sensor did not give: an error, 0, or the last "
                 "valid value before it (0 where there is none).");
    return declared;
  }
};

// By name, else by number from 1.
Result<std::size_t> find_element(const ChannelLayout& channel, std::size_t elements,
                                 const std::string& name) {
  const std::vector<std::string>& names = channel.element_names;
  if (const auto found = std::find(names.begin(), names.end(), name); found != names.end()) {
    return static_cast<std::size_t>(found - names.begin());
  }
  std::size_t number = 0;
  const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
  const bool is_number = read.ec == std::errc{} && read.ptr == name.data() + name.size();
  if (is_number && number >= 1 && number <= elements) return number - 1;
  if (!names.empty()) return fail(unknown_name("element", name, {}, names));
  return fail(ErrorKind::kUsage, "there is no element '" + name + "'", {},
              fmt::format("number the elements from 1 to {}", elements));
}

class ChannelModule : public Source {
 public:
  using Parameters = ChannelParameters;
  explicit ChannelModule(Parameters parameters) : parameters_(std::move(parameters)) {}

  Result<void> open(const RecordingLayout& layout) override {
    std::vector<std::string> known;
    if (layout.channels.empty()) return open_without_recording();
    for (const ChannelLayout& channel : layout.channels) {
      if (channel.name == parameters_.channel) return open(channel);
      known.push_back(channel.name);
    }
    if (parameters_.channel.empty()) {
      return fail(
          ErrorKind::kUsage, "it does not say which channel it is", {},
          "add channel = \"...\"; the recording has: " + fmt::format("{}", fmt::join(known, ", ")));
    }
    return fail(unknown_name("channel", parameters_.channel, {}, known));
  }

  Result<PortType> connect(const std::vector<Connection>& /*inputs*/) override { return type_; }

  Result<Sequence> read(const Exploration& exploration) const override {
    Result<const Channel*> found = find_channel(exploration, parameters_.channel);
    if (!found) return fail(std::move(found.error()));
    const Channel& channel = **found;
    if (channel.frames.columns() != source_elements_) {
      return fail(ErrorKind::kData,
                  fmt::format("channel '{}' has {} elements where the system takes {}",
                              channel.name, channel.frames.columns(), source_elements_));
    }
    Matrix<float> values(channel.frames.rows(), elements_.size());
    for (std::size_t frame = 0; frame < values.rows(); ++frame) {
      if (auto taken = take(channel, frame, values); !taken) return fail(taken.error());
    }
    return Sequence{Samples(std::move(values)), channel.frame_rate()};
  }

  const std::string& channel() const override { return parameters_.channel; }
  std::size_t channel_elements() const override { return source_elements_; }

  void take(std::span<const float> frame, SignalBuffer& out) const override {
    std::vector<float>& values = out.begin_dense(elements_.size());
    for (std::size_t i = 0; i < elements_.size(); ++i) values[i] = frame[elements_[i]];
  }

 private:
  // Its own word is all there is.
  Result<void> open_without_recording() {
    if (parameters_.channel.empty()) {
      return fail(ErrorKind::kUsage, "it does not say which channel it is", {},
                  "add channel = \"...\"");
    }
    if (parameters_.shape.empty()) {
      return fail(ErrorKind::kUsage, "without a recording its shape is unknown", {},
                  "give a recording with --data, or write shape = [...]");
    }
    ChannelLayout channel{parameters_.channel, {}, parameters_.shape, {}, "the recording"};
    // Whatever names its elements have: only their number is asked for.
    channel.element_names = parameters_.elements;
    return open(channel);
  }

  Result<void> open(const ChannelLayout& channel) {
    if (!parameters_.shape.empty() && parameters_.shape != channel.shape) {
      return fail(
          ErrorKind::kUsage,
          fmt::format("channel '{}' has the shape {} in the recording, not {}", channel.name,
                      fmt::join(channel.shape, " x "), fmt::join(parameters_.shape, " x ")),
          {}, "correct 'shape', or leave it out");
    }
    type_ = {Rate::kFrame, channel.shape, false, channel.clock};
    if (auto possible = checked_size(type_, {}); !possible) return fail(possible.error());
    source_elements_ = type_.size();
    for (std::size_t i = 0; parameters_.elements.empty() && i < source_elements_; ++i) {
      elements_.push_back(i);
    }
    for (const std::string& name : parameters_.elements) {
      const Result<std::size_t> element = find_element(channel, source_elements_, name);
      if (!element) return fail(element.error());
      elements_.push_back(*element);
    }
    if (!parameters_.elements.empty()) type_.shape = {elements_.size()};
    return {};
  }

  Result<void> take(const Channel& channel, std::size_t frame, Matrix<float>& values) const {
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      const bool valid = channel.valid.empty() || channel.valid(frame, elements_[i]) != 0;
      values(frame, i) = channel.frames(frame, elements_[i]);
      if (valid) continue;
      if (parameters_.invalid == Invalid::kRefuse) {
        return fail(ErrorKind::kData,
                    fmt::format("channel '{}', frame {}, element {} is not valid", channel.name,
                                frame + 1, elements_[i] + 1),
                    {}, R"(set 'invalid' of the module to "zero" or "hold")");
      }
      const bool hold = parameters_.invalid == Invalid::kHold && frame > 0;
      values(frame, i) = hold ? values(frame - 1, i) : 0.0F;
    }
    return {};
  }

  Parameters parameters_;
  PortType type_;
  std::size_t source_elements_ = 0;
  std::vector<std::size_t> elements_;
};

}  // namespace

std::vector<ModuleType> source_types() {
  return {describe<ChannelModule>("channel", "A channel of the recording.", {},
                                  "Every frame of the channel, or those elements of it.")};
}

}  // namespace modules
}  // namespace somato
