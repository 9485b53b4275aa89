#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <utility>
#include <vector>

namespace somato::live {

/// The limits of a request, in bytes and numbers.
struct HttpLimits {
  std::size_t head = 8192;
  std::size_t headers = 64;
  std::size_t body = 65536;
};

/// Why a request is not answered: a status of HTTP, and a sentence for a person.
struct HttpRefusal {
  int status = 400;
  std::string sentence;
};

template <typename T>
using HttpResult = tl::expected<T, HttpRefusal>;

inline tl::unexpected<HttpRefusal> refuse(int status, std::string sentence) {
  return tl::unexpected<HttpRefusal>(HttpRefusal{status, std::move(sentence)});
}

/// A request as it came, with nothing decoded but the parameters.
struct HttpRequest {
  std::string method;
  std::string path;  ///< As it was sent; begins with a slash.
  std::vector<std::pair<std::string, std::string>> parameters;  ///< Behind the question mark.
  std::vector<std::pair<std::string, std::string>> headers;     ///< Names in small letters.
  std::size_t content_length = 0;
  std::string body;

  /// The value of that header or parameter, when there is exactly one.
  std::optional<std::string> header(std::string_view name) const;
  std::optional<std::string> parameter(std::string_view name) const;
};

/// The request whose first line and headers `head` holds, with the empty line behind them. Takes
/// what RFC 9112 allows and a browser sends, and no more: HTTP/1.0 or 1.1, a path (no address),
/// lines that end in CR LF, printable characters, no header over several lines, no body of unknown
/// length. A request with two lengths, types or hosts is refused, as are other methods than GET,
/// HEAD and POST.
HttpResult<HttpRequest> parse_http_head(std::string_view head, const HttpLimits& limits = {});

/// Whether the data so far can still become a request: the headers are not awaited if the first
/// line is refused.
HttpResult<void> check_first_line(std::string_view bytes);

}  // namespace somato::live
