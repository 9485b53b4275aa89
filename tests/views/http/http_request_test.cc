#include "views/http/http_request.h"

#include <gtest/gtest.h>

#include "views/http/http_access.h"

namespace somato::live {
namespace {

TEST(HttpRequest, IsReadAsItWasSent) {
  const auto request = parse_http_head(
      "POST /api/neuron?map=a%20b&neuron=3&flag HTTP/1.1\r\nHost: x:1\r\nX-One:  a b \r\n"
      "Content-Length: 7\r\n\r\n");
  ASSERT_TRUE(request);
  EXPECT_EQ(request->method, "POST");
  EXPECT_EQ(request->path, "/api/neuron");
  EXPECT_EQ(request->parameter("map"), "a b");
  EXPECT_EQ(request->parameter("neuron"), "3");
  EXPECT_EQ(request->parameter("flag"), "");
  EXPECT_EQ(request->header("host"), "x:1");
  EXPECT_EQ(request->header("x-one"), "a b");
  EXPECT_FALSE(request->header("x-two"));
  EXPECT_EQ(request->content_length, 7U);
}

TEST(HttpRequest, NeedsTheEndOfItsHeaders) {
  EXPECT_EQ(parse_http_head("GET / HTTP/1.1\r\nHost: x\r\n").error().status, 400);
  EXPECT_EQ(parse_http_head("GET / HTTP/1.1").error().status, 400);
}

TEST(HttpRequest, MayBeAsLongAsItsLimitsAndNoLonger) {
  const std::string start = "GET / HTTP/1.1\r\nX: ";
  const std::string end = "\r\n\r\n";
  const std::string most = start + std::string(8192 - start.size() - end.size(), 'a') + end;
  EXPECT_TRUE(parse_http_head(most));
  EXPECT_EQ(parse_http_head(start + "a" + most.substr(start.size())).error().status, 431);
}

TEST(HttpRequest, IsRefusedByItsFirstLine) {
  EXPECT_TRUE(check_first_line("GE"));
  EXPECT_TRUE(check_first_line("GET / HTTP/1.1\r\nHo"));
  EXPECT_EQ(check_first_line("GET /\r\n").error().status, 400);
  EXPECT_EQ(check_first_line("PUT / HTTP/1.1\r\n").error().status, 405);
}

TEST(HttpAccess, ComparesWholeTexts) {
  EXPECT_TRUE(equal_in_constant_time("abc", "abc"));
  for (const char* other : {"", "ab", "abcd", "abd", "abcabc", "ABC"}) {
    EXPECT_FALSE(equal_in_constant_time("abc", other)) << other;
    EXPECT_FALSE(equal_in_constant_time(other, "abc")) << other;
  }
}

TEST(HttpAccess, MakesTokensOf128RandomBits) {
  const auto token = new_token();
  ASSERT_TRUE(token);
  EXPECT_EQ(token->size(), 32U);
  EXPECT_EQ(token->find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_NE(token, new_token());
}

}  // namespace
}  // namespace somato::live
