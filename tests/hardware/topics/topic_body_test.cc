#include "hardware/topics/topic_body.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "base/archives/little_endian.h"
#include "hardware/topics/topic_server.h"
#include "recordings/ros/cdr.h"

namespace somato::topics {
namespace {

using testing::TopicServer;

constexpr std::uint64_t kMillisecond = 1'000'000;  // ns

// A server with the topics /touch and /force of one number each, and its client.
struct TopicBodyThread : ::testing::Test {
  TopicBodyThread() {
    server.advertise(1, "/touch", "float32 value");
    server.advertise(2, "/force", "float32 value");
    client = std::move(*TopicClient::start(server.address()));
  }

  Result<std::unique_ptr<TopicBody>> start(double patience, KeptFrames keep = KeptFrames::kLatest) {
    return TopicBody::start(
        "robot", *client,
        {{"touch", "N", "/touch", {"value"}, {}}, {"force", "", "/force", {"value"}, {}}}, patience,
        keep);
  }

  // The body, after a message of each topic.
  std::unique_ptr<TopicBody> started(KeptFrames keep = KeptFrames::kLatest) {
    std::thread sender([&] {
      while (server.received().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
      server.send_number(1, 0, 5.0F);
      server.send_number(0, 0, 6.0F);
    });
    auto body = start(60.0, keep);
    sender.join();
    EXPECT_TRUE(body) << to_string(body.error());
    if (!body) return nullptr;
    (*body)->begin();
    return std::move(*body);
  }

  TopicServer server;
  std::unique_ptr<TopicClient> client;
};

TEST_F(TopicBodyThread, EveryMessageOfTheFirstTopicIsAFrameWithItsTime) {
  const auto body = started();
  ASSERT_TRUE(body);
  const auto& sensors = body->description().sensors;
  ASSERT_EQ(sensors.size(), 2U);
  EXPECT_EQ(sensors[0].name, "touch");
  EXPECT_EQ(sensors[0].unit, "N");
  server.send_number(0, 1000 * kMillisecond, 1.0F);
  server.send_number(1, 1001 * kMillisecond, 7.0F);
  server.send_number(0, 1010 * kMillisecond, 2.0F);
  server.send_number(0, 1020 * kMillisecond, 3.0F);
  server.send_number(0, 1120 * kMillisecond, 4.0F);
  const std::vector<double> times{0.0, 0.01, 0.02, 0.12};
  const std::vector<float> force{5.0F, 7.0F, 7.0F, 7.0F};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto stepped = body->step(0.01);
    ASSERT_TRUE(stepped) << to_string(stepped.error());
    EXPECT_NEAR(body->state().time, times[i], 1e-12);
    EXPECT_EQ(body->state().readings[0].row(0)[0], static_cast<float>(i + 1));
    EXPECT_EQ(body->state().readings[1].row(0)[0], force[i]);
  }
  EXPECT_EQ(body->times().messages, 4U);
  EXPECT_EQ(body->times().gaps, 1U);
  EXPECT_NEAR(body->times().longest, 0.1, 1e-9);
  EXPECT_NEAR(body->times().usual, 0.01, 1e-9);
}

TEST_F(TopicBodyThread, EveryMessageOfEachTopicIsKeptOnRequestWithItsTime) {
  const auto body = started(KeptFrames::kEvery);
  ASSERT_TRUE(body);
  server.send_number(1, 995 * kMillisecond, 6.0F);  // before the first frame
  server.send_number(0, 1000 * kMillisecond, 1.0F);
  for (std::uint64_t i = 1; i <= 9; ++i) {
    server.send_number(1, (1000 + i) * kMillisecond, static_cast<float>(i));
  }
  server.send_number(0, 1010 * kMillisecond, 2.0F);
  server.send_number(0, 1020 * kMillisecond, 3.0F);
  const std::vector<std::size_t> forces{0, 9, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto stepped = body->step(0.01);
    ASSERT_TRUE(stepped) << to_string(stepped.error());
    const BodyState& state = body->state();
    EXPECT_EQ(state.readings[0], Matrix<float>(1, 1, static_cast<float>(i + 1)));
    EXPECT_NEAR(state.times[0].at(0), 0.01 * static_cast<double>(i), 1e-12);
    ASSERT_EQ(state.readings[1].rows(), forces[i]);
    ASSERT_EQ(state.times[1].size(), forces[i]);
    for (std::size_t k = 0; k < forces[i]; ++k) {
      EXPECT_EQ(state.readings[1](k, 0), static_cast<float>(k + 1));
      EXPECT_NEAR(state.times[1][k], 0.001 * static_cast<double>(k + 1), 1e-12);
    }
  }
  server.send_number(1, 1031 * kMillisecond, 1.0F);
  server.send_number(1, 1030 * kMillisecond, 1.0F);
  const auto stepped = body->step(0.01);
  ASSERT_FALSE(stepped);
  EXPECT_EQ(stepped.error().where, "/force");
  EXPECT_EQ(stepped.error().what, "the clock of the server went back by 0.001 s");
}

TEST_F(TopicBodyThread, ANumberThatAMessageLacksIsMissingAndAnInfiniteOneAnError) {
  const auto body = started();
  ASSERT_TRUE(body);
  server.send_number(0, 1000 * kMillisecond, std::numeric_limits<float>::quiet_NaN());
  server.send_number(0, 1010 * kMillisecond, std::numeric_limits<float>::infinity());
  ASSERT_TRUE(body->step(0.01));
  EXPECT_TRUE(std::isnan(body->state().readings[0](0, 0)));
  const auto stepped = body->step(0.01);
  ASSERT_FALSE(stepped);
  EXPECT_EQ(stepped.error().what, "element 1 of a message is infinite");
  EXPECT_EQ(stepped.error().where, "/touch");
}

// A message of joints with these names, each at the position of its letter in the alphabet.
std::string joints_message(std::uint64_t time, const std::vector<std::string>& names) {
  std::string bytes(1, '\1');
  append_little_endian(bytes, std::uint32_t{0});
  append_little_endian(bytes, time);
  CdrWriter writer;
  writer.number(static_cast<std::uint32_t>(names.size()));
  std::vector<double> positions;
  for (const std::string& name : names) {
    writer.text(name);
    positions.push_back(name[0] - 'a');
  }
  writer.numbers(std::span<const double>(positions));
  return bytes + writer.bytes();
}

TEST(NamedTopicsThread, ValuesArePlacedByNameAndOtherMessagesCounted) {
  TopicServer server;
  server.advertise(1, "/joints", "string[] name\\nfloat64[] position");
  const auto client = std::move(*TopicClient::start(server.address()));
  std::thread sender([&] {
    while (server.received().empty()) std::this_thread::sleep_for(std::chrono::milliseconds(2));
    server.send_bytes(joints_message(0, {"g"}));
    server.send_bytes(joints_message(0, {"b", "a"}));
  });
  const auto started =
      TopicBody::start("robot", *client, {{"arm", "rad", "/joints", {"position[b,a]"}, {}}}, 60.0);
  sender.join();
  ASSERT_TRUE(started) << to_string(started.error());
  TopicBody& body = **started;
  EXPECT_EQ(body.description().sensors[0].element_names, (std::vector<std::string>{"b", "a"}));
  body.begin();
  server.send_bytes(joints_message(1000 * kMillisecond, {"a", "b", "c"}));
  server.send_bytes(joints_message(1010 * kMillisecond, {"g"}));
  server.send_bytes(joints_message(1020 * kMillisecond, {"b", "a"}));
  for (const double time : {0.0, 0.02}) {
    const auto stepped = body.step(0.01);
    ASSERT_TRUE(stepped) << to_string(stepped.error());
    EXPECT_NEAR(body.state().time, time, 1e-12);
    EXPECT_EQ(body.state().readings[0].row(0)[0], 1.0F);
    EXPECT_EQ(body.state().readings[0].row(0)[1], 0.0F);
  }
  EXPECT_EQ(body.times().left_out, 1U);
  EXPECT_EQ(body.times().messages, 2U);
}

TEST_F(TopicBodyThread, AClockThatGoesBackIsAnError) {
  const auto body = started();
  ASSERT_TRUE(body);
  server.send_number(0, 2000 * kMillisecond, 1.0F);
  server.send_number(0, 1500 * kMillisecond, 1.0F);
  ASSERT_TRUE(body->step(0.01));
  const auto stepped = body->step(0.01);
  ASSERT_FALSE(stepped);
  EXPECT_EQ(stepped.error().what, "the clock of the server went back by 0.500 s");
}

TEST_F(TopicBodyThread, ASilentTopicIsAnErrorWithItsName) {
  while (client->topics().size() < 2) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  const auto body = start(0.4);
  ASSERT_FALSE(body);
  EXPECT_EQ(body.error().kind, ErrorKind::kSystem);
  EXPECT_EQ(body.error().where, "/touch");
}

TEST_F(TopicBodyThread, AnUnknownPathIsAnErrorWithItsTopic) {
  const auto body = TopicBody::start("robot", *client, {{"touch", "", "/touch", {"valu"}, {}}}, 10);
  ASSERT_FALSE(body);
  EXPECT_EQ(body.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(body.error().where.rfind("/touch", 0), 0U);
  EXPECT_NE(body.error().advice.find("value"), std::string::npos);
}

TEST_F(TopicBodyThread, AMessageThatIsTooShortIsAnError) {
  const auto body = started();
  ASSERT_TRUE(body);
  server.send_bytes("\1" + std::string(12, '\0') + std::string("\0\1\0\0\0\0", 6));
  const auto stepped = body->step(0.01);
  ASSERT_FALSE(stepped);
  EXPECT_EQ(stepped.error().kind, ErrorKind::kData);
  EXPECT_EQ(stepped.error().where.rfind("/touch", 0), 0U);
}

TEST_F(TopicBodyThread, AnInterruptEndsAWait) {
  const auto body = started();
  ASSERT_TRUE(body);
  std::atomic<int> looks = 0;
  body->keep_to({.should_continue = [&] { return ++looks < 3; }});
  const auto stepped = body->step(0.01);
  ASSERT_FALSE(stepped);
  EXPECT_EQ(stepped.error().kind, ErrorKind::kInterrupted);
}

}  // namespace
}  // namespace somato::topics
