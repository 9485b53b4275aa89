#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "views/exports/bag_writer.h"
#include "views/exports/recording_export.h"

namespace somato {

/// A bag of ROS 2 (see BagWriter) with `import.toml`, which describes it for import_bags(). The
/// channel `joints` is a topic of sensor_msgs/JointState, the others are topics of
/// std_msgs/Float32MultiArray. Topics of std_msgs/String have the labels (`/labels/NAME`) before
/// the frames of each exploration, and the events (`/exploration`): its number from 1 where it
/// begins, an empty text where it ends.
///
/// Explorations are at least one second apart. Frames without times have those of the recording
/// file, 100 in a second.
class BagExport final : public RecordingExport {
 public:
  static Result<std::unique_ptr<RecordingExport>> begin(const std::string& path);

  explicit BagExport(std::unique_ptr<BagWriter> writer) : writer_(std::move(writer)) {}

  Result<void> begin_exploration(const ExplorationStart& start) override;
  Result<void> frame(std::size_t channel, std::span<const float> values, double time,
                     std::span<const std::uint8_t> valid) override;
  Result<void> end_exploration() override;
  Result<void> finish() override;

  /// The bag, for further topics and files.
  BagWriter& bag() { return *writer_; }

  /// The bag's time (ns) of the latest frame, or of the start before the first frame.
  std::int64_t frame_time() const { return frame_time_; }

  /// The topic of the channel with that index, once an exploration has begun.
  const std::string& topic_of_channel(std::size_t channel) const {
    return writer_->name_of(channels_[channel]);
  }
  /// The field of its messages that has the values.
  std::string field_of_channel(std::size_t channel) const;

  /// The topic of the label with that index.
  const std::string& topic_of_label(std::size_t label) const {
    return writer_->name_of(labels_[label]);
  }

 private:
  struct ExportedChannel {
    double rate = 0.0;
    std::uint64_t frames = 0;
  };

  Result<void> open_topics(const ExplorationStart& first);
  std::string description() const;

  std::unique_ptr<BagWriter> writer_;
  std::size_t events_ = 0;             // The index of a topic.
  std::vector<std::size_t> labels_;    // Their topics.
  std::vector<std::size_t> channels_;  // Their topics.
  std::vector<std::string> label_names_;
  std::vector<ChannelDescription> descriptions_;
  std::vector<ExportedChannel> open_;  // Belongs to the exploration.
  std::int64_t zero_ = 0;              // The bag's time at 0 s of the exploration.
  std::int64_t frame_time_ = 0;
  std::vector<float> values_;
  std::uint64_t explorations_ = 0;
};

}  // namespace somato
