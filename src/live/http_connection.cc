#include "live/http_connection.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

namespace somato::live {
namespace {

std::string_view reason_of(int status) {
  switch (status) {
    case 200:
      return "OK";
    case 400:
      return "Bad Request";
    case 403:
      return "Forbidden";
    case 404:
      return "Not Found";
    case 405:
      return "Method Not Allowed";
    case 408:
      return "Request Timeout";
    case 411:
      return "Length Required";
    case 413:
      return "Content Too Large";
    case 415:
      return "Unsupported Media Type";
    case 417:
      return "Expectation Failed";
    case 431:
      return "Request Header Fields Too Large";
    case 503:
      return "Service Unavailable";
    default:
      return "Error";
  }
}

// What a browser is told with everything: nothing from elsewhere, nothing kept, nobody around it.
constexpr std::string_view kSafety =
    "Content-Security-Policy: default-src 'none'; script-src 'self'; style-src 'self'; connect-src "
    "'self'; img-src 'self' data: blob:; base-uri 'none'; form-action 'none'; frame-ancestors "
    "'none'\r\n"
    "X-Content-Type-Options: nosniff\r\n"
    "X-Frame-Options: DENY\r\n"
    "Referrer-Policy: no-referrer\r\n"
    "Cache-Control: no-store\r\n"
    "Cross-Origin-Opener-Policy: same-origin\r\n"
    "Cross-Origin-Resource-Policy: same-origin\r\n"
    "Connection: close\r\n";

std::string head_of(const HttpResponse& response) {
  std::string head = fmt::format("HTTP/1.1 {} {}\r\nContent-Type: {}\r\n{}", response.status,
                                 reason_of(response.status), response.type, kSafety);
  for (const auto& [name, value] : response.headers) {
    head += fmt::format("{}: {}\r\n", name, value);
  }
  if (!response.stream) head += fmt::format("Content-Length: {}\r\n", response.body.size());
  return head + "\r\n";
}

}  // namespace

HttpResponse response_of(const HttpRefusal& refusal) {
  HttpResponse response;
  response.status = refusal.status;
  response.body = refusal.sentence + "\n";
  if (refusal.status == 405) response.headers.emplace_back("Allow", "GET, HEAD, POST");
  return response;
}

HttpConnection::HttpConnection(int socket, Duration patience)
    : socket_(socket), patience_(patience) {}

HttpConnection::~HttpConnection() {
  ::close(socket_);
}

void HttpConnection::interrupt() const {
  ::shutdown(socket_, SHUT_RDWR);
}

bool HttpConnection::wait(short event, Clock::time_point until) const {
  for (;;) {
    const auto left = std::chrono::duration_cast<Duration>(until - Clock::now());
    if (left.count() <= 0) return false;
    pollfd waiting{socket_, event, 0};
    const int ready = ::poll(&waiting, 1, static_cast<int>(left.count()));
    if (ready > 0) return true;
    if (ready == 0 || errno != EINTR) return false;
  }
}

bool HttpConnection::receive(std::string& bytes, Clock::time_point until) const {
  std::array<char, 4096> part{};
  if (!wait(POLLIN, until)) return false;
  const ssize_t count = ::recv(socket_, part.data(), part.size(), MSG_DONTWAIT);
  if (count < 0) return errno == EINTR || errno == EAGAIN;
  bytes.append(part.data(), static_cast<std::size_t>(count));
  return count > 0;
}

HttpResult<HttpRequest> HttpConnection::read(const HttpLimits& limits) {
  const auto until = Clock::now() + patience_;
  std::string bytes;
  std::size_t end = std::string::npos;
  while ((end = bytes.find("\r\n\r\n")) == std::string::npos && bytes.size() <= limits.head) {
    if (!receive(bytes, until)) return refuse(408, "The request took too long, or ended too soon.");
    if (auto line = check_first_line(bytes); !line) return tl::unexpected(std::move(line.error()));
  }
  const std::size_t head = end == std::string::npos ? bytes.size() : end + 4;
  auto request = parse_http_head(std::string_view(bytes).substr(0, head), limits);
  if (!request) return request;
  bytes.erase(0, head);
  while (bytes.size() < request->content_length) {
    if (!receive(bytes, until)) return refuse(408, "The body took too long, or ended too soon.");
  }
  bytes.resize(request->content_length);
  request->body = std::move(bytes);
  return request;
}

bool HttpConnection::send_all(std::string_view bytes) const {
  const auto until = Clock::now() + patience_;
  while (!bytes.empty()) {
    if (!wait(POLLOUT, until)) return false;
    const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count < 0 && errno != EINTR && errno != EAGAIN) return false;
    bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  }
  return true;
}

bool HttpConnection::write(const HttpResponse& response, bool head_only) {
  bool taken = send_all(head_of(response));
  if (taken && !head_only && response.stream) {
    response.stream([this](std::string_view part) { return send_all(part); });
  } else if (taken && !head_only) {
    taken = send_all(response.body);
  }
  // Whoever has been silent for too long has nothing left to say.
  if (response.status != 408) leave();
  return taken;
}

// What is still coming is taken and dropped for a while: closing at once would take the response
// away from whoever is not done with asking.
void HttpConnection::leave() const {
  constexpr std::size_t kMost = std::size_t{32} << 20;
  ::shutdown(socket_, SHUT_WR);
  const auto until = Clock::now() + std::min<Duration>(patience_, std::chrono::seconds(1));
  std::string dropped;
  for (std::size_t count = 0; count < kMost && receive(dropped, until); dropped.clear()) {
    count += dropped.size();
  }
}

}  // namespace somato::live
