#include "hardware/topics/foxglove_messages.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace somato::topics {
namespace {

// Messages as the specification of the protocol describes them.
TEST(FoxgloveMessages, AnAdvertisementNamesTopics) {
  const auto message = parse_server_message(
      R"({"op":"advertise","channels":[{"id":3,"topic":"/joint_states","encoding":"cdr",)"
      R"("schemaName":"sensor_msgs/msg/JointState","schema":"float64[] position",)"
      R"("schemaEncoding":"ros2msg"},{"id":4,"topic":"/old","encoding":"cdr",)"
      R"("schemaName":"x/Y","schema":""}]})",
      "ws://robot");
  ASSERT_TRUE(message) << to_string(message.error());
  const auto& topics = std::get<Advertisement>(*message).topics;
  ASSERT_EQ(topics.size(), 2U);
  EXPECT_EQ(topics[0].id, 3U);
  EXPECT_EQ(topics[0].name, "/joint_states");
  EXPECT_EQ(topics[0].type, "sensor_msgs/msg/JointState");
  EXPECT_EQ(topics[0].definition, "float64[] position");
  EXPECT_EQ(topics[0].definition_encoding, "ros2msg");
  EXPECT_EQ(topics[1].definition_encoding, "ros2msg");  // version 1 of the protocol has none
}

// The examples of RFC 4648.
TEST(FoxgloveMessages, DefinitionsInProtobufAreInBase64) {
  const auto definition_in = [](const std::string& schema) {
    return parse_server_message(
               R"({"op":"advertise","channels":[{"id":3,"topic":"/x","encoding":"protobuf",)"
               R"("schemaName":"a.B","schemaEncoding":"protobuf","schema":")" +
                   schema + "\"}]}",
               "ws://robot")
        .map([](const ServerMessage& message) {
          return std::get<Advertisement>(message).topics.at(0).definition;
        });
  };
  EXPECT_EQ(definition_in(""), "");
  EXPECT_EQ(definition_in("Zg=="), "f");
  EXPECT_EQ(definition_in("Zm8="), "fo");
  EXPECT_EQ(definition_in("Zm9v"), "foo");
  EXPECT_EQ(definition_in("Zm9vYmE"), "fooba");
  EXPECT_EQ(definition_in("/+8="), "\xFF\xEF");
  EXPECT_FALSE(definition_in("a.b"));
}

TEST(FoxgloveMessages, WithdrawalsAndStatesAreRead) {
  const auto withdrawn =
      parse_server_message(R"({"op":"unadvertise","channelIds":[3,4]})", "ws://robot");
  EXPECT_EQ(std::get<Withdrawal>(*withdrawn).ids, (std::vector<std::uint32_t>{3, 4}));
  const auto status =
      parse_server_message(R"({"op":"status","level":2,"message":"too slow"})", "ws://robot");
  EXPECT_EQ(std::get<ServerStatus>(*status).level, 2);
  EXPECT_EQ(std::get<ServerStatus>(*status).message, "too slow");
  const auto other = parse_server_message(R"({"op":"serverInfo","name":"x"})", "ws://robot");
  EXPECT_TRUE(std::holds_alternative<OtherMessage>(*other));
}

TEST(FoxgloveMessages, OtherTextsAreRefusedWithTheAddress) {
  for (const char* text : {"", "[]", "{}", R"({"op":3})", R"({"op":"advertise","channels":[3]})",
                           R"({"op":"advertise","channels":[{"id":-1,"topic":"/x"}]})",
                           R"({"op":"advertise","channels":[{"id":4294967296,"topic":"/x"}]})",
                           R"({"op":"advertise","channels":[{"id":1}]})",
                           R"({"op":"unadvertise","channelIds":["x"]})", R"({"op":)"}) {
    const auto message = parse_server_message(text, "ws://robot");
    ASSERT_FALSE(message) << text;
    EXPECT_EQ(message.error().kind, ErrorKind::kData);
    EXPECT_EQ(message.error().where.rfind("ws://robot", 0), 0U) << text;
  }
}

TEST(FoxgloveMessages, AMessageOfATopicHasANumberATimeAndAPayload) {
  const std::string bytes("\1\7\0\0\0\1\2\0\0\0\0\0\0payload", 20);
  const auto message = parse_topic_message(bytes, "ws://robot");
  ASSERT_TRUE(message && *message);
  EXPECT_EQ((*message)->subscription, 7U);
  EXPECT_EQ((*message)->time, 513U);
  EXPECT_EQ((*message)->payload, "payload");
  EXPECT_FALSE(*parse_topic_message("\2other", "ws://robot"));
  for (std::size_t size = 0; size < 13; ++size) {
    EXPECT_FALSE(parse_topic_message(std::string_view(bytes).substr(0, size), "ws://robot"));
  }
}

TEST(FoxgloveMessages, ASubscriptionNamesTheTopicsOfTheServer) {
  EXPECT_EQ(nlohmann::json::parse(subscribe_text({{0, 12}, {1, 3}})),
            nlohmann::json::parse(R"({"op":"subscribe","subscriptions":[)"
                                  R"({"id":0,"channelId":12},{"id":1,"channelId":3}]})"));
}

}  // namespace
}  // namespace somato::topics
