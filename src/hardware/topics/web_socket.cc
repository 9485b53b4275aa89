#include "hardware/topics/web_socket.h"

#include <fmt/format.h>
#include <libwebsockets.h>

#include <array>
#include <chrono>
#include <cstring>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "base/text/number_of_text.h"

namespace somato::topics {
namespace {

constexpr const char* kAddressAdvice = "write it as ws://HOST:PORT, such as ws://robot:8765";

tl::unexpected<Error> no_address(const std::string& what, const std::string& text) {
  return fail(ErrorKind::kUsage, what, text, kAddressAdvice);
}

// Removes `prefix` from the beginning of `text`, if it begins with it.
bool take_prefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

std::optional<int> port_in(std::string_view text) {
  const auto port = number_of_text<int>(text);
  return port && *port >= 1 && *port <= 65535 ? port : std::nullopt;
}

// The connection by libwebsockets, whose context has this one connection.
class LwsSocket : public WebSocket {
 public:
  LwsSocket(WebSocketAddress address, std::string subprotocols, std::size_t most_bytes,
            Events events)
      : address_(std::move(address)),
        subprotocols_(std::move(subprotocols)),
        most_bytes_(most_bytes),
        events_(std::move(events)) {}

  LwsSocket(const LwsSocket&) = delete;
  LwsSocket(LwsSocket&&) = delete;
  LwsSocket& operator=(const LwsSocket&) = delete;
  LwsSocket& operator=(LwsSocket&&) = delete;
  // Callbacks during the destruction of the context are no events.
  ~LwsSocket() override { closed_ = true; }

  Result<void> begin() {
    lws_set_log_level(0, nullptr);
    lws_context_creation_info info{};
    info.port = CONTEXT_PORT_NO_LISTEN;
    info.protocols = protocols_.data();
    info.options = LWS_SERVER_OPTION_DO_SSL_GLOBAL_INIT;
    info.connect_timeout_secs = kConnectSeconds;
    context_.reset(lws_create_context(&info));
    if (!context_) return fail(ErrorKind::kSystem, "the network cannot be used", address_.host);
    lws_client_connect_info connection{};
    connection.context = context_.get();
    connection.address = address_.host.c_str();
    connection.host = address_.host.c_str();
    connection.origin = address_.host.c_str();
    connection.port = address_.port;
    connection.path = address_.path.c_str();
    connection.protocol = subprotocols_.c_str();
    connection.local_protocol_name = protocols_.front().name;
    connection.ssl_connection = address_.encrypted ? LCCSCF_USE_SSL : 0;
    connection.opaque_user_data = this;
    connection.pwsi = &socket_;
    if (lws_client_connect_via_info(&connection) == nullptr) close("no connection");
    return {};
  }

  // A wait ends at the first event; the timer of the library ends it after `seconds`.
  void serve(double seconds) override {
    if (closed_) return;
    lws_sul_schedule(
        context_.get(), 0, &timer_, [](lws_sorted_usec_list_t*) {},
        static_cast<lws_usec_t>(seconds * LWS_US_PER_SEC));
    lws_service(context_.get(), 0);
  }

  void wake() override { lws_cancel_service(context_.get()); }

  void send(std::string text) override {
    unsent_.push_back(std::move(text));
    if (socket_ != nullptr) lws_callback_on_writable(socket_);
  }

 private:
  struct DestroyContext {
    void operator()(lws_context* context) const { lws_context_destroy(context); }
  };

  static int called(lws* socket, lws_callback_reasons reason, void*, void* in, std::size_t size) {
    auto* self = static_cast<LwsSocket*>(lws_get_opaque_user_data(socket));
    return self == nullptr ? 0 : self->handle(socket, reason, static_cast<const char*>(in), size);
  }

  int handle(lws* socket, lws_callback_reasons reason, const char* in, std::size_t size) {
    if (closed_) return 0;
    switch (reason) {
      case LWS_CALLBACK_CLIENT_ESTABLISHED:
        events_.on_open();
        return 0;
      case LWS_CALLBACK_CLIENT_CONNECTION_ERROR:
        close(in == nullptr ? "no connection" : std::string(in, size));
        return 0;
      case LWS_CALLBACK_CLIENT_RECEIVE:
        return receive(socket, {in, size});
      case LWS_CALLBACK_CLIENT_WRITEABLE:
        return write(socket);
      case LWS_CALLBACK_CLIENT_CLOSED:
        close(too_long_ ? fmt::format("a message has more than {} bytes", most_bytes_)
                        : "the connection was closed");
        return 0;
      default:
        return 0;
    }
  }

  int receive(lws* socket, std::string_view part) {
    if (message_.size() + part.size() > most_bytes_) {
      too_long_ = true;
      return -1;
    }
    message_.append(part);
    if (lws_is_final_fragment(socket) == 0 || lws_remaining_packet_payload(socket) > 0) return 0;
    if (lws_frame_is_binary(socket) != 0) {
      events_.on_bytes(message_);
    } else {
      events_.on_text(message_);
    }
    message_.clear();
    return 0;
  }

  int write(lws* socket) {
    if (unsent_.empty()) return 0;
    std::vector<unsigned char> bytes(LWS_PRE + unsent_.front().size());
    std::memcpy(bytes.data() + LWS_PRE, unsent_.front().data(), unsent_.front().size());
    const std::size_t size = unsent_.front().size();
    if (lws_write(socket, bytes.data() + LWS_PRE, size, LWS_WRITE_TEXT) < 0) return -1;
    unsent_.pop_front();
    if (!unsent_.empty()) lws_callback_on_writable(socket);
    return 0;
  }

  void close(const std::string& reason) {
    if (closed_) return;
    closed_ = true;
    socket_ = nullptr;
    events_.on_close(reason);
  }

  static constexpr unsigned kConnectSeconds = 5;
  static constexpr std::size_t kReceiveBytes = 65536;

  WebSocketAddress address_;
  std::string subprotocols_;
  std::size_t most_bytes_;
  Events events_;
  std::array<lws_protocols, 2> protocols_{
      lws_protocols{"topics", called, 0, kReceiveBytes, 0, nullptr, 0}, lws_protocols{}};
  lws* socket_ = nullptr;
  lws_sorted_usec_list_t timer_{};
  std::string message_;
  std::deque<std::string> unsent_;
  bool closed_ = false;
  bool too_long_ = false;
  std::unique_ptr<lws_context, DestroyContext> context_;  // ends before the rest
};

}  // namespace

Result<WebSocketAddress> parse_web_socket_address(const std::string& text) {
  std::string_view rest = text;
  WebSocketAddress address;
  address.encrypted = take_prefix(rest, "wss://");
  if (!address.encrypted && !take_prefix(rest, "ws://")) {
    return no_address("not the address of a WebSocket server", text);
  }
  address.port = address.encrypted ? 443 : 80;
  if (const std::size_t slash = rest.find('/'); slash != std::string_view::npos) {
    address.path = rest.substr(slash);
    rest = rest.substr(0, slash);
  }
  const std::size_t bracket = rest.rfind(']');  // an address of IPv6 contains colons
  const std::size_t colon = rest.rfind(':');
  if (colon != std::string_view::npos && (bracket == std::string_view::npos || colon > bracket)) {
    const auto port = port_in(rest.substr(colon + 1));
    if (!port) return no_address("the port is not a number from 1 to 65535", text);
    address.port = *port;
    rest = rest.substr(0, colon);
  }
  if (rest.starts_with('[') && rest.ends_with(']')) rest = rest.substr(1, rest.size() - 2);
  if (rest.empty()) return no_address("the address has no host", text);
  address.host = rest;
  return address;
}

Result<std::unique_ptr<WebSocket>> WebSocket::connect(const WebSocketAddress& address,
                                                      const std::string& subprotocols,
                                                      std::size_t most_bytes, Events events) {
  auto socket = std::make_unique<LwsSocket>(address, subprotocols, most_bytes, std::move(events));
  SOMATO_TRY_VOID(socket->begin());
  return std::unique_ptr<WebSocket>(std::move(socket));
}

}  // namespace somato::topics
