#include "base/mpi/joined_processes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "program/support/program_test.h"
#include "somato/core/random.h"
#include "somato/files/npy.h"

namespace somato {
namespace {

class SeveralProcesses : public ProgramTest {
 protected:
  // Columns of different sizes, so that sums of doubles would depend on their order.
  void write_rows(std::size_t count = 400, std::size_t size = 5) const {
    Random random(6);
    Matrix<float> rows(count, size);
    for (std::size_t i = 0; i < count; ++i) {
      double scale = 1e-3;
      for (float& value : rows.row(i)) {
        value = static_cast<float>(random.normal() * scale);
        scale *= 20.0;
      }
    }
    write("rows.npy", npy_start(count, size) + npy_numbers(rows.values()));
  }

  static Words training(const std::string& map, const Words& more = {}) {
    Words words{"som",   "train",     "rows.npy", "-o",       map,    "--training",
                "batch", "--epochs",  "4",        "--rows",   "4",    "--columns",
                "6",     "--threads", "1",        "--memory", "20KiB"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  // Several processes of the program.
  ProgramRun run_several(const std::string& count, const Words& arguments) const {
    Words words{"mpiexec", "-n", count, program()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return run_other(words);
  }
};

TEST_F(SeveralProcesses, TrainTheMapOfOne) {
  write_rows();
  const std::string shown = output_of(training("one.map"));
  const ProgramRun done = run_several("3", training("several.map"));
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(done.err, "");
  EXPECT_EQ(done.out.substr(done.out.find(':')), shown.substr(shown.find(':')));
  EXPECT_TRUE(read("several.map") == read("one.map"));
  const Words quality{"som", "quality", "one.map", "rows.npy", "--json"};
  EXPECT_EQ(run_several("3", quality).out, output_of(quality));
}

TEST_F(SeveralProcesses, MapRowsAsOneDoes) {
  write_rows();
  output_of(training("one.map"));
  const auto mapping = [](const std::string& winners, const std::string& activity) {
    return Words{"som",   "map",        "one.map", "rows.npy", "-o",
                 winners, "--activity", activity,  "--memory", "20KiB"};
  };
  output_of(mapping("one.csv", "one.npy"));
  const ProgramRun done = run_several("3", mapping("several.csv", "several.npy"));
  EXPECT_EQ(done.exit_code, 0) << done.err;
  EXPECT_EQ(done.err, run(mapping("again.csv", "again.npy")).err);
  EXPECT_TRUE(read("several.csv") == read("one.csv"));
  EXPECT_TRUE(read("several.npy") == read("one.npy"));
  const Words json{"som", "map", "one.map", "rows.npy", "rows.npy", "--json"};
  EXPECT_TRUE(run_several("2", json).out == run(json).out);
}

// The disk is full when the map is saved: the checkpoint remains, for another number of processes.
TEST_F(SeveralProcesses, LoseNothingOnAFullDisk) {
  write_rows();
  output_of(training("one.map"));
  const auto expect_full = [&](const Words& arguments) {
    const ProgramRun full = run_several("2", arguments);
    EXPECT_EQ(full.exit_code, 1);
    EXPECT_NE(full.err.find("No space left on device"), std::string::npos) << full.err;
    EXPECT_EQ(full.err.find("somato: "), full.err.rfind("somato: ")) << full.err;
  };
  expect_full(training("/dev/full", {"--checkpoint", "checkpoint"}));
  EXPECT_EQ(run_several("3", training("several.map", {"--checkpoint", "checkpoint"})).exit_code, 0);
  EXPECT_TRUE(read("several.map") == read("one.map"));
  EXPECT_FALSE(std::filesystem::exists(path("checkpoint")));
  expect_full({"som", "map", "one.map", "rows.npy", "-o", "/dev/full"});
}

TEST_F(SeveralProcesses, AreRefusedOnceWithOneMessage) {
  write_rows();
  const auto expect_message = [&](const Words& arguments, int exit_code, const std::string& says) {
    const ProgramRun done = run_several("2", arguments);
    EXPECT_EQ(done.exit_code, exit_code);
    EXPECT_NE(done.err.find(says), std::string::npos) << done.err;
    EXPECT_EQ(done.err.find("somato: "), done.err.rfind("somato: ")) << done.err;
    EXPECT_EQ(done.out, "");
    EXPECT_FALSE(std::filesystem::exists(path("several.map")));
  };
  expect_message(training("several.map", {"--standardize"}), 2, "--standardize");
  expect_message({"som", "train", "rows.npy", "-o", "several.map"}, 2, "online training");
  expect_message({"som", "train", "-", "-o", "several.map", "--training", "batch"}, 2,
                 "/dev/stdin");
  std::string bytes = read("rows.npy");
  bytes.replace(bytes.size() - 4, 4, "\xFF\xFF\xFF\x7F", 4);  // NaN, read by the second process
  write("rows.npy", bytes);
  expect_message(training("several.map"), 1, "rows.npy");
}

}  // namespace
}  // namespace somato
