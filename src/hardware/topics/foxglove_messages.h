#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "somato/core/result.h"

namespace somato::topics {

/// The subprotocols of the Foxglove WebSocket protocol that this client speaks, the newest first.
inline constexpr const char* kSubprotocols = "foxglove.sdk.v1, foxglove.websocket.v1";

/// A topic as its server advertises it.
struct Topic {
  std::uint32_t id = 0;  ///< The number of the server, valid during a connection.
  std::string name;      ///< Such as "/joint_states".
  std::string type;      ///< Such as "sensor_msgs/msg/JointState".
  std::string encoding;  ///< The encoding of its messages, such as "cdr".
  std::string definition;
  std::string definition_encoding;  ///< Such as "ros2msg".
};

/// The messages of a server that are text.
struct Advertisement {
  std::vector<Topic> topics;
};
struct Withdrawal {
  std::vector<std::uint32_t> ids;
};
struct ServerStatus {
  int level = 0;  ///< 0: information, 1: warning, 2: error.
  std::string message;
};
struct OtherMessage {};
using ServerMessage = std::variant<Advertisement, Withdrawal, ServerStatus, OtherMessage>;

/// Errors (kData, at `where`): it is not a JSON object of the protocol.
Result<ServerMessage> parse_server_message(std::string_view text, const std::string& where);

/// A message of a topic.
struct TopicMessage {
  std::uint32_t subscription = 0;
  std::uint64_t time = 0;    ///< Nanoseconds by the server's clock, when the message was logged.
  std::string_view payload;  ///< A part of the bytes that were parsed.
};

/// The message of a topic in a binary message; nothing if it is of another kind. Errors (kData, at
/// `where`): it is too short.
Result<std::optional<TopicMessage>> parse_topic_message(std::string_view bytes,
                                                        const std::string& where);

/// The text that subscribes to topics, as pairs of the subscription's number and the topic's.
std::string subscribe_text(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& wanted);

}  // namespace somato::topics
