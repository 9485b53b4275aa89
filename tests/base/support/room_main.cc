#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

// Every test of a wing has a room: the test program of the wing runs the cases of one room at a
// time (cmake/SomatoTest.cmake), and a case that belongs to none would never run.
bool is_in(const testing::TestInfo& test, const std::string& folder) {
  return std::string(test.file()).find("tests/" + folder + "/") != std::string::npos;
}

// The filter `cases`, without the cases outside of the room `room`, which is WING/ROOM. Ends the
// process if a case is outside of the wing.
std::string filter_of(const std::string& room, std::string cases) {
  const std::string wing = room.substr(0, room.find('/'));
  std::string separator = cases.find('-') == std::string::npos ? "-" : ":";
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int j = 0; j < suite.total_test_count(); ++j) {
      const testing::TestInfo& test = *suite.GetTestInfo(j);
      if (!is_in(test, wing)) {
        std::fprintf(stderr, "%s.%s in %s is not in a room of tests/%s\n", suite.name(),
                     test.name(), test.file(), wing.c_str());
        std::exit(1);
      }
      if (is_in(test, room)) continue;
      cases += separator + suite.name() + "." + test.name();
      separator = ":";
    }
  }
  return cases;
}

}  // namespace

/// Runs the cases of the room in the environment variable SOMATO_TEST_ROOM, or all.
int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (const char* room = std::getenv("SOMATO_TEST_ROOM")) {
    GTEST_FLAG_SET(filter, filter_of(room, GTEST_FLAG_GET(filter)));
  }
  return RUN_ALL_TESTS();
}
