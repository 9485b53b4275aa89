#include <algorithm>
#include <fstream>

#include "program/program_test.h"

namespace somato {
namespace {

const std::string kTrials = SOMATO_SOURCE_DIR "/examples/synthetic_grasps/trials";

const std::string kStudy =
    "[study]\n"         // line 1
    "name = 'small'\n"  // line 2
    "seeds = 1\n"       // line 3
    "protocols = ['leave_one_out']\n"
    "[recording]\n"  // line 5
    "format = 'icub_grasp'\n"
    "[vector]\n"  // line 7
    "channels = ['joints']\n"
    "[map]\n"  // line 9
    "rows = 4\n"
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

TEST_F(BadStudy, PlaceAndRemedyAreNamed) {
  const std::vector<std::pair<std::string, Words>> cases{
      {with("rows = 4", "rows = = 4"), {"study.toml:10:8", "correct the TOML"}},
      {with("['joints']", "['joints'"), {"study.toml:"}},
      {with("columns = 4", "rows = 4"), {"study.toml:11", "'rows'"}},
      {with("[map]", "[mpa]"), {"study.toml:9", "unknown table 'mpa'", "did you mean 'map'?"}},
      {with("rows = 4", "rwos = 4"), {"study.toml:10", "unknown key 'rwos'", "'rows'"}},
      {with("rows = 4", "rows = 0"), {"study.toml:10", "1 to 16777216, not 0"}},
      {with("rows = 4", "rows = 4.5"), {"study.toml:10", "whole number", "4.5"}},
      {with("rows = 4", "rows = nan"), {"study.toml:10", "nan"}},
      {with("rows = 4", "rows = 'four'"), {"study.toml:10", "four"}},
      {with("rows = 4", "rows = [4]"), {"study.toml:10", "rows"}},
      {with("rows = 4", "lattice = 'hexagon'"), {"study.toml:10", "did you mean 'hexagonal'?"}},
      {with("'leave_one_out'", "'leave_one_in'"),
       {"study.toml:4", "did you mean 'leave_one_out'?"}},
      {with("'icub_grasp'", "'icub_grip'"), {"study.toml:6", "icub_grasp"}},
      {with("name = 'small'\n", ""), {"study.toml", "no name", "[study]"}},
      {with("['leave_one_out']", "[]"), {"study.toml", "no protocols", "[study]"}},
      {with("['joints']", "[]"), {"study.toml", "no channels", "[vector]"}},
      {with("['joints']", "['jonts']"), {"unknown channel 'jonts'", "did you mean 'joints'?"}},
      {with("seeds = 1", "seeds = 0"), {"study.toml:3", "seeds"}},
      {with("seeds = 1", "label = 'objct'"), {"unknown label 'objct'", "did you mean 'object'?"}},
      {with("seeds = 1", "individual = 'objct'"), {"unknown label 'objct'"}},
      {"map = 3\n", {"study.toml:1", "'map' must be a table", "[map]"}},
      {"", {"study.toml", "no name"}}};
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
  write("study.toml", kStudy);
  expect_refused(1, words, {"joints", "constant_columns"});
  write("study.toml", with("['joints']", "['joints']\nconstant_columns = 'zero'"));
  output_of(words);
  EXPECT_FALSE(read("out/results.json").empty());
}

TEST_F(BadStudy, PathsThatAreNoStudies) {
  write("study.toml", kStudy);
  std::filesystem::create_symlink("loop", path("loop"));
  const auto run_of = [](const std::string& study) {
    return Words{"run", study, "--data", kTrials, "--out", "out"};
  };
  expect_refused(1, {{run_of("missing"), {"missing: cannot open", "No such file"}},
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
  expect_refused(1, {{run_of("missing"), {"missing: ", "No such file", "give the folder"}},
                     {run_of("empty"), {"empty: ", "no files", "give the folder"}},
                     {run_of("study.toml"), {"study.toml: "}},
                     {run_of("broken"), {"broken/ball_small_2.txt:", "repair the file"}},
                     {run_of("hollow"), {"hollow/block_large_1.txt"}},
                     {run_of("single"), {"single: ", "two"}},
                     {run_of("alike"), {"alike", "same 'object'"}}});
}

TEST_F(BadStudy, OutputThatCannotBeSaved) {
  write("study.toml", kStudy);
  write("file", "in the way");
  std::filesystem::create_directories(path("taken/map.svg"));
  const auto run_to = [](const std::string& out) {
    return Words{"run", "study.toml", "--data", kTrials, "--out", out};
  };
  expect_refused(1, {{run_to("file"), {"file: ", "folder cannot be made", "--out"}},
                     {run_to("file/out"), {"file/out: ", "folder cannot be made"}},
                     {run_to("/proc/somato"), {"/proc/somato: ", "folder cannot be made"}},
                     {run_to("taken"), {"taken/map.svg", "name a file, not a folder"}}});
  ProgramWorld world;
  world.largest_file = 100;
  expect_refused(1, run_to("out"), {"out/results.json: cannot save", "File too large"}, world);
}

}  // namespace
}  // namespace somato
