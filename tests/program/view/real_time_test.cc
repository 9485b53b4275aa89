#include <unistd.h>

#include "program/support/program_test.h"

namespace somato {
namespace {

class RealTime : public ProgramTest {
 protected:
  // `somato live --realtime` of a device, without the permissions of a real-time priority.
  ProgramRun run_unpermitted() const {
    write("device.toml", "name = 'board'\n");
    Words words{"prlimit", "--rtprio=0:0", "--memlock=65536:65536"};
    if (geteuid() == 0) {
      const std::string capabilities = "-sys_nice,-ipc_lock";
      words.insert(words.end(),
                   {"setpriv", "--bounding-set=" + capabilities, "--inh-caps=" + capabilities});
    }
    words.insert(words.end(), {program(), "live", "--model", "device.toml", "--device",
                               "device.toml", "--realtime"});
    return run_other(words);
  }
};

TEST_F(RealTime, WithoutPermissionItEndsAndSaysWhatIsMissingAndWhatToDo) {
  const ProgramRun done = run_unpermitted();
  EXPECT_EQ(done.exit_code, 1);
  for (const char* word :
       {"--realtime", "RLIMIT_RTPRIO is 0", "CAP_SYS_NICE is missing", "RLIMIT_MEMLOCK is 65536",
        "CAP_IPC_LOCK", "/etc/security/limits.d", "LimitRTPRIO=40", "LimitMEMLOCK=infinity"}) {
    EXPECT_NE(done.err.find(word), std::string::npos) << word << "\n" << done.err;
  }
}

TEST_F(RealTime, ItHasNoEffectWithoutADevice) {
  write("model", "");
  const ProgramRun done = run({"live", "--model", "model", "--body", "lucs2", "--realtime"});
  EXPECT_EQ(done.exit_code, 2);
  EXPECT_NE(done.err.find("--realtime"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("without a device"), std::string::npos) << done.err;
}

}  // namespace
}  // namespace somato
