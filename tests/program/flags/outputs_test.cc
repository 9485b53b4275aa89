#include <filesystem>

#include "program/support/program_test.h"

namespace somato {
namespace {

namespace fs = std::filesystem;

// A command line that works, the files that it reads, and its flags for files that it writes.
struct ReadingCommand {
  Words words;
  Words reads;
  Words flags{"-o"};
};

class Outputs : public ProgramTest {
 protected:
  void SetUp() override {
    train();
    write("labels.txt", "a\na\na\na\nb\nb\nb\nb\nc\nc\nc\nc\n");
    write_study();
    fs::create_directories(path("grasps"));
    fs::copy(kTrials, path("grasps/trials"));
    output_of({"import", "icub_grasp", "grasps", "-o", "grasps.mcap"});
    output_of({"run", "study.toml", "--data", "grasps.mcap", "--out", "out"});
    fs::copy(path("grasps.mcap"), path("out/beside.mcap"));
    fs::copy(path("out/system.somato"), path("other.somato"));
    fs::create_directory(path("in"));
    write("in/a_1.csv", "t,x\n0,1\n1,2\n");
    write("in.toml",
          "[import]\nfiles = '{object}_{trial:number}.csv'\ntime = 't'\n"
          "[[channel]]\nname = 'x'\nelements = ['x']\n");
    write("things.toml",
          "[object]\nball = { shape = 'sphere', diameter = 72, material = 'wood' }\n");
    write("settings.toml", "[simulation]\nsensor_noise = 0.0\n");
    output_of({"explore", "--body", "hardness", "--explorations", "1", "--true-values", "true",
               "-o", "true.mcap"});
  }

  std::string trial() const {
    for (const auto& entry : fs::recursive_directory_iterator(path("grasps/trials"))) {
      if (entry.is_regular_file()) return fs::relative(entry.path(), path(".")).string();
    }
    return {};
  }
};

// Eight of these wrote over what they read, and ended with 0.
TEST_F(Outputs, AreNeverWhatIsRead) {
  const std::vector<ReadingCommand> commands{
      {{"som", "train", "data.csv", "--labels", "labels.txt"}, {"data.csv", "labels.txt"}},
      {{"som", "map", "good.map", "data.csv"}, {"good.map", "data.csv"}, {"-o", "--activity"}},
      {{"som", "cluster", "good.map", "data.csv", "--labels", "labels.txt"},
       {"good.map", "data.csv", "labels.txt"},
       {"-o", "--samples", "--features", "--merges"}},
      {{"som", "features", "good.map", "data.csv"}, {"good.map", "data.csv"}},
      {{"som", "plot", "good.map", "data.csv", "--labels", "labels.txt"},
       {"good.map", "data.csv", "labels.txt"}},
      {{"som", "export", "good.map"}, {"good.map"}},
      {{"som", "export", "out/system.somato"}, {"out/system.somato"}},
      {{"som", "import", "good.map"}, {"good.map"}},
      {{"import", "csv", "in", "--description", "in.toml"}, {"in/a_1.csv", "in.toml"}},
      {{"import", "icub_grasp", "grasps"}, {trial()}},
      {{"recover", "grasps.mcap"}, {"grasps.mcap"}},
      {{"information", "study.toml", "--data", "grasps"}, {"study.toml", trial()}},
      {{"information", "study.toml", "--data", "grasps.mcap"}, {"study.toml", "grasps.mcap"}},
      {{"apply", "out/system.somato", "grasps"}, {"out/system.somato", trial()}},
      {{"apply", "out/system.somato", "grasps.mcap"},
       {"out/system.somato", "grasps.mcap"},
       {"-o", "--contributions"}},
      {{"explore", "--body", "lucs2", "--objects", "things.toml", "--settings", "settings.toml"},
       {"things.toml", "settings.toml"}},
      {{"sense", "true.mcap", "--settings", "settings.toml"}, {"true.mcap", "settings.toml"}},
      {{"report", "out/results.json", "--data", "grasps.mcap", "--model", "other.somato"},
       {"out/results.json", "grasps.mcap", "other.somato", "out/system.somato", "out/beside.mcap"}},
      {{"figure", "out/results.json", "map", "--data", "grasps.mcap", "--model", "other.somato"},
       {"out/results.json", "grasps.mcap", "other.somato"}}};
  for (const ReadingCommand& command : commands) {
    for (const std::string& flag : command.flags) {
      for (const std::string& read : command.reads) {
        Words words = command.words;
        words.insert(words.end(), {flag, read});
        expect_refused(2, words, {read + ": ", "saving would overwrite"});
      }
    }
  }
}

TEST_F(Outputs, AreNotWhatIsReadUnderAnotherName) {
  fs::create_hard_link(path("data.csv"), path("hard"));
  fs::create_symlink("data.csv", path("soft"));
  for (const char* name : {"hard", "soft", "in/../data.csv"}) {
    expect_refused(2, {"som", "train", "data.csv", "-o", name},
                   {"saving would overwrite one of DATA"});
  }
  fs::create_hard_link(path(trial()), path("hard_trial"));
  expect_refused(2, {"apply", "out/system.somato", "grasps", "-o", "hard_trial"},
                 {"saving would overwrite a file of the folder DATA"});
}

TEST_F(Outputs, DifferFromEachOther) {
  expect_refused(2, {"som", "map", "good.map", "data.csv", "-o", "x", "--activity", "x"},
                 {"saving would overwrite --output"});
}

TEST_F(Outputs, OfAFolderAreNotWhatIsRead) {
  write("out/results.json", read("study.toml"));
  expect_refused(2, {"run", "out/results.json", "--data", "grasps.mcap", "--out", "out"},
                 {"out/results.json: ", "would overwrite it", "STUDY"});
  fs::copy(path("grasps.mcap"), path("out/map.svg"), fs::copy_options::overwrite_existing);
  expect_refused(2, {"run", "study.toml", "--data", "out/map.svg", "--out", "out"},
                 {"out/map.svg: ", "would overwrite it", "--data"});
}

// Other files in the folder do not matter.
TEST_F(Outputs, MayReplaceOtherFiles) {
  write("answers.csv", "old");
  output_of({"apply", "out/system.somato", "grasps.mcap", "-o", "answers.csv"});
  EXPECT_NE(read("answers.csv"), "old");
  output_of({"apply", "out/system.somato", "grasps", "-o", "grasps/new.csv"});
}

}  // namespace
}  // namespace somato
