#include "live/event_hub.h"

#include <gtest/gtest.h>

#include <thread>

namespace somato::live {
namespace {

using std::chrono::milliseconds;

TEST(EventHubThread, TellsTheLatestOfEachKindInOrder) {
  EventHub hub;
  hub.publish(EventKind::kFrame, "old frame");
  hub.publish(EventKind::kFrame, "frame");
  hub.publish(EventKind::kState, "state");
  const auto seat = hub.take_seat(1);
  const auto events = seat->next(milliseconds(0));
  ASSERT_EQ(events->size(), 2U);
  EXPECT_EQ(events->at(0).first, EventKind::kState);
  EXPECT_EQ(*events->at(1).second, "frame");
  EXPECT_TRUE(seat->next(milliseconds(0))->empty());
}

TEST(EventHubThread, DropsWhatASlowOneMissedAndNeverWaitsForIt) {
  EventHub hub;
  const auto slow = hub.take_seat(2);
  const auto fast = hub.take_seat(2);
  for (int i = 0; i < 1000; ++i) {
    hub.publish(EventKind::kFrame, std::to_string(i));
    EXPECT_EQ(*fast->next(milliseconds(0))->at(0).second, std::to_string(i));
  }
  const auto events = slow->next(milliseconds(0));
  ASSERT_EQ(events->size(), 1U);
  EXPECT_EQ(*events->at(0).second, "999");
}

TEST(EventHubThread, HasSoManySeats) {
  EventHub hub;
  int changes = 0;
  hub.on_change([&] { ++changes; });
  auto first = hub.take_seat(1);
  EXPECT_EQ(hub.lookers_on(), 1U);
  EXPECT_EQ(hub.take_seat(1), nullptr);
  first.reset();
  EXPECT_EQ(hub.lookers_on(), 0U);
  EXPECT_EQ(changes, 2);
  EXPECT_NE(hub.take_seat(1), nullptr);
}

TEST(EventHubThread, WakesThoseWhoWaitWhenItCloses) {
  EventHub hub;
  const auto seat = hub.take_seat(1);
  std::thread closing([&] { hub.close(); });
  EXPECT_FALSE(seat->next(std::chrono::hours(1)));
  closing.join();
  EXPECT_EQ(hub.take_seat(2), nullptr);
}

TEST(EventHubThread, HandsOutFromManyThreads) {
  EventHub hub;
  std::vector<std::thread> readers;
  for (int i = 0; i < 4; ++i) {
    readers.emplace_back([&] {
      const auto seat = hub.take_seat(4);
      std::string last;
      while (const auto events = seat->next(std::chrono::hours(1))) {
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
