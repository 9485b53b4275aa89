#include "recordings/bags/sorted_bag.h"

#include <algorithm>
#include <utility>

namespace somato {
namespace {

void count(std::vector<std::uint64_t>& messages, std::size_t at) {
  if (messages.size() <= at) messages.resize(at + 1);
  ++messages[at];
}

}  // namespace

Result<std::optional<BagMessage>> SortedBag::next() {
  while (!is_first_ready()) take_next();
  if (waiting_.empty()) {
    if (damage_) return fail(*damage_);
    return std::optional<BagMessage>();
  }
  auto first = waiting_.extract(waiting_.begin());
  current_ = std::move(first.mapped());
  bytes_ -= current_.data.size();
  return BagMessage{current_.topic, first.key().time, current_.data};
}

bool SortedBag::is_first_ready() const {
  if (is_at_end_ || damage_) return true;
  if (waiting_.empty()) return false;
  const Key& first = waiting_.begin()->first;
  return first.epoch < latest_.epoch || first.time <= latest_.time - kLongestDelay ||
         bytes_ > kMostWaiting;
}

// Messages before a damaged place are handed out before the error.
void SortedBag::take_next() {
  Result<std::optional<BagMessage>> message = from_->next();
  if (!message) {
    damage_ = std::move(message.error());
  } else if (*message) {
    take(**message);
  } else {
    is_at_end_ = true;
  }
}

void SortedBag::take(const BagMessage& message) {
  count(of_topics_, message.topic);
  count(of_files_, message.file);
  const bool is_first = latest_.number == 0;
  const bool is_set_back = !is_first && message.time < latest_.time - kLongestDelay;
  if (is_set_back) ++latest_.epoch;
  if (!is_first && !is_set_back && message.time < latest_.time) ++displaced_;
  latest_.time = is_first || is_set_back ? message.time : std::max(latest_.time, message.time);
  waiting_.emplace(Key{latest_.epoch, message.time, latest_.number++},
                   Waiting{message.topic, std::string(message.data)});
  bytes_ += message.data.size();
}

}  // namespace somato
