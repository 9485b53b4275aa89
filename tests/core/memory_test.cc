#include "somato/core/memory.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace somato {
namespace {

// Linux says it in another place, too.
TEST(Memory, IsWhatTheKernelSays) {
  std::ifstream file("/proc/meminfo");
  std::string name;
  std::size_t kibibytes = 0;
  if (!(file >> name >> kibibytes) || name != "MemTotal:") GTEST_SKIP() << "no /proc/meminfo";
  EXPECT_EQ(memory_of_machine(), kibibytes * 1024);
}

}  // namespace
}  // namespace somato
