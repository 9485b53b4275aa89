#include "recordings/bags/mcap_bag.h"

#include <gtest/gtest.h>

#include "base/support/temporary_folder.h"
#include "recordings/bags/made_bag.h"

namespace somato {
namespace {

TEST(McapBag, MessagesComeInTheOrderOfTheFileWithTheirTopics) {
  const TemporaryFolder folder;
  MadeBag made(folder.file("a.mcap"));
  const auto text = made.topic("/text", "std_msgs/msg/String", "string data\n");
  const auto numbers = made.topic("/x", "a/msg/X", "float64[] x\n");
  made.add(numbers, 5, numbers_message({1.0})).add(text, 3, text_message("a")).finish();
  const auto bag = McapBag::open(folder.file("a.mcap")).value();
  const auto first = bag->next().value().value();
  EXPECT_EQ(bag->topics()[first.topic].name, "/x");
  EXPECT_EQ(first.time, 5'000'000);
  EXPECT_EQ(first.data, numbers_message({1.0}));
  const auto second = bag->next().value().value();
  EXPECT_EQ(bag->topics()[second.topic].encoding.definition, "string data\n");
  EXPECT_FALSE(bag->next().value());
}

}  // namespace
}  // namespace somato
