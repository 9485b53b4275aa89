#include "recordings/bags/bag_metadata.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace somato {
namespace {

// The lines of rosbag2, shortened.
const std::string kText =
    "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: mcap\n"
    "  message_count: 70\n  topics_with_message_count:\n    - topic_metadata:\n"
    "        name: /joint_states\n        type: sensor_msgs/msg/JointState\n"
    "      message_count: 40\n    - topic_metadata:\n        name: '/touch'\n"
    "        type: a/msg/B\n      message_count: 30\n  compression_format: \"\"\n"
    "  compression_mode: FILE\n  relative_file_paths:\n    - b_0.mcap\n    - \"b_1.mcap\"\n"
    "  files:\n    - path: b_0.mcap\n      message_count: 50\n";

TEST(BagMetadata, FilesAndNumbersOfMessagesAreRead) {
  for (const std::string& end : {std::string("\n"), std::string("\r\n")}) {
    std::string text;
    for (const char c : kText) text += c == '\n' ? end : std::string(1, c);
    const BagMetadata metadata = parse_bag_metadata(text);
    EXPECT_EQ(metadata.files, (std::vector<std::string>{"b_0.mcap", "b_1.mcap"}));
    EXPECT_EQ(metadata.compression, "FILE");
    EXPECT_EQ(metadata.messages,
              (std::map<std::string, std::uint64_t>{{"/joint_states", 40}, {"/touch", 30}}));
    EXPECT_EQ(metadata.messages_of_files, (std::map<std::string, std::uint64_t>{{"b_0.mcap", 50}}));
    EXPECT_EQ(metadata.all_messages, 70U);
  }
}

// Programs that sort the keys of YAML write the number of messages before the name.
TEST(BagMetadata, EmptyLinesAndCommentsChangeNothing) {
  for (const std::string between : {"\n", "# the second half\n", "  # half\n", "   \n"}) {
    std::string text;
    for (const char c : kText) text += c == '\n' ? "\n" + between : std::string(1, c);
    const BagMetadata metadata = parse_bag_metadata(text);
    EXPECT_EQ(metadata.files, (std::vector<std::string>{"b_0.mcap", "b_1.mcap"})) << between;
    EXPECT_EQ(metadata.messages,
              (std::map<std::string, std::uint64_t>{{"/joint_states", 40}, {"/touch", 30}}));
    EXPECT_EQ(metadata.messages_of_files, (std::map<std::string, std::uint64_t>{{"b_0.mcap", 50}}));
  }
}

TEST(BagMetadata, KeysHaveAnyOrder) {
  const BagMetadata metadata = parse_bag_metadata(
      "rosbag2_bagfile_information:\n  files:\n  - message_count: 20\n    path: b_0.mcap\n"
      "  message_count: 70\n  relative_file_paths:\n  - b_0.mcap\n  topics_with_message_count:\n"
      "  - message_count: 40\n    topic_metadata:\n      name: /joint_states\n"
      "      offered_qos_profiles:\n      - depth: 10\n        history: keep_last\n"
      "  - message_count: 30\n    topic_metadata:\n      name: /touch\n  version: 9\n");
  EXPECT_EQ(metadata.files, (std::vector<std::string>{"b_0.mcap"}));
  EXPECT_EQ(metadata.messages,
            (std::map<std::string, std::uint64_t>{{"/joint_states", 40}, {"/touch", 30}}));
  EXPECT_EQ(metadata.messages_of_files, (std::map<std::string, std::uint64_t>{{"b_0.mcap", 20}}));
  EXPECT_EQ(metadata.all_messages, 70U);
}

std::vector<std::string> differences_from(const BagMetadata& listed,
                                          std::map<std::string, std::uint64_t> topics,
                                          std::map<std::string, std::uint64_t> files = {}) {
  return differences(listed, {std::move(topics), std::move(files)});
}

TEST(BagMetadata, DifferencesOfFilesAndOfTheSumAreNamed) {
  using Sentences = std::vector<std::string>;
  BagMetadata listed;
  listed.messages_of_files = {{"bag/b_0.mcap", 50}, {"bag/b_1.mcap", 20}};
  listed.all_messages = 70;
  EXPECT_EQ(differences_from(listed, {{"/touch", 70}}, {{"b_0.mcap", 50}, {"b_1.mcap", 20}}),
            Sentences());
  EXPECT_EQ(differences_from(listed, {{"/touch", 70}}, {{"b_0.mcap", 51}, {"b_1.mcap", 19}}),
            (Sentences{"metadata.yaml lists 50 messages in 'b_0.mcap', which holds 51",
                       "metadata.yaml lists 20 messages in 'b_1.mcap', which holds 19"}));
  listed.messages_of_files.clear();
  EXPECT_EQ(differences_from(listed, {{"/touch", 69}}),
            Sentences{"metadata.yaml lists 70 messages, the files hold 69"});
}

TEST(BagMetadata, DifferencesOfTopicsAreNamed) {
  const BagMetadata metadata = parse_bag_metadata(kText);
  EXPECT_TRUE(differences_from(metadata, {{"/joint_states", 40}, {"/touch", 30}}).empty());
  EXPECT_EQ(differences_from(metadata, {{"/joint_states", 39}, {"/touch", 30}, {"/new", 2}}),
            (std::vector<std::string>{
                "metadata.yaml lists 40 messages of /joint_states, the files hold 39",
                "the files hold 2 messages of /new, which metadata.yaml does not list"}));
  EXPECT_EQ(
      differences_from(metadata, {{"/joint_states", 40}}),
      (std::vector<std::string>{"metadata.yaml lists 30 messages of /touch, the files hold 0"}));
  EXPECT_TRUE(differences_from({}, {{"/touch", 30}}).empty());
}

TEST(BagMetadata, OtherTextListsNothing) {
  for (const char* text : {"", "\n\n", "- - -", "files:\n  - a", "message_count: 3\nname: x\n"}) {
    EXPECT_TRUE(parse_bag_metadata(text).files.empty()) << text;
    EXPECT_TRUE(parse_bag_metadata(text).messages.empty()) << text;
  }
}

}  // namespace
}  // namespace somato
