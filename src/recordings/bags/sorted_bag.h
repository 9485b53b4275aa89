#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "recordings/bags/bag_source.h"
#include "somato/core/result.h"

namespace somato {

/// The messages of a bag in the order of their times, as players show them. Recorders write several
/// topics side by side, so that messages are displaced by little in a file; a message that is
/// displaced by more than kLongestDelay, or by more bytes of other messages than kMostWaiting, is
/// not sorted, because the clock was set back there.
class SortedBag : public BagSource {
 public:
  /// The longest time by which a message is displaced without a clock that was set back: longer
  /// than the caches of recorders and the publishing interval of sensors, shorter than the
  /// corrections that set a clock.
  static constexpr std::int64_t kLongestDelay = 1'000'000'000;  // ns

  /// The memory for messages that wait: a second of any skin, or a few pictures of a camera, so
  /// that an import stays below 64 MB.
  static constexpr std::size_t kMostWaiting = std::size_t{8} << 20;  // bytes

  explicit SortedBag(std::unique_ptr<BagSource> from) : from_(std::move(from)) {}

  /// Errors: as those of the source, after all messages before the damage.
  Result<std::optional<BagMessage>> next() override;
  const std::vector<BagTopic>& topics() const override { return from_->topics(); }

  /// The number of messages so far of a topic, and of a file of the bag.
  std::uint64_t messages_of_topic(std::size_t topic) const { return count_at(of_topics_, topic); }
  std::uint64_t messages_of_file(std::size_t file) const { return count_at(of_files_, file); }

  /// The number of messages so far that were not in the order of their times, and were sorted.
  std::uint64_t displaced() const { return displaced_; }

 private:
  // The order in which messages leave: the clock was set back between two epochs.
  struct Key {
    std::uint64_t epoch = 0;
    std::int64_t time = 0;
    std::uint64_t number = 0;
    auto operator<=>(const Key&) const = default;
  };
  struct Waiting {
    std::size_t topic = 0;
    std::string data;
  };

  // Topics and files without a message may lie behind the last one with messages.
  static std::uint64_t count_at(const std::vector<std::uint64_t>& counts, std::size_t at) {
    return at < counts.size() ? counts[at] : 0;
  }

  void take_next();
  void take(const BagMessage& message);
  bool is_first_ready() const;

  std::unique_ptr<BagSource> from_;
  std::map<Key, Waiting> waiting_;
  std::size_t bytes_ = 0;  // The size of the messages that wait.
  Key latest_;             // The latest time of the epoch, and the number of messages so far.
  std::vector<std::uint64_t> of_topics_;
  std::vector<std::uint64_t> of_files_;
  std::uint64_t displaced_ = 0;
  std::optional<Error> damage_;
  bool is_at_end_ = false;
  Waiting current_;
};

}  // namespace somato
