#include <algorithm>

#include "program/support/program_test.h"
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

class SenseCommand : public ProgramTest {
 protected:
  void explore(const std::string& name, const Words& more) const {
    Words words{"explore", "--body", "hardness", "--explorations", "2", "-o", name};
    words.insert(words.end(), more.begin(), more.end());
    output_of(words);
  }

  Recording recorded(const std::string& name) const {
    const auto recording = read_recording(path(name));
    EXPECT_TRUE(recording);
    EXPECT_TRUE(validate(*recording));
    return *recording;
  }

  std::string labels_in(const std::string& name) const {
    std::string text;
    for (const Exploration& exploration : recorded(name).explorations) {
      text += *find_label(exploration, "material") + *find_label(exploration, "trial") + " ";
    }
    return text;
  }
};

TEST_F(SenseCommand, GivesTheReadingsOfTheExplorationThroughAFile) {
  explore("plain.mcap", {"--seed", "4"});
  explore("true.mcap", {"--seed", "4", "--true-values", "true"});
  EXPECT_EQ(output_of({"sense", "true.mcap", "-o", "played.mcap"}),
            "played.mcap: 16 explorations\n");
  EXPECT_EQ(recorded("played.mcap"), recorded("plain.mcap"));
  output_of({"sense", "true.mcap", "--seed", "4", "--true-values", "true", "-o", "played.mcap"});
  EXPECT_EQ(recorded("played.mcap"), recorded("true.mcap"));
}

TEST_F(SenseCommand, SettingsAndFlagsOfSensorsCount) {
  explore("true.mcap", {"--true-values", "true"});
  write("sensors.toml",
        "[hardness_probe]\nforce = 2.0\npotentiometer_bits = 8\npotentiometer_noise = 0.0\n");
  output_of({"sense", "true.mcap", "--settings", "sensors.toml", "-o", "file.mcap"});
  output_of({"sense", "true.mcap", "--potentiometer-bits", "8", "--potentiometer-noise", "0", "-o",
             "flags.mcap"});
  EXPECT_EQ(recorded("file.mcap"), recorded("flags.mcap"));
  for (const Exploration& exploration : recorded("file.mcap").explorations) {
    EXPECT_LT(exploration.channels.front().frames(0, 0), 256.0F);
  }
}

TEST_F(SenseCommand, DrawsATableOfObjectsFromAStock) {
  explore("true.mcap", {"--true-values", "true"});
  output_of({"sense", "true.mcap", "--objects", "wood,felt", "--explorations", "1", "--seed", "9",
             "-o", "two.mcap"});
  EXPECT_EQ(labels_in("two.mcap"), "wood1 felt1 ");
  output_of({"sense", "true.mcap", "--seed", "9", "-o", "all.mcap"});
  const Recording all = recorded("all.mcap");
  const Exploration wood = recorded("two.mcap").explorations[0];
  EXPECT_NE(std::find(all.explorations.begin(), all.explorations.end(), wood),
            all.explorations.end());
}

TEST_F(SenseCommand, RefusesWhatItCannotPlay) {
  explore("plain.mcap", {});
  explore("true.mcap", {"--true-values", "true"});
  expect_refused(
      2, {{{"sense", "plain.mcap", "-o", "out.mcap"},
           {"no true values", "explore again with true_values = true"}},
          {{"sense", "true.mcap", "--joint-noise", "1", "-o", "out.mcap"},
           {"--joint-noise", "has no effect"}},
          {{"sense", "true.mcap", "--objects", "wod", "-o", "out.mcap"}, {"did you mean 'wood'"}},
          {{"sense", "true.mcap", "--explorations", "3", "-o", "out.mcap"},
           {"has 2 explorations, not 3"}},
          {{"sense", "true.mcap", "--potentiometer-bits", "0", "-o", "out.mcap"},
           {"--potentiometer-bits"}}});
}

}  // namespace
}  // namespace somato
