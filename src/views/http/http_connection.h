#pragma once

#include <chrono>
#include <string>
#include <string_view>

#include "views/http/http_request.h"
#include "views/http/http_response.h"

namespace somato::live {

/// A connection that brings one request and takes one response. It owns the socket.
class HttpConnection {
 public:
  using Duration = std::chrono::milliseconds;

  /// `patience` is how long a request may take as a whole, and how long a client may take nothing
  /// of a response.
  HttpConnection(int socket, Duration patience);
  HttpConnection(const HttpConnection&) = delete;
  HttpConnection(HttpConnection&&) = delete;
  HttpConnection& operator=(const HttpConnection&) = delete;
  HttpConnection& operator=(HttpConnection&&) = delete;
  ~HttpConnection();

  /// Waits for a request. Refusals: those of parse_http_head(), and 408 for one that takes too long
  /// or ends before its end.
  HttpResult<HttpRequest> read(const HttpLimits& limits = {});

  /// Sends the response; for HEAD without its body. Returns whether all was taken.
  bool write(const HttpResponse& response, bool head_only);

  /// Stops readers and writers of this connection; can be called from any thread during the
  /// lifetime of this object.
  void interrupt() const;

 private:
  using Clock = std::chrono::steady_clock;

  bool wait(short event, Clock::time_point until) const;
  bool receive(std::string& bytes, Clock::time_point until) const;
  bool send_all(std::string_view bytes) const;
  void keep_buffer_empty() const;
  void leave() const;

  int socket_;
  Duration patience_;
};

}  // namespace somato::live
