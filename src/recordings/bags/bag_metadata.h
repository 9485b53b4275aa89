#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace somato {

/// The description of a bag (metadata.yaml of rosbag2), as far as it is used.
struct BagMetadata {
  std::vector<std::string> files;
  std::string compression;
  std::map<std::string, std::uint64_t> messages;  ///< By topic.
};

/// Reads the description; keys that are not needed are ignored. rosbag2 writes one key or item on
/// each line.
BagMetadata parse_bag_metadata(std::string_view text);

/// How the numbers of messages that the files of a bag hold, by topic, differ from those that its
/// description lists: a sentence for each topic.
std::vector<std::string> differences(const BagMetadata& listed,
                                     const std::map<std::string, std::uint64_t>& held);

}  // namespace somato
