#include "recordings/bags/mcap_bag.h"

#include <limits>

namespace somato {

Result<std::unique_ptr<BagSource>> McapBag::open(const std::string& path) {
  SOMATO_TRY(McapReader file, McapReader::open(operating_system(), path));
  return std::make_unique<McapBag>(std::move(file));
}

Result<std::optional<BagMessage>> McapBag::next() {
  SOMATO_TRY(const std::optional<McapMessage> message, file_.next());
  if (!message) return std::optional<BagMessage>();
  if (message->log_time > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
    return file_.bad("a message has a time beyond the year 2262");
  }
  const auto [topic, is_new] = topic_by_id_.emplace(message->channel_id, topics_.size());
  if (is_new) {
    const McapChannel& channel = file_.channel(message->channel_id);
    const McapSchema& schema = file_.schema_of(message->channel_id);
    topics_.push_back(
        {channel.topic, {schema.name, channel.message_encoding, schema.encoding, schema.data}});
  }
  return BagMessage{topic->second, static_cast<std::int64_t>(message->log_time), message->data};
}

}  // namespace somato
