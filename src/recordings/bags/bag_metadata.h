#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace somato {

/// The description of a bag (metadata.yaml of rosbag2), as far as it is used.
struct BagMetadata {
  std::vector<std::string> files;
  std::string compression;
  std::map<std::string, std::uint64_t> messages;           ///< By topic.
  std::map<std::string, std::uint64_t> messages_of_files;  ///< By the path of the file.
  std::optional<std::uint64_t> all_messages;
};

/// The numbers of messages that the files of a bag hold.
struct BagCounts {
  std::map<std::string, std::uint64_t> topics;  ///< By topic.
  std::map<std::string, std::uint64_t> files;   ///< By the name of the file, without its folder.
};

/// Reads the description; keys that are not needed are ignored. rosbag2 writes one key or item on
/// each line.
BagMetadata parse_bag_metadata(std::string_view text);

/// How the numbers of messages that a bag holds differ from those that its description lists: a
/// sentence for each topic and file, or one for the sum, if only that differs.
std::vector<std::string> differences(const BagMetadata& listed, const BagCounts& held);

}  // namespace somato
