#include "somato/graph/live_system.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "somato/core/check.h"
#include "somato/graph/system_model.h"
#include "systems/modules/sum_of_frames.h"
#include "systems/walk/sum_reading.h"
#include "systems/walk/walk.h"

namespace somato {
namespace {

// A memory of more elements would be as large as all else.
constexpr std::size_t kMostFollowed = std::size_t{1} << 26;

const Module& module_at(const System& system, std::size_t module) {
  return *system.modules()[module].module;
}

// A sum of sparse frames that the map reads, divided by its norm or as it is.
struct FollowedSum {
  std::size_t frames = 0;  // the module whose frames are added
  Norm norm = Norm::kNone;
};

std::optional<FollowedSum> followed_sum(const System& system, std::size_t map) {
  const SomParameters& parameters = som_of(system, map)->parameters();
  if (!follows_from_products(parameters) || !parameters.relevances.empty()) return {};
  std::size_t module = system.modules()[map].inputs.front();
  FollowedSum sum;
  if (const auto norm = modules::norm_divided_by(module_at(system, module))) {
    sum.norm = *norm;
    module = system.modules()[module].inputs.front();
  }
  if (!modules::adds_frames(module_at(system, module)) || !SumReading::follows(sum.norm)) return {};
  sum.frames = system.modules()[module].inputs.front();
  const PortType& frames = system.modules()[sum.frames].output;
  const bool is_whole = system.modules()[module].output.rate == Rate::kExploration;
  if (!is_whole || !frames.sparse || frames.size() > kMostFollowed) return {};
  return sum;
}

}  // namespace

class LiveSystem::Impl {
 public:
  Impl(const System& system, std::size_t map)
      : som_(*som_of(system, map)),
        input_(system.modules()[map].inputs.front()),
        walk_(system, {input_}, Outputs::kLatest),
        followed_(followed_sum(system, map)) {
    if (followed_) sum_.emplace(som_, followed_->norm);
  }

  Result<void> open(const System& system);
  void start(double frame_rate);
  Result<void> step(std::span<const std::span<const float>> frame);
  Result<std::size_t> winner();
  Result<std::size_t> winner_among(std::span<const std::size_t> neurons);
  Result<SignalView> input();
  const std::vector<std::string>& channels() const { return channels_; }
  const std::vector<std::size_t>& elements() const { return elements_; }

 private:
  const Som& som_;
  std::size_t input_;  // the module whose value the map reads
  Walk walk_;
  std::vector<std::string> channels_;
  std::vector<std::size_t> elements_;  // of each channel
  Exploration present_;                // of one frame
  std::optional<FollowedSum> followed_;
  std::optional<SumReading> sum_;
  SomWorkspace workspace_;
};

// A frame holds all channels, so they have to come together.
Result<void> LiveSystem::Impl::open(const System& system) {
  const auto together = walk_.channels();
  if (together.size() != 1) {
    return fail(ErrorKind::kUsage,
                "the frames of '" + together.front().front() + "' and of '" +
                    together.back().front() + "' are not recorded together",
                {}, "record the channels together, frame by frame");
  }
  channels_ = together.front();
  for (const std::string& name : channels_) {
    Channel channel;
    channel.name = name;
    for (const SystemModule& module : system.modules()) {
      const auto* source = dynamic_cast<const Source*>(module.module.get());
      if (source == nullptr || source->channel() != name) continue;
      channel.frames = Matrix<float>(1, source->channel_elements());
    }
    elements_.push_back(channel.frames.columns());
    present_.channels.push_back(std::move(channel));
  }
  return {};
}

void LiveSystem::Impl::start(double frame_rate) {
  for (Channel& channel : present_.channels) channel.rate = frame_rate;
  require(walk_.start(&present_).has_value(), "a live system has the channels of its system");
  if (sum_) sum_->start();
}

Result<void> LiveSystem::Impl::step(std::span<const std::span<const float>> frame) {
  require(frame.size() == channels_.size(), "a frame needs the values of every channel");
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const std::span<float> row = present_.channels[i].frames.row(0);
    require(frame[i].size() == row.size(), "a channel has the wrong number of elements");
    std::copy(frame[i].begin(), frame[i].end(), row.begin());
  }
  SOMATO_TRY_VOID(walk_.step(0));
  if (sum_) sum_->add(*walk_.output(followed_->frames));
  return {};
}

// The input of the map for the exploration so far.
Result<SignalView> LiveSystem::Impl::input() {
  require(walk_.has_frames(), "a live system has not received a frame yet");
  SOMATO_TRY_VOID(walk_.settle());
  return *walk_.output(input_);
}

Result<std::size_t> LiveSystem::Impl::winner() {
  require(walk_.has_frames(), "a live system has not received a frame yet");
  if (const auto winner = sum_ ? sum_->winner() : std::nullopt) return *winner;
  SOMATO_TRY(const SignalView read, input());
  return som_.winner(read, workspace_);
}

Result<std::size_t> LiveSystem::Impl::winner_among(std::span<const std::size_t> neurons) {
  SOMATO_TRY(const SignalView read, input());
  return som_.winner_among(neurons, read, workspace_);
}

Result<LiveSystem> LiveSystem::build(const System& system, std::size_t map) {
  const Som* som = som_of(system, map);
  require(som != nullptr && som->neurons() > 0, "a live system needs a trained map");
  auto impl = std::make_unique<Impl>(system, map);
  if (auto opened = impl->open(system); !opened) return fail(system.at_module(opened.error(), map));
  impl->start(0.0);
  return LiveSystem(std::move(impl));
}

LiveSystem::LiveSystem(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LiveSystem::LiveSystem(LiveSystem&&) noexcept = default;
LiveSystem& LiveSystem::operator=(LiveSystem&&) noexcept = default;
LiveSystem::~LiveSystem() = default;

const std::vector<std::string>& LiveSystem::channels() const {
  return impl_->channels();
}

const std::vector<std::size_t>& LiveSystem::elements() const {
  return impl_->elements();
}

void LiveSystem::start(double frame_rate) {
  impl_->start(frame_rate);
}

Result<void> LiveSystem::step(std::span<const std::span<const float>> frame) {
  return impl_->step(frame);
}

Result<std::size_t> LiveSystem::winner() {
  return impl_->winner();
}

Result<std::size_t> LiveSystem::winner_among(std::span<const std::size_t> neurons) {
  return impl_->winner_among(neurons);
}

Result<SignalView> LiveSystem::input() {
  return impl_->input();
}

}  // namespace somato
