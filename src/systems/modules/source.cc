#include "systems/modules/support.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/text/flag_hint.h"
#include "base/text/number_of_text.h"

namespace somato {

namespace modules {
namespace {

/// Treatment of a missing value of a sensor.
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
  std::vector<double> fill;

  static const Declarations<ChannelParameters>& declarations() {
    using P = ChannelParameters;
    static const auto declared =
        Declarations<P>()
            .add("channel", &P::channel, "", Range::any(),
                 "Name of the recording's channel. Required.")
            .add("shape", &P::shape, "", Range::between(1, 1 << 24),
                 "Shape of a frame, which the recording must have; empty: that of the recording.")
            .add("elements", &P::elements, "", Range::any(),
                 "Elements to select, by name or by number from 1; empty: all.")
            .add("invalid", &P::invalid, "", Range::any(),
                 "Treatment of a value marked as invalid: an error, 0, or the preceding valid "
                 "value (0 if there is none).")
            .add("fill", &P::fill, "", Range::between(-1e30, 1e30),
                 "Numbers that replace values marked as invalid, one for each selected element or "
                 "one for all; with \"hold\", those before the first valid value.");
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
  const auto number = number_of_text<std::size_t>(name);
  if (number && *number >= 1 && *number <= elements) return *number - 1;
  if (!names.empty()) return fail(unknown_name("element", name, {}, names));
  return fail(ErrorKind::kUsage, "unknown element '" + name + "'", {},
              fmt::format("elements are numbered from 1 to {}", elements));
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
      return fail(ErrorKind::kUsage, "'channel' is missing", {},
                  "add channel = \"...\"; the channels of the recording are: " +
                      fmt::format("{}", fmt::join(known, ", ")));
    }
    return fail(unknown_name("channel", parameters_.channel, {}, known));
  }

  Result<PortType> connect(const std::vector<Connection>& /*inputs*/) override { return type_; }

  const std::string& channel() const override { return parameters_.channel; }
  std::size_t channel_elements() const override { return source_elements_; }
  const std::vector<std::size_t>& elements() const override { return elements_; }

  Result<void> read(const Channel& channel, std::size_t row, bool is_first,
                    SignalBuffer& out) const override {
    std::vector<float>& values = out.begin_dense(elements_.size());
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      const bool valid = channel.valid.empty() || channel.valid(row, elements_[i]) != 0;
      if (valid) {
        values[i] = channel.frames(row, elements_[i]);
      } else if (refuses()) {
        return fail(ErrorKind::kData,
                    fmt::format("channel '{}', frame {}, element {} is not valid", channel.name,
                                row + 1, elements_[i] + 1),
                    {}, R"(set 'invalid' of the module to "zero" or "hold", or 'fill' to numbers)");
      } else if (is_first || parameters_.invalid != Invalid::kHold) {
        values[i] = filled(i);
      }
    }
    return {};
  }

 private:
  bool refuses() const {
    return parameters_.invalid == Invalid::kRefuse && parameters_.fill.empty();
  }

  float filled(std::size_t element) const {
    if (parameters_.fill.empty()) return 0.0F;
    return static_cast<float>(parameters_.fill[parameters_.fill.size() == 1 ? 0 : element]);
  }

  // Uses only the module's own settings.
  Result<void> open_without_recording() {
    if (parameters_.channel.empty()) {
      return fail(ErrorKind::kUsage, "'channel' is missing", {}, "add channel = \"...\"");
    }
    if (parameters_.shape.empty()) {
      return fail(ErrorKind::kUsage, "its shape is unknown without a recording", {},
                  fmt::format("use a recording{}, or write shape = [...]", flag_hint("data")));
    }
    ChannelLayout channel{parameters_.channel, {}, parameters_.shape, {}, "the recording"};
    // The names of its elements are irrelevant; only their number is used.
    channel.element_names = parameters_.elements;
    return open(channel);
  }

  Result<void> open(const ChannelLayout& channel) {
    if (!parameters_.shape.empty() && parameters_.shape != channel.shape) {
      return fail(
          ErrorKind::kUsage,
          fmt::format("channel '{}' has the shape {} in the recording, not {}", channel.name,
                      fmt::join(channel.shape, " x "), fmt::join(parameters_.shape, " x ")),
          {}, "correct 'shape', or remove it");
    }
    type_ = {Rate::kFrame, channel.shape, false, channel.clock};
    SOMATO_TRY_VOID(checked_size(type_, {}));
    source_elements_ = type_.size();
    for (std::size_t i = 0; parameters_.elements.empty() && i < source_elements_; ++i) {
      elements_.push_back(i);
    }
    for (const std::string& name : parameters_.elements) {
      SOMATO_TRY(const std::size_t element, find_element(channel, source_elements_, name));
      elements_.push_back(element);
    }
    if (!parameters_.elements.empty()) type_.shape = {elements_.size()};
    return check_fill();
  }

  Result<void> check_fill() const {
    const std::size_t count = parameters_.fill.size();
    if (count > 0 && parameters_.invalid == Invalid::kZero) {
      return fail(ErrorKind::kUsage, "invalid = \"zero\" and 'fill' exclude each other", {},
                  "remove one of them");
    }
    if (count < 2 || count == elements_.size()) return {};
    return fail(ErrorKind::kUsage,
                fmt::format("'fill' has {} numbers for {} elements", count, elements_.size()), {},
                "write one number for each element, or one for all");
  }

  Parameters parameters_;
  PortType type_;
  std::size_t source_elements_ = 0;
  std::vector<std::size_t> elements_;
};

}  // namespace

std::vector<ModuleType> source_types() {
  return {describe<ChannelModule>("channel", "A channel of the recording.", {},
                                  "Every frame of the channel, or the selected elements of it.")};
}

}  // namespace modules
}  // namespace somato
