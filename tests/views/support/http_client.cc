#include "views/support/http_client.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace somato::testing {

HttpClient::HttpClient(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    ::close(socket_);
    throw std::runtime_error("no server is listening");
  }
}

HttpClient::~HttpClient() {
  ::close(socket_);
}

void HttpClient::send(const std::string& bytes) const {
  std::size_t sent = 0;
  while (sent < bytes.size()) {
    const ssize_t count = ::send(socket_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
    if (count <= 0) return;
    sent += static_cast<std::size_t>(count);
  }
}

void HttpClient::finish() const {
  ::shutdown(socket_, SHUT_WR);
}

std::string HttpClient::receive(std::chrono::milliseconds patience) const {
  return receive_until("", patience);
}

std::string HttpClient::receive_until(const std::string& text,
                                      std::chrono::milliseconds patience) const {
  const auto until = std::chrono::steady_clock::now() + patience;
  std::string received;
  std::array<char, 65536> part{};
  while (text.empty() || received.find(text) == std::string::npos) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        until - std::chrono::steady_clock::now());
    pollfd waiting{socket_, POLLIN, 0};
    if (left.count() <= 0 || ::poll(&waiting, 1, static_cast<int>(left.count())) <= 0) break;
    const ssize_t count = ::recv(socket_, part.data(), part.size(), 0);
    if (count <= 0) break;
    received.append(part.data(), static_cast<std::size_t>(count));
  }
  return received;
}

std::string get_request(std::uint16_t port, const std::string& target,
                        const std::vector<std::string>& headers) {
  std::string request = fmt::format("GET {} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n", target, port);
  for (const std::string& header : headers) request += fmt::format("{}\r\n", header);
  return request + "\r\n";
}

std::string post_request(std::uint16_t port, const std::string& target, const std::string& body,
                         const std::vector<std::string>& headers) {
  std::string request = fmt::format(
      "POST {0} HTTP/1.1\r\nHost: 127.0.0.1:{1}\r\nOrigin: http://127.0.0.1:{1}\r\n"
      "Content-Type: application/json\r\nContent-Length: {2}\r\n",
      target, port, body.size());
  for (const std::string& header : headers) request += fmt::format("{}\r\n", header);
  return fmt::format("{}\r\n{}", request, body);
}

int status_of(const std::string& response) {
  if (!response.starts_with("HTTP/1.1 ") || response.size() < 12) return 0;
  return std::stoi(response.substr(9, 3));
}

std::string body_of(const std::string& response) {
  const std::size_t end = response.find("\r\n\r\n");
  return end == std::string::npos ? "" : response.substr(end + 4);
}

std::string ask(std::uint16_t port, const std::string& request) {
  const HttpClient client(port);
  client.send(request);
  return client.receive();
}

}  // namespace somato::testing
