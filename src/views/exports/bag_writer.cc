#include "views/exports/bag_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace somato {
namespace {

constexpr const char* kBagFile = "bag_0.mcap";
constexpr std::size_t kChunkBytes = std::size_t{1} << 20;

}  // namespace

Result<std::unique_ptr<BagWriter>> BagWriter::begin(const std::string& path) {
  SOMATO_TRY(NewFolder folder, NewFolder::begin(path));
  SOMATO_TRY(FileWriter file, FileWriter::begin(folder.file(kBagFile)));
  auto bag = std::make_unique<BagWriter>(std::move(folder), std::move(file));
  SOMATO_TRY_VOID(bag->writer_.begin({"ros2", "somato"}));
  return bag;
}

BagWriter::BagWriter(NewFolder folder, FileWriter file)
    : folder_(std::move(folder)),
      file_(std::move(file)),
      writer_([this](std::string_view bytes) { return file_.write(bytes); }, Compression::kZstd,
              kChunkBytes) {}

Result<std::size_t> BagWriter::open_topic(const std::string& name, const McapSchema& schema,
                                          McapChannel channel) {
  channel.topic = name;
  channel.message_encoding = "cdr";
  channel.metadata["offered_qos_profiles"] = "";
  SOMATO_TRY(const std::uint16_t id, writer_.channel(&schema, std::move(channel)));
  topics_.push_back({name, schema.name, id});
  return topics_.size() - 1;
}

Result<void> BagWriter::write(std::size_t topic, std::int64_t time, std::string_view message) {
  first_time_ = std::min(first_time_.value_or(time), time);
  latest_time_ = std::max(latest_time_, time);
  const auto log_time = static_cast<std::uint64_t>(time);
  Topic& to = topics_[topic];
  return writer_.add({to.id, to.messages++, log_time, log_time, message});
}

std::string BagWriter::metadata() const {
  std::uint64_t messages = 0;
  for (const Topic& topic : topics_) messages += topic.messages;
  const std::int64_t start = first_time_.value_or(0);
  const std::int64_t duration = latest_time_ - start;
  std::string text = fmt::format(
      "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: mcap\n  duration:\n"
      "    nanoseconds: {}\n  starting_time:\n    nanoseconds_since_epoch: {}\n"
      "  message_count: {}\n  topics_with_message_count:\n",
      duration, start, messages);
  for (const Topic& topic : topics_) {
    text += fmt::format(
        "    - topic_metadata:\n        name: {}\n        type: {}\n"
        "        serialization_format: cdr\n        offered_qos_profiles: \"\"\n"
        "      message_count: {}\n",
        topic.name, topic.type, topic.messages);
  }
  return text + fmt::format(
                    "  compression_format: \"\"\n  compression_mode: \"\"\n"
                    "  relative_file_paths:\n    - {0}\n  files:\n    - path: {0}\n"
                    "      starting_time:\n        nanoseconds_since_epoch: {1}\n"
                    "      duration:\n        nanoseconds: {2}\n      message_count: {3}\n",
                    kBagFile, start, duration, messages);
}

Result<void> BagWriter::save(const std::string& name, const std::string& text) const {
  SOMATO_TRY(FileWriter file, FileWriter::begin(folder_.file(name)));
  return file.write(text).and_then([&] { return file.commit(); });
}

Result<void> BagWriter::finish() {
  SOMATO_TRY_VOID(writer_.finish());
  SOMATO_TRY_VOID(file_.commit());
  SOMATO_TRY_VOID(save("metadata.yaml", metadata()));
  return folder_.commit();
}

}  // namespace somato
