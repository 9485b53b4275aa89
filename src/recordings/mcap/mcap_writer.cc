#include "recordings/mcap/mcap_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "recordings/mcap/mcap_compression.h"

namespace somato {
namespace {

constexpr std::size_t kMostIds = std::numeric_limits<std::uint16_t>::max();

// Gives `thing` the next id and keeps it, unless one that is the same has an id.
template <typename Thing>
Result<std::uint16_t> id_of(Thing thing, std::string_view what, std::vector<Thing>& all,
                            std::map<std::string, std::uint16_t>& ids) {
  thing.id = 0;
  const auto [known, is_new] = ids.emplace(mcap_record(thing), 0);
  if (!is_new) return known->second;
  if (all.size() == kMostIds) {
    return fail(ErrorKind::kData,
                fmt::format("there are more than {} different {}", kMostIds, what), {},
                "write several files");
  }
  thing.id = static_cast<std::uint16_t>(all.size() + 1);
  all.push_back(thing);
  known->second = thing.id;
  return thing.id;
}

// The records of one kind in the summary, and their positions.
class SummaryGroups {
 public:
  explicit SummaryGroups(std::uint64_t place) : place_(place) {}

  template <typename Records>
  void add(McapOpcode opcode, const Records& records) {
    const std::size_t start = bytes_.size();
    for (const auto& record : records) bytes_ += mcap_record(record);
    if (bytes_.size() == start) return;
    offsets_ += mcap_record(McapSummaryOffset{opcode, place_ + start, bytes_.size() - start});
  }
  std::string bytes() const { return bytes_ + offsets_; }
  std::uint64_t offsets_place() const { return place_ + bytes_.size(); }

 private:
  std::uint64_t place_;
  std::string bytes_;
  std::string offsets_;
};

}  // namespace

Result<void> McapWriter::put(std::string_view bytes) {
  if (broken_) return fail(*broken_);
  Result<void> written = sink_(bytes);
  if (!written) {
    broken_ = written.error();
    return written;
  }
  place_ += bytes.size();
  data_crc_.add(bytes);
  return {};
}

Result<void> McapWriter::begin(const McapHeader& header) {
  return put(std::string(kMcapMagic) + mcap_record(header));
}

Result<std::uint16_t> McapWriter::schema(const McapSchema& schema) {
  return id_of(schema, "schemas", schemas_, schema_ids_);
}

Result<std::uint16_t> McapWriter::channel(const McapSchema* schema, McapChannel channel) {
  Result<std::uint16_t> id = schema ? this->schema(*schema) : std::uint16_t{0};
  if (!id) return id;
  channel.schema_id = *id;
  return id_of(std::move(channel), "channels", channels_, channel_ids_);
}

void McapWriter::announce(std::uint16_t channel) {
  const McapChannel& announced = channels_.at(channel - std::size_t{1});
  const auto [latest, is_new] = announced_channels_.emplace(announced.topic, channel);
  if (!is_new && latest->second == channel) return;
  latest->second = channel;
  const std::uint16_t schema = announced.schema_id;
  if (schema != 0 && announced_schemas_.insert(schema).second) {
    chunk_ += mcap_record(schemas_.at(schema - std::size_t{1}));
  }
  chunk_ += mcap_record(announced);
}

Result<void> McapWriter::add(const McapMessage& message) {
  return add_before_another(message).and_then(
      [&] { return chunk_.size() < chunk_size_ ? Result<void>() : end_chunk(); });
}

Result<void> McapWriter::add_before_another(const McapMessage& message) {
  if (broken_) return fail(*broken_);
  if (message.data.size() > kLargestMcapMessage) {
    return fail(ErrorKind::kData, fmt::format("a message has {} bytes, more than {}",
                                              message.data.size(), kLargestMcapMessage));
  }
  announce(message.channel_id);
  message_indexes_[message.channel_id].emplace_back(message.log_time, chunk_.size());
  chunk_ += mcap_record(message);
  const bool first = messages_in_chunk_++ == 0;
  chunk_start_ = first ? message.log_time : std::min(chunk_start_, message.log_time);
  chunk_end_ = first ? message.log_time : std::max(chunk_end_, message.log_time);
  latest_time_ = std::max(latest_time_, message.log_time);
  ++statistics_.messages[message.channel_id];
  return {};
}

Result<void> McapWriter::add(const McapMetadata& metadata) {
  SOMATO_TRY_VOID(end_chunk());
  const std::string bytes = mcap_record(metadata);
  McapMetadataIndex index{place_, bytes.size(), metadata.name};
  SOMATO_TRY_VOID(put(bytes));
  metadata_.push_back(std::move(index));
  return {};
}

std::string McapWriter::message_indexes(McapChunkIndex& index) const {
  std::string records;
  for (const auto& [channel, entries] : message_indexes_) {
    index.message_index_places[channel] = index.place + index.length + records.size();
    records += mcap_record(channel, entries);
  }
  index.message_index_length = records.size();
  return records;
}

void McapWriter::start_chunk() {
  chunk_.clear();
  messages_in_chunk_ = 0;
  announced_schemas_.clear();
  announced_channels_.clear();
  message_indexes_.clear();
}

Result<void> McapWriter::end_chunk() {
  if (broken_) return fail(*broken_);
  if (chunk_is_empty()) return {};
  SOMATO_TRY(const std::string packed, pack(compression_, chunk_));
  const std::string_view name = mcap_name(compression_);
  std::string bytes =
      mcap_record(McapChunk{chunk_start_, chunk_end_, chunk_.size(), crc32(chunk_), name, packed});
  McapChunkIndex index{chunk_start_,      chunk_end_,    place_,       bytes.size(), {}, 0,
                       std::string(name), packed.size(), chunk_.size()};
  bytes += message_indexes(index);
  const bool first = chunks_.empty();
  statistics_.start_time = first ? chunk_start_ : std::min(statistics_.start_time, chunk_start_);
  statistics_.end_time = first ? chunk_end_ : std::max(statistics_.end_time, chunk_end_);
  chunks_.push_back(std::move(index));
  start_chunk();
  return put(bytes);
}

std::string McapWriter::summary() const {
  McapStatistics statistics = statistics_;
  statistics.schemas = static_cast<std::uint16_t>(schemas_.size());
  statistics.channels = static_cast<std::uint32_t>(channels_.size());
  statistics.chunks = static_cast<std::uint32_t>(chunks_.size());
  statistics.metadata = static_cast<std::uint32_t>(metadata_.size());
  SummaryGroups groups(place_);
  groups.add(McapOpcode::kSchema, schemas_);
  groups.add(McapOpcode::kChannel, channels_);
  groups.add(McapOpcode::kStatistics, std::vector{statistics});
  groups.add(McapOpcode::kChunkIndex, chunks_);
  groups.add(McapOpcode::kMetadataIndex, metadata_);
  const std::string bytes = groups.bytes();
  // The checksum covers the bytes before it.
  std::string footer = mcap_record(McapFooter{place_, groups.offsets_place(), 0});
  footer.resize(footer.size() - sizeof(std::uint32_t));
  const std::uint32_t crc = crc32(bytes + footer);
  return bytes + mcap_record(McapFooter{place_, groups.offsets_place(), crc});
}

Result<void> McapWriter::finish() {
  return end_chunk().and_then([&] { return put(mcap_data_end(data_crc_.value())); }).and_then([&] {
    return put(summary() + std::string(kMcapMagic));
  });
}

}  // namespace somato
