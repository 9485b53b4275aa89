#include "hardware/topics/web_socket.h"

#include <gtest/gtest.h>

namespace somato::topics {
namespace {

TEST(WebSocketAddress, HasHostPortAndPath) {
  const auto plain = parse_web_socket_address("ws://robot:8765");
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->host, "robot");
  EXPECT_EQ(plain->port, 8765);
  EXPECT_EQ(plain->path, "/");
  EXPECT_FALSE(plain->encrypted);
  const auto secure = parse_web_socket_address("wss://robot.example/topics?x=1");
  ASSERT_TRUE(secure);
  EXPECT_EQ(secure->host, "robot.example");
  EXPECT_EQ(secure->port, 443);
  EXPECT_EQ(secure->path, "/topics?x=1");
  EXPECT_TRUE(secure->encrypted);
  const auto version6 = parse_web_socket_address("ws://[::1]:90");
  ASSERT_TRUE(version6);
  EXPECT_EQ(version6->host, "::1");
  EXPECT_EQ(version6->port, 90);
}

TEST(WebSocketAddress, OthersAreRefusedWithAnExample) {
  for (const char* text : {"", "robot:8765", "http://robot:8765", "ws://", "ws://:80",
                           "ws://robot:0", "ws://robot:65536", "ws://robot:x", "ws://robot:"}) {
    const auto address = parse_web_socket_address(text);
    ASSERT_FALSE(address) << text;
    EXPECT_EQ(address.error().kind, ErrorKind::kUsage);
    EXPECT_NE(address.error().advice.find("ws://robot:8765"), std::string::npos);
  }
}

}  // namespace
}  // namespace somato::topics
