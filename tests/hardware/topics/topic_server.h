#pragma once

#include <libwebsockets.h>

#include <atomic>
#include <cstdint>
#include <cstring>
#include <deque>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/archives/little_endian.h"

namespace somato::testing {

/// A server of the Foxglove WebSocket protocol for tests, on a port of the loopback. It sends what
/// the test gives it, whole messages or not of the protocol, to its only client.
class TopicServer {
 public:
  /// Listens on `port`, or on any free one.
  explicit TopicServer(int port = 0) {
    lws_set_log_level(0, nullptr);
    lws_context_creation_info info{};
    info.port = port;
    info.iface = "127.0.0.1";
    info.protocols = kProtocols;
    info.user = this;
    info.options = LWS_SERVER_OPTION_EXPLICIT_VHOSTS;
    context_ = lws_create_context(&info);
    lws_vhost* host = context_ == nullptr ? nullptr : lws_create_vhost(context_, &info);
    if (host != nullptr) port_ = lws_get_vhost_listen_port(host);
    thread_ = std::thread([this] {
      while (!stopping_) lws_service(context_, 0);
    });
  }
  TopicServer(const TopicServer&) = delete;
  TopicServer(TopicServer&&) = delete;
  TopicServer& operator=(const TopicServer&) = delete;
  TopicServer& operator=(TopicServer&&) = delete;
  ~TopicServer() {
    stopping_ = true;
    lws_cancel_service(context_);
    thread_.join();
    lws_context_destroy(context_);
  }

  int port() const { return port_; }
  std::string address() const { return "ws://127.0.0.1:" + std::to_string(port_); }

  /// Sent to every client when it connects.
  void greet(std::string text) {
    const std::scoped_lock lock(mutex_);
    greetings_.push_back(std::move(text));
  }
  void advertise(std::uint32_t id, const std::string& topic, const std::string& definition) {
    greet(advertisement(id, topic, definition));
  }
  static std::string advertisement(std::uint32_t id, const std::string& topic,
                                   const std::string& definition) {
    return R"({"op":"advertise","channels":[{"id":)" + std::to_string(id) + R"(,"topic":")" +
           topic + R"(","encoding":"cdr","schemaName":"test_msgs/msg/Touch","schema":")" +
           definition + R"(","schemaEncoding":"ros2msg"}]})";
  }

  void send_text(std::string text) { send({false, std::move(text)}); }
  void send_bytes(std::string bytes) { send({true, std::move(bytes)}); }

  /// A message of a topic with one float32, at a time in ns.
  void send_number(std::uint32_t subscription, std::uint64_t time, float value) {
    std::string bytes(1, '\1');
    append_little_endian(bytes, subscription);
    append_little_endian(bytes, time);
    bytes += std::string("\0\1\0\0", 4);
    append_little_endian(bytes, value);
    send_bytes(std::move(bytes));
  }

  /// The messages of all clients.
  std::vector<std::string> received() const {
    const std::scoped_lock lock(mutex_);
    return received_;
  }

 private:
  using Message = std::pair<bool, std::string>;  // whether it is binary

  void send(Message message) {
    {
      const std::scoped_lock lock(mutex_);
      unsent_.push_back(std::move(message));
    }
    lws_cancel_service(context_);
  }

  static int called(lws* socket, lws_callback_reasons reason, void*, void* in, std::size_t size) {
    auto* self = static_cast<TopicServer*>(lws_context_user(lws_get_context(socket)));
    return self == nullptr ? 0 : self->handle(socket, reason, static_cast<const char*>(in), size);
  }

  int handle(lws* socket, lws_callback_reasons reason, const char* in, std::size_t size) {
    const std::scoped_lock lock(mutex_);
    switch (reason) {
      case LWS_CALLBACK_ESTABLISHED:
        client_ = socket;
        unsent_.clear();
        for (const std::string& text : greetings_) unsent_.emplace_back(false, text);
        lws_callback_on_writable(socket);
        return 0;
      case LWS_CALLBACK_CLOSED:
        if (client_ == socket) client_ = nullptr;
        return 0;
      case LWS_CALLBACK_RECEIVE:
        received_.emplace_back(in, size);
        return 0;
      case LWS_CALLBACK_EVENT_WAIT_CANCELLED:
        if (client_ != nullptr) lws_callback_on_writable(client_);
        return 0;
      case LWS_CALLBACK_SERVER_WRITEABLE:
        return write(socket);
      default:
        return 0;
    }
  }

  int write(lws* socket) {
    if (unsent_.empty()) return 0;
    const auto& [binary, content] = unsent_.front();
    std::vector<unsigned char> bytes(LWS_PRE + content.size());
    std::memcpy(bytes.data() + LWS_PRE, content.data(), content.size());
    lws_write(socket, bytes.data() + LWS_PRE, content.size(),
              binary ? LWS_WRITE_BINARY : LWS_WRITE_TEXT);
    unsent_.pop_front();
    if (!unsent_.empty()) lws_callback_on_writable(socket);
    return 0;
  }

  static inline const lws_protocols kProtocols[] = {
      {"foxglove.sdk.v1", called, 0, 65536, 0, nullptr, 0}, {}};

  // libwebsockets 4.3 calls back for a change of what it polls, within lws_callback_on_writable().
  mutable std::recursive_mutex mutex_;
  std::vector<std::string> greetings_;
  std::deque<Message> unsent_;
  std::vector<std::string> received_;
  lws* client_ = nullptr;
  std::atomic<bool> stopping_ = false;
  int port_ = 0;
  lws_context* context_ = nullptr;
  std::thread thread_;
};

}  // namespace somato::testing
