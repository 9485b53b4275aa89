#include "views/http/event_hub.h"

#include <gtest/gtest.h>

#include <thread>

namespace somato::live {
namespace {

using std::chrono::milliseconds;

TEST(EventHubThread, ReturnsTheLatestOfEachKindInOrder) {
  EventHub hub;
  hub.publish(EventKind::kFrame, "old frame");
  hub.publish(EventKind::kFrame, "frame");
  hub.publish(EventKind::kState, "state");
  const auto subscription = hub.subscribe(1);
  const auto events = subscription->next(milliseconds(0));
  ASSERT_EQ(events->size(), 2U);
  EXPECT_EQ(events->at(0).first, EventKind::kState);
  EXPECT_EQ(*events->at(1).second, "frame");
  EXPECT_TRUE(subscription->next(milliseconds(0))->empty());
}

TEST(EventHubThread, DropsWhatASlowOneMissedAndNeverWaitsForIt) {
  EventHub hub;
  const auto slow = hub.subscribe(2);
  const auto fast = hub.subscribe(2);
  for (int i = 0; i < 1000; ++i) {
    hub.publish(EventKind::kFrame, std::to_string(i));
    EXPECT_EQ(*fast->next(milliseconds(0))->at(0).second, std::to_string(i));
  }
  const auto events = slow->next(milliseconds(0));
  ASSERT_EQ(events->size(), 1U);
  EXPECT_EQ(*events->at(0).second, "999");
}

TEST(EventHubThread, HasSoManySubscriptions) {
  EventHub hub;
  int changes = 0;
  hub.on_change([&] { ++changes; });
  auto first = hub.subscribe(1);
  EXPECT_EQ(hub.viewers(), 1U);
  EXPECT_EQ(hub.subscribe(1), nullptr);
  first.reset();
  EXPECT_EQ(hub.viewers(), 0U);
  EXPECT_EQ(changes, 2);
  EXPECT_NE(hub.subscribe(1), nullptr);
}

TEST(EventHubThread, WakesThoseWhoWaitWhenItCloses) {
  EventHub hub;
  const auto subscription = hub.subscribe(1);
  std::thread closing([&] { hub.close(); });
  EXPECT_FALSE(subscription->next(std::chrono::hours(1)));
  closing.join();
  EXPECT_EQ(hub.subscribe(2), nullptr);
}

TEST(EventHubThread, HandsOutFromManyThreads) {
  EventHub hub;
  std::vector<std::thread> readers;
  for (int i = 0; i < 4; ++i) {
    readers.emplace_back([&] {
      const auto subscription = hub.subscribe(4);
      std::string last;
      while (const auto events = subscription->next(std::chrono::hours(1))) {
        for (const auto& [kind, text] : *events) {
          EXPECT_LT(last.size(), text->size());
          last = *text;
        }
        if (last.size() == 200) return;
      }
    });
  }
  for (std::size_t i = 1; i <= 200; ++i) hub.publish(EventKind::kFrame, std::string(i, 'a'));
  for (std::thread& reader : readers) reader.join();
}

}  // namespace
}  // namespace somato::live
