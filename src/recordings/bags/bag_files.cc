#include "recordings/bags/bag_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "base/files/whole_file.h"
#include "base/text/text.h"
#include "recordings/bags/mcap_bag.h"
#include "recordings/bags/sorted_bag.h"
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
constexpr std::string_view kZstdMagic = "\x28\xB5\x2F\xFD";
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

Result<std::unique_ptr<BagSource>> open_bag_file(const std::string& path) {
  const std::string beginning = beginning_of(path);
  if (is_mcap(beginning)) return McapBag::open(path);
  if (beginning.starts_with(kSqlite)) return SqliteBag::open(path);
  if (beginning.starts_with(kRos1)) {
    return fail(ErrorKind::kData, "it is a bag of ROS 1", path,
                "convert it with `rosbags-convert --src FILE.bag --dst FOLDER` of the Python "
                "package rosbags");
  }
  if (beginning.starts_with(kZstdMagic)) {
    return fail(ErrorKind::kData, "the file is compressed as a whole", path,
                "decompress it with `zstd -d`");
  }
  return fail(ErrorKind::kData, "it is neither MCAP nor a database of rosbag2", path,
              "use a file that `ros2 bag record` or a program for MCAP has written");
}

// The time of the first message of a file, or nothing if it has none.
Result<std::optional<std::int64_t>> first_time_of(const std::string& path) {
  SOMATO_TRY(const std::unique_ptr<BagSource> file, open_bag_file(path));
  SOMATO_TRY(const std::optional<BagMessage> message, file->next());
  return message ? std::optional(message->time) : std::nullopt;
}

// Files without a list of their order are in that of their first messages.
Result<void> sort_by_time(std::vector<std::string>& files) {
  std::vector<std::pair<std::int64_t, std::size_t>> order;
  order.reserve(files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    SOMATO_TRY(const auto time, first_time_of(files[i]));
    order.emplace_back(time.value_or(std::numeric_limits<std::int64_t>::max()), i);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::string> sorted;
  sorted.reserve(files.size());
  for (const auto& [time, index] : order) sorted.push_back(std::move(files[index]));
  files = std::move(sorted);
  return {};
}

// The bag of a folder whose description lists no files, or is missing.
Result<BagLocation> bag_of_unlisted_files(BagLocation bag, std::vector<std::string> files,
                                          const std::string& reason) {
  bag.files = std::move(files);
  SOMATO_TRY_VOID(sort_by_time(bag.files));
  bag.remarks.push_back(
      fmt::format("{}, so that the {} files of the folder are read in the order of their times",
                  reason, bag.files.size()));
  return bag;
}

// `files` are the bag files in the folder, with their paths.
Result<BagLocation> bag_of_folder(const fs::path& folder, std::string name,
                                  std::vector<std::string> files) {
  const std::string place = (folder / kMetadata).string();
  SOMATO_TRY(const std::string text, read_whole(place, kLongestMetadata));
  BagLocation bag{folder.string(), std::move(name), {}, parse_bag_metadata(text), {}};
  if (bag.metadata.files.empty()) {
    if (!files.empty()) {
      return bag_of_unlisted_files(std::move(bag), std::move(files),
                                   "metadata.yaml lists no files");
    }
    return fail(ErrorKind::kData, "it lists no files in relative_file_paths", place,
                "write it again with `ros2 bag reindex`");
  }
  if (bag.metadata.compression == "MESSAGE" || bag.metadata.compression == "message") {
    return fail(ErrorKind::kData, "the messages of the bag are compressed one by one", place,
                "write it without compression with `ros2 bag convert`");
  }
  for (const std::string& file : bag.metadata.files) {
    const fs::path path = folder / fs::path(file).filename();
    std::error_code failure;
    if (!fs::is_regular_file(path, failure)) {
      return fail(ErrorKind::kData, fmt::format("the bag's file {} is missing", shown(file)), place,
                  "copy all files of the bag");
    }
    bag.files.push_back(path.string());
  }
  for (const std::string& file : files) {
    if (std::find(bag.files.begin(), bag.files.end(), file) != bag.files.end()) continue;
    bag.remarks.push_back(
        fmt::format("metadata.yaml does not list {}, which is not read; write it again with `ros2 "
                    "bag reindex` if the file belongs to the bag",
                    shown(fs::path(file).filename().string())));
  }
  return bag;
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
        message->file = next_file_ - 1;
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
    if (encoding.message_encoding != "cdr") return {};
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

// The files that belong to bags in a folder.
struct FolderOfBags {
  bool has_metadata = false;
  std::vector<std::string> files;  // Below the folder that is searched.
};

// Whether rosbag2 has split a bag into these files: FOLDER_0.mcap, FOLDER_1.mcap and so on.
bool are_parts_of_one(const std::string& folder, const std::vector<std::string>& files) {
  return files.size() > 1 && std::all_of(files.begin(), files.end(), [&](const std::string& file) {
           std::string name = fs::path(file).filename().string();
           name = name.substr(0, name.find('.', folder.size()));
           return name.starts_with(folder + "_") && name.size() > folder.size() + 1 &&
                  name.find_first_not_of("0123456789", folder.size() + 1) == std::string::npos;
         });
}

Result<void> add_bags_of_folder(const fs::path& searched, const fs::path& relative,
                                const FolderOfBags& folder, std::vector<BagLocation>& bags) {
  const fs::path path = relative.empty() ? searched : searched / relative;
  const std::string own_name = fs::weakly_canonical(path).filename().string();
  const std::string name = relative.empty() ? own_name : relative.generic_string();
  std::vector<std::string> paths;
  paths.reserve(folder.files.size());
  for (const std::string& file : folder.files) paths.push_back((searched / file).string());
  if (folder.has_metadata) {
    SOMATO_TRY(BagLocation bag, bag_of_folder(path, name, std::move(paths)));
    bags.push_back(std::move(bag));
  } else if (are_parts_of_one(own_name, folder.files)) {
    SOMATO_TRY(BagLocation bag,
               bag_of_unlisted_files({path.string(), name, {}, {}, {}}, std::move(paths),
                                     "the bag has no metadata.yaml"));
    bags.push_back(std::move(bag));
  } else {
    for (std::size_t i = 0; i < paths.size(); ++i) {
      bags.push_back({paths[i], folder.files[i], {paths[i]}, {}, {}});
    }
  }
  return {};
}

}  // namespace

Result<std::vector<BagLocation>> find_bags(const fs::path& path) {
  std::error_code failure;
  std::vector<BagLocation> bags;
  if (fs::is_regular_file(path, failure)) {
    bags.push_back({path.string(), path.filename().string(), {path.string()}, {}, {}});
    return bags;
  }
  SOMATO_TRY(const std::vector<std::string> files, files_below(path, ""));
  std::map<fs::path, FolderOfBags> folders;
  for (const std::string& file : files) {
    FolderOfBags& folder = folders[fs::path(file).parent_path()];
    if (fs::path(file).filename() == kMetadata) folder.has_metadata = true;
    if (is_bag_file(file)) folder.files.push_back(file);
  }
  for (const auto& [relative, folder] : folders) {
    SOMATO_TRY_VOID(add_bags_of_folder(path, relative, folder, bags));
  }
  std::sort(bags.begin(), bags.end(), [](const BagLocation& a, const BagLocation& b) {
    return naturally_before(a.name, b.name);
  });
  if (!bags.empty()) return bags;
  return fail(ErrorKind::kData, "there are no bags (*.mcap, *.db3, folders with metadata.yaml)",
              path.string(), "use a bag, or a folder that contains bags");
}

Result<std::unique_ptr<SortedBag>> open_bag(const BagLocation& bag,
                                            const std::string& definitions) {
  SOMATO_TRY(RosDefinitions known, read_definitions(definitions));
  auto source = std::make_unique<BagOfFiles>(bag.files, std::move(known));
  SOMATO_TRY_VOID(source->open_next());
  return std::make_unique<SortedBag>(std::move(source));
}

std::vector<std::string> remarks_on(const BagLocation& bag, const SortedBag& read) {
  BagCounts held;
  for (std::size_t i = 0; i < read.topics().size(); ++i) {
    held.topics[read.topics()[i].name] += read.messages_of_topic(i);
  }
  for (std::size_t i = 0; i < bag.files.size(); ++i) {
    held.files[fs::path(bag.files[i]).filename().string()] += read.messages_of_file(i);
  }
  std::vector<std::string> remarks = bag.remarks;
  for (std::string& sentence : differences(bag.metadata, held)) {
    remarks.push_back(std::move(sentence));
  }
  return remarks;
}

}  // namespace somato
