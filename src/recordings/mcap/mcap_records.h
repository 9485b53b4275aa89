#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// The records of an MCAP file (https://mcap.dev/spec), as far as they are used here.

namespace somato {

inline constexpr std::string_view kMcapMagic{"\x89MCAP0\r\n", 8};

/// The version of MCAP of a file that begins with `bytes`; nothing if it is no MCAP file.
std::optional<std::uint64_t> mcap_version(std::string_view bytes);

/// Opcode and length precede the content of every record.
inline constexpr std::size_t kMcapRecordHead = 9;

/// The largest chunk, unpacked and packed, that is written or read, in bytes.
inline constexpr std::size_t kLargestMcapChunk = std::size_t{24} << 20;

enum class McapOpcode : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kStatistics = 0x0B,
  kMetadata = 0x0C,
  kMetadataIndex = 0x0D,
  kSummaryOffset = 0x0E,
  kDataEnd = 0x0F,
};

struct McapHeader {
  std::string profile;
  std::string library;
};

struct McapSchema {
  std::uint16_t id = 0;
  std::string name;
  std::string encoding;
  std::string data;

  bool operator==(const McapSchema&) const = default;
};

struct McapChannel {
  std::uint16_t id = 0;
  std::uint16_t schema_id = 0;  ///< 0: none.
  std::string topic;
  std::string message_encoding;
  std::map<std::string, std::string> metadata;

  bool operator==(const McapChannel&) const = default;
};

/// Times are in nanoseconds. The owner of the data is documented at the source of a message.
struct McapMessage {
  std::uint16_t channel_id = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time = 0;
  std::uint64_t publish_time = 0;
  std::string_view data;
};

struct McapChunk {
  std::uint64_t start_time = 0;
  std::uint64_t end_time = 0;
  std::uint64_t unpacked_size = 0;
  std::uint32_t unpacked_crc = 0;  ///< 0: not known.
  std::string_view compression;    ///< Empty, "lz4", "zstd" or another.
  std::string_view packed;
};

/// The positions of the messages of a channel in a decompressed chunk: time and offset.
using McapMessageIndex = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

struct McapChunkIndex {
  std::uint64_t start_time = 0;
  std::uint64_t end_time = 0;
  std::uint64_t place = 0;
  std::uint64_t length = 0;
  std::map<std::uint16_t, std::uint64_t> message_index_places;
  std::uint64_t message_index_length = 0;
  std::string compression;
  std::uint64_t packed_size = 0;
  std::uint64_t unpacked_size = 0;
};

struct McapMetadata {
  std::string name;
  std::map<std::string, std::string> texts;
};

/// The position of a metadata record.
struct McapMetadataIndex {
  std::uint64_t place = 0;
  std::uint64_t length = 0;
  std::string name;
};

struct McapStatistics {
  std::uint16_t schemas = 0;
  std::uint32_t chunks = 0;
  std::uint64_t start_time = 0;
  std::uint64_t end_time = 0;
  std::map<std::uint16_t, std::uint64_t> messages;  ///< By channel.
  std::uint32_t channels = 0;
  std::uint32_t metadata = 0;
};

/// The positions of the records of one kind in the summary.
struct McapSummaryOffset {
  McapOpcode opcode = McapOpcode::kSchema;
  std::uint64_t place = 0;
  std::uint64_t length = 0;
};

struct McapFooter {
  std::uint64_t summary_place = 0;
  std::uint64_t summary_offset_place = 0;
  std::uint32_t summary_crc = 0;  ///< 0: not known.
};

// A record in the format of the file.
std::string mcap_record(McapOpcode opcode, std::string_view content);
std::string mcap_record(const McapHeader& header);
std::string mcap_record(const McapSchema& schema);
std::string mcap_record(const McapChannel& channel);
std::string mcap_record(const McapMessage& message);
std::string mcap_record(const McapChunk& chunk);
std::string mcap_record(std::uint16_t channel, const McapMessageIndex& index);
std::string mcap_record(const McapChunkIndex& index);
std::string mcap_record(const McapMetadata& metadata);
std::string mcap_record(const McapMetadataIndex& index);
std::string mcap_record(const McapStatistics& statistics);
std::string mcap_record(const McapSummaryOffset& offset);
std::string mcap_record(const McapFooter& footer);
std::string mcap_data_end(std::uint32_t data_crc);

// The parsed content of a record, or nothing if it is invalid. Views refer to `content`.
std::optional<McapHeader> parse_mcap_header(std::string_view content);
std::optional<McapSchema> parse_mcap_schema(std::string_view content);
std::optional<McapChannel> parse_mcap_channel(std::string_view content);
std::optional<McapMessage> parse_mcap_message(std::string_view content);
std::optional<McapChunk> parse_mcap_chunk(std::string_view content);
std::optional<McapMetadata> parse_mcap_metadata(std::string_view content);
std::optional<McapFooter> parse_mcap_footer(std::string_view content);
std::optional<std::uint32_t> parse_mcap_data_end(std::string_view content);

/// The content of a chunk that is cut off: as the above, but `packed` is what there is of it.
std::optional<McapChunk> parse_cut_mcap_chunk(std::string_view content);

}  // namespace somato
