#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files/file_writer.h"
#include "recordings/mcap/mcap_writer.h"
#include "views/exports/new_folder.h"

namespace somato {

/// Writes the folder of a bag of ROS 2: `bag_0.mcap` and `metadata.yaml` (version 5, as ROS 2
/// Humble writes it). Nothing is at its path before finish().
class BagWriter {
 public:
  static Result<std::unique_ptr<BagWriter>> begin(const std::string& path);

  BagWriter(NewFolder folder, FileWriter file);

  /// Adds a topic with messages in CDR and returns its index. Errors: kData for too many topics.
  Result<std::size_t> open_topic(const std::string& name, const McapSchema& schema,
                                 McapChannel channel = {});

  /// Adds a message at `time` (ns, at least 0). Errors: kSystem with the system's reason.
  Result<void> write(std::size_t topic, std::int64_t time, std::string_view message);

  /// Adds a file beside those of the bag. Errors: kSystem with the system's reason.
  Result<void> save(const std::string& name, const std::string& text) const;

  /// Completes the bag and moves it to its path. Errors: kSystem with the system's reason.
  Result<void> finish();

  const std::string& name_of(std::size_t topic) const { return topics_[topic].name; }
  const std::string& type_of(std::size_t topic) const { return topics_[topic].type; }

  /// The latest time of a message, or 0.
  std::int64_t latest_time() const { return latest_time_; }

 private:
  struct Topic {
    std::string name;
    std::string type;
    std::uint16_t id = 0;
    std::uint32_t messages = 0;
  };

  std::string metadata() const;

  NewFolder folder_;
  FileWriter file_;
  McapWriter writer_;
  std::vector<Topic> topics_;
  std::optional<std::int64_t> first_time_;
  std::int64_t latest_time_ = 0;
};

}  // namespace somato
