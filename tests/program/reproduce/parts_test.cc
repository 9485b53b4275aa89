#include <filesystem>
#include <nlohmann/json.hpp>

#include "program/support/reproducing.h"

namespace somato {
namespace {

using Json = nlohmann::json;

class Parts : public Reproduce {
 protected:
  static Words study(const std::string& out, const Words& more = {}) {
    Words words{"run", "study.toml", "--data", kTrials, "--out", out};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  void expect_same(const std::string& a, const std::string& b, const Words& files) const {
    for (const std::string& file : files) {
      EXPECT_TRUE(read(a + "/" + file) == read(b + "/" + file)) << file;
    }
  }
};

TEST_F(Parts, OfAStudyInAnyOrderOneCutAreTheSameBytesAsOneRun) {
  write_study("3");
  output_of(study("one"));
  output_of(study("seven", {"--part", "2/7"}));
  // A killed part leaves a line that is cut.
  const std::string journal = "seven/parts/2-of-7/" + files("seven/parts/2-of-7").front();
  write(journal, read(journal).substr(0, read(journal).size() / 2));
  for (const std::string part : {"5", "3", "7", "1", "6", "4"}) {
    const std::string shown = output_of(study("seven", {"--part", part + "/7"}));
    EXPECT_TRUE(shown.starts_with("Part " + part + " of 7 is done.\n")) << shown;
    EXPECT_FALSE(fs::exists(path("seven/results.json")));
  }
  const Json status = Json::parse(output_of(study("seven", {"--part", "3/7", "--json"})));
  EXPECT_EQ(status["part"], 3);
  EXPECT_EQ(status["parts"], 7);
  EXPECT_EQ(status["trainings"], 2 + 3 * 30);  // the model is trained at the end
  EXPECT_LT(status["done"], 92);
  const std::string shown = output_of(study("seven", {"--part", "2/7"}));
  EXPECT_NE(shown.find("Written: seven/results.json"), std::string::npos) << shown;
  expect_same("seven", "one", {"results.json", "map.svg", "system.somato"});
  // Without --part the results come from the journals of the parts.
  fs::remove(path("seven/results.json"));
  output_of(study("seven"));
  expect_same("seven", "one", {"results.json"});
}

TEST_F(Parts, OfReproductionsAreThoseOfSlurmTasksAndIgnoreOtherRequestsInTheFolder) {
  write("press.toml", press() + "[variation.single]\nmodule.map.rows = 1\n");
  output_of(reproduce("press.toml", "one"));
  output_of(reproduce("press.toml", "two", {"--part", "1/2", "--seed", "7"}));
  ProgramWorld task;
  task.environment = {{"SLURM_ARRAY_TASK_ID", "1"}, {"SLURM_ARRAY_TASK_COUNT", "2"}};
  const ProgramRun first = run(reproduce("press.toml", "two"), task);
  EXPECT_TRUE(first.out.starts_with("Part 1 of 2 (SLURM_ARRAY_TASK_ID = 1) is done.\n"))
      << first.out << first.err;
  output_of(reproduce("press.toml", "two", {"--part", "2/2"}));
  expect_same("two", "one", {"results.json", "maps/press.svg"});
}

TEST_F(Parts, OfSeparateFoldersAreMerged) {
  write_study("2");
  output_of(study("one"));
  for (const std::string part : {"1", "2", "3"}) {
    output_of(study("at" + part, {"--part", part + "/3"}));
  }
  EXPECT_EQ(Json::parse(output_of({"merge", "at3", "at1", "--out", "all", "--json"})),
            Json::parse(R"({"parts": 2, "trainings": 41, "sweep_results": 0})"));
  output_of({"merge", "at2", "at2", "all", "--out", "all"});  // no line twice
  for (const std::string part : {"1", "2", "3"}) {
    const std::string folder = "/parts/" + part + "-of-3";
    const std::string journal = folder + "/" + files("at" + part + folder).front();
    EXPECT_TRUE(read("all" + journal) == read("at" + part + journal));
  }
  output_of(study("all", {"--part", "1/3"}));
  expect_same("all", "one", {"results.json", "map.svg", "system.somato"});
}

TEST_F(Parts, ThatAreWrongAreRefused) {
  write_study();
  expect_refused(2, study("out", {"--part", "0/7"}), {"--part", "is not a part"});
  fs::create_directories(path("empty/parts/1-of-2"));
  expect_refused(2, {"merge", "empty", "--out", "all"}, {"empty", "contains no parts"});
  expect_refused(2, {"merge", "missing", "--out", "all"}, {"missing", "contains no parts"});
}

}  // namespace
}  // namespace somato
