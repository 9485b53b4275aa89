#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/archives/checksum.h"
#include "recordings/mcap/exploration_notes.h"
#include "recordings/mcap/mcap_input.h"
#include "recordings/mcap/mcap_records.h"
#include "somato/core/result.h"

namespace somato {

/// Reads the messages of an MCAP file from front to back and believes nothing: lengths, checksums,
/// ids and the summary are checked. Memory is bounded by a chunk and 8 MiB of schemas and channels.
class McapReader {
 public:
  /// Errors: kSystem with the system's reason; kUsage for a file that is not regular; kData for a
  /// file that is not MCAP.
  static Result<McapReader> open(FileSystem& files, const std::string& path);

  /// The next message, its data valid until the next call; nothing after the last one of a whole
  /// file. Errors: kSystem with the system's reason; kData with file and place.
  Result<std::optional<McapMessage>> next();

  /// After an error: continues behind the damage, with the rest of the chunk or the next complete
  /// chunk. Returns whether there are more data. Errors: kSystem with the system's reason.
  Result<bool> go_on();

  /// The notes about explorations in the whole file; none in a file of another program.
  const ExplorationNotes& notes() const { return notes_; }

  const McapHeader& header() const { return header_; }
  const std::string& path() const { return input_.path(); }
  std::size_t size() const { return input_.size(); }

  /// The channel of the last message.
  const McapChannel& channel(std::uint16_t id) const { return channels_.at(id); }
  const McapSchema& schema_of(std::uint16_t channel) const;

  /// The channel announced last for `topic`, or nullptr.
  const McapChannel* latest(const std::string& topic) const;

  /// The compression of the chunks so far, with commas between.
  std::string compressions() const;

  /// The byte at which the chunk of the latest message begins, or the message outside chunks.
  std::size_t place() const { return message_place_; }

  /// Whether all messages were read: what fails after that is no loss.
  bool has_all_messages() const { return has_all_messages_; }

  /// Whether the next data, after go_on(), directly follow the preceding ones.
  bool continues_without_gap() const { return in_chunk_ && chunk_is_cut_ && chunk_at_ == 0; }

  /// An error (kData) at the latest message.
  tl::unexpected<Error> bad(const std::string& what, const std::string& advice = {}) const;

 private:
  explicit McapReader(McapInput input) : input_(std::move(input)) {}

  tl::unexpected<Error> bad_at(std::size_t place, const std::string& what,
                               const std::string& advice = {}) const;
  Result<void> begin();
  Result<std::optional<McapMessage>> next_in_chunk();
  Result<std::optional<McapMessage>> next_record();
  Result<std::uint64_t> record_length();
  Result<void> pass(std::size_t length);
  Result<std::string_view> whole_record(std::size_t length);
  Result<std::optional<McapMessage>> read_record(McapOpcode opcode, std::string_view content);
  Result<void> open_chunk(std::string_view content);
  Result<void> take_header(std::string_view content);
  Result<void> remember_schema(std::string_view content);
  Result<void> remember_channel(std::string_view content);
  Result<void> keep_within_limit(std::size_t more);
  Result<std::optional<McapMessage>> known(std::string_view content);
  Result<void> check_end(std::string_view data_end);
  Result<void> check_summary();
  Result<std::uint32_t> pass_summary();
  Result<bool> open_cut_chunk();
  Result<bool> find_chunk(std::size_t from);

  McapInput input_;
  McapHeader header_;
  ExplorationNotes notes_;
  std::size_t place_ = 0;  // The place of the next record outside chunks.
  bool in_chunk_ = false;
  std::string chunk_;
  std::size_t chunk_place_ = 0;
  std::size_t chunk_at_ = 0;  // The part of the chunk that was read.
  bool chunk_is_cut_ = false;
  std::size_t message_place_ = 0;
  bool record_is_damaged_ = false;  // The one at place_, so that its length may be wrong.
  bool after_data_ = false;
  bool has_all_messages_ = false;
  Crc32 crc_;
  bool crc_known_ = true;
  std::map<std::uint16_t, McapSchema> schemas_;
  std::map<std::uint16_t, McapChannel> channels_;
  std::map<std::string, std::uint16_t> latest_;
  std::size_t announced_ = 0;  // Bytes of schemas and channels.
  std::map<std::string, std::size_t> compressions_;
};

}  // namespace somato
