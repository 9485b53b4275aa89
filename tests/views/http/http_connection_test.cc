#include "views/http/http_connection.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <pthread.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <string>
#include <thread>

namespace somato::live {
namespace {

std::atomic<int> signals_taken = 0;

void take_signal(int /*signal*/) {
  ++signals_taken;
}

// Counts SIGUSR1 while it lives, and interrupts what waits.
class Interruptions {
 public:
  Interruptions() {
    signals_taken = 0;
    struct sigaction action{};
    action.sa_handler = take_signal;
    ::sigaction(SIGUSR1, &action, &before_);
  }
  Interruptions(const Interruptions&) = delete;
  Interruptions(Interruptions&&) = delete;
  Interruptions& operator=(const Interruptions&) = delete;
  Interruptions& operator=(Interruptions&&) = delete;
  ~Interruptions() { ::sigaction(SIGUSR1, &before_, nullptr); }

  // One at a time, with time for the thread to wait again in between.
  static void send(std::thread& thread, int count) {
    for (int sent = 0; sent < count; ++sent) {
      ::pthread_kill(thread.native_handle(), SIGUSR1);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

 private:
  struct sigaction before_{};
};

TEST(HttpConnectionThread, WaitsOnWhenASignalInterruptsIt) {
  std::array<int, 2> sockets{};
  ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, sockets.data()), 0);
  const Interruptions interruptions;
  HttpConnection connection(sockets[0], std::chrono::minutes(1));
  HttpResult<HttpRequest> request = refuse(0, "nothing has come");
  std::thread reader([&] { request = connection.read(); });
  Interruptions::send(reader, 50);
  const std::string text = "GET /page HTTP/1.1\r\nHost: x\r\n\r\n";
  EXPECT_EQ(::write(sockets[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
  reader.join();
  ::close(sockets[1]);
  EXPECT_GT(signals_taken, 0);
  ASSERT_TRUE(request) << request.error().sentence;
  EXPECT_EQ(request->path, "/page");
}

// Both ends of a connection by TCP.
std::array<int, 2> tcp_sockets() {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* const any = reinterpret_cast<sockaddr*>(&address);
  const int listening = ::socket(AF_INET, SOCK_STREAM, 0);
  EXPECT_EQ(::bind(listening, any, size), 0);
  EXPECT_EQ(::listen(listening, 1), 0);
  EXPECT_EQ(::getsockname(listening, any, &size), 0);
  const int client = ::socket(AF_INET, SOCK_STREAM, 0);
  EXPECT_EQ(::connect(client, any, size), 0);
  const int server = ::accept(listening, nullptr, nullptr);
  ::close(listening);
  return {server, client};
}

TEST(HttpConnectionThread, KeepsNothingInTheBufferOfTheSystem) {
  const std::array<int, 2> sockets = tcp_sockets();
  HttpConnection connection(sockets[0], std::chrono::minutes(1));
  int unsent = 0;
  HttpResponse response;
  response.stream = [&](const HttpResponse::Write& write) {
    socklen_t size = sizeof unsent;
    EXPECT_EQ(::getsockopt(sockets[0], IPPROTO_TCP, TCP_NOTSENT_LOWAT, &unsent, &size), 0);
    EXPECT_TRUE(write("part"));
  };
  std::thread writer([&] { connection.write(response, false); });
  std::string received;
  std::array<char, 4096> part{};
  for (ssize_t count = 1; count > 0;) {
    count = ::recv(sockets[1], part.data(), part.size(), 0);
    received.append(part.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  }
  ::close(sockets[1]);
  writer.join();
  EXPECT_TRUE(received.ends_with("\r\n\r\npart"));
  EXPECT_EQ(unsent, 1);
}

}  // namespace
}  // namespace somato::live
