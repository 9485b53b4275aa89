#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "live/http_request.h"

namespace somato::live {

/// What is answered. With `stream` the body is what that writes, until it returns.
struct HttpResponse {
  /// Sends a part of the body; false once nobody takes it any more.
  using Write = std::function<bool(std::string_view)>;

  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string body;
  std::vector<std::pair<std::string, std::string>> headers = {};
  std::function<void(const Write&)> stream = {};
};

/// The response that tells a refusal.
HttpResponse response_of(const HttpRefusal& refusal);

/// Its first line and headers, with the empty line that ends them: what a browser is told with
/// everything is among them.
std::string head_of(const HttpResponse& response);

}  // namespace somato::live
