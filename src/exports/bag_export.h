#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exports/new_folder.h"
#include "exports/recording_export.h"
#include "files/file_writer.h"
#include "recording/mcap_writer.h"

namespace somato {

/// A bag of ROS 2: a folder with `bag_0.mcap`, `metadata.yaml` (version 5, as ROS 2 Humble writes
/// it) and `import.toml`, which describes it for import_bags(). The channel `joints` is a topic of
/// sensor_msgs/JointState, the others are topics of std_msgs/Float32MultiArray. Topics of
/// std_msgs/String have the labels (`/labels/NAME`) before the frames of each exploration, and the
/// events (`/exploration`): its number from 1 where it begins, an empty text where it ends.
///
/// Explorations are at least one second apart. Frames without times have those of the recording
/// file, 100 in a second.
class BagExport final : public RecordingExport {
 public:
  static Result<std::unique_ptr<RecordingExport>> begin(const std::string& path);

  BagExport(NewFolder folder, FileWriter file);

  Result<void> add(const Exploration& exploration) override;
  Result<void> finish() override;

 private:
  struct Topic {
    std::string name;
    std::string type;
    std::uint16_t id = 0;
    std::uint32_t messages = 0;
  };

  Result<void> open_topics(const Exploration& first);
  Result<std::size_t> open_topic(const std::string& name, const McapSchema& schema,
                                 McapChannel channel);
  Result<void> write(std::size_t topic, std::int64_t time, std::string_view message);
  Result<void> begin_exploration(const Exploration& exploration, std::int64_t start);
  Result<void> add_frame(const Exploration& exploration, std::size_t channel, std::size_t frame,
                         std::int64_t time);
  Result<void> save(const std::string& name, const std::string& text) const;
  std::string metadata() const;
  std::string description() const;

  NewFolder folder_;
  FileWriter file_;
  McapWriter writer_;
  std::vector<Topic> topics_;
  std::size_t events_ = 0;             // The index of a topic.
  std::vector<std::size_t> labels_;    // Their topics.
  std::vector<std::size_t> channels_;  // Their topics.
  std::vector<std::string> label_names_;
  std::vector<ChannelDescription> descriptions_;
  std::vector<float> values_;
  std::uint64_t explorations_ = 0;
  std::optional<std::int64_t> first_time_;
  std::int64_t latest_time_ = 0;
};

}  // namespace somato
