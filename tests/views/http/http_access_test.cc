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

HttpRequest request_to(const std::string& host) {
  HttpRequest request;
  request.headers = {{"host", host}};
  return request;
}

std::string refusal_of(const HttpAccess& access, const std::string& host) {
  const auto checked = access.check_host(request_to(host));
  EXPECT_EQ(checked ? 200 : checked.error().status, 403);
  return checked ? "" : checked.error().sentence;
}

TEST(HttpAccess, SaysHowATunnelReachesIt) {
  const std::string advice = "ssh -L 45874:localhost:45874 HOST";
  const HttpAccess four(hosts_at("127.0.0.1", 45874), "token");
  EXPECT_TRUE(four.check_host(request_to("localhost:45874")));
  EXPECT_NE(refusal_of(four, "localhost:8080").find(advice), std::string::npos);
  const HttpAccess six(hosts_at("::1", 45874), "token");
  EXPECT_NE(refusal_of(six, "localhost:8080").find(advice), std::string::npos);
  const HttpAccess http(hosts_at("127.0.0.1", 80), "token");
  EXPECT_NE(refusal_of(http, "localhost:8080").find("ssh -L 80:localhost:80 "), std::string::npos);
  EXPECT_EQ(refusal_of(four, "evil.example").find("evil"), std::string::npos);
}

TEST(HttpAccess, SaysItsAddressWhereATunnelDoesNotReachIt) {
  const HttpAccess other(hosts_at("192.168.1.20", 8080), "token");
  const std::string sentence = refusal_of(other, "localhost:8080");
  EXPECT_NE(sentence.find("http://192.168.1.20:8080/"), std::string::npos);
  EXPECT_EQ(sentence.find("ssh"), std::string::npos);
}

}  // namespace
}  // namespace somato::live
