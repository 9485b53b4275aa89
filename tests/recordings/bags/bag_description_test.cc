#include "recordings/bags/bag_description.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/files/toml_file.h"

namespace somato {
namespace {

Result<BagImport> parsed(const std::string& toml) {
  return parse_toml(toml, "bag.toml").and_then(read_bag_import);
}

TEST(BagDescription, FlagsDescribeChannelsAndLabels) {
  const BagChannel channel =
      parse_bag_channels("touch:counts=/xServTopic:sensors[*].taxels[*].z+last").value().front();
  EXPECT_EQ(channel.name, "touch");
  EXPECT_EQ(channel.unit, "counts");
  EXPECT_EQ(channel.topic, "/xServTopic");
  EXPECT_EQ(channel.fields, (std::vector<std::string>{"sensors[*].taxels[*].z", "last"}));
  EXPECT_EQ(parse_bag_channels("a=/b:c").value().front().unit, "");
  EXPECT_EQ(parse_bag_label("object=cup").value().value, "cup");
  EXPECT_EQ(parse_bag_label("object=/events:data").value().topic, "/events");
  EXPECT_EQ(parse_bag_label("object=/events:data").value().field, "data");
  for (const std::string text : {"touch", "=/a:b", "touch=", "touch=/a", "touch=/a:"}) {
    EXPECT_FALSE(parse_bag_channels(text)) << text;
  }
  EXPECT_FALSE(parse_bag_label("object"));
  EXPECT_FALSE(parse_bag_label("object="));
}

TEST(BagDescription, CommasAndPlusSignsInBracketsBelongToNames) {
  const auto channels =
      parse_bag_channels("arm:rad=/j:position[a,b+c]+effort[a,b+c],skin=/s:x[*:4]").value();
  ASSERT_EQ(channels.size(), 2U);
  EXPECT_EQ(channels[0].fields, (std::vector<std::string>{"position[a,b+c]", "effort[a,b+c]"}));
  EXPECT_EQ(channels[1].fields, (std::vector<std::string>{"x[*:4]"}));
}

TEST(BagDescription, TablesDescribeTheSame) {
  const auto description = parsed(
      "[import]\ngap = 2.5\nclock = \"header\"\n[[channel]]\nname = \"touch\"\ntopic = \"/t\"\n"
      "fields = [\"a\", \"b[*]\"]\nfactor = 0.5\n[[label]]\nname = \"object\"\nvalue = \"cup\"\n");
  ASSERT_TRUE(description) << to_string(description.error());
  EXPECT_EQ(description->trials.gap, 2.5);
  EXPECT_EQ(description->trials.clock, BagClock::kHeader);
  EXPECT_EQ(description->channels[0].fields.size(), 2U);
  EXPECT_EQ(description->labels[0].value, "cup");
}

TEST(BagDescription, ContradictionsAreRefused) {
  EXPECT_FALSE(parsed("[import]\ngap = 1.0\nevents = \"/e\"\n"));
  EXPECT_FALSE(parsed("[[channel]]\nname = \"a\"\ntopic = \"/t\"\n"));
  EXPECT_FALSE(parsed("[[label]]\nname = \"a\"\n"));
  EXPECT_FALSE(parsed("[[label]]\nname = \"a\"\nvalue = \"b\"\ntopic = \"/t\"\nfield = \"x\"\n"));
  EXPECT_FALSE(parsed("[[label]]\nname = \"a\"\ntopic = \"/t\"\n"));
  EXPECT_FALSE(parsed("[import]\nrate = 3\n"));
  EXPECT_FALSE(parsed("[chanel]\n"));
}

}  // namespace
}  // namespace somato
