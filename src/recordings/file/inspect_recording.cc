#include "somato/recording/inspect_recording.h"

#include <algorithm>
#include <map>
#include <utility>

#include "recordings/explorations/nanoseconds.h"
#include "recordings/file/recording_interpreter.h"
#include "recordings/mcap/mcap_reader.h"

namespace somato {
namespace {

using Meaning = RecordingInterpreter::Meaning;

constexpr std::size_t kMostLabelBytes = std::size_t{4} << 20;
constexpr std::size_t kMostElementsWithRanges = std::size_t{1} << 16;  // More than any skin has.
constexpr std::size_t kBytesAnEntry = 128;  // Approximate memory in addition to its text.

// Counts the values of labels, as long as there is room for new ones.
class LabelCounter {
 public:
  void add(const std::vector<Label>& labels) {
    for (const Label& label : labels) {
      LabelSummary* summary = find(label.name);
      if (summary) count(*summary, label.value);
    }
  }
  std::vector<LabelSummary> take() { return std::move(labels_); }

 private:
  bool has_room(std::size_t bytes) {
    const std::size_t more = bytes + kBytesAnEntry;
    if (bytes_ + more > kMostLabelBytes) return false;
    bytes_ += more;
    return true;
  }

  LabelSummary* find(const std::string& name) {
    const auto known = by_name_.find(name);
    if (known != by_name_.end()) return &labels_[known->second];
    if (!has_room(2 * name.size())) return nullptr;
    by_name_.emplace(name, labels_.size());
    labels_.push_back({name, {}, 0});
    return &labels_.back();
  }

  void count(LabelSummary& summary, const std::string& value) {
    const auto key = std::pair(summary.name, value);
    const auto known = by_value_.find(key);
    if (known != by_value_.end()) {
      ++summary.values[known->second].explorations;
    } else if (has_room(2 * value.size() + summary.name.size())) {
      by_value_.emplace(key, summary.values.size());
      summary.values.push_back({value, 1});
    } else {
      ++summary.others;
    }
  }

  std::vector<LabelSummary> labels_;
  std::map<std::string, std::size_t> by_name_;
  std::map<std::pair<std::string, std::string>, std::size_t> by_value_;
  std::size_t bytes_ = 0;
};

class Inspection {
 public:
  explicit Inspection(McapReader& file) : file_(&file), meanings_(file) {}

  RecordingSummary run() {
    Result<void> done;
    for (bool more = true; done && more;) {
      const Result<bool> stepped = step();
      if (stepped) more = *stepped;
      if (!stepped) done = fail(stepped.error());
    }
    if (meanings_.is_open()) end();
    if (done) done = meanings_.finish();
    if (!done) summary_.damage = done.error();
    summary_.knows_explorations = !meanings_.is_foreign();
    summary_.labels = labels_.take();
    for (ChannelSummary& channel : summary_.channels) {
      channel.ranges = std::move(ranges_[channel.description.name]).elements();
    }
    summary_.compression = file_->compressions();
    summary_.size = file_->size();
    return std::move(summary_);
  }

 private:
  // Whether there is more to come.
  Result<bool> step() {
    SOMATO_TRY(const std::optional<McapMessage> message, file_->next());
    if (!message) return false;
    if (summary_.unfit) return true;
    const Result<Meaning> interpreted = meanings_.interpret(*message);
    if (!interpreted && meanings_.is_unfit()) {
      summary_.unfit = interpreted.error();
      return true;
    }
    SOMATO_TRY(const Meaning meaning, interpreted);
    if (meaning == Meaning::kBegin) labels_.add(meanings_.exploration().labels);
    if (meaning == Meaning::kFrame) see(meanings_.frames());
    if (meaning == Meaning::kEnd) end();
    return true;
  }

  void see(const std::vector<RecordingInterpreter::Frame>& frames) {
    const std::int64_t time = frames.front().time;
    earliest_ = std::min(earliest_.value_or(time), time);
    latest_ = std::max(latest_.value_or(time), time);
    for (const RecordingInterpreter::Frame& frame : frames) {
      if (frame.values.size() > kMostElementsWithRanges) continue;
      ranges_[meanings_.channels()[frame.channel].description.name].add(frame.values, frame.valid);
    }
  }

  void end() {
    ++summary_.explorations;
    for (const InterpretedChannel& channel : meanings_.channels()) add(channel);
    if (earliest_) summary_.duration += seconds_of(*latest_ - *earliest_);
    earliest_.reset();
    latest_.reset();
  }

  void add(const InterpretedChannel& channel) {
    const auto [known, is_new] =
        by_name_.emplace(channel.description.name, summary_.channels.size());
    if (is_new) {
      const double rate = channel.description.rate;
      summary_.channels.push_back({channel.description,
                                   channel.elements,
                                   0,
                                   channel.frames,
                                   channel.frames,
                                   rate,
                                   rate,
                                   {}});
    }
    ChannelSummary& summary = summary_.channels[known->second];
    summary.least_rate = std::min(summary.least_rate, channel.description.rate);
    summary.most_rate = std::max(summary.most_rate, channel.description.rate);
    ++summary.explorations;
    summary.elements = std::max(summary.elements, channel.elements);
    summary.least_frames = std::min<std::uint64_t>(summary.least_frames, channel.frames);
    summary.most_frames = std::max<std::uint64_t>(summary.most_frames, channel.frames);
  }

  McapReader* file_;
  RecordingInterpreter meanings_;
  LabelCounter labels_;
  std::map<std::string, std::size_t> by_name_;
  std::map<std::string, ElementRanges> ranges_;
  RecordingSummary summary_;
  std::optional<std::int64_t> earliest_;
  std::optional<std::int64_t> latest_;
};

}  // namespace

Result<RecordingSummary> inspect_recording(const std::string& path) {
  SOMATO_TRY(McapReader file, McapReader::open(operating_system(), path));
  return Inspection(file).run();
}

}  // namespace somato
