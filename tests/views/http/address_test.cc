#include "views/http/address.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace somato {
namespace {

using Reach = Address::Reach;

struct Case {
  std::string given;
  std::string text;
  Reach reach;
};

// As RFC 5952 writes addresses of IPv6, which browsers follow.
TEST(Address, IsWrittenAsBrowsersDoAndKnownByItsReach) {
  const std::vector<Case> cases{
      {"127.0.0.1", "127.0.0.1", Reach::kLoopback},
      {"127.1.2.3", "127.1.2.3", Reach::kLoopback},
      {"::1", "::1", Reach::kLoopback},
      {"0:0:0:0:0:0:0:1", "::1", Reach::kLoopback},
      {"0.0.0.0", "0.0.0.0", Reach::kAll},
      {"::", "::", Reach::kAll},
      {"0:0::0", "::", Reach::kAll},
      {"192.168.1.20", "192.168.1.20", Reach::kInterface},
      {"2001:DB8:0:0::00AB", "2001:db8::ab", Reach::kInterface},
  };
  for (const Case& one : cases) {
    const auto address = parse_address(one.given);
    ASSERT_TRUE(address) << one.given;
    EXPECT_EQ(address->text, one.text);
    EXPECT_EQ(address->reach, one.reach) << one.given;
  }
}

TEST(Address, RefusesWhatIsNone) {
  for (const char* text : {"", "localhost", "127.0.0.1:80", "127.0.1", "256.0.0.1", "[::1]", "::1 ",
                           "127.0.0.01x", "1::2::3"}) {
    const auto address = parse_address(text);
    ASSERT_FALSE(address) << text;
    EXPECT_EQ(address.error().kind, ErrorKind::kUsage);
  }
}

}  // namespace
}  // namespace somato
