#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "somato/core/result.h"

namespace somato::topics {

/// The address of a WebSocket server.
struct WebSocketAddress {
  std::string host;
  int port = 0;
  std::string path = "/";
  bool encrypted = false;
};

/// The address in a text such as "ws://robot:8765" or "wss://robot/path". Errors (kUsage): it is
/// another kind of address.
Result<WebSocketAddress> parse_web_socket_address(const std::string& text);

/// A client of one WebSocket connection, used by one thread. After it is closed, another client is
/// needed.
class WebSocket {
 public:
  /// Called by serve(). `on_text` and `on_bytes` receive whole messages.
  struct Events {
    std::function<void()> on_open;
    std::function<void(std::string_view text)> on_text;
    std::function<void(std::string_view bytes)> on_bytes;
    std::function<void(const std::string& reason)> on_close;  ///< Once; or it could not connect.
  };

  /// Begins to connect. `subprotocols` are separated by commas. A message of more than
  /// `most_bytes` closes the connection. Errors (kSystem): the network cannot be used.
  static Result<std::unique_ptr<WebSocket>> connect(const WebSocketAddress& address,
                                                    const std::string& subprotocols,
                                                    std::size_t most_bytes, Events events);

  WebSocket(const WebSocket&) = delete;
  WebSocket(WebSocket&&) = delete;
  WebSocket& operator=(const WebSocket&) = delete;
  WebSocket& operator=(WebSocket&&) = delete;
  virtual ~WebSocket() = default;

  /// Waits for an event, at most for `seconds`, and reports all that have happened.
  virtual void serve(double seconds) = 0;

  /// Ends a wait of serve(); from any thread.
  virtual void wake() = 0;

  /// Sends a text message as soon as possible.
  virtual void send(std::string text) = 0;

 protected:
  WebSocket() = default;
};

}  // namespace somato::topics
