#include "views/http/http_access.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace somato::live {
namespace {

using Hosts = std::vector<std::string>;

TEST(HttpAccess, AnswersToItsAddressAndItsName) {
  EXPECT_EQ(hosts_at("127.0.0.1", 8080), (Hosts{"127.0.0.1:8080", "localhost:8080"}));
  EXPECT_EQ(hosts_at("::1", 8080), (Hosts{"[::1]:8080", "localhost:8080"}));
  EXPECT_EQ(hosts_at("192.168.1.20", 8080), (Hosts{"192.168.1.20:8080"}));
}

TEST(HttpAccess, KnowsThatBrowsersLeaveOutThePortOfHttp) {
  EXPECT_EQ(hosts_at("127.0.0.1", 80),
            (Hosts{"127.0.0.1:80", "localhost:80", "127.0.0.1", "localhost"}));
}

}  // namespace
}  // namespace somato::live
