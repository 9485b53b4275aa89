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

  // With the sources of the other recording: those of played sensors state this.
  Recording played(const std::string& name, const Recording& other) const {
    Recording recording = recorded(name);
    EXPECT_EQ(recording.explorations.size(), other.explorations.size());
    for (std::size_t i = 0; i < other.explorations.size(); ++i) {
      EXPECT_NE(recording.explorations[i].source.find(", sensors played, seed "),
                std::string::npos);
      recording.explorations[i].source = other.explorations[i].source;
    }
    return recording;
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
  EXPECT_EQ(played("played.mcap", recorded("plain.mcap")), recorded("plain.mcap"));
  output_of({"sense", "true.mcap", "--seed", "4", "--true-values", "true", "-o", "played.mcap"});
  EXPECT_EQ(played("played.mcap", recorded("true.mcap")), recorded("true.mcap"));
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

TEST_F(SenseCommand, SaysThatDefaultSensorsAreNotThoseOfTheExploration) {
  write("coarse.toml",
        "[hardness_probe]\npotentiometer_bits = 12\nstroke = 60.0\n"
        "[simulation]\ntrue_values = true\n");
  explore("coarse.mcap", {"--settings", "coarse.toml"});
  for (const Words& more : {Words{}, Words{"--potentiometer-bits", "12"}, Words{"--seed", "7"}}) {
    Words words{"sense", "coarse.mcap", "-o", "played.mcap"};
    words.insert(words.end(), more.begin(), more.end());
    const ProgramRun done = run(words);
    EXPECT_EQ(done.exit_code, 0);
    EXPECT_EQ(done.out, "played.mcap: 16 explorations\n");
    EXPECT_EQ(done.err,
              "somato: coarse.mcap: the recording was made with other sensors than the default "
              "ones, and parameters of sensors that are not given have their defaults; give the "
              "settings of the exploration (--settings FILE)\n");
  }
}

// Also without its true values, although the settings of the exploration have them.
TEST_F(SenseCommand, SettingsOfTheExplorationGiveItsReadings) {
  const std::string probe = "[hardness_probe]\npotentiometer_bits = 12\nstroke = 60.0\n";
  write("plain.toml", probe);
  write("true.toml", probe + "[simulation]\ntrue_values = true\n");
  explore("plain.mcap", {"--settings", "plain.toml"});
  explore("true.mcap", {"--settings", "true.toml"});
  output_of({"sense", "true.mcap", "--settings", "true.toml", "-o", "played.mcap"});
  EXPECT_EQ(played("played.mcap", recorded("plain.mcap")), recorded("plain.mcap"));
  output_of({"sense", "true.mcap", "--settings", "true.toml", "--true-values", "true", "-o",
             "played.mcap"});
  EXPECT_EQ(played("played.mcap", recorded("true.mcap")), recorded("true.mcap"));
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
