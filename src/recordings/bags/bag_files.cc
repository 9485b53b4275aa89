#include "recordings/bags/bag_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <set>
#include <utility>

#include "base/files/whole_file.h"
#include "base/text/text.h"
#include "recordings/bags/mcap_bag.h"
#include "recordings/bags/sqlite_bag.h"
#include "recordings/file/ros_messages.h"
#include "recordings/ros/definition.h"
#include "recordings/tables/files_below.h"
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMetadata = "metadata.yaml";
constexpr std::string_view kSqlite = "SQLite format 3";
constexpr std::string_view kRos1 = "#ROSBAG";
constexpr std::string_view kZstd = "\x28\xB5\x2F\xFD";
constexpr std::size_t kLongestMetadata = std::size_t{16} << 20;

std::string beginning_of(const std::string& path) {
  std::array<char, 16> bytes{};
  std::ifstream file(path, std::ios::binary);
  file.read(bytes.data(), bytes.size());
  return {bytes.data(), static_cast<std::size_t>(file.gcount())};
}

bool is_bag_file(const std::string& name) {
  return name.ends_with(".mcap") || name.ends_with(".db3") || name.ends_with(".bag") ||
         name.ends_with(".mcap.zstd") || name.ends_with(".db3.zstd");
}

std::string_view unquoted(std::string_view text) {
  const bool is_quoted = text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
                         text.back() == text.front();
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

// The needed keys of metadata.yaml; rosbag2 writes one key or item on each line.
struct BagMetadata {
  std::vector<std::string> files;
  std::string compression;
};

BagMetadata parse_metadata(std::string_view text) {
  BagMetadata metadata;
  bool is_list_of_files = false;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (is_list_of_files && line.starts_with("- ")) {
      metadata.files.emplace_back(unquoted(trimmed(line.substr(2))));
      continue;
    }
    is_list_of_files = line == "relative_file_paths:";
    constexpr std::string_view kCompression = "compression_mode:";
    if (line.starts_with(kCompression)) {
      metadata.compression = unquoted(trimmed(line.substr(kCompression.size())));
    }
  }
  return metadata;
}

Result<BagLocation> bag_of_folder(const fs::path& folder, std::string name) {
  const std::string place = (folder / kMetadata).string();
  SOMATO_TRY(const std::string text, read_whole(place, kLongestMetadata));
  const BagMetadata metadata = parse_metadata(text);
  if (metadata.files.empty()) {
    return fail(ErrorKind::kData, "it lists no files in relative_file_paths", place,
                "write it again with `ros2 bag reindex`");
  }
  if (metadata.compression == "MESSAGE" || metadata.compression == "message") {
    return fail(ErrorKind::kData, "the messages of the bag are compressed one by one", place,
                "write it without compression with `ros2 bag convert`");
  }
  BagLocation bag{folder.string(), std::move(name), {}};
  for (const std::string& file : metadata.files) {
    const fs::path path = folder / fs::path(file).filename();
    std::error_code failure;
    if (!fs::is_regular_file(path, failure)) {
      return fail(ErrorKind::kData, fmt::format("the bag's file {} is missing", shown(file)), place,
                  "copy all files of the bag");
    }
    bag.files.push_back(path.string());
  }
  return bag;
}

Result<std::unique_ptr<BagSource>> open_bag_file(const std::string& path) {
  const std::string beginning = beginning_of(path);
  if (is_mcap(beginning)) return McapBag::open(path);
  if (beginning.starts_with(kSqlite)) return SqliteBag::open(path);
  if (beginning.starts_with(kRos1)) {
    return fail(ErrorKind::kData, "it is a bag of ROS 1", path,
                "convert it with `rosbags-convert --src FILE.bag --dst FOLDER` of the Python "
                "package rosbags");
  }
  if (beginning.starts_with(kZstd)) {
    return fail(ErrorKind::kData, "the file is compressed as a whole", path,
                "decompress it with `zstd -d`");
  }
  return fail(ErrorKind::kData, "it is neither MCAP nor a database of rosbag2", path,
              "use a file that `ros2 bag record` or a program for MCAP has written");
}

// "package/Name" for "package/msg/Name.msg", or nothing.
std::string type_of_path(const fs::path& path) {
  std::vector<std::string> parts;
  for (const fs::path& part : path.parent_path()) parts.push_back(part.string());
  if (!parts.empty() && parts.back() == "msg") parts.pop_back();
  return parts.empty() ? std::string() : parts.back() + "/" + path.stem().string();
}

Result<RosDefinitions> read_definitions(const std::string& folder) {
  RosDefinitions definitions;
  if (folder.empty()) return definitions;
  SOMATO_TRY(const std::vector<std::string> files, files_below(folder, ".msg"));
  const fs::path absolute = fs::weakly_canonical(folder);
  for (const std::string& file : files) {
    const std::string path = (fs::path(folder) / file).string();
    SOMATO_TRY(const std::string text, read_whole(path, kLongestMetadata));
    definitions.add(type_of_path(absolute / file), text, path);
  }
  if (!files.empty()) return definitions;
  return fail(ErrorKind::kUsage, "there are no .msg files", folder,
              "use a folder such as package/msg/Name.msg");
}

// The files of a bag, one after the other.
class BagOfFiles : public BagSource {
 public:
  BagOfFiles(std::vector<std::string> files, RosDefinitions definitions)
      : files_(std::move(files)), definitions_(std::move(definitions)) {}

  Result<void> open_next() {
    SOMATO_TRY(file_, open_bag_file(files_[next_file_]));
    ++next_file_;
    topic_in_bag_.clear();
    return add_topics();
  }

  Result<std::optional<BagMessage>> next() override {
    for (;;) {
      SOMATO_TRY(std::optional<BagMessage> message, file_->next());
      if (message) {
        SOMATO_TRY_VOID(add_topics());
        message->topic = topic_in_bag_[message->topic];
        return message;
      }
      if (next_file_ == files_.size()) return message;
      SOMATO_TRY_VOID(open_next());
    }
  }

  const std::vector<BagTopic>& topics() const override { return topics_; }

 private:
  Result<void> add_topics() {
    for (std::size_t i = topic_in_bag_.size(); i < file_->topics().size(); ++i) {
      const BagTopic& topic = file_->topics()[i];
      const auto same = std::find_if(topics_.begin(), topics_.end(),
                                     [&](const BagTopic& other) { return other.is_same(topic); });
      topic_in_bag_.push_back(static_cast<std::size_t>(same - topics_.begin()));
      if (same != topics_.end()) continue;
      topics_.push_back(topic);
      SOMATO_TRY_VOID(complete(topics_.back().encoding));
    }
    return {};
  }

  Result<void> complete(TopicEncoding& encoding) const {
    if (encoding.definition_encoding == "ros2msg" && !encoding.definition.empty()) return {};
    std::optional<std::string> text = standard_definition(encoding.type);
    if (definitions_.has(encoding.type)) {
      SOMATO_TRY(text, definitions_.all_of(encoding.type));
    }
    if (!text) return {};
    encoding.definition_encoding = "ros2msg";
    encoding.definition = std::move(*text);
    return {};
  }

  std::vector<std::string> files_;
  RosDefinitions definitions_;
  std::size_t next_file_ = 0;
  std::unique_ptr<BagSource> file_;
  std::vector<std::size_t> topic_in_bag_;
  std::vector<BagTopic> topics_;
};

}  // namespace

Result<std::vector<BagLocation>> find_bags(const fs::path& path) {
  std::error_code failure;
  std::vector<BagLocation> bags;
  if (fs::is_regular_file(path, failure)) {
    bags.push_back({path.string(), path.filename().string(), {path.string()}});
    return bags;
  }
  SOMATO_TRY(const std::vector<std::string> files, files_below(path, ""));
  std::set<fs::path> folders;
  for (const std::string& file : files) {
    const fs::path relative(file);
    if (relative.filename() != kMetadata) continue;
    folders.insert(relative.parent_path());
    const fs::path folder = path / relative.parent_path();
    const std::string name = relative.has_parent_path()
                                 ? relative.parent_path().generic_string()
                                 : fs::weakly_canonical(path).filename().string();
    SOMATO_TRY(BagLocation bag, bag_of_folder(folder, name));
    bags.push_back(std::move(bag));
  }
  for (const std::string& file : files) {
    if (!is_bag_file(file) || folders.contains(fs::path(file).parent_path())) continue;
    bags.push_back({(path / file).string(), file, {(path / file).string()}});
  }
  std::sort(bags.begin(), bags.end(), [](const BagLocation& a, const BagLocation& b) {
    return naturally_before(a.name, b.name);
  });
  if (!bags.empty()) return bags;
  return fail(ErrorKind::kData, "there are no bags (*.mcap, *.db3, folders with metadata.yaml)",
              path.string(), "use a bag, or a folder that contains bags");
}

Result<std::unique_ptr<BagSource>> open_bag(const BagLocation& bag,
                                            const std::string& definitions) {
  SOMATO_TRY(RosDefinitions known, read_definitions(definitions));
  auto source = std::make_unique<BagOfFiles>(bag.files, std::move(known));
  SOMATO_TRY_VOID(source->open_next());
  return source;
}

}  // namespace somato
