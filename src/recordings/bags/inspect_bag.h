#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "recordings/bags/bag_files.h"
#include "somato/core/result.h"

namespace somato {

/// A topic of a bag, with the channels that it has without a description.
struct TopicSummary {
  struct Channel {
    std::string name;
    std::string unit;
    std::size_t elements = 0;  ///< In the first message that has values.
  };
  std::string name;
  std::string type;
  std::vector<Channel> channels;
  std::string reason;  ///< Why there are no channels; empty if there are.
  std::uint64_t messages = 0;
  std::int64_t last = 0;       ///< The time of the latest message, in ns by the recorder's clock.
  std::int64_t passed = 0;     ///< The time in which that clock went forward, in ns.
  std::uint64_t set_back = 0;  ///< How often the time of a message precedes that of the one before.
  std::uint64_t not_of_calendar = 0;  ///< Messages with times before the year 2000.
  std::int64_t longest_gap = 0;

  /// Messages per second while the clock went forward, or 0 if there are no two times.
  double rate() const;
};

/// Summary of a bag.
struct BagSummary {
  std::string name;
  std::uint64_t files = 0;
  std::vector<TopicSummary> topics;
  std::uint64_t displaced = 0;       ///< Messages that SortedBag has sorted.
  std::vector<std::string> remarks;  ///< How the files differ from the bag's description.
  std::optional<Error> damage;       ///< The first damaged position; data after it are not counted.
};

/// Reads all messages of a bag. Errors: as open_bag().
Result<BagSummary> inspect_bag(const BagLocation& bag, const std::string& definitions = {});

}  // namespace somato
