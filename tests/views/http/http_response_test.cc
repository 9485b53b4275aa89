#include "views/http/http_response.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace somato::live {
namespace {

// RFC 9110, section 15; 431 of RFC 6585.
TEST(HttpResponse, SaysInItsFirstLineWhatTheStandardSays) {
  const std::vector<std::pair<int, std::string>> reasons{{200, "OK"},
                                                         {400, "Bad Request"},
                                                         {403, "Forbidden"},
                                                         {404, "Not Found"},
                                                         {405, "Method Not Allowed"},
                                                         {408, "Request Timeout"},
                                                         {411, "Length Required"},
                                                         {413, "Content Too Large"},
                                                         {415, "Unsupported Media Type"},
                                                         {417, "Expectation Failed"},
                                                         {431, "Request Header Fields Too Large"},
                                                         {503, "Service Unavailable"}};
  for (const auto& [status, reason] : reasons) {
    HttpResponse response;
    response.status = status;
    const std::string head = head_of(response);
    EXPECT_EQ(head.substr(0, head.find("\r\n")),
              "HTTP/1.1 " + std::to_string(status) + " " + reason);
  }
}

}  // namespace
}  // namespace somato::live
