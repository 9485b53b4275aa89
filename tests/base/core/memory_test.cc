#include "base/core/memory.h"

#include <gtest/gtest.h>
#include <sys/sysinfo.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>

#include "base/support/temporary_folder.h"

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

TEST(Memory, WhatIsFreeIsWithinTheLimitAndThatWithinTheMachine) {
  EXPECT_GT(free_memory(), 0u);
  EXPECT_LE(free_memory(), memory_limit());
  EXPECT_LE(memory_limit(), memory_of_machine());
}

// The system's other word for what is free, which leaves out what could be given back.
TEST(Memory, WhatIsFreeIsNotLessThanTheSystemSays) {
  if (memory_limit() < memory_of_machine()) GTEST_SKIP() << "limits leave this process less";
  struct sysinfo info = {};
  ASSERT_EQ(sysinfo(&info), 0);
  EXPECT_GE(static_cast<double>(free_memory()),
            0.5 * static_cast<double>(info.freeram) * info.mem_unit);
}

TEST(Memory, IsCheckedForWhatAFileAsksFor) {
  EXPECT_TRUE(check_free_memory(10, 8, "f"));
  const std::size_t most = free_memory();
  for (const auto& [count, size] : {std::pair<std::size_t, std::size_t>{most / 3, 1},
                                    {std::size_t{1} << 62, std::size_t{1} << 62}}) {
    const auto refused = check_free_memory(count, size, "f");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kSystem);
    EXPECT_EQ(refused.error().where, "f");
  }
}

TEST(Memory, OfControlGroupsIsTheLeastOfThoseAround) {
  constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  const TemporaryFolder root;
  std::filesystem::create_directories(root.file("a/b/c"));
  const std::string groups = "0::/a/b/c\n";
  EXPECT_EQ(detail::control_group_memory(root.path(), groups, true), kNone);
  root.with("a/b/c/memory.max", "max\n");
  EXPECT_EQ(detail::control_group_memory(root.path(), groups, false), kNone);
  root.with("a/memory.max", "1000\n");
  root.with("a/memory.current", "700\n");
  root.with("a/memory.stat", "anon 500\ninactive_file 200\n");
  EXPECT_EQ(detail::control_group_memory(root.path(), groups, false), 1000u);
  EXPECT_EQ(detail::control_group_memory(root.path(), groups, true), 500u);
  root.with("a/b/memory.max", "400\n");
  root.with("a/b/memory.current", "500\n");
  EXPECT_EQ(detail::control_group_memory(root.path(), groups, false), 400u);
  EXPECT_EQ(detail::control_group_memory(root.path(), groups, true), 0u);
  EXPECT_EQ(detail::control_group_memory(root.path(), "", true), kNone);
  root.with("memory.max", "50");
  EXPECT_EQ(detail::control_group_memory(root.path(), "0::/\n", false), 50u);
}

}  // namespace
}  // namespace somato
