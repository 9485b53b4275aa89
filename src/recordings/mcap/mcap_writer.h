#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/archives/checksum.h"
#include "recordings/mcap/mcap_records.h"
#include "somato/core/result.h"
#include "somato/recording/recording_writer.h"

namespace somato {

/// The largest message that is written, in bytes: it fits into a chunk with all that goes before.
inline constexpr std::size_t kLargestMcapMessage = std::size_t{23} << 20;

/// Writes an MCAP file of chunks with indexes, statistics and checksums. Every chunk announces the
/// schemas and channels of its messages, so that it can be read without those before it.
class McapWriter {
 public:
  /// Destination of the bytes.
  using Sink = std::function<Result<void>(std::string_view)>;

  McapWriter(Sink sink, Compression compression, std::size_t chunk_size)
      : sink_(std::move(sink)), compression_(compression), chunk_size_(chunk_size) {}

  Result<void> begin(const McapHeader& header);

  /// The id of a channel with that schema (ids in them do not count; no schema: nullptr), a new one
  /// unless it is known. Errors (kData): there are as many as ids.
  Result<std::uint16_t> channel(const McapSchema* schema, McapChannel channel);

  /// Announces the channel in the chunk, unless it is the latest announced there for its topic.
  void announce(std::uint16_t channel);

  /// Errors: kData for a message that is too large; the sink's.
  Result<void> add(const McapMessage& message);

  /// The same, but the chunk continues with the next message even if it is full.
  Result<void> add_before_another(const McapMessage& message);

  /// Writes out what there is, and after it a record outside chunks. Errors: the sink's.
  Result<void> add(const McapMetadata& metadata);

  bool chunk_is_empty() const { return messages_in_chunk_ == 0; }
  std::uint64_t latest_time() const { return latest_time_; }

  /// Writes out what there is.
  Result<void> end_chunk();

  /// Writes out what there is, and what makes the file whole.
  Result<void> finish();

 private:
  Result<std::uint16_t> schema(const McapSchema& schema);
  Result<void> put(std::string_view bytes);
  std::string message_indexes(McapChunkIndex& index) const;
  std::string summary() const;
  void start_chunk();

  Sink sink_;
  Compression compression_;
  std::size_t chunk_size_;
  std::optional<Error> broken_;  // The sink's failure: nothing may follow it.
  std::uint64_t place_ = 0;
  Crc32 data_crc_;
  std::vector<McapSchema> schemas_;  // Number i has the id i + 1.
  std::vector<McapChannel> channels_;
  std::map<std::string, std::uint16_t> channel_ids_;  // By the record with the id 0.
  std::map<std::string, std::uint16_t> schema_ids_;

  std::string chunk_;
  std::size_t messages_in_chunk_ = 0;
  std::uint64_t chunk_start_ = 0;
  std::uint64_t chunk_end_ = 0;
  std::set<std::uint16_t> announced_schemas_;
  std::map<std::string, std::uint16_t> announced_channels_;  // The latest by topic.
  std::map<std::uint16_t, McapMessageIndex> message_indexes_;

  std::vector<McapChunkIndex> chunks_;
  std::vector<McapMetadataIndex> metadata_;
  McapStatistics statistics_;
  std::uint64_t latest_time_ = 0;
};

}  // namespace somato
