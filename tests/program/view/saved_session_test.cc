// The files of a session that ends by a signal, is killed, or fills the disk.

#include "program/support/program_test.h"
#include "somato/recording/recording_file.h"

#include <csignal>
#include <filesystem>
#include <string>

namespace somato {
namespace {

class SavedSession : public ProgramTest {
 protected:
  // Many explorations of a body, ended by a signal after the first of them.
  ProgramRun explore_until(int signal) const {
    ProgramWorld world;
    world.terminal = true;
    world.interrupt_at = " left";
    world.interrupt_with = signal;
    return run({"explore", "--body", "hardness", "--explorations", "100000", "-o", "hand.mcap"},
               world);
  }

  std::size_t explorations(const std::string& name) const {
    const auto read = read_recording(path(name));
    EXPECT_TRUE(read) << name;
    return read ? read->explorations.size() : 0;
  }

  bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
};

TEST_F(SavedSession, IsWholeAfterASignalThatAsksToEnd) {
  for (const auto& [signal, code] : {std::pair(SIGHUP, 129), std::pair(SIGTERM, 143)}) {
    const ProgramRun done = explore_until(signal);
    EXPECT_EQ(done.exit_code, code) << done.err;
    const std::size_t saved = explorations("hand.mcap");
    EXPECT_GE(saved, 1U);
    const std::string said = std::to_string(saved) + " exploration" + (saved == 1 ? "" : "s");
    EXPECT_NE(done.err.find(said + " saved in hand.mcap"), std::string::npos) << done.err;
    EXPECT_FALSE(exists("hand.mcap.partial"));
  }
}

// The next session does not overwrite it, and prints the command that recovers it.
TEST_F(SavedSession, IsRecoveredAfterItWasKilled) {
  EXPECT_EQ(explore_until(SIGKILL).signal, SIGKILL);
  EXPECT_FALSE(exists("hand.mcap"));
  const std::string command = "somato recover hand.mcap.partial -o hand.mcap";
  expect_refused(2, {"explore", "--body", "hardness", "-o", "hand.mcap"},
                 {"hand.mcap.partial", command});
  const ProgramRun recovered = run({"recover", "hand.mcap.partial", "-o", "hand.mcap"});
  EXPECT_NE(recovered.out.find("saved: "), std::string::npos) << recovered.out << recovered.err;
  EXPECT_GE(explorations("hand.mcap"), 1U);
  EXPECT_TRUE(exists("hand.mcap.partial"));
}

TEST_F(SavedSession, IsNotTouchedByAnotherProgramWhileItContinues) {
  ProgramWorld world;
  world.terminal = true;
  world.interrupt_at = " left";
  world.before_interrupt = [&](const std::string&) {
    const ProgramRun other = run({"explore", "--body", "hardness", "-o", "hand.mcap"});
    EXPECT_EQ(other.exit_code, 2);
    EXPECT_NE(other.err.find("another process records into this file"), std::string::npos)
        << other.err;
  };
  run({"explore", "--body", "hardness", "--explorations", "100000", "-o", "hand.mcap"}, world);
  EXPECT_GE(explorations("hand.mcap"), 1U);
}

// A limit on the size of files is like a disk that is full.
TEST_F(SavedSession, KeepsWhatFitsOnTheDisk) {
  ProgramWorld world;
  world.largest_file = 20000;
  const ProgramRun done =
      run({"explore", "--body", "hardness", "--explorations", "1000", "-o", "hand.mcap"}, world);
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_NE(done.err.find("somato recover hand.mcap.partial -o hand.mcap"), std::string::npos)
      << done.err;
  run({"recover", "hand.mcap.partial", "-o", "hand.mcap"});
  const std::size_t saved = explorations("hand.mcap");
  EXPECT_GE(saved, 1U);
  EXPECT_NE(done.err.find(std::to_string(saved) + " explorations are in hand.mcap.partial"),
            std::string::npos)
      << done.err;
}

}  // namespace
}  // namespace somato
