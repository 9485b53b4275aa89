#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "program/support/program_test.h"
#include "recordings/bags/made_bag.h"

namespace somato {
namespace {

class ImportBag : public ProgramTest {
 protected:
  ImportBag() {
    MadeBag made(path("bag.mcap"));
    const auto x = made.topic("/skin", "a/msg/X", "float64[] x\n");
    const auto event = made.topic("/object", "std_msgs/msg/String", "string data\n");
    made.add(x, 0, numbers_message({0}));
    made.add(event, 50, text_message("cup")).add(x, 100, numbers_message({1}));
    made.add(event, 150, text_message("ball")).add(x, 200, numbers_message({2}));
    made.finish();
  }

  static Words import(const Words& flags) {
    Words arguments{"import", "bag", "bag.mcap", "-o", "out.mcap"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    return arguments;
  }
};

TEST_F(ImportBag, FlagsAndAFileDescribeTheSame) {
  const std::string by_flags =
      output_of(import({"--channels", "touch:N=/skin:x", "--events", "/object", "--labels",
                        "object=/object:data,hand=LEAP"}));
  EXPECT_EQ(by_flags,
            "out.mcap: 2 explorations; labels: object, hand; channels: touch (1 x N)\n"
            "left out: 1 frames outside of the explorations\n");
  write("bag.toml",
        "[import]\nevents = \"/object\"\n[[channel]]\nname = \"touch\"\nunit = \"N\"\n"
        "topic = \"/skin\"\nfields = [\"x\"]\n[[label]]\nname = \"object\"\ntopic = \"/object\"\n"
        "field = \"data\"\n[[label]]\nname = \"hand\"\nvalue = \"LEAP\"\n");
  EXPECT_EQ(output_of(import({"--description", "bag.toml"})), by_flags);
  expect_refused(2, import({"--description", "bag.toml", "--gap", "1"}), {"--gap", "both"});
}

TEST_F(ImportBag, FlagsOfOtherFormatsAreRefused) {
  expect_refused(2, import({"--channels", "touch=/skin:x", "--rate", "100"}), {"--rate"});
  expect_refused(2, {"import", "csv", ".", "-o", "out.mcap", "--events", "/object"}, {"--events"});
}

TEST_F(ImportBag, AnImportThatFailsWritesNoFile) {
  expect_refused(1, import({}), {"there are no explorations", "inspect"});
  expect_refused(2, import({"--channels", "touch=/skin:y"}), {"/skin", "unknown field 'y'"});
  expect_refused(2, import({"--channels", "touch=/skim:x"}), {"/skin"});
  expect_refused(2, import({"--channels", "touch=x"}), {"--channels"});
  expect_refused(2, import({"--channels", "touch[2x2]:N=/skin:x"}), {"brackets", "shape = [4, 4]"});
}

TEST_F(ImportBag, InspectListsTopicsThatAreNoChannels) {
  const std::string topic =
      "topic \"/skin\": a/msg/X, 3 messages, 10 Hz: no channel, because a/msg/X is not a known "
      "type; its numbers: x[*]\n";
  EXPECT_NE(output_of({"inspect", "bag.mcap"}).find(topic), std::string::npos);
  EXPECT_EQ(output_of({"inspect", "."}).find("bag \"bag.mcap\": 1 file\n" + topic), 0U);
  EXPECT_NE(output_of({"inspect", ".", "--json"}).find("\"set_back\""), std::string::npos);
}

}  // namespace
}  // namespace somato
