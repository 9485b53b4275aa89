#include "recordings/bags/bag_metadata.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "base/text/text.h"

namespace somato {
namespace {

std::string_view unquoted(std::string_view text) {
  const bool is_quoted = text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
                         text.back() == text.front();
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

// The value of "key: value", or nothing for another key.
std::optional<std::string_view> value_of(std::string_view line, std::string_view key) {
  if (!line.starts_with(key) || !line.substr(key.size()).starts_with(':')) return std::nullopt;
  return unquoted(trimmed(line.substr(key.size() + 1)));
}

// Reads the lines, of which some belong to a list.
class MetadataLines {
 public:
  void take(std::string_view line) {
    const bool is_item = line.starts_with("- ");
    if (is_item) line = trimmed(line.substr(2));
    if (is_item && list_ == List::kFiles) {
      metadata.files.emplace_back(unquoted(line));
    } else if (list_ == List::kTopics && take_of_topic(line)) {
      return;
    } else {
      take_key(line);
    }
  }

  BagMetadata metadata;

 private:
  enum class List { kNone, kFiles, kTopics };

  // The name of a topic and the number of its messages follow each other in either order.
  bool take_of_topic(std::string_view line) {
    const auto name = value_of(line, "name");
    const auto count = value_of(line, "message_count");
    if (name) topic_ = *name;
    if (count) std::from_chars(count->data(), count->data() + count->size(), messages_.emplace());
    if (topic_ && messages_) {
      metadata.messages[*topic_] = *messages_;
      topic_.reset();
      messages_.reset();
    }
    return name || count || line == "topic_metadata:";
  }

  void take_key(std::string_view line) {
    if (const auto compression = value_of(line, "compression_mode")) {
      metadata.compression = *compression;
    }
    if (line == "relative_file_paths:") list_ = List::kFiles;
    if (line == "topics_with_message_count:") list_ = List::kTopics;
    if (line == "files:" || line.starts_with("compression_format:")) list_ = List::kNone;
  }

  List list_ = List::kNone;
  std::optional<std::string> topic_;
  std::optional<std::uint64_t> messages_;
};

}  // namespace

BagMetadata parse_bag_metadata(std::string_view text) {
  MetadataLines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.take(trimmed(line));
  }
  return std::move(lines.metadata);
}

std::vector<std::string> differences(const BagMetadata& listed,
                                     const std::map<std::string, std::uint64_t>& held) {
  std::vector<std::string> sentences;
  if (listed.messages.empty()) return sentences;
  for (const auto& [topic, messages] : listed.messages) {
    const auto found = held.find(topic);
    const std::uint64_t count = found == held.end() ? 0 : found->second;
    if (count == messages) continue;
    sentences.push_back(fmt::format("metadata.yaml lists {} messages of {}, the files hold {}",
                                    messages, topic, count));
  }
  for (const auto& [topic, messages] : held) {
    if (listed.messages.contains(topic) || messages == 0) continue;
    sentences.push_back(
        fmt::format("the files hold {} messages of {}, which metadata.yaml does "
                    "not list",
                    messages, topic));
  }
  return sentences;
}

}  // namespace somato
