#include "systems/exchange/system_map.h"

#include <gtest/gtest.h>

#include "systems/support/systems.h"

namespace somato {
namespace {

using testing::build;
using testing::hand_recording;
using testing::trained;

const std::string kTwoMaps =
    "[system]\nname = \"two\"\n"
    "[module.joints]\ntype = \"channel\"\nchannel = \"joints\"\n"
    "[module.last]\ntype = \"last\"\ninput = \"joints\"\n"
    "[module.first_map]\ntype = \"som\"\ninput = \"last\"\nrows = 1\ncolumns = 2\niterations = "
    "20\n";
const std::string kSecondMap =
    "[module.second_map]\ntype = \"som\"\ninput = \"first_map\"\nrows = 1\ncolumns = 3\n"
    "iterations = 20\n";

SystemModel model_of_system(const std::string& text) {
  const Recording recording = hand_recording(4, 8);
  return {trained(build(text, recording), recording, 3), {}};
}

TEST(SystemMap, IsTheOnlyOneOrTheNamedOne) {
  const SystemModel one = model_of_system(kTwoMaps);
  const SystemModel two = model_of_system(kTwoMaps + kSecondMap);
  EXPECT_EQ(map_of_system(one, "", "f")->som.neurons(), 2);
  EXPECT_EQ(map_of_system(two, "second_map", "f")->som.neurons(), 3);
  const auto several = map_of_system(two, "", "f");
  ASSERT_FALSE(several);
  EXPECT_NE(to_string(several.error()).find("first_map, second_map"), std::string::npos);
  EXPECT_FALSE(map_of_system(one, "joints", "f"));
  EXPECT_FALSE(map_of_system(one, "nothing", "f"));
}

TEST(SystemMap, HasTheLabelsOfTheAnswerAndTheNamesOfItsInputs) {
  SystemModel two = model_of_system(kTwoMaps + kSecondMap);
  two.answer =
      SystemAnswer{"first_map", "object", {"ball", "cube"}, NeuronLabels({std::nullopt, 1})};
  const auto first = map_of_system(two, "first_map", "f");
  EXPECT_EQ(first->classes, two.answer->classes);
  EXPECT_EQ(first->labels, two.answer->labels);
  EXPECT_EQ(first->features.size(), first->som.input_size());
  EXPECT_TRUE(map_of_system(two, "second_map", "f")->classes.empty());
}

TEST(SystemMap, IsRefusedForASystemWithoutMaps) {
  const SystemModel none = model_of_system(
      "[system]\nname = \"none\"\n[module.joints]\ntype = \"channel\"\nchannel = \"joints\"\n");
  EXPECT_FALSE(map_of_system(none, "", "f"));
}

}  // namespace
}  // namespace somato
