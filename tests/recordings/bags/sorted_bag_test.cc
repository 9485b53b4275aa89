#include "recordings/bags/sorted_bag.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace somato {
namespace {

constexpr std::int64_t kMillisecond = 1'000'000;

// Messages at these times (ms), whose data are their numbers; after them perhaps damage.
class GivenBag : public BagSource {
 public:
  explicit GivenBag(std::vector<std::int64_t> times, bool is_damaged = false)
      : times_(std::move(times)), is_damaged_(is_damaged) {}
  Result<std::optional<BagMessage>> next() override {
    if (at_ == times_.size() && is_damaged_) return fail(ErrorKind::kData, "damaged");
    if (at_ == times_.size()) return std::optional<BagMessage>();
    data_ = std::to_string(at_);
    return BagMessage{0, times_[at_++] * kMillisecond, data_};
  }
  const std::vector<BagTopic>& topics() const override { return topics_; }

 private:
  std::vector<std::int64_t> times_;
  bool is_damaged_;
  std::size_t at_ = 0;
  std::string data_;
  std::vector<BagTopic> topics_;
};

struct Read {
  std::vector<std::int64_t> times;
  std::vector<std::string> data;
  bool has_failed = false;
};

Read read_all(SortedBag& bag) {
  Read read;
  for (;;) {
    auto message = bag.next();
    read.has_failed = !message;
    if (!message || !*message) return read;
    read.times.push_back((*message)->time / kMillisecond);
    read.data.emplace_back((*message)->data);
  }
}

SortedBag sorted(std::vector<std::int64_t> times, bool is_damaged = false) {
  return SortedBag(std::make_unique<GivenBag>(std::move(times), is_damaged));
}

TEST(SortedBag, MessagesThatAreDisplacedByLittleAreSorted) {
  SortedBag bag = sorted({10, 5, 900, 20, 1500, 1500, 700});
  const Read read = read_all(bag);
  EXPECT_EQ(read.times, (std::vector<std::int64_t>{5, 10, 20, 700, 900, 1500, 1500}));
  EXPECT_EQ(read.data, (std::vector<std::string>{"1", "0", "3", "6", "2", "4", "5"}));
  EXPECT_EQ(bag.displaced(), 3U);
}

TEST(SortedBag, AClockThatIsSetBackIsNotSorted) {
  SortedBag bag = sorted({5000, 5010, 1000, 990, 1020});
  EXPECT_EQ(read_all(bag).times, (std::vector<std::int64_t>{5000, 5010, 990, 1000, 1020}));
}

TEST(SortedBag, MessagesBeforeADamagedPlaceAreReadFirst) {
  SortedBag bag = sorted({3, 2, 1}, true);
  const Read read = read_all(bag);
  EXPECT_EQ(read.times, (std::vector<std::int64_t>{1, 2, 3}));
  EXPECT_TRUE(read.has_failed);
}

TEST(SortedBag, RandomDisplacementsBelowTheLimitAreUndone) {
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round) {
    std::vector<std::int64_t> expected(60);
    std::vector<std::pair<std::int64_t, std::int64_t>> delayed;
    for (std::int64_t& time : expected) {
      time = std::uniform_int_distribution<std::int64_t>(0, 20'000)(random);
      delayed.emplace_back(time + std::uniform_int_distribution<std::int64_t>(0, 999)(random),
                           time);
    }
    std::sort(expected.begin(), expected.end());
    std::sort(delayed.begin(), delayed.end());
    std::vector<std::int64_t> times;
    for (const auto& [written, time] : delayed) times.push_back(time);
    SortedBag bag = sorted(times);
    ASSERT_EQ(read_all(bag).times, expected);
  }
}

}  // namespace
}  // namespace somato
