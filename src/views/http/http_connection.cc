#include "views/http/http_connection.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

namespace somato::live {

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
    if (!receive(bytes, until)) return refuse(408, "The request was incomplete, or took too long.");
    if (auto line = check_first_line(bytes); !line) return tl::unexpected(std::move(line.error()));
  }
  const std::size_t head = end == std::string::npos ? bytes.size() : end + 4;
  auto request = parse_http_head(std::string_view(bytes).substr(0, head), limits);
  if (!request) return request;
  bytes.erase(0, head);
  while (bytes.size() < request->content_length) {
    if (!receive(bytes, until)) return refuse(408, "The body was incomplete, or took too long.");
  }
  bytes.resize(request->content_length);
  request->body = std::move(bytes);
  return request;
}

// A slow line takes long for a large part, but some of it within the patience.
bool HttpConnection::send_all(std::string_view bytes) const {
  auto until = Clock::now() + patience_;
  while (!bytes.empty()) {
    if (!wait(POLLOUT, until)) return false;
    const ssize_t count = ::send(socket_, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (count < 0 && errno != EINTR && errno != EAGAIN) return false;
    if (count <= 0) continue;
    bytes.remove_prefix(static_cast<std::size_t>(count));
    until = Clock::now() + patience_;
  }
  return true;
}

// Nothing waits in the buffer of the system, which takes megabytes: a part of a stream is written
// when the one before has left, and a client that takes little is noticed to take something, which
// the system reports only when a third of its buffer is free. Only TCP has the option.
void HttpConnection::keep_buffer_empty() const {
  constexpr int kMostUnsent = 1;  // bytes
  ::setsockopt(socket_, IPPROTO_TCP, TCP_NOTSENT_LOWAT, &kMostUnsent, sizeof kMostUnsent);
}

bool HttpConnection::write(const HttpResponse& response, bool head_only) {
  keep_buffer_empty();
  bool taken = send_all(head_of(response));
  if (taken && !head_only && response.stream) {
    response.stream([this](std::string_view part) { return send_all(part); });
  } else if (taken && !head_only) {
    taken = send_all(response.body);
  }
  // The client has exceeded the time limit.
  if (response.status != 408) leave();
  return taken;
}

// Remaining data are received and discarded for a while: closing immediately would discard the
// response of a client that is still sending.
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
