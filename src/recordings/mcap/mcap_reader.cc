#include "recordings/mcap/mcap_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/archives/little_endian.h"
#include "base/text/text.h"
#include "recordings/mcap/mcap_compression.h"
#include "recordings/mcap/mcap_search.h"

namespace somato {
namespace {

constexpr std::size_t kMostBytesAnnounced = std::size_t{8} << 20;
constexpr std::size_t kSmallRecord = std::size_t{1} << 20;

std::string opcode_text(McapOpcode opcode) {
  return fmt::format("a record of kind 0x{:02X}", static_cast<unsigned>(opcode));
}

}  // namespace

tl::unexpected<Error> McapReader::bad_at(std::size_t place, const std::string& what,
                                         const std::string& advice) const {
  return fail(ErrorKind::kData, what, fmt::format("{}:byte {}", path(), place),
              advice.empty()
                  ? fmt::format("recover its readable part: somato recover {} -o OUT", path())
                  : advice);
}

tl::unexpected<Error> McapReader::bad(const std::string& what, const std::string& advice) const {
  return bad_at(place(), what, advice);
}

Result<McapReader> McapReader::open(FileSystem& files, const std::string& path) {
  SOMATO_TRY(McapInput input, McapInput::open(files, path));
  McapReader reader(std::move(input));
  SOMATO_TRY_VOID(reader.begin());
  return reader;
}

Result<void> McapReader::begin() {
  SOMATO_TRY(const std::string_view magic, input_.view(0, kMcapMagic.size()));
  if (magic != kMcapMagic) {
    if (const auto version = mcap_version(magic)) {
      return fail(ErrorKind::kData,
                  fmt::format("a file of version {} of MCAP; version 0 is supported", *version),
                  path(), "update Somato");
    }
    return fail(ErrorKind::kData, "not an MCAP file", path(), "check that it is the right file");
  }
  crc_.add(magic);
  place_ = kMcapMagic.size();
  SOMATO_TRY(notes_, find_notes(input_));
  return {};
}

const McapSchema& McapReader::schema_of(std::uint16_t channel) const {
  static const McapSchema none;
  const auto found = schemas_.find(channels_.at(channel).schema_id);
  return found == schemas_.end() ? none : found->second;
}

const McapChannel* McapReader::latest(const std::string& topic) const {
  const auto found = latest_.find(topic);
  return found == latest_.end() ? nullptr : &channels_.at(found->second);
}

std::string McapReader::compressions() const {
  std::string all;
  for (const auto& [name, chunks] : compressions_) {
    all += (all.empty() ? "" : ", ") + (name.empty() ? "none" : name);
  }
  return all.empty() ? "none" : all;
}

Result<void> McapReader::keep_within_limit(std::size_t more) {
  announced_ += more;
  if (announced_ <= kMostBytesAnnounced) return {};
  return bad(fmt::format("the schemas and channels exceed {} MiB", kMostBytesAnnounced >> 20));
}

Result<void> McapReader::remember_schema(std::string_view content) {
  std::optional<McapSchema> schema = parse_mcap_schema(content);
  if (!schema) return bad("a schema does not fill its record");
  if (schema->id == 0) return bad("a schema has the number 0");
  const auto found = schemas_.find(schema->id);
  if (found == schemas_.end()) {
    return keep_within_limit(content.size()).map([&] {
      const std::uint16_t id = schema->id;
      schemas_.emplace(id, std::move(*schema));
    });
  }
  if (found->second == *schema) return {};
  return bad(fmt::format("there are two different schemas {}", schema->id));
}

Result<void> McapReader::remember_channel(std::string_view content) {
  std::optional<McapChannel> channel = parse_mcap_channel(content);
  if (!channel) return bad("a channel does not fill its record");
  const std::uint16_t id = channel->id;
  if (channel->schema_id != 0 && !schemas_.contains(channel->schema_id)) {
    return bad(fmt::format("channel {} has the unknown schema {}", id, channel->schema_id));
  }
  const auto found = channels_.find(id);
  if (found != channels_.end() && found->second != *channel) {
    return bad(fmt::format("there are two different channels {}", id));
  }
  latest_[channel->topic] = id;
  if (found != channels_.end()) return {};
  return keep_within_limit(content.size()).map([&] { channels_.emplace(id, std::move(*channel)); });
}

Result<std::optional<McapMessage>> McapReader::known(std::string_view content) {
  const std::optional<McapMessage> message = parse_mcap_message(content);
  if (!message) return bad("a message does not fill its record");
  if (channels_.contains(message->channel_id)) return message;
  return bad(
      fmt::format("a message belongs to channel {}, which is not declared", message->channel_id));
}

Result<std::optional<McapMessage>> McapReader::next() {
  record_is_damaged_ = false;
  for (;;) {
    if (!in_chunk_ && after_data_) return std::optional<McapMessage>();
    record_is_damaged_ = !in_chunk_;
    Result<std::optional<McapMessage>> message = in_chunk_ ? next_in_chunk() : next_record();
    if (!message) return message;
    record_is_damaged_ = false;
    if (*message) return message;
  }
}

Result<std::optional<McapMessage>> McapReader::next_in_chunk() {
  const std::string_view left = std::string_view(chunk_).substr(chunk_at_);
  const auto length = left.size() < kMcapRecordHead ? 0 : little_endian<std::uint64_t>(&left[1]);
  const bool fits = left.size() >= kMcapRecordHead && length <= left.size() - kMcapRecordHead;
  const auto opcode = left.empty() ? McapOpcode::kHeader : static_cast<McapOpcode>(left[0]);
  const bool belongs = opcode == McapOpcode::kMessage || opcode == McapOpcode::kSchema ||
                       opcode == McapOpcode::kChannel;
  if (!fits || (chunk_is_cut_ && !belongs)) {
    in_chunk_ = false;
    if (chunk_is_cut_) return bad_at(chunk_place_, "the file ends within a chunk");
    if (left.empty()) return std::optional<McapMessage>();
    return bad_at(chunk_place_, "a record is longer than the rest of its chunk");
  }
  const std::string_view content = left.substr(kMcapRecordHead, static_cast<std::size_t>(length));
  chunk_at_ += kMcapRecordHead + content.size();
  if (!belongs) return bad_at(chunk_place_, opcode_text(opcode) + " is not allowed in a chunk");
  message_place_ = chunk_place_;
  return read_record(opcode, content);
}

// The position of a record: in a chunk, or between chunks.
Result<std::optional<McapMessage>> McapReader::read_record(McapOpcode opcode,
                                                           std::string_view content) {
  if (opcode == McapOpcode::kMessage) return known(content);
  Result<void> remembered =
      opcode == McapOpcode::kSchema ? remember_schema(content) : remember_channel(content);
  return remembered.map([] { return std::optional<McapMessage>(); });
}

// The length of the record at place_, of which the whole file holds.
Result<std::uint64_t> McapReader::record_length() {
  SOMATO_TRY(const std::string_view head, input_.view(place_, kMcapRecordHead));
  if (head.empty()) return bad("the file ends without its end marker");
  if (head.size() < kMcapRecordHead) return bad("the file ends within a record");
  const auto length = little_endian<std::uint64_t>(head.data() + 1);
  if (length <= size() - place_ - kMcapRecordHead) return length;
  return bad(fmt::format("a record of {} bytes is longer than the rest of the file", length));
}

// Skips a record; a large one without reading it.
Result<void> McapReader::pass(std::size_t length) {
  if (length <= kSmallRecord) {
    SOMATO_TRY(const std::string_view bytes, input_.view(place_, length));
    crc_.add(bytes);
  } else {
    crc_known_ = false;
  }
  place_ += length;
  return {};
}

Result<std::string_view> McapReader::whole_record(std::size_t length) {
  Result<std::string_view> record = input_.view(place_, length);
  if (record && record->size() < length) return bad_at(place_, "the file has become shorter");
  return record;
}

Result<void> McapReader::open_chunk(std::string_view content) {
  const std::optional<McapChunk> chunk = parse_mcap_chunk(content);
  if (!chunk) return bad("a chunk does not fill its record");
  if (chunk->unpacked_size > kLargestMcapChunk) {
    return bad(fmt::format("a chunk declares {} bytes, more than {}", chunk->unpacked_size,
                           kLargestMcapChunk));
  }
  std::string().swap(chunk_);  // Never two at once.
  Result<std::string> unpacked =
      unpack(chunk->compression, chunk->packed, static_cast<std::size_t>(chunk->unpacked_size));
  if (!unpacked) return bad(unpacked.error().what, unpacked.error().advice);
  if (chunk->unpacked_crc != 0 && crc32(*unpacked) != chunk->unpacked_crc) {
    return bad("the checksum of a chunk does not match");
  }
  ++compressions_[std::string(chunk->compression)];
  chunk_ = std::move(*unpacked);
  chunk_place_ = place_;
  chunk_at_ = 0;
  chunk_is_cut_ = false;
  in_chunk_ = true;
  return {};
}

Result<std::optional<McapMessage>> McapReader::next_record() {
  message_place_ = place_;
  SOMATO_TRY(const std::uint64_t length, record_length());
  SOMATO_TRY(const std::string_view head, whole_record(kMcapRecordHead));
  const auto opcode = static_cast<McapOpcode>(head.front());
  const std::size_t whole = kMcapRecordHead + static_cast<std::size_t>(length);
  const bool first = place_ == kMcapMagic.size();
  if (static_cast<unsigned>(opcode) == 0 || opcode == McapOpcode::kFooter ||
      first != (opcode == McapOpcode::kHeader)) {
    return bad(opcode_text(opcode) + " is not allowed here");
  }
  if (opcode > McapOpcode::kChunk && opcode != McapOpcode::kDataEnd) {
    return pass(whole).map([] { return std::optional<McapMessage>(); });
  }
  if (length > kLargestMcapChunk + kLargestChunkHead) {
    return bad(fmt::format("a record has {} bytes, more than {}", length, kLargestMcapChunk));
  }
  SOMATO_TRY(const std::string_view record, whole_record(whole));
  const std::string_view content = record.substr(kMcapRecordHead);
  if (opcode == McapOpcode::kDataEnd) {
    return check_end(content).map([] { return std::optional<McapMessage>(); });
  }
  if (opcode == McapOpcode::kChunk || opcode == McapOpcode::kHeader) {
    SOMATO_TRY_VOID(opcode == McapOpcode::kChunk ? open_chunk(content) : take_header(content));
  }
  crc_.add(record);
  place_ += whole;
  if (opcode == McapOpcode::kChunk || opcode == McapOpcode::kHeader) {
    return std::optional<McapMessage>();
  }
  record_is_damaged_ = false;  // Its end is known independent of its content.
  return read_record(opcode, content);
}

Result<void> McapReader::take_header(std::string_view content) {
  std::optional<McapHeader> header = parse_mcap_header(content);
  if (!header) return bad("the header does not fill its record");
  header_ = std::move(*header);
  return {};
}

Result<void> McapReader::check_end(std::string_view data_end) {
  const std::optional<std::uint32_t> crc = parse_mcap_data_end(data_end);
  if (!crc) return bad("the end of the data does not fill its record");
  after_data_ = true;
  has_all_messages_ = *crc == 0 || !crc_known_ || *crc == crc_.value();
  if (!has_all_messages_) return bad("the checksum of the data does not match");
  place_ += kMcapRecordHead + data_end.size();
  return check_summary();
}

// Reading from front to back does not need the summary, but a complete file has a complete one.
Result<void> McapReader::check_summary() {
  message_place_ = place_;
  SOMATO_TRY(const std::uint32_t crc, pass_summary());
  SOMATO_TRY(const std::uint64_t length, record_length());
  const std::size_t whole = kMcapRecordHead + static_cast<std::size_t>(length);
  SOMATO_TRY(const auto record, whole_record(std::min(whole, kSmallRecord)));
  const std::optional<McapFooter> footer = parse_mcap_footer(record.substr(kMcapRecordHead));
  if (!footer) return bad_at(place_, "the footer does not fill its record");
  if (footer->summary_crc != 0 && footer->summary_crc != crc) {
    return bad("the checksum of the summary does not match");
  }
  place_ += whole;
  SOMATO_TRY(const std::string_view magic, input_.view(place_, kMcapMagic.size()));
  if (magic != kMcapMagic) return bad_at(place_, "the file ends without its end marker");
  place_ += kMcapMagic.size();
  if (place_ == size()) return {};
  return bad_at(place_, fmt::format("{} bytes follow the end", size() - place_));
}

// Goes to the footer; the checksum of all before and of the footer up to its own.
Result<std::uint32_t> McapReader::pass_summary() {
  constexpr std::size_t kFooterUpToChecksum = kMcapRecordHead + 2 * sizeof(std::uint64_t);
  Crc32 crc;
  for (;;) {
    SOMATO_TRY(const std::uint64_t length, record_length());
    SOMATO_TRY(const std::string_view head, whole_record(kMcapRecordHead));
    const auto opcode = static_cast<McapOpcode>(head.front());
    if (static_cast<unsigned>(opcode) == 0) {
      return bad_at(place_, opcode_text(opcode) + " is not allowed here");
    }
    const bool is_footer = opcode == McapOpcode::kFooter;
    const std::size_t end =
        place_ +
        (is_footer ? kFooterUpToChecksum : kMcapRecordHead + static_cast<std::size_t>(length));
    for (std::size_t at = place_; at < end; at += kSmallRecord) {
      SOMATO_TRY(const auto piece, input_.view(at, std::min(end - at, kSmallRecord)));
      crc.add(piece);
    }
    if (is_footer) return crc.value();
    place_ = end;
  }
}

Result<bool> McapReader::go_on() {
  crc_known_ = false;
  if (after_data_) return false;
  if (record_is_damaged_) {
    Result<bool> cut = open_cut_chunk();
    if (!cut || *cut) return cut;
    return find_chunk(place_ + 1);
  }
  if (in_chunk_ || !chunk_is_cut_) return true;
  chunk_is_cut_ = false;
  return find_chunk(chunk_place_ + 1);
}

// A chunk that is not packed and longer than the rest of the file still holds messages.
Result<bool> McapReader::open_cut_chunk() {
  SOMATO_TRY(const std::string_view head, input_.view(place_, kLargestChunkHead));
  if (head.size() < kMcapRecordHead || static_cast<McapOpcode>(head.front()) != McapOpcode::kChunk)
    return false;
  const auto length = little_endian<std::uint64_t>(head.data() + 1);
  if (length <= size() - place_ - kMcapRecordHead ||
      length > kLargestMcapChunk + kLargestChunkHead) {
    return false;
  }
  SOMATO_TRY(const std::string_view rest, input_.view(place_, size() - place_));
  const std::optional<McapChunk> chunk = parse_cut_mcap_chunk(rest.substr(kMcapRecordHead));
  if (!chunk || !chunk->compression.empty()) return false;
  chunk_ = std::string(chunk->packed);
  chunk_place_ = place_;
  chunk_at_ = 0;
  chunk_is_cut_ = true;
  in_chunk_ = true;
  ++compressions_[""];
  return true;
}

Result<bool> McapReader::find_chunk(std::size_t from) {
  SOMATO_TRY(const auto found, find_mcap_chunk(input_, from));
  place_ = found.value_or(place_);
  return found.has_value();
}

}  // namespace somato
