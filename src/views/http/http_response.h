#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "views/http/http_request.h"

namespace somato::live {

/// The response to a request. With `stream`, the body is the output of that function until it
/// returns.
struct HttpResponse {
  /// Sends a part of the body; returns false if the client does not receive any more.
  using Write = std::function<bool(std::string_view)>;

  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string body;
  std::vector<std::pair<std::string, std::string>> headers = {};
  std::function<void(const Write&)> stream = {};
};

/// The response for an error.
HttpResponse response_of(const HttpRefusal& refusal);

/// The status line and headers, with the empty line that ends them; includes the headers of every
/// response.
std::string head_of(const HttpResponse& response);

}  // namespace somato::live
