#include "views/http/http_server.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <system_error>
#include <utility>

namespace somato::live {
namespace {

constexpr std::size_t kTurnedAway = 64;  // that receive this response at a time

// An address of either family as the system wants it.
struct SocketAddress {
  sockaddr_storage storage{};
  socklen_t size = 0;

  sockaddr* get() { return reinterpret_cast<sockaddr*>(&storage); }
  sockaddr_in& v4() { return reinterpret_cast<sockaddr_in&>(storage); }
  sockaddr_in6& v6() { return reinterpret_cast<sockaddr_in6&>(storage); }
};

Result<SocketAddress> socket_address(const std::string& text, std::uint16_t port) {
  SocketAddress address;
  if (inet_pton(AF_INET, text.c_str(), &address.v4().sin_addr) == 1) {
    address.v4().sin_family = AF_INET;
    address.v4().sin_port = htons(port);
    address.size = sizeof(sockaddr_in);
    return address;
  }
  if (inet_pton(AF_INET6, text.c_str(), &address.v6().sin6_addr) == 1) {
    address.v6().sin6_family = AF_INET6;
    address.v6().sin6_port = htons(port);
    address.size = sizeof(sockaddr_in6);
    return address;
  }
  return fail(ErrorKind::kUsage, fmt::format("'{}' is not a numeric IP address", text), {},
              "use an address such as 127.0.0.1");
}

tl::unexpected<Error> system_refused(const HttpServer::Settings& settings) {
  return fail(ErrorKind::kSystem, std::generic_category().message(errno),
              fmt::format("{}:{}", settings.address, settings.port),
              errno == EADDRINUSE ? "use another port, or omit it to use any free port" : "");
}

}  // namespace

HttpServer::~HttpServer() {
  stop();
  if (socket_ >= 0) ::close(socket_);
}

Result<void> HttpServer::bind(const Settings& settings) {
  settings_ = settings;
  SOMATO_TRY(auto address, socket_address(settings.address, settings.port));
  socket_ = ::socket(address.storage.ss_family, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (socket_ < 0) return system_refused(settings);
  // A port that this program used shortly before can be used again.
  const int yes = 1;
  ::setsockopt(socket_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  if (::bind(socket_, address.get(), address.size) != 0) return system_refused(settings);
  if (::listen(socket_, SOMAXCONN) != 0) return system_refused(settings);
  if (::getsockname(socket_, address.get(), &address.size) != 0) return system_refused(settings);
  // The port stands at the same place in both families.
  port_ = ntohs(address.v4().sin_port);
  return {};
}

void HttpServer::start(Answer answer) {
  answer_ = std::move(answer);
  acceptor_ = std::thread([this] { accept_all(); });
}

void HttpServer::stop() {
  stopping_ = true;
  if (acceptor_.joinable()) acceptor_.join();
  const std::scoped_lock lock(mutex_);
  for (const Visit& visit : visits_) visit.connection.interrupt();
  for (Visit& visit : visits_) visit.thread.join();
  visits_.clear();
}

void HttpServer::accept_all() {
  constexpr int kLook = 50;  // ms; interval of checks whether to stop
  while (!stopping_) {
    pollfd waiting{socket_, POLLIN, 0};
    if (::poll(&waiting, 1, kLook) > 0) accept_one();
    collect();
  }
}

void HttpServer::accept_one() {
  const int socket = ::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC);
  if (socket < 0) {
    // Too many files are open: a connection must be closed first.
    if (errno == EMFILE || errno == ENFILE) std::this_thread::sleep_for(settings_.patience / 100);
    return;
  }
  collect();
  const std::scoped_lock lock(mutex_);
  const bool is_full = visits_.size() >= settings_.connections;
  if (visits_.size() >= settings_.connections + kTurnedAway) {
    ::close(socket);
    return;
  }
  Visit& visit = visits_.emplace_back(socket, settings_.patience);
  try {
    visit.thread =
        std::thread([this, &visit, is_full] { is_full ? turn_away(visit) : serve(visit); });
  } catch (const std::system_error&) {
    visits_.pop_back();
  }
}

void HttpServer::turn_away(Visit& visit) {
  try {
    visit.connection.write(response_of({503, "Too many connections; try again later."}), false);
  } catch (const std::exception&) {
    visit.connection.interrupt();
  }
  visit.done = true;
}

void HttpServer::serve(Visit& visit) {
  try {
    const auto request = visit.connection.read();
    const bool head_only = request && request->method == "HEAD";
    visit.connection.write(request ? answer_to(*request) : response_of(request.error()), head_only);
  } catch (const std::exception&) {
    visit.connection.interrupt();
  }
  visit.done = true;
}

// An internal error must not end the program.
HttpResponse HttpServer::answer_to(const HttpRequest& request) const {
  try {
    return answer_(request);
  } catch (const std::exception&) {
    return response_of({500, "Internal error."});
  }
}

void HttpServer::collect() {
  const std::scoped_lock lock(mutex_);
  for (auto visit = visits_.begin(); visit != visits_.end();) {
    if (!visit->done) {
      ++visit;
      continue;
    }
    visit->thread.join();
    visit = visits_.erase(visit);
  }
}

}  // namespace somato::live
