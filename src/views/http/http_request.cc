#include "views/http/http_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace somato::live {
namespace {

using Fields = std::vector<std::pair<std::string, std::string>>;

bool is_one_of(char c, std::string_view characters) {
  return characters.find(c) != std::string_view::npos;
}

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

bool is_name_character(char c) {
  return is_letter_or_digit(c) || is_one_of(c, "!#$%&'*+-.^_`|~");
}

bool is_printable(char c) {
  return c > ' ' && c < 0x7F;
}

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  for (char& c : small) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return small;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

std::optional<std::string> only(const Fields& fields, std::string_view name) {
  const auto is_it = [&](const auto& field) { return field.first == name; };
  const auto found = std::find_if(fields.begin(), fields.end(), is_it);
  if (found == fields.end() || std::count_if(found, fields.end(), is_it) > 1) return {};
  return found->second;
}

// The next line, taken off the front of `text`; nothing where none ends in CR LF.
std::optional<std::string_view> take_line(std::string_view& text) {
  const std::size_t end = text.find("\r\n");
  if (end == std::string_view::npos) return {};
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end + 2);
  return line;
}

int digit_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// Text without its %XX; nothing where one is broken or stands for a control character.
std::optional<std::string> decoded(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      plain.push_back(text[i]);
      continue;
    }
    if (i + 2 >= text.size()) return {};
    const int high = digit_of(text[i + 1]);
    const int low = digit_of(text[i + 2]);
    if (high < 0 || low < 0 || 16 * high + low < 0x20) return {};
    plain.push_back(static_cast<char>(16 * high + low));
    i += 2;
  }
  return plain;
}

HttpResult<Fields> parse_parameters(std::string_view query) {
  Fields fields;
  while (!query.empty()) {
    const std::string_view pair = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(query.size(), pair.size() + 1));
    const std::size_t equals = std::min(pair.find('='), pair.size());
    const auto value = decoded(pair.substr(std::min(equals + 1, pair.size())));
    if (!value) return refuse(400, "Malformed query parameter.");
    fields.emplace_back(pair.substr(0, equals), *value);
  }
  return fields;
}

HttpResult<void> parse_target(std::string_view target, HttpRequest& request) {
  if (!target.starts_with('/') || !std::all_of(target.begin(), target.end(), is_printable)) {
    return refuse(400, "The path must begin with a slash.");
  }
  const std::size_t mark = std::min(target.find('?'), target.size());
  request.path = target.substr(0, mark);
  auto parameters = parse_parameters(target.substr(std::min(mark + 1, target.size())));
  if (!parameters) return tl::unexpected(std::move(parameters.error()));
  request.parameters = std::move(*parameters);
  return {};
}

HttpResult<void> check_method(std::string_view method) {
  if (method == "GET" || method == "HEAD" || method == "POST") return {};
  if (method.empty() || !std::all_of(method.begin(), method.end(), is_name_character)) {
    return refuse(400, "Malformed HTTP request.");
  }
  return refuse(405, "Only GET, HEAD and POST are supported.");
}

HttpResult<void> parse_first_line(std::string_view line, HttpRequest& request) {
  const std::size_t first = line.find(' ');
  const std::size_t last = line.rfind(' ');
  if (first == std::string_view::npos || first == last) {
    return refuse(400, "Malformed HTTP/1.1 request.");
  }
  const std::string_view version = line.substr(last + 1);
  if (version != "HTTP/1.1" && version != "HTTP/1.0") {
    return refuse(400, "Unsupported HTTP version.");
  }
  request.method = line.substr(0, first);
  if (auto known = check_method(request.method); !known) return known;
  return parse_target(line.substr(first + 1, last - first - 1), request);
}

HttpResult<void> parse_header(std::string_view line, HttpRequest& request) {
  const std::size_t colon = line.find(':');
  const std::string_view name = line.substr(0, std::min(colon, line.size()));
  if (colon == std::string_view::npos || name.empty() ||
      !std::all_of(name.begin(), name.end(), is_name_character)) {
    return refuse(400, "Malformed header.");
  }
  const std::string_view value = trimmed(line.substr(colon + 1));
  const auto fits = [](char c) { return is_printable(c) || c == ' ' || c == '\t'; };
  if (!std::all_of(value.begin(), value.end(), fits)) {
    return refuse(400, "A header contains an invalid character.");
  }
  request.headers.emplace_back(in_small_letters(name), value);
  return {};
}

bool is_there(const HttpRequest& request, std::string_view name) {
  return std::any_of(request.headers.begin(), request.headers.end(),
                     [&](const auto& header) { return header.first == name; });
}

HttpResult<void> check_once(const HttpRequest& request) {
  for (const std::string_view name :
       {"host", "origin", "content-length", "content-type", "x-somato-token"}) {
    if (!is_there(request, name) || request.header(name)) continue;
    return refuse(name == "host" || name == "origin" ? 403 : 400,
                  fmt::format("The header {} must occur only once.", name));
  }
  return {};
}

HttpResult<void> parse_length(HttpRequest& request, const HttpLimits& limits) {
  if (is_there(request, "transfer-encoding")) {
    return refuse(411, "Transfer encodings are not supported; send Content-Length.");
  }
  if (is_there(request, "expect")) return refuse(417, "The header Expect is not supported.");
  const auto length = request.header("content-length");
  if (!length) {
    if (request.method != "POST") return {};
    return refuse(411, "Content-Length is required.");
  }
  const char* end = length->data() + length->size();
  const auto [stop, error] = std::from_chars(length->data(), end, request.content_length);
  if (error == std::errc::result_out_of_range) return refuse(413, "The body is too large.");
  if (error != std::errc() || stop != end) {
    return refuse(400, "Content-Length is not a number.");
  }
  if (request.content_length > limits.body) {
    return refuse(413, fmt::format("The body must have at most {} bytes.", limits.body));
  }
  if (request.method == "POST" || request.content_length == 0) return {};
  return refuse(400, "Only POST requests may have a body.");
}

HttpResult<void> parse_headers(std::string_view text, HttpRequest& request,
                               const HttpLimits& limits) {
  while (const auto line = take_line(text)) {
    if (line->empty()) return {};
    if (request.headers.size() == limits.headers) {
      return refuse(431, fmt::format("At most {} headers are allowed.", limits.headers));
    }
    if (auto parsed = parse_header(*line, request); !parsed) return parsed;
  }
  return refuse(400, "The headers are incomplete.");
}

}  // namespace

std::optional<std::string> HttpRequest::header(std::string_view name) const {
  return only(headers, name);
}

std::optional<std::string> HttpRequest::parameter(std::string_view name) const {
  return only(parameters, name);
}

HttpResult<void> check_first_line(std::string_view bytes) {
  const auto line = take_line(bytes);
  HttpRequest request;
  return line ? parse_first_line(*line, request) : HttpResult<void>();
}

HttpResult<HttpRequest> parse_http_head(std::string_view head, const HttpLimits& limits) {
  if (head.size() > limits.head) {
    return refuse(431, fmt::format("The headers must have at most {} bytes.", limits.head));
  }
  HttpRequest request;
  const auto line = take_line(head);
  if (!line) return refuse(400, "Malformed HTTP/1.1 request.");
  const auto parsed = parse_first_line(*line, request)
                          .and_then([&] { return parse_headers(head, request, limits); })
                          .and_then([&] { return check_once(request); })
                          .and_then([&] { return parse_length(request, limits); });
  if (!parsed) return tl::unexpected(parsed.error());
  return request;
}

}  // namespace somato::live
