#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/ros/topic_type.h"
#include "somato/core/result.h"

namespace somato {

/// A topic of a bag.
struct BagTopic {
  std::string name;
  TopicEncoding encoding;

  bool is_same(const BagTopic& other) const {
    return name == other.name && encoding.type == other.encoding.type &&
           encoding.message_encoding == other.encoding.message_encoding;
  }
};

/// A message of a bag; the data are valid until the next one is read.
struct BagMessage {
  std::size_t topic = 0;  ///< Index in BagSource::topics().
  std::int64_t time = 0;  ///< Nanoseconds by the recorder's clock.
  std::string_view data;
  std::size_t file = 0;  ///< Its number among the files of the bag.
};

/// The messages of a bag in the order in which they were recorded.
class BagSource {
 public:
  BagSource() = default;
  BagSource(const BagSource&) = delete;
  BagSource(BagSource&&) = delete;
  BagSource& operator=(const BagSource&) = delete;
  BagSource& operator=(BagSource&&) = delete;
  virtual ~BagSource() = default;

  /// The next message; nothing after the last one. Errors: kSystem with the system's reason; kData
  /// with the place for a damaged file.
  virtual Result<std::optional<BagMessage>> next() = 0;

  /// The topics so far; next() may add more.
  virtual const std::vector<BagTopic>& topics() const = 0;
};

}  // namespace somato
