#include "hardware/topics/topic_client.h"

#include <gtest/gtest.h>

#include <chrono>
#include <memory>

#include "hardware/topics/topic_server.h"

namespace somato::topics {
namespace {

using testing::TopicServer;

constexpr double kPatience = 60.0;  // s; far longer than anything takes

// Whether a condition becomes true in that time.
template <typename Condition>
bool becomes(const Condition& condition) {
  for (int i = 0; i < 12000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

bool is_subscribed(const TopicServer& server, std::size_t times) {
  return becomes([&] { return server.received().size() == times; });
}

// Topics that are advertised one after the other may be subscribed to by several messages.
bool is_subscribed_to(const TopicServer& server, std::size_t topics) {
  return becomes([&] {
    std::size_t count = 0;
    for (const std::string& message : server.received()) {
      for (std::size_t at = message.find("channelId"); at != std::string::npos;
           at = message.find("channelId", at + 1)) {
        ++count;
      }
    }
    return count == topics;
  });
}

std::deque<Arrival> take(TopicClient& client, std::size_t count) {
  std::deque<Arrival> all;
  becomes([&] {
    for (Arrival& arrival : client.take(0.0)) all.push_back(std::move(arrival));
    return all.size() >= count;
  });
  return all;
}

TEST(TopicClientThread, ReceivesWantedTopicsInOrder) {
  TopicServer server;
  server.greet(R"({"op":"serverInfo","name":"test"})");
  server.advertise(5, "/touch", "float32 value");
  server.advertise(9, "/force", "float32 value");
  auto client = TopicClient::start(server.address());
  ASSERT_TRUE(client);
  const auto topics = (*client)->subscribe({"/force", "/touch"}, kPatience);
  ASSERT_TRUE(topics) << to_string(topics.error());
  EXPECT_EQ((*topics)[0].id, 9U);
  EXPECT_EQ((*topics)[1].definition, "float32 value");
  ASSERT_TRUE(is_subscribed_to(server, 2));
  server.send_number(99, 7, 0.0F);  // of no subscription
  for (std::uint32_t i = 0; i < 500; ++i) server.send_number(i % 2, i, static_cast<float>(i));
  const auto arrivals = take(**client, 500);
  ASSERT_EQ(arrivals.size(), 500U);
  for (std::uint32_t i = 0; i < 500; ++i) {
    EXPECT_EQ(arrivals[i].topic, i % 2);
    EXPECT_EQ(arrivals[i].time, i);
    EXPECT_EQ(arrivals[i].payload.size(), 8U);
  }
  EXPECT_EQ((*client)->state().received, 500U);
}

TEST(TopicClientThread, NamesTheNearestTopic) {
  TopicServer server;
  server.advertise(1, "/touch", "float32 value");
  auto client = TopicClient::start(server.address());
  ASSERT_TRUE((*client)->subscribe({"/touch"}, kPatience));
  const auto missing = (*client)->subscribe({"/tuch"}, 0.01);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::kUsage);
  EXPECT_NE(missing.error().advice.find("did you mean '/touch'"), std::string::npos);
}

TEST(TopicClientThread, NamesTheAddressWithoutAConnection) {
  int port = 0;
  {
    const TopicServer gone;
    port = gone.port();
  }
  auto client = TopicClient::start("ws://127.0.0.1:" + std::to_string(port));
  const auto topics = (*client)->subscribe({"/touch"}, 0.3);
  ASSERT_FALSE(topics);
  EXPECT_EQ(topics.error().kind, ErrorKind::kSystem);
  EXPECT_EQ(topics.error().what.rfind("no connection", 0), 0U);
  EXPECT_EQ(topics.error().where, "ws://127.0.0.1:" + std::to_string(port));
}

TEST(TopicClientThread, ConnectsAndSubscribesAgain) {
  auto server = std::make_unique<TopicServer>();
  const int port = server->port();
  server->advertise(1, "/touch", "float32 value");
  auto client = TopicClient::start(server->address(), {.reconnect = 0.02});
  ASSERT_TRUE((*client)->subscribe({"/touch"}, kPatience));
  server.reset();
  ASSERT_TRUE(becomes([&] { return !(*client)->state().connected; }));
  EXPECT_FALSE((*client)->state().problem.empty());
  server = std::make_unique<TopicServer>(port);
  server->advertise(8, "/touch", "float32 value");  // it has another number now
  // A client that connects before this line is greeted by nothing.
  server->send_text(TopicServer::advertisement(8, "/touch", "float32 value"));
  ASSERT_TRUE(is_subscribed(*server, 1));
  EXPECT_NE(server->received().front().find("\"channelId\":8"), std::string::npos);
  server->send_number(0, 3, 1.0F);
  EXPECT_EQ(take(**client, 1).size(), 1U);
  EXPECT_EQ((*client)->state().connections, 2U);
}

TEST(TopicClientThread, SubscribesToATopicThatIsAdvertisedAgain) {
  TopicServer server;
  server.advertise(1, "/touch", "float32 value");
  auto client = TopicClient::start(server.address());
  ASSERT_TRUE((*client)->subscribe({"/touch"}, kPatience));
  ASSERT_TRUE(is_subscribed(server, 1));
  server.send_text(R"({"op":"unadvertise","channelIds":[1]})");
  server.send_text(TopicServer::advertisement(2, "/touch", "float32 value"));
  EXPECT_TRUE(is_subscribed(server, 2));
}

TEST(TopicClientThread, HostileMessagesAreProblemsAndEndNothing) {
  TopicServer server;
  server.advertise(1, "/touch", "float32 value");
  auto client = TopicClient::start(server.address());
  ASSERT_TRUE((*client)->subscribe({"/touch"}, kPatience));
  ASSERT_TRUE(is_subscribed(server, 1));
  server.send_text("no json");
  server.send_text(std::string(1000, '['));
  server.send_bytes("\1" + std::string(2, '\0'));
  server.send_bytes("\xFFother");
  server.send_number(0, 3, 1.0F);
  EXPECT_EQ(take(**client, 1).size(), 1U);
  EXPECT_NE((*client)->state().problem.find("has only 3 bytes"), std::string::npos);
}

TEST(TopicClientThread, DropsAndCountsTheOldestOfAFullQueue) {
  TopicServer server;
  server.advertise(1, "/touch", "float32 value");
  auto client = TopicClient::start(server.address(), {.queue_bytes = 80});  // ten messages
  ASSERT_TRUE((*client)->subscribe({"/touch"}, kPatience));
  ASSERT_TRUE(is_subscribed(server, 1));
  for (std::uint32_t i = 0; i < 100; ++i) server.send_number(0, i, 1.0F);
  ASSERT_TRUE(becomes([&] { return (*client)->state().received == 100; }));
  EXPECT_EQ((*client)->state().dropped, 90U);
  const auto kept = (*client)->take(0.0);
  ASSERT_EQ(kept.size(), 10U);
  EXPECT_EQ(kept.front().time, 90U);
}

TEST(TopicClientThread, AMessageBeyondTheLimitEndsTheConnection) {
  TopicServer server;
  server.advertise(1, "/touch", "float32 value");
  auto client = TopicClient::start(server.address(), {.message_bytes = 1000, .reconnect = 5.0});
  ASSERT_TRUE((*client)->subscribe({"/touch"}, kPatience));
  ASSERT_TRUE(is_subscribed(server, 1));
  server.send_bytes(std::string(2000, '\1'));
  ASSERT_TRUE(becomes([&] { return !(*client)->state().connected; }));
  EXPECT_EQ((*client)->state().problem, "a message has more than 1000 bytes");
}

}  // namespace
}  // namespace somato::topics
