#include "program/support/program_test.h"
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

class Explore : public ProgramTest {
 protected:
  // Two objects and two grasps: done in a moment.
  Explore() {
    write("things.toml", kTube + R"(
cone = { shape = "cone", diameter = 80, height = 110, material = "wood" }
)");
    write("short.toml", "[plan]\ngrasps = 2\n");
  }

  // Only the first object, because its explorations do not depend on the other.
  void leave_one_object() const { write("things.toml", kTube); }

  Words explore(const Words& more, const std::string& explorations = "2") const {
    Words all{"explore",     "--body",     "lucs2",      "--objects",
              "things.toml", "--settings", "short.toml", "--explorations",
              explorations,  "-o",         "out.mcap"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  Recording recorded(const std::string& name = "out.mcap") const {
    const auto recording = read_recording(path(name));
    EXPECT_TRUE(recording);
    EXPECT_TRUE(validate(*recording));
    return *recording;
  }

 private:
  inline static const std::string kTube = R"([object]
tube = { shape = "cylinder", diameter = 62, height = 121, material = "hard_board" })";
};

TEST_F(Explore, RecordsEveryThingAsOftenAsRequested) {
  const std::string out = output_of(explore({}));
  EXPECT_TRUE(out.starts_with("out.mcap: 4 explorations of 2 things, ")) << out;
  const Recording recording = recorded();
  ASSERT_EQ(recording.explorations.size(), 4U);
  EXPECT_EQ(*label_values(recording, "object"), (std::vector<std::string>{"tube", "cone"}));
  EXPECT_EQ(*label_values(recording, "trial"), (std::vector<std::string>{"1", "2"}));
  EXPECT_NE(recording.explorations[0].source.find("seed 1"), std::string::npos);
}

TEST_F(Explore, SeedsAndFlagsChangeWhatIsFeltAndThreadsDoNot) {
  output_of(explore({}));
  const Recording first = recorded();
  output_of(explore({"--threads", "1"}));
  EXPECT_EQ(recorded(), first);
  leave_one_object();
  output_of(explore({}, "1"));
  EXPECT_EQ(recorded().explorations[0], first.explorations[0]);
  output_of(explore({"--seed", "2"}, "1"));
  EXPECT_NE(recorded().explorations[0].channels, first.explorations[0].channels);
  output_of(explore({"--free"}, "1"));
  EXPECT_NE(recorded().explorations[0].channels, first.explorations[0].channels);
  output_of(explore({"--placement-noise", "4"}, "1"));
  EXPECT_NE(recorded().explorations[0].channels, first.explorations[0].channels);
}

TEST_F(Explore, SettingsAndFlagsMeanTheSame) {
  leave_one_object();
  output_of(explore({"--placement-noise", "3", "--free"}));
  const Recording by_flags = recorded();
  write("short.toml", "[plan]\ngrasps = 2\n[simulation]\nplacement_noise = 3.0\nfree = true\n");
  output_of(explore({}));
  EXPECT_EQ(recorded(), by_flags);
}

TEST_F(Explore, DrawsTheGrasps) {
  output_of(explore({"--images", "pictures"}));
  for (const char* name : {"tube-1-1.png", "tube-2-2.png", "cone-1-1.png"})
    EXPECT_TRUE(std::filesystem::file_size(path(std::string("pictures/") + name)) > 1000) << name;
}

TEST_F(Explore, PicturesStayInTheirFolderWhateverAThingIsCalled) {
  write("things.toml", R"([object]
"../tube" = { shape = "cylinder", diameter = 62, height = 121, material = "hard_board" }
)");
  output_of(explore({"--images", "pictures"}));
  EXPECT_TRUE(std::filesystem::exists(path("pictures/.._tube-1-1.png")));
  EXPECT_FALSE(std::filesystem::exists(path("tube-1-1.png")));
}

TEST_F(Explore, RefusesBeforeAnythingMoves) {
  write("empty.toml", "");
  write("wide.toml",
        "[object]\nplank = { shape = \"block\", width = 300, depth = 50, height = 50, material = "
        "\"wood\" }\n");
  write("negative.toml",
        "[object]\nball = { shape = \"sphere\", diameter = -3, material = \"wood\" }\n");
  write("bad_settings.toml", "[grasp]\nthreshhold = 1.0\n");
  const auto with = [](const Words& more) {
    Words all{"explore", "-o", "out.mcap"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  expect_refused(
      1, explore({"--images", "empty.toml/pictures"}),
      {"empty.toml/pictures: the folder cannot be created", "a writable folder for --images"});
  const std::vector<Refusal> refusals = {
      {with({"--body", "lucs5"}), {"lucs5", "lucs"}},
      {with({"--body", "lucs2", "--objects", "none.toml"}), {"none.toml"}},
      {with({"--body", "lucs2", "--objects", "wide.toml"}), {"plank", "does not fit"}},
      {with({"--body", "lucs2", "--objects", "negative.toml"}), {"negative.toml:2", "diameter"}},
      {with({"--body", "lucs2", "--settings", "bad_settings.toml"}),
       {"bad_settings.toml:2", "did you mean 'threshold'"}},
      {with({"--body", "lucs2", "--placement-noise", "-1"}), {"--placement-noise"}},
      {with({"--body", "lucs2", "--free", "perhaps"}), {"--free"}},
      {with({"--body", "lucs2", "--explorations", "0"}), {"--explorations"}},
      {{"explore", "--body", "lucs2", "-o", "nowhere/out.mcap"}, {"nowhere"}},
      {{"explore", "--body", "lucs2"}, {"output"}},
  };
  for (const Refusal& refusal : refusals) {
    const int code =
        refusal.says.front() == "none.toml" || refusal.says.front() == "nowhere" ? 1 : 2;
    expect_refused(code, refusal.arguments, refusal.says);
  }
}

TEST_F(Explore, FailuresAreReportedAndNotRecorded) {
  write("things.toml", R"([object]
pea = { shape = "sphere", diameter = 6, material = "wood" }
tube = { shape = "cylinder", diameter = 62, height = 121, material = "hard_board" }
)");
  const ProgramRun done = run(explore({}));
  EXPECT_EQ(done.exit_code, 3);
  EXPECT_NE(done.err.find("pea, trial 1"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("never touched"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("2 of 4 explorations failed"), std::string::npos) << done.err;
  EXPECT_EQ(*label_values(recorded(), "object"), (std::vector<std::string>{"tube"}));
}

TEST_F(Explore, AnOldFileStaysWhenEveryExplorationFails) {
  write("things.toml",
        "[object]\npea = { shape = \"sphere\", diameter = 6, material = \"wood\" }\n");
  write("out.mcap", "as it was");
  const ProgramRun done = run(explore({}));
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_NE(done.err.find("every exploration failed"), std::string::npos) << done.err;
  EXPECT_EQ(read("out.mcap"), "as it was");
}

TEST_F(Explore, CtrlCLeavesAWholeFileOfWhatWasExplored) {
  ProgramWorld world;
  world.terminal = true;
  world.interrupt_at = " left";
  Words words = explore({"--threads", "1"});
  words[8] = "200";
  const ProgramRun interrupted = run(words, world);
  EXPECT_EQ(interrupted.exit_code, 130);
  EXPECT_NE(interrupted.err.find(" saved in out.mcap"), std::string::npos) << interrupted.err;
  const std::size_t explorations = recorded().explorations.size();
  EXPECT_GT(explorations, 0U);
  EXPECT_LT(explorations, 400U);
}

TEST_F(Explore, ProbesListenAndPress) {
  write("materials.toml",
        "[material.bark]\nroughness = 80.0\nhardness = \"soft\"\nstiffness = 2.0\n");
  EXPECT_EQ(output_of({"explore", "--body", "texture", "--objects", "materials.toml",
                       "--explorations", "2", "-o", "sound.mcap"}),
            "sound.mcap: 2 explorations of 1 thing, 8192 frames each\n");
  output_of({"explore", "--body", "hardness", "--explorations", "1", "-o", "press.mcap"});
  EXPECT_EQ(recorded("press.mcap").explorations.size(), 8U);
  EXPECT_EQ(*label_values(recorded("press.mcap"), "hardness"),
            (std::vector<std::string>{"soft", "hard"}));
}

}  // namespace
}  // namespace somato
