#include "recordings/bags/bag_metadata.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>

#include "base/text/number_of_text.h"
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

// Reads the lines, of which some belong to a list: it ends at the first line that is indented less.
class MetadataLines {
 public:
  void take(std::string_view line) {
    std::size_t indent = std::min(line.find_first_not_of(' '), line.size());
    line = trimmed(line);
    if (line.empty() || line.starts_with('#')) return;
    const bool is_item = line.starts_with("- ");
    if (is_item) {
      line = trimmed(line.substr(2));
      indent += 2;
      if (!list_indent_) list_indent_ = indent;
    }
    if (list_indent_ && indent < *list_indent_) begin_list(List::kNone);
    if (is_item && list_ == List::kPaths) {
      metadata.files.emplace_back(unquoted(line));
    } else if (!take_count(line)) {
      take_key(line);
    }
  }

  BagMetadata metadata;

 private:
  enum class List { kNone, kPaths, kTopics, kFiles };

  bool take_count(std::string_view line) {
    if (list_ == List::kTopics) return take_count(line, "name", metadata.messages);
    if (list_ == List::kFiles) return take_count(line, "path", metadata.messages_of_files);
    return false;
  }

  // The name of a topic or file and the number of its messages follow each other in either order.
  bool take_count(std::string_view line, std::string_view key,
                  std::map<std::string, std::uint64_t>& counts) {
    const auto counted = value_of(line, key);
    const auto count = value_of(line, "message_count");
    if (counted) counted_ = *counted;
    if (count) messages_ = number_of_text<std::uint64_t>(*count);
    if (counted_ && messages_) {
      counts[*counted_] = *messages_;
      counted_.reset();
      messages_.reset();
    }
    return counted || count || line == "topic_metadata:";
  }

  void take_key(std::string_view line) {
    if (const auto compression = value_of(line, "compression_mode")) {
      metadata.compression = *compression;
    }
    if (const auto count = value_of(line, "message_count")) {
      metadata.all_messages = number_of_text<std::uint64_t>(*count);
    }
    if (line == "relative_file_paths:") begin_list(List::kPaths);
    if (line == "topics_with_message_count:") begin_list(List::kTopics);
    if (line == "files:") begin_list(List::kFiles);
  }

  void begin_list(List list) {
    list_ = list;
    list_indent_.reset();
    counted_.reset();
    messages_.reset();
  }

  List list_ = List::kNone;
  std::optional<std::size_t> list_indent_;  // of what its items hold; none before the first item
  std::optional<std::string> counted_;
  std::optional<std::uint64_t> messages_;
};

std::uint64_t count_of(const std::map<std::string, std::uint64_t>& counts,
                       const std::string& counted) {
  const auto found = counts.find(counted);
  return found == counts.end() ? 0 : found->second;
}

void add_differences_of_topics(const BagMetadata& listed, const BagCounts& held,
                               std::vector<std::string>& sentences) {
  if (listed.messages.empty()) return;
  for (const auto& [topic, messages] : listed.messages) {
    const std::uint64_t count = count_of(held.topics, topic);
    if (count == messages) continue;
    sentences.push_back(fmt::format("metadata.yaml lists {} messages of {}, the files hold {}",
                                    messages, topic, count));
  }
  for (const auto& [topic, messages] : held.topics) {
    if (listed.messages.contains(topic) || messages == 0) continue;
    sentences.push_back(
        fmt::format("the files hold {} messages of {}, which metadata.yaml does "
                    "not list",
                    messages, topic));
  }
}

// The files that are listed and missing, or found and not listed, are remarks of the bag.
void add_differences_of_files(const BagMetadata& listed, const BagCounts& held,
                              std::vector<std::string>& sentences) {
  for (const auto& [path, messages] : listed.messages_of_files) {
    const std::string name = std::filesystem::path(path).filename().string();
    if (!held.files.contains(name) || held.files.at(name) == messages) continue;
    sentences.push_back(fmt::format("metadata.yaml lists {} messages in {}, which holds {}",
                                    messages, shown(name), held.files.at(name)));
  }
}

}  // namespace

BagMetadata parse_bag_metadata(std::string_view text) {
  MetadataLines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.take(line);
  }
  return std::move(lines.metadata);
}

std::vector<std::string> differences(const BagMetadata& listed, const BagCounts& held) {
  std::vector<std::string> sentences;
  add_differences_of_topics(listed, held, sentences);
  add_differences_of_files(listed, held, sentences);
  std::uint64_t all = 0;
  for (const auto& [topic, messages] : held.topics) all += messages;
  if (sentences.empty() && listed.all_messages.value_or(all) != all) {
    sentences.push_back(fmt::format("metadata.yaml lists {} messages, the files hold {}",
                                    *listed.all_messages, all));
  }
  return sentences;
}

}  // namespace somato
