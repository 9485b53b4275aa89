#include <algorithm>
#include <fstream>

#include "program/support/program_test.h"

namespace somato {
namespace {

const std::string kStudy =
    "[study]\n"         // line 1
    "name = 'small'\n"  // line 2
    "seeds = 1\n"       // line 3
    "protocols = ['leave_one_out']\n"
    "[recording]\n"  // line 5
    "format = 'icub_grasp'\n"
    "[module.joints]\n"  // line 7
    "type = 'channel'\n"
    "channel = 'joints'\n"
    "[module.closed]\n"  // line 10
    "type = 'last'\n"
    "input = 'joints'\n"
    "[module.map]\n"  // line 13
    "type = 'som'\n"
    "input = 'closed'\n"
    "rows = 4\n"  // line 16
    "columns = 4\n"
    "iterations = 100\n";

std::string with(const std::string& old, const std::string& replacement) {
  std::string study = kStudy;
  return study.replace(study.find(old), old.size(), replacement);
}

class BadStudy : public ProgramTest {
 protected:
  void expect_study_refused(int code, const std::string& study, const Words& says) const {
    SCOPED_TRACE(study);
    write("study.toml", study);
    expect_refused(code, {"run", "study.toml", "--data", kTrials, "--out", "out"}, says);
  }
};

// Tables that 'reproduce' reads are not wrong unnoticed.
TEST_F(BadStudy, WhatBelongsToReproduceIsRefusedToo) {
  const std::vector<std::pair<std::string, Words>> cases{
      {kStudy + "[explore]\nobjects = 'x.toml'\n", {"study.toml:19", "[explore] requires a body"}},
      {kStudy + "[explore]\nbody = 'lucs5'\n", {"study.toml:20", "lucs2"}},
      {kStudy + "[variation.wide]\nmodule.mpa.rows = 3\n",
       {"study.toml:20", "unknown module 'mpa'", "did you mean 'map'?"}},
      {kStudy + "[[claim]]\ntext = 't'\nmetric = 'accuracy'\n",
       {"study.toml:19", "the claim has no bound"}},
      {kStudy + "[[claim]]\ntext = 't'\nmetric = 'accuracy'\nat_least = 0\nvariation = 'w'\n",
       {"study.toml:19", "system or variation that is not run"}},
      {kStudy + "[question]\nname = 'q'\n",
       {"study.toml", "contains a question about several systems", "somato reproduce"}},
  };
  for (const auto& [study, says] : cases) expect_study_refused(2, study, says);
}

TEST_F(BadStudy, PlaceAndRemedyAreNamed) {
  const std::vector<std::pair<std::string, Words>> cases{
      {with("rows = 4", "rows = = 4"), {"study.toml:16:8", "correct the TOML"}},
      {with("['leave_one_out']", "['leave_one_out'"), {"study.toml:"}},
      {with("columns = 4", "rows = 4"), {"study.toml:17", "'rows'"}},
      {with("[module.map]", "[modlue.map]"),
       {"study.toml:13", "unknown table 'modlue'", "did you mean 'module'?"}},
      {with("rows = 4", "rwos = 4"), {"study.toml:16", "unknown key 'rwos'", "'rows'"}},
      {with("rows = 4", "rows = 0"), {"study.toml:16", "1 to 16777216, not 0"}},
      {with("rows = 4", "rows = 4.5"), {"study.toml:16", "whole number", "4.5"}},
      {with("rows = 4", "rows = nan"), {"study.toml:16", "nan"}},
      {with("rows = 4", "rows = 'four'"), {"study.toml:16", "four"}},
      {with("rows = 4", "rows = [4]"), {"study.toml:16", "rows"}},
      {with("rows = 4", "lattice = 'hexagon'"), {"study.toml:16", "did you mean 'hexagonal'?"}},
      {with("rows = 4", "seed = 3"), {"study.toml:16", "seed"}},
      {with("rows = 4", "training = 'batch'"), {"study.toml:18", "'iterations' has no effect"}},
      {with("'leave_one_out'", "'leave_one_in'"),
       {"study.toml:4", "did you mean 'leave_one_out'?"}},
      {with("'leave_one_out'", "'test_data'"), {"study.toml:4", "--test-data"}},
      {with("'leave_one_out'", "'leave_group_out'"), {"study.toml:4", "add groups = "}},
      {with("seeds = 1", "groups = ['trial']"), {"study.toml:3", "'groups' has no effect"}},
      {with("seeds = 1", "folds = 3"), {"study.toml:3", "'folds' has no effect"}},
      {with("'icub_grasp'", "'icub_grip'"), {"study.toml:6", "icub_grasp"}},
      {with("name = 'small'\n", ""), {"study.toml:1", "no name", "[study]"}},
      {with("['leave_one_out']", "[]"), {"study.toml:4", "no protocols", "[study]"}},
      {with("seeds = 1", "seeds = 0"), {"study.toml:3", "seeds"}},
      {with("seeds = 1", "label = 'objct'"), {"unknown label 'objct'", "did you mean 'object'?"}},
      {with("seeds = 1", "individual = 'objct'"), {"unknown label 'objct'"}},
      {with("seeds = 1", "map = 'mop'"),
       {"study.toml:1", "unknown module of type som 'mop'", "did you mean 'map'?"}},
      {"module = 3\n", {"study.toml:1", "'module' must hold tables", "[module.NAME]"}},
      {"", {"study.toml", "no modules"}}};
  for (const auto& [study, says] : cases) expect_study_refused(2, study, says);
}

// The modules are named with the place where they stand.
TEST_F(BadStudy, ModulesThatDoNotFitAreNamed) {
  const std::vector<std::pair<std::string, Words>> cases{
      {with("'som'", "'smo'"), {"study.toml:14", "unknown type of module 'smo'"}},
      {with("type = 'last'\n", ""), {"study.toml:10, module 'closed'", "type"}},
      {with("'last'", "'lost'"), {"study.toml:11", "did you mean 'last'?"}},
      {with("channel = 'joints'", "channel = 'jonts'"),
       {"study.toml:7, module 'joints'", "unknown channel 'jonts'", "did you mean 'joints'?"}},
      {with("channel = 'joints'\n", ""), {"study.toml:7, module 'joints'", "add channel ="}},
      {with("channel = 'joints'", "channel = 'joints'\nelements = ['10']"),
       {"study.toml:7, module 'joints'", "unknown element '10'"}},
      {with("input = 'closed'", "input = 'closd'"),
       {"study.toml:15", "unknown module 'closd'", "did you mean 'closed'?"}},
      {with("input = 'closed'", "input = 3"), {"study.toml:15", "input"}},
      {with("input = 'closed'\n", ""), {"study.toml:13, module 'map'", "input"}},
      {with("input = 'closed'", "input = 'map'"), {"map", "delay"}},
      {with("input = 'closed'", "input = 'joints'"),
       {"study.toml:13, module 'map'", "one per frame", "'last'"}},
      {with("input = 'joints'", "input = 'map'"),
       {"study.toml:13, module 'map'", "map -> closed -> map"}},
      {with("'som'", "'last'"), {"study.toml:16, module 'map'", "unknown key 'rows'"}},
      {kStudy + "[[phase]]\nlearn = ['closed']\n", {"study.toml:19", "closed", "learn"}},
      {kStudy + "[[phase]]\nlearn = ['mop']\n", {"study.toml:19", "did you mean 'map'?"}},
      {kStudy + "[module.other]\ntype = 'som'\ninput = 'closed'\n",
       {"study.toml:1", "more than one map could answer", "map, other", "'map' in [study]"}}};
  for (const auto& [study, says] : cases) expect_study_refused(2, study, says);
}

// The trials with 1.0 as every first joint: lines of nine numbers are joints.
void copy_with_stiff_joint(const std::string& to) {
  std::filesystem::create_directory(to);
  for (const auto& entry : std::filesystem::directory_iterator(kTrials)) {
    std::ifstream in(entry.path());
    std::ofstream out(std::filesystem::path(to) / entry.path().filename());
    for (std::string line; std::getline(in, line);) {
      const bool joints = std::count(line.begin(), line.end(), ' ') == 8;
      out << (joints ? "1.0" + line.substr(line.find(' ')) : line) << "\n";
    }
  }
}

TEST_F(BadStudy, ConstantElementsAreNamedUnlessMadeZero) {
  copy_with_stiff_joint(path("stiff"));
  const Words words{"run", "study.toml", "--data", "stiff", "--out", "out"};
  const std::string standardized =
      with("input = 'closed'", "input = 'standardized'") +
      "[module.standardized]\ntype = 'standardization'\ninput = 'closed'\n";
  write("study.toml", standardized);
  expect_refused(1, words, {"study.toml:19, module 'standardized'", "constant_columns"});
  write("study.toml", standardized + "constant_columns = 'zero'\n");
  output_of(words);
  EXPECT_FALSE(read("out/results.json").empty());
}

TEST_F(BadStudy, PathsThatAreNoStudies) {
  write("study.toml", kStudy);
  std::filesystem::create_symlink("loop", path("loop"));
  const auto run_of = [](const std::string& study) {
    return Words{"run", study, "--data", kTrials, "--out", "out"};
  };
  expect_refused(1,
                 {{run_of("missing"), {"missing: cannot open", "No such file"}},
                  {run_of("tensor_chan"), {"check the path, or use the built-in 'tensor_chain'"}},
                  {run_of("."), {".: cannot read", "not a folder"}},
                  {run_of("loop"), {"loop: cannot open", "symbolic links"}}});
}

TEST_F(BadStudy, RecordingsThatCannotBeUsed) {
  write("study.toml", kStudy);
  std::filesystem::create_directory(path("empty"));
  std::filesystem::copy(kTrials, path("broken"));
  std::ofstream(path("broken/ball_small_2.txt"), std::ios::app) << "1 2 three\n";
  std::filesystem::copy(kTrials, path("hollow"));
  write("hollow/block_large_1.txt", "");
  std::filesystem::create_directory(path("single"));
  std::filesystem::copy(kTrials + "/ball_small_1.txt", path("single"));
  std::filesystem::create_directory(path("alike"));
  std::filesystem::copy(kTrials + "/ball_small_1.txt", path("alike"));
  std::filesystem::copy(kTrials + "/ball_small_2.txt", path("alike"));
  const auto run_of = [](const std::string& data) {
    return Words{"run", "study.toml", "--data", data, "--out", "out"};
  };
  expect_refused(1, {{run_of("missing"), {"missing: ", "No such file", "use the folder"}},
                     {run_of("empty"), {"empty: ", "no files", "use the folder"}},
                     {run_of("study.toml"), {"study.toml: "}},
                     {run_of("broken"), {"broken/ball_small_2.txt:", "repair or remove the file"}},
                     {run_of("hollow"), {"hollow/block_large_1.txt"}},
                     {run_of("single"), {"single: ", "two"}},
                     {run_of("alike"), {"alike", "same 'object'"}}});
}

TEST_F(BadStudy, OutputThatCannotBeSaved) {
  write("study.toml", kStudy);
  write("file", "in the way");
  std::filesystem::create_directories(path("taken/map.svg"));
  std::filesystem::create_directories(path("kept/unfinished.journal"));
  const auto run_to = [](const std::string& out) {
    return Words{"run", "study.toml", "--data", kTrials, "--out", out};
  };
  expect_refused(1, {{run_to("file"), {"file: ", "folder cannot be created", "--out"}},
                     {run_to("file/out"), {"file/out: ", "folder cannot be created"}},
                     {run_to("/proc/somato"), {"/proc/somato: ", "folder cannot be created"}},
                     {run_to("taken"), {"taken/map.svg", "name a file, not a folder"}},
                     {run_to("kept"), {"kept/unfinished.journal", "not a folder"}}});
}

// Completed work is kept: with enough space the same command resumes.
TEST_F(BadStudy, ADiskThatIsFullKeepsWhatIsDone) {
  write("study.toml", kStudy);
  const Words words{"run", "study.toml", "--data", kTrials, "--out", "out"};
  ProgramWorld world;
  world.largest_file = 2000;
  const ProgramRun full = run(words, world);
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_NE(full.err.find("out/unfinished.journal: the journal cannot be written: File too large"),
            std::string::npos)
      << full.err;
  output_of(words);
  const std::string results = read("out/results.json");
  EXPECT_FALSE(results.empty());
  EXPECT_FALSE(std::filesystem::exists(path("out/unfinished.journal")));
  world.largest_file = results.size() - 1;
  const ProgramRun late = run({"run", "study.toml", "--data", kTrials, "--out", "late"}, world);
  EXPECT_EQ(late.exit_code, 1);
  EXPECT_FALSE(std::filesystem::exists(path("late/results.json")));
}

}  // namespace
}  // namespace somato
