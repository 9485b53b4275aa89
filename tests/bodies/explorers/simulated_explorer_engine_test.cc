#include "somato/simulation/simulated_explorer.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

namespace somato {
namespace {

// 222 was 2.2.2; from 3.12 on it is three digits a number: 3017000.
std::string version_of_headers() {
  constexpr int kVersion = mjVERSION_HEADER;
  const int base = kVersion < 100'000 ? 10 : 1000;
  return fmt::format("{}.{}.{}", kVersion / base / base, kVersion / base % base, kVersion % base);
}

TEST(PhysicsEngine, IsTheOneWhoseHeadersWereRead) {
  EXPECT_EQ(physics_engine(), "MuJoCo " + version_of_headers());
}

}  // namespace
}  // namespace somato
