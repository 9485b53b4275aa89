#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <thread>

#include "somato/core/result.h"
#include "views/http/http_connection.h"

namespace somato::live {

/// Answers HTTP requests, each connection in a separate thread; http_request.h describes the
/// accepted requests. There are at most `connections` at a time: further clients are advised to try
/// again later.
class HttpServer {
 public:
  using Answer = std::function<HttpResponse(const HttpRequest&)>;

  struct Settings {
    std::string address = "127.0.0.1";  ///< Of IPv4 or IPv6, in digits.
    std::uint16_t port = 0;             ///< 0: any that is free.
    std::size_t connections = 64;
    std::chrono::milliseconds patience{5000};
  };

  HttpServer() = default;
  HttpServer(const HttpServer&) = delete;
  HttpServer(HttpServer&&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;
  HttpServer& operator=(HttpServer&&) = delete;
  ~HttpServer();

  /// Binds the port; no request is answered yet. Errors: kUsage for an invalid address, kSystem
  /// with the system's reason.
  Result<void> bind(const Settings& settings);

  /// The port that was taken.
  std::uint16_t port() const { return port_; }

  /// Begins to answer; `answer` is called from several threads at once.
  void start(Answer answer);

  /// Ends all connections and waits for their threads. A stream must end when it cannot write.
  void stop();

 private:
  struct Visit {
    Visit(int socket, std::chrono::milliseconds patience) : connection(socket, patience) {}
    HttpConnection connection;
    std::thread thread;
    std::atomic<bool> done = false;
  };

  void accept_all();
  void accept_one();
  static void turn_away(Visit& visit);
  void serve(Visit& visit);
  HttpResponse answer_to(const HttpRequest& request) const;
  void collect();

  Settings settings_;
  Answer answer_;
  int socket_ = -1;
  std::uint16_t port_ = 0;
  std::atomic<bool> stopping_ = false;
  std::thread acceptor_;
  std::mutex mutex_;
  std::list<Visit> visits_;
};

}  // namespace somato::live
