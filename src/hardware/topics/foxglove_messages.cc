#include "hardware/topics/foxglove_messages.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/archives/little_endian.h"
#include "base/text/json_text.h"

namespace somato::topics {
namespace {

constexpr const char* kAdvice = "check that the address is that of a Foxglove bridge or SDK";

std::string text_of(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::optional<std::uint32_t> id_in(const nlohmann::json& value) {
  if (!value.is_number_unsigned()) return std::nullopt;
  const auto number = value.get<std::uint64_t>();
  if (number > UINT32_MAX) return std::nullopt;
  return static_cast<std::uint32_t>(number);
}

tl::unexpected<Error> not_of_protocol(const std::string& what, const std::string& where) {
  return fail(ErrorKind::kData, "not a message of the Foxglove WebSocket protocol: " + what, where,
              kAdvice);
}

// The list under `key`, or an empty one.
const nlohmann::json& list_in(const nlohmann::json& object, const char* key) {
  static const nlohmann::json kNone = nlohmann::json::array();
  const auto found = object.find(key);
  return found != object.end() && found->is_array() ? *found : kNone;
}

// The bytes of a text in base64, with or without the padding at its end, or nothing.
std::optional<std::string> bytes_of_base64(std::string_view text) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  constexpr unsigned kBitsOfDigit = 6;
  constexpr unsigned kBitsOfByte = 8;
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string bytes;
  std::uint32_t bits = 0;
  unsigned count = 0;
  for (const char digit : text) {
    const std::size_t value = kDigits.find(digit);
    if (value == std::string_view::npos) return std::nullopt;
    bits = bits << kBitsOfDigit | static_cast<std::uint32_t>(value);
    count += kBitsOfDigit;
    if (count < kBitsOfByte) continue;
    count -= kBitsOfByte;
    bytes += static_cast<char>(bits >> count & 0xFF);
  }
  return bytes;
}

// The definitions of the encoding protobuf are bytes, which the protocol carries in base64.
Result<void> decode_definition(Topic& topic, const std::string& where) {
  if (topic.definition_encoding != "protobuf") return {};
  std::optional<std::string> bytes = bytes_of_base64(topic.definition);
  if (!bytes) {
    return not_of_protocol(fmt::format("the schema of {} is not in base64", topic.name), where);
  }
  topic.definition = std::move(*bytes);
  return {};
}

Result<ServerMessage> advertisement(const nlohmann::json& message, const std::string& where) {
  Advertisement advertised;
  for (const nlohmann::json& channel : list_in(message, "channels")) {
    if (!channel.is_object()) return not_of_protocol("a channel is no object", where);
    const auto id = channel.contains("id") ? id_in(channel["id"]) : std::nullopt;
    Topic topic{0,
                text_of(channel, "topic"),
                text_of(channel, "schemaName"),
                text_of(channel, "encoding"),
                text_of(channel, "schema"),
                text_of(channel, "schemaEncoding")};
    if (!id || topic.name.empty()) {
      return not_of_protocol("a channel has no number or no topic", where);
    }
    topic.id = *id;
    // The first version of the protocol left it out.
    if (topic.definition_encoding.empty() && topic.encoding == "cdr") {
      topic.definition_encoding = "ros2msg";
    }
    SOMATO_TRY_VOID(decode_definition(topic, where));
    advertised.topics.push_back(std::move(topic));
  }
  return ServerMessage{std::move(advertised)};
}

Result<ServerMessage> withdrawal(const nlohmann::json& message, const std::string& where) {
  Withdrawal withdrawn;
  for (const nlohmann::json& value : list_in(message, "channelIds")) {
    const auto id = id_in(value);
    if (!id) return not_of_protocol("the number of a channel is no number", where);
    withdrawn.ids.push_back(*id);
  }
  return ServerMessage{std::move(withdrawn)};
}

}  // namespace

Result<ServerMessage> parse_server_message(std::string_view text, const std::string& where) {
  SOMATO_TRY(const auto message, parse_json<nlohmann::json>(text, where, kAdvice));
  if (!message.is_object()) return not_of_protocol("it is no object", where);
  const std::string operation = text_of(message, "op");
  if (operation == "advertise") return advertisement(message, where);
  if (operation == "unadvertise") return withdrawal(message, where);
  if (operation == "status") {
    const auto level = message.contains("level") ? id_in(message["level"]) : std::nullopt;
    return ServerMessage{
        ServerStatus{static_cast<int>(level.value_or(0)), text_of(message, "message")}};
  }
  if (operation.empty()) return not_of_protocol("it has no 'op'", where);
  return ServerMessage{OtherMessage{}};
}

Result<std::optional<TopicMessage>> parse_topic_message(std::string_view bytes,
                                                        const std::string& where) {
  constexpr char kMessageData = 1;
  constexpr std::size_t kHead = 1 + sizeof(std::uint32_t) + sizeof(std::uint64_t);
  if (bytes.empty()) return not_of_protocol("it is empty", where);
  if (bytes.front() != kMessageData) return std::optional<TopicMessage>();
  if (bytes.size() < kHead) {
    return not_of_protocol(fmt::format("a message of a topic has only {} bytes", bytes.size()),
                           where);
  }
  return TopicMessage{little_endian<std::uint32_t>(bytes.data() + 1),
                      little_endian<std::uint64_t>(bytes.data() + 1 + sizeof(std::uint32_t)),
                      bytes.substr(kHead)};
}

std::string subscribe_text(const std::vector<std::pair<std::uint32_t, std::uint32_t>>& wanted) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& [subscription, topic] : wanted) {
    list.push_back({{"id", subscription}, {"channelId", topic}});
  }
  return nlohmann::json{{"op", "subscribe"}, {"subscriptions", std::move(list)}}.dump();
}

}  // namespace somato::topics
