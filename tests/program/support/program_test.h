#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/support/places.h"
#include "base/support/run_program.h"
#include "base/support/temporary_folder.h"

namespace somato {

using Words = std::vector<std::string>;

/// The example's recording.
inline const std::string kTrials = source_path("examples/synthetic_grasps/trials");

/// The program to test: that of this build, unless the environment names another.
inline std::string program() {
  const char* named = std::getenv("SOMATO_PROGRAM");
  return named ? named : built_program();
}

/// Whether the program refused because it was built without its pages, for want of npm.
inline bool has_no_pages(const ProgramRun& done) {
  return done.err.find("without its pages") != std::string::npos;
}

/// A refused command line: what it is, and what the message must say.
struct Refusal {
  Words arguments;
  Words says;
};

/// Runs the program in a folder of the test's own.
class ProgramTest : public ::testing::Test {
 protected:
  ProgramRun run(const Words& arguments, ProgramWorld world = {}) const {
    Words all{program()};
    all.insert(all.end(), arguments.begin(), arguments.end());
    world.folder = folder_.path();
    const ProgramRun run = run_program(all, world);
    EXPECT_FALSE(run.accused()) << run.err;
    EXPECT_FALSE(run.timed_out);
    return run;
  }

  /// Another program, in the same folder.
  ProgramRun run_other(const Words& arguments) const {
    ProgramWorld world;
    world.folder = folder_.path();
    Words found_on_the_path{"/usr/bin/env"};
    found_on_the_path.insert(found_on_the_path.end(), arguments.begin(), arguments.end());
    return run_program(found_on_the_path, world);
  }

  /// A run that must succeed, and say nothing on standard error; its standard output.
  std::string output_of(const Words& arguments) const {
    const ProgramRun done = run(arguments);
    EXPECT_EQ(done.exit_code, 0) << ::testing::PrintToString(arguments);
    EXPECT_EQ(done.err, "");
    return done.out;
  }

  /// A run that must fail with `exit_code`, one line that says all of `says`, and nothing else: no
  /// output, and every file as it was.
  void expect_refused(int exit_code, const Words& arguments, const Words& says,
                      const ProgramWorld& world = {}) const {
    SCOPED_TRACE(::testing::PrintToString(arguments));
    const auto before = contents();
    const ProgramRun done = run(arguments, world);
    EXPECT_EQ(done.signal, 0);
    EXPECT_EQ(done.exit_code, exit_code);
    EXPECT_EQ(done.out, "");
    EXPECT_TRUE(done.err.starts_with("somato: ")) << done.err;
    EXPECT_EQ(done.err.find('\n'), done.err.size() - 1) << done.err;
    for (const std::string& part : says) {
      EXPECT_NE(done.err.find(part), std::string::npos) << part << "\n is not in\n" << done.err;
    }
    EXPECT_TRUE(contents() == before) << "a file was made, changed or removed";
  }

  void expect_refused(int exit_code, const std::vector<Refusal>& refusals) const {
    for (const Refusal& refusal : refusals) {
      expect_refused(exit_code, refusal.arguments, refusal.says);
    }
  }

  /// Every path in the folder, with a file's bytes or a link's target.
  std::map<std::string, std::string> contents() const {
    std::map<std::string, std::string> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path())) {
      const std::string path = entry.path().string();
      if (entry.is_symlink()) {
        found[path] = "link to " + std::filesystem::read_symlink(path).string();
      } else {
        found[path] = entry.is_regular_file() ? "file of " + bytes_of(path) : "other";
      }
    }
    return found;
  }

  void write(const std::string& name, const std::string& bytes) const { folder_.with(name, bytes); }
  std::string read(const std::string& name) const { return bytes_of(folder_.file(name)); }
  std::string path(const std::string& name) const { return folder_.file(name); }

  /// data.csv: twelve rows of three columns in three groups; and good.map, trained on them.
  void write_data() const { write("data.csv", data()); }
  void train() const {
    write_data();
    output_of({"som", "train", "data.csv", "-o", "good.map", "--rows", "4", "--columns", "5",
               "--iterations", "200"});
  }

  /// study.toml: `seeds` maps of the joints of the closed hand, each of `iterations`.
  void write_study(const std::string& seeds = "1", const std::string& iterations = "150") const {
    write("study.toml", "[study]\nname = 'small'\nseeds = " + seeds +
                            "\n[module.joints]\ntype = 'channel'\nchannel = 'joints'\n"
                            "[module.closed]\ntype = 'last'\ninput = 'joints'\n"
                            "[module.map]\ntype = 'som'\ninput = 'closed'\nrows = 3\ncolumns = 3\n"
                            "iterations = " +
                            iterations + "\n");
  }

  static std::string data() {
    return "0.1,0.2,0.3\n0.2,0.1,0.35\n0.15,0.25,0.3\n0.05,0.2,0.4\n"
           "3.1,3.2,3.3\n3.2,3.1,3.35\n3.15,3.25,3.3\n3.05,3.2,3.4\n"
           "6.1,0.2,9.3\n6.2,0.1,9.35\n6.15,0.25,9.3\n6.05,0.2,9.4\n";
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace somato
