#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace somato::testing {

/// A connection to a server on 127.0.0.1 that sends the given bytes, one by one if required.
class HttpClient {
 public:
  explicit HttpClient(std::uint16_t port);
  HttpClient(const HttpClient&) = delete;
  HttpClient(HttpClient&&) = delete;
  HttpClient& operator=(const HttpClient&) = delete;
  HttpClient& operator=(HttpClient&&) = delete;
  ~HttpClient();

  /// As much as the server takes.
  void send(const std::string& bytes) const;

  /// Nothing more comes from here.
  void finish() const;

  /// All that comes until the server closes the connection, or `patience` has passed.
  std::string receive(std::chrono::milliseconds patience = std::chrono::seconds(20)) const;

  /// All that comes until it holds `text`, or as above.
  std::string receive_until(const std::string& text,
                            std::chrono::milliseconds patience = std::chrono::seconds(20)) const;

 private:
  int socket_;
};

/// A browser's request, with its headers.
std::string get_request(std::uint16_t port, const std::string& target,
                        const std::vector<std::string>& headers = {});
std::string post_request(std::uint16_t port, const std::string& target, const std::string& body,
                         const std::vector<std::string>& headers = {});

/// The status of a response; 0 when it is none.
int status_of(const std::string& response);

/// The part behind its headers.
std::string body_of(const std::string& response);

/// One request and its response.
std::string ask(std::uint16_t port, const std::string& request);

}  // namespace somato::testing
