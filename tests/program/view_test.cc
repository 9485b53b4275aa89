#include "program/program_test.h"

namespace somato {
namespace {

class View : public ProgramTest {
 protected:
  void record() const {
    output_of({"explore", "--body", "hardness", "--explorations", "1", "-o", "pressed.mcap"});
  }
};

TEST_F(View, RefusesWhatItCannotShow) {
  write("nothing.mcap", "nothing");
  expect_refused(
      2, {{{"view"}, {"name a recording to play, or a body"}},
          {{"view", "a.mcap", "--body", "lucs9"}, {"lucs9"}},
          {{"view", "--body", "lucs4"}, {"lucs4", "did you mean", "lucs"}},
          {{"view", "--body", "probes"}, {"only one body"}},
          {{"view", "--body", "lucs2", "--object", "boul"}, {"boul", "did you mean 'boule'"}},
          {{"view", "a.mcap", "--object", "boule"}, {"--object", "a recording holds"}},
          {{"view", "a.mcap", "--port", "65536"}, {"--port", "65535"}},
          {{"view", "a.mcap", "--address", "0.0.0.0"}, {"--address", "one address alone"}},
          {{"view", "a.mcap", "--address", "192.168.7.7"}, {"--address", "--allow-others"}}});
  expect_refused(1, {{{"view", "missing.mcap"}, {"missing.mcap"}},
                     {{"view", "nothing.mcap"}, {"nothing.mcap"}}});
}

TEST_F(View, PrintsWhereItIsAndEndsPolitely) {
  record();
  ProgramWorld world;
  world.interrupt_at = "Ctrl-C ends the view.";
  for (const Words& words : {Words{"view", "pressed.mcap"}, Words{"view", "--body", "texture"}}) {
    const ProgramRun done = run(words, world);
    if (done.exit_code == 2 && done.err.find("without its pages") != std::string::npos) {
      GTEST_SKIP() << "the program was built without npm";
    }
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_EQ(done.signal, 0);
    EXPECT_TRUE(done.out.starts_with("Open http://127.0.0.1:")) << done.out;
    EXPECT_NE(done.out.find("/?token="), std::string::npos);
    EXPECT_TRUE(done.out.ends_with("The view is closed.\n")) << done.out;
  }
}

TEST_F(View, RefusesObjectsThatItCannotRead) {
  record();
  write("objects.toml", "[object]\ncup = { shape = \"cup\" }\n");
  expect_refused(1, {{{"view", "pressed.mcap", "--objects", "missing.toml"}, {"missing.toml"}}});
  expect_refused(2, {{{"view", "pressed.mcap", "--objects", "objects.toml"}, {"objects.toml"}}});
}

TEST_F(View, TakesASystemThatDoesNotFit) {
  write_data();
  expect_refused(1, {{{"view", "--body", "texture", "--model", "data.csv"}, {"data.csv"}}});
}

}  // namespace
}  // namespace somato
