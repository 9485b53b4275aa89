#include "recordings/mcap/mcap_search.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "base/archives/little_endian.h"
#include "base/text/format_version.h"
#include "base/text/number_of_text.h"

namespace somato {
namespace {

constexpr std::size_t kSearchedAtOnce = std::size_t{1} << 20;
constexpr std::size_t kMostBytesNoted = std::size_t{8} << 20;

// Whether a chunk begins here, in a file with `left` bytes from here on, whose sizes agree.
bool is_chunk_head(std::string_view bytes, std::size_t left) {
  const std::string_view head = bytes.substr(0, kLargestChunkHead);
  if (head.size() < kMcapRecordHead) return false;
  const auto length = little_endian<std::uint64_t>(&head[1]);
  if (length > kLargestMcapChunk + kLargestChunkHead || length > left - kMcapRecordHead) {
    return false;
  }
  const std::optional<McapChunk> chunk = parse_cut_mcap_chunk(head.substr(kMcapRecordHead));
  if (!chunk || chunk->unpacked_size > kLargestMcapChunk) return false;
  const std::string_view name = chunk->compression;
  if (!name.empty() && name != "lz4" && name != "zstd") return false;
  const std::size_t head_size = head.size() - chunk->packed.size();
  const auto packed = little_endian<std::uint64_t>(&head[head_size - sizeof(std::uint64_t)]);
  return packed == length - (head_size - kMcapRecordHead);
}

// Another version of Somato may write recordings with a profile such as "somato 2".
Result<void> check_version(std::string_view profile, const std::string& path) {
  const std::string begin = std::string(kRecordingProfile) + " ";
  if (!profile.starts_with(begin)) return {};
  const auto version = number_of_text<std::uint64_t>(profile.substr(begin.size()));
  if (!version || *version <= kRecordingVersion) return {};
  return unsupported_format(*version, kRecordingVersion, path, {});
}

// Searches the records outside chunks one after the other.
class NoteSearch {
 public:
  explicit NoteSearch(McapInput& input) : input_(&input) {}

  // A record may say something about an exploration that comes before it, so all are read first.
  // Where a record is damaged, the next chunk continues the search: a hole in a file, of zeros, is
  // not read as millions of records.
  Result<ExplorationNotes> run() {
    for (bool more = true; more;) {
      SOMATO_TRY(const std::string_view head, input_->view(place_, kMcapRecordHead));
      const std::size_t left = input_->size() - std::min(place_, input_->size());
      const bool has_head = head.size() == kMcapRecordHead;
      const auto length = has_head ? little_endian<std::uint64_t>(&head[1]) : 0;
      if (!has_head || head.front() == '\0' || length > left - kMcapRecordHead) {
        SOMATO_TRY(more, pass_damage());
      } else {
        const auto opcode = static_cast<McapOpcode>(head.front());
        SOMATO_TRY(more, pass(opcode, static_cast<std::size_t>(length)));
      }
    }
    return std::move(notes_);
  }

 private:
  Result<bool> pass_damage() {
    SOMATO_TRY(const auto chunk, find_mcap_chunk(*input_, place_ + 1));
    place_ = chunk.value_or(place_);
    return chunk.has_value();
  }

  // Whether other records can be notes, too.
  Result<bool> pass(McapOpcode opcode, std::size_t length) {
    const std::size_t place = place_ + kMcapRecordHead;
    place_ = place + length;
    if (opcode == McapOpcode::kDataEnd || opcode == McapOpcode::kFooter) return false;
    const bool is_read = opcode == McapOpcode::kHeader || opcode == McapOpcode::kMetadata;
    if (!is_read || length > kLongestExplorationText) return true;
    SOMATO_TRY(const std::string_view content, input_->view(place, length));
    if (opcode == McapOpcode::kMetadata) return take(content).map([] { return true; });
    const auto header = parse_mcap_header(content);
    if (!header) return true;
    SOMATO_TRY_VOID(check_version(header->profile, input_->path()));
    return header->profile == kRecordingProfile;
  }

  Result<void> take(std::string_view content) {
    const auto metadata = parse_mcap_metadata(content);
    if (!metadata || !notes_.add(*metadata)) return {};
    bytes_ += content.size();
    if (bytes_ <= kMostBytesNoted) return {};
    return fail(
        ErrorKind::kData,
        fmt::format("the labels that were given later exceed {} MiB", kMostBytesNoted >> 20),
        input_->path());
  }

  McapInput* input_;
  std::size_t place_ = kMcapMagic.size();
  ExplorationNotes notes_;
  std::size_t bytes_ = 0;
};

}  // namespace

Result<std::optional<std::size_t>> find_mcap_chunk(McapInput& input, std::size_t from) {
  for (std::size_t at = from; at < input.size();) {
    SOMATO_TRY(const std::string_view bytes, input.view(at, kSearchedAtOnce));
    const bool last = at + bytes.size() >= input.size();
    if (bytes.size() < kLargestChunkHead && !last) break;  // It has become shorter.
    const std::size_t heads = last ? bytes.size() : bytes.size() - kLargestChunkHead;
    for (std::size_t i = 0; i < heads; ++i) {
      i = std::min(bytes.find(static_cast<char>(McapOpcode::kChunk), i), heads);
      if (i == heads || !is_chunk_head(bytes.substr(i), input.size() - at - i)) continue;
      return at + i;
    }
    at += std::max<std::size_t>(heads, 1);
  }
  return std::nullopt;
}

Result<ExplorationNotes> find_notes(McapInput& input) {
  return NoteSearch(input).run();
}

}  // namespace somato
