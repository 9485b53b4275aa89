#include "somato/core/result.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

TEST(Error, IsOneLineOfPlaceFailureAndAdvice) {
  const Error error{ErrorKind::kData, "not a number: 'x'", "data.csv:3:7", "write a number"};
  EXPECT_EQ(to_string(error), "data.csv:3:7: not a number: 'x'; write a number");
}

TEST(Error, LeavesOutWhatIsEmpty) {
  EXPECT_EQ(to_string(Error{ErrorKind::kData, "no samples", "", ""}), "no samples");
  EXPECT_EQ(to_string(Error{ErrorKind::kData, "no samples", "a.npy", ""}), "a.npy: no samples");
  EXPECT_EQ(to_string(Error{ErrorKind::kData, "no samples", "", "add one"}), "no samples; add one");
}

}  // namespace
}  // namespace somato
