#include "views/http/event_hub.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>
#include <vector>

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

std::vector<std::string> texts_of(const std::optional<std::vector<EventHub::Event>>& events) {
  std::vector<std::string> texts;
  for (const auto& [kind, text] : *events) texts.push_back(*text);
  return texts;
}

using Texts = std::vector<std::string>;

// All buffers between the program and a viewer have one frame, and the next is the latest.
TEST(EventHubThread, WaitsForTheAcknowledgementOfASlowOneAndThenHandsOutTheLatest) {
  EventHub hub;
  const auto slow = hub.subscribe(2, EventHub::Flow::kAcknowledged);
  const auto fast = hub.subscribe(2, EventHub::Flow::kAcknowledged);
  const auto take = [&](EventHub::Subscription& one) {
    const Texts texts = texts_of(one.next(milliseconds(0)));
    EXPECT_TRUE(hub.acknowledge(one.handed().viewer, one.handed().number));
    return texts;
  };
  hub.publish(EventKind::kFrame, "first");
  EXPECT_EQ(texts_of(slow->next(milliseconds(0))), Texts{"first"});
  EXPECT_EQ(take(*fast), Texts{"first"});
  hub.publish(EventKind::kState, "state");
  for (int i = 0; i < 1000; ++i) hub.publish(EventKind::kFrame, std::to_string(i));
  EXPECT_EQ(take(*fast), (Texts{"state", "999"}));
  const auto first = slow->handed().number;
  EXPECT_EQ(texts_of(slow->next(milliseconds(0))), Texts{});
  EXPECT_EQ(slow->handed().number, first);
  EXPECT_TRUE(hub.acknowledge(slow->handed().viewer, first + 1));  // what was not handed out yet
  EXPECT_EQ(texts_of(slow->next(milliseconds(0))), Texts{});
  EXPECT_EQ(take(*slow), Texts{});
  EXPECT_EQ(take(*slow), (Texts{"state", "999"}));
  EXPECT_EQ(take(*slow), Texts{});
  EXPECT_GT(slow->handed().number, first + 1);  // with a ping, though nothing is new
}

TEST(EventHubThread, IsWokenByAnAcknowledgement) {
  EventHub hub;
  const auto viewer = hub.subscribe(1, EventHub::Flow::kAcknowledged);
  hub.publish(EventKind::kFrame, "first");
  EXPECT_EQ(texts_of(viewer->next(std::chrono::hours(1))), Texts{"first"});
  hub.publish(EventKind::kFrame, "second");
  std::thread acknowledging([&, handed = viewer->handed()] {
    EXPECT_TRUE(hub.acknowledge(handed.viewer, handed.number));
  });
  EXPECT_EQ(texts_of(viewer->next(std::chrono::hours(1))), Texts{"second"});
  acknowledging.join();
}

TEST(EventHubThread, KnowsNoViewerThatHasLeft) {
  EventHub hub;
  auto viewer = hub.subscribe(1, EventHub::Flow::kAcknowledged);
  const std::uint64_t left = viewer->handed().viewer;
  EXPECT_TRUE(hub.acknowledge(left, 0));
  EXPECT_FALSE(hub.acknowledge(left + 1, 0));
  viewer.reset();
  EXPECT_FALSE(hub.acknowledge(left, 0));
  viewer = hub.subscribe(1, EventHub::Flow::kAcknowledged);
  EXPECT_NE(viewer->handed().viewer, left);  // so that an old acknowledgement is for none
}

TEST(EventHubThread, HandsOutTheLastEndThatASlowOneMissedBeforeWhatFollowed) {
  EventHub hub;
  const auto viewer = hub.subscribe(2);
  hub.publish(EventKind::kFrame, "0");
  EXPECT_EQ(texts_of(viewer->next(milliseconds(0))), Texts{"0"});
  hub.publish_end("end of 0");
  hub.publish(EventKind::kFrame, "1");
  hub.publish_end("end of 1");
  hub.publish(EventKind::kState, "state of 2");
  hub.publish(EventKind::kFrame, "2");
  hub.publish(EventKind::kFrame, "2, later");
  EXPECT_EQ(texts_of(viewer->next(milliseconds(0))), (Texts{"end of 1", "state of 2", "2, later"}));
  hub.publish_end("end of 2");
  EXPECT_EQ(texts_of(viewer->next(milliseconds(0))), Texts{"end of 2"});
  hub.publish(EventKind::kFrame, "3");
  EXPECT_EQ(texts_of(viewer->next(milliseconds(0))), Texts{"3"});  // the end was handed out
  EXPECT_EQ(texts_of(hub.subscribe(2)->next(milliseconds(0))), (Texts{"state of 2", "3"}));
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
