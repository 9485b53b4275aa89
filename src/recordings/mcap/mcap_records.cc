#include "recordings/mcap/mcap_records.h"

#include <algorithm>

#include "base/archives/little_endian.h"
#include "base/text/number_of_text.h"

namespace somato {
namespace {

// Appends fields one after the other.
class Fields {
 public:
  template <typename T>
  Fields& number(T value) {
    append_little_endian(bytes_, value);
    return *this;
  }
  Fields& text(std::string_view value) {
    number(static_cast<std::uint32_t>(value.size()));
    return raw(value);
  }
  Fields& raw(std::string_view value) {
    bytes_ += value;
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

std::string texts_bytes(const std::map<std::string, std::string>& texts) {
  Fields fields;
  for (const auto& [name, text] : texts) fields.text(name).text(text);
  return fields.bytes();
}

// Takes fields one after the other; after one that does not fit all are empty, and fits() is false.
class Taker {
 public:
  explicit Taker(std::string_view bytes) : bytes_(bytes) {}

  template <typename T>
  T number() {
    const std::string_view taken = raw(sizeof(T));
    return taken.empty() ? T{} : little_endian<T>(taken.data());
  }
  std::string_view text() { return raw(number<std::uint32_t>()); }
  std::string_view raw(std::uint64_t count) {
    fits_ = fits_ && count <= bytes_.size();
    if (!fits_) return {};
    const std::string_view taken = bytes_.substr(0, static_cast<std::size_t>(count));
    bytes_.remove_prefix(taken.size());
    return taken;
  }
  std::string_view rest() { return raw(bytes_.size()); }
  std::size_t left() const { return bytes_.size(); }
  bool fits() const { return fits_; }

 private:
  std::string_view bytes_;
  bool fits_ = true;
};

std::map<std::string, std::string> take_texts(Taker& taker) {
  std::map<std::string, std::string> texts;
  Taker entries(taker.raw(taker.number<std::uint32_t>()));
  while (entries.fits() && entries.left() > 0) {
    const std::string_view name = entries.text();
    texts.emplace(name, entries.text());
  }
  if (!entries.fits()) (void)taker.raw(taker.left() + 1);
  return texts;
}

McapChunk take_chunk_head(Taker& taker) {
  McapChunk chunk;
  chunk.start_time = taker.number<std::uint64_t>();
  chunk.end_time = taker.number<std::uint64_t>();
  chunk.unpacked_size = taker.number<std::uint64_t>();
  chunk.unpacked_crc = taker.number<std::uint32_t>();
  chunk.compression = taker.text();
  return chunk;
}

template <typename T>
std::optional<T> if_fits(const Taker& taker, T value) {
  if (!taker.fits()) return std::nullopt;
  return value;
}

}  // namespace

std::string mcap_record(McapOpcode opcode, std::string_view content) {
  return Fields()
      .number(static_cast<std::uint8_t>(opcode))
      .number(std::uint64_t{content.size()})
      .raw(content)
      .bytes();
}

std::string mcap_record(const McapHeader& header) {
  return mcap_record(McapOpcode::kHeader,
                     Fields().text(header.profile).text(header.library).bytes());
}

std::string mcap_record(const McapSchema& schema) {
  return mcap_record(
      McapOpcode::kSchema,
      Fields().number(schema.id).text(schema.name).text(schema.encoding).text(schema.data).bytes());
}

std::string mcap_record(const McapChannel& channel) {
  return mcap_record(McapOpcode::kChannel, Fields()
                                               .number(channel.id)
                                               .number(channel.schema_id)
                                               .text(channel.topic)
                                               .text(channel.message_encoding)
                                               .text(texts_bytes(channel.metadata))
                                               .bytes());
}

std::string mcap_record(const McapMessage& message) {
  return mcap_record(McapOpcode::kMessage, Fields()
                                               .number(message.channel_id)
                                               .number(message.sequence)
                                               .number(message.log_time)
                                               .number(message.publish_time)
                                               .raw(message.data)
                                               .bytes());
}

std::string mcap_record(const McapChunk& chunk) {
  return mcap_record(McapOpcode::kChunk, Fields()
                                             .number(chunk.start_time)
                                             .number(chunk.end_time)
                                             .number(chunk.unpacked_size)
                                             .number(chunk.unpacked_crc)
                                             .text(chunk.compression)
                                             .number(std::uint64_t{chunk.packed.size()})
                                             .raw(chunk.packed)
                                             .bytes());
}

std::string mcap_record(std::uint16_t channel, const McapMessageIndex& index) {
  Fields entries;
  for (const auto& [time, offset] : index) entries.number(time).number(offset);
  return mcap_record(McapOpcode::kMessageIndex,
                     Fields().number(channel).text(entries.bytes()).bytes());
}

std::string mcap_record(const McapChunkIndex& index) {
  Fields places;
  for (const auto& [channel, place] : index.message_index_places) {
    places.number(channel).number(place);
  }
  return mcap_record(McapOpcode::kChunkIndex, Fields()
                                                  .number(index.start_time)
                                                  .number(index.end_time)
                                                  .number(index.place)
                                                  .number(index.length)
                                                  .text(places.bytes())
                                                  .number(index.message_index_length)
                                                  .text(index.compression)
                                                  .number(index.packed_size)
                                                  .number(index.unpacked_size)
                                                  .bytes());
}

std::string mcap_record(const McapMetadata& metadata) {
  return mcap_record(McapOpcode::kMetadata,
                     Fields().text(metadata.name).text(texts_bytes(metadata.texts)).bytes());
}

std::string mcap_record(const McapMetadataIndex& index) {
  return mcap_record(McapOpcode::kMetadataIndex,
                     Fields().number(index.place).number(index.length).text(index.name).bytes());
}

std::string mcap_record(const McapStatistics& statistics) {
  Fields counts;
  std::uint64_t messages = 0;
  for (const auto& [channel, count] : statistics.messages) {
    counts.number(channel).number(count);
    messages += count;
  }
  constexpr std::uint32_t kAttachments = 0;
  return mcap_record(McapOpcode::kStatistics, Fields()
                                                  .number(messages)
                                                  .number(statistics.schemas)
                                                  .number(statistics.channels)
                                                  .number(kAttachments)
                                                  .number(statistics.metadata)
                                                  .number(statistics.chunks)
                                                  .number(statistics.start_time)
                                                  .number(statistics.end_time)
                                                  .text(counts.bytes())
                                                  .bytes());
}

std::string mcap_record(const McapSummaryOffset& offset) {
  return mcap_record(McapOpcode::kSummaryOffset,
                     Fields()
                         .number(static_cast<std::uint8_t>(offset.opcode))
                         .number(offset.place)
                         .number(offset.length)
                         .bytes());
}

std::string mcap_record(const McapFooter& footer) {
  return mcap_record(McapOpcode::kFooter, Fields()
                                              .number(footer.summary_place)
                                              .number(footer.summary_offset_place)
                                              .number(footer.summary_crc)
                                              .bytes());
}

std::string mcap_data_end(std::uint32_t data_crc) {
  return mcap_record(McapOpcode::kDataEnd, Fields().number(data_crc).bytes());
}

std::optional<std::uint64_t> mcap_version(std::string_view bytes) {
  constexpr std::size_t kPlace = 5;
  std::string magic(bytes.substr(0, kMcapMagic.size()));
  if (magic.size() < kMcapMagic.size()) return {};
  const char digit = std::exchange(magic[kPlace], kMcapMagic[kPlace]);
  return magic == kMcapMagic ? number_of_text<std::uint64_t>({&digit, 1}) : std::nullopt;
}

std::optional<McapHeader> parse_mcap_header(std::string_view content) {
  Taker taker(content);
  McapHeader header;
  header.profile = taker.text();
  header.library = taker.text();
  return if_fits(taker, std::move(header));
}

std::optional<McapSchema> parse_mcap_schema(std::string_view content) {
  Taker taker(content);
  McapSchema schema;
  schema.id = taker.number<std::uint16_t>();
  schema.name = taker.text();
  schema.encoding = taker.text();
  schema.data = taker.text();
  return if_fits(taker, std::move(schema));
}

std::optional<McapChannel> parse_mcap_channel(std::string_view content) {
  Taker taker(content);
  McapChannel channel;
  channel.id = taker.number<std::uint16_t>();
  channel.schema_id = taker.number<std::uint16_t>();
  channel.topic = taker.text();
  channel.message_encoding = taker.text();
  channel.metadata = take_texts(taker);
  return if_fits(taker, std::move(channel));
}

std::optional<McapMetadata> parse_mcap_metadata(std::string_view content) {
  Taker taker(content);
  McapMetadata metadata;
  metadata.name = taker.text();
  metadata.texts = take_texts(taker);
  return if_fits(taker, std::move(metadata));
}

std::optional<McapMessage> parse_mcap_message(std::string_view content) {
  Taker taker(content);
  McapMessage message;
  message.channel_id = taker.number<std::uint16_t>();
  message.sequence = taker.number<std::uint32_t>();
  message.log_time = taker.number<std::uint64_t>();
  message.publish_time = taker.number<std::uint64_t>();
  message.data = taker.rest();
  return if_fits(taker, message);
}

std::optional<McapChunk> parse_mcap_chunk(std::string_view content) {
  Taker taker(content);
  McapChunk chunk = take_chunk_head(taker);
  chunk.packed = taker.raw(taker.number<std::uint64_t>());
  return if_fits(taker, chunk);
}

std::optional<McapChunk> parse_cut_mcap_chunk(std::string_view content) {
  Taker taker(content);
  McapChunk chunk = take_chunk_head(taker);
  (void)taker.number<std::uint64_t>();
  chunk.packed = taker.rest();
  return if_fits(taker, chunk);
}

std::optional<McapFooter> parse_mcap_footer(std::string_view content) {
  Taker taker(content);
  McapFooter footer;
  footer.summary_place = taker.number<std::uint64_t>();
  footer.summary_offset_place = taker.number<std::uint64_t>();
  footer.summary_crc = taker.number<std::uint32_t>();
  return if_fits(taker, footer);
}

std::optional<std::uint32_t> parse_mcap_data_end(std::string_view content) {
  Taker taker(content);
  const auto crc = taker.number<std::uint32_t>();
  return if_fits(taker, crc);
}

}  // namespace somato
