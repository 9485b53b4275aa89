#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "somato/core/check.h"
#include "views/http/http_request.h"
#include "views/session/view_command.h"

namespace {

bool is_printable(const std::string& text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return c == '\t' || (c >= ' ' && c < 0x7F); });
}

// Accepted requests are within the limits and contain only expected characters.
void check(std::string_view bytes) {
  const auto request = somato::live::parse_http_head(bytes);
  if (!request) {
    SOMATO_ASSERT(request.error().status >= 400 && !request.error().sentence.empty());
    return;
  }
  SOMATO_ASSERT(bytes.size() <= 8192 && request->headers.size() <= 64);
  SOMATO_ASSERT(request->content_length <= 65536);
  SOMATO_ASSERT(request->method == "GET" || request->method == "HEAD" || request->method == "POST");
  SOMATO_ASSERT(request->path.starts_with('/') && is_printable(request->path));
  for (const auto& [name, value] : request->headers) {
    SOMATO_ASSERT(!name.empty() && is_printable(name) && is_printable(value));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  check(bytes);
  (void)somato::live::check_first_line(bytes);
  (void)somato::live::parse_view_command(bytes);
  return 0;
}
