#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <vector>

namespace somato::testing {

/// A request that the pages never send, and the status with which it is refused.
struct HostileRequest {
  std::string name;
  std::string bytes;
  int status = 400;
  bool ends = true;  ///< Nothing follows; else the connection stays open and silent.
};

/// The conditions for a request: the address and the token, which is right unless it says so.
class HostileRequests {
 public:
  HostileRequests(std::uint16_t port, std::string token)
      : port_(port), token_(std::move(token)), host_(fmt::format("127.0.0.1:{}", port)) {}

  std::vector<HostileRequest> all() const {
    std::vector<HostileRequest> requests;
    for (const auto& part :
         {hosts(), origins(), tokens(), paths(), methods(), sizes(), forms(), commands()}) {
      requests.insert(requests.end(), part.begin(), part.end());
    }
    return requests;
  }

 private:
  using Requests = std::vector<HostileRequest>;

  std::string get(const std::string& target, const std::string& headers = "") const {
    return fmt::format("GET {} HTTP/1.1\r\nHost: {}\r\n{}\r\n", target, host_, headers);
  }
  std::string state() const { return "/api/state?token=" + token_; }

  std::string with_host(const std::string& lines) const {
    return fmt::format("GET {} HTTP/1.1\r\n{}\r\n", state(), lines);
  }

  std::string post(const std::string& headers, const std::string& body) const {
    return fmt::format("POST /api/command?token={} HTTP/1.1\r\nHost: {}\r\n{}\r\n{}", token_, host_,
                       headers, body);
  }
  std::string own() const { return fmt::format("Origin: http://{}\r\n", host_); }
  static std::string json() { return "Content-Type: application/json\r\n"; }
  static std::string length(std::size_t bytes) {
    return fmt::format("Content-Length: {}\r\n", bytes);
  }
  std::string command_request(const std::string& body) const {
    return post(own() + json() + length(body.size()), body);
  }

  // Names that may resolve to this machine, and names similar to those of the server.
  Requests hosts() const {
    Requests requests;
    const auto add = [&](const std::string& name, const std::string& host) {
      requests.push_back({"host " + name, with_host(fmt::format("Host: {}\r\n", host)), 403});
    };
    add("of somebody else", fmt::format("evil.example:{}", port_));
    add("that begins like ours", fmt::format("127.0.0.1.evil.example:{}", port_));
    add("of the network 127", fmt::format("127.0.0.2:{}", port_));
    add("with a trailing dot", fmt::format("localhost.:{}", port_));
    add("with another port", fmt::format("127.0.0.1:{}", port_ ^ 1));
    add("without a port", "127.0.0.1");
    add("in capitals", fmt::format("LOCALHOST:{}", port_));
    add("of IPv6 that is not bound", fmt::format("[::1]:{}", port_));
    add("of IPv4 in IPv6", fmt::format("[::ffff:127.0.0.1]:{}", port_));
    add("as one number", fmt::format("2130706433:{}", port_));
    add("as a short address", fmt::format("127.1:{}", port_));
    add("of any address", fmt::format("0.0.0.0:{}", port_));
    add("with a user", fmt::format("user@127.0.0.1:{}", port_));
    add("with more behind it", host_ + "/evil");
    add("that is empty", "");
    requests.push_back({"no host", with_host(""), 403});
    requests.push_back(
        {"two hosts", with_host(fmt::format("Host: {0}\r\nHost: {0}\r\n", host_)), 403});
    requests.push_back({"two hosts, one of them another's",
                        with_host(fmt::format("Host: {}\r\nHost: evil.example\r\n", host_)), 403});
    return requests;
  }

  Requests origins() const {
    const std::string body = R"({"command":"pause"})";
    const auto from = [&](const std::string& origin) {
      return post(origin + json() + length(body.size()), body);
    };
    return {
        {"no origin", from(""), 403},
        {"origin null", from("Origin: null\r\n"), 403},
        {"origin of somebody else", from("Origin: http://evil.example\r\n"), 403},
        {"origin that begins like ours", from(fmt::format("Origin: http://{}.evil\r\n", host_)),
         403},
        {"origin with another scheme", from(fmt::format("Origin: https://{}\r\n", host_)), 403},
        {"origin with another port", from("Origin: http://127.0.0.1:1\r\n"), 403},
        {"two origins", from(own() + own()), 403},
        {"origin with a path", from(fmt::format("Origin: http://{}/\r\n", host_)), 403},
        {"another type", post(own() + "Content-Type: text/plain\r\n" + length(body.size()), body),
         415},
        {"no type", post(own() + length(body.size()), body), 415},
        {"a form",
         post(own() + "Content-Type: application/x-www-form-urlencoded\r\n" + length(7), "a=b&c=d"),
         415}};
  }

  Requests tokens() const {
    std::string wrong = token_;
    wrong.back() = wrong.back() == '0' ? '1' : '0';
    return {{"no token", get("/api/state"), 403},
            {"an empty token", get("/api/state?token="), 403},
            {"half a token", get("/api/state?token=" + token_.substr(0, 16)), 403},
            {"too long a token", get("/api/state?token=" + token_ + "0"), 403},
            {"a wrong token", get("/api/state?token=" + wrong), 403},
            {"a token in capitals", get("/api/state?token=" + in_capitals()), 403},
            {"two tokens", get("/api/state?token=" + token_ + "&token=" + token_), 403},
            {"a wrong token in the header", get("/api/state", "X-Somato-Token: 00\r\n"), 403},
            {"events without a token", get("/api/events"), 403},
            {"a neuron without a token", get("/api/neuron?map=map&neuron=0"), 403},
            {"strips without a token", get("/api/strips"), 403},
            {"a token of broken characters", get("/api/state?token=%zz"), 400},
            {"a token of control characters", get("/api/state?token=%00%0a"), 400}};
  }

  std::string in_capitals() const {
    std::string text = token_;
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text == token_ ? text + "A" : text;
  }

  Requests paths() const {
    Requests requests;
    for (const char* path :
         {"/../etc/passwd", "/..%2f..%2fetc/passwd", "/%2e%2e/%2e%2e/etc/passwd",
          "/%252e%252e%252fetc/passwd", "/view.js/../../secret", "//etc/passwd", "/.git/config",
          "/..\\..\\windows", "/api/state/", "/API/STATE", "/index.html", "/view.js%00.html"}) {
      requests.push_back(
          {fmt::format("path {}", path), get(fmt::format("{}?token={}", path, token_)), 404});
    }
    requests.push_back({"a command by GET", get("/api/command?token=" + token_), 405});
    requests.push_back({"no map", get("/api/neuron?neuron=1&token=" + token_), 400});
    requests.push_back(
        {"a neuron below 0", get("/api/neuron?map=m&neuron=-1&token=" + token_), 400});
    requests.push_back({"a neuron beyond all numbers",
                        get("/api/neuron?map=m&neuron=99999999999999999999999&token=" + token_),
                        400});
    requests.push_back(
        {"a taxel that is no number", get("/api/taxel?element=1e3&token=" + token_), 400});
    return requests;
  }

  Requests methods() const {
    Requests requests;
    for (const char* method :
         {"PUT", "DELETE", "OPTIONS", "TRACE", "CONNECT", "PATCH", "get", "PRI"}) {
      requests.push_back({fmt::format("method {}", method),
                          fmt::format("{} {} HTTP/1.1\r\nHost: {}\r\n\r\n", method, state(), host_),
                          405});
    }
    return requests;
  }

  Requests sizes() const {
    std::string many;
    for (int i = 0; i < 200; ++i) many += fmt::format("X-{}: 1\r\n", i);
    return {
        {"a body of 10 MB", command_request(std::string(10'000'000, ' ')), 413},
        {"a body of 64 KiB and one", command_request(std::string(65537, ' ')), 413},
        {"a length beyond all numbers",
         post(own() + json() + "Content-Length: 99999999999999999999999\r\n", ""), 413},
        {"a length below 0", post(own() + json() + "Content-Length: -1\r\n", ""), 400},
        {"a length in words", post(own() + json() + "Content-Length: ten\r\n", ""), 400},
        {"two lengths", post(own() + json() + length(2) + length(20), "{}"), 400},
        {"no length", post(own() + json(), "{}"), 411},
        {"a body in chunks",
         post(own() + json() + "Transfer-Encoding: chunked\r\n", "2\r\n{}\r\n0\r\n\r\n"), 411},
        {"chunks and a length",
         post(own() + json() + length(2) + "Transfer-Encoding: chunked\r\n", "0\r\n\r\n"), 411},
        {"expects a response before the body",
         post(own() + json() + length(2) + "Expect: 100-continue\r\n", "{}"), 417},
        {"a body with GET", get(state(), length(5)) + "hello", 400},
        {"a header of 16 KiB", get(state(), "X-Long: " + std::string(16384, 'a') + "\r\n"), 431},
        {"a path of 16 KiB", get("/" + std::string(16384, 'a')), 431},
        {"200 headers", get(state(), many), 431},
        {"headers that never end", "GET / HTTP/1.1\r\nHost: " + host_ + "\r\nX-Slow: ", 408, false},
        {"half a body", post(own() + json() + length(100), "{\"comm"), 408, false},
        {"a body that ends too soon", post(own() + json() + length(100), "{}"), 408},
        {"nothing at all", "", 408, false},
        {"nothing, and the end", "", 408}};
  }

  Requests forms() const {
    const std::string rest = fmt::format(" HTTP/1.1\r\nHost: {}\r\n\r\n", host_);
    return {{"an address for a path", "GET http://" + host_ + state() + rest, 400},
            {"another's address for a path", "GET http://evil.example/" + rest, 400},
            {"a path without a slash", "GET api/state" + rest, 400},
            {"a star for a path", "GET *" + rest, 400},
            {"HTTP/0.9", "GET /\r\n\r\n", 400},
            {"HTTP/2.0", "GET / HTTP/2.0\r\nHost: " + host_ + "\r\n\r\n", 400},
            {"HTTP/1.10", "GET / HTTP/1.10\r\nHost: " + host_ + "\r\n\r\n", 400},
            {"lines that end in LF only",
             fmt::format("GET {} HTTP/1.1\nHost: {}\n\n", state(), host_), 408},
            {"a NUL in the path", std::string("GET /\0 HTTP/1.1\r\n", 17) + "Host: x\r\n\r\n", 400},
            {"a NUL in a header", get(state(), std::string("X: a\0b\r\n", 8)), 400},
            {"letters beyond ASCII", "GET /\xC3\xA4" + rest, 400},
            {"a header over two lines", get(state(), "X: a\r\n b: c\r\n"), 400},
            {"a header without a colon", get(state(), "nonsense\r\n"), 400},
            {"a header without a name", get(state(), ": a\r\n"), 400},
            {"a space before the colon", get(state(), "X : a\r\n"), 400},
            {"a lone CR in a header", get(state(), "X: a\rb\r\n"), 400},
            {"greeting of TLS",
             std::string("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03\r\n\r\n", 15), 400},
            {"noise", "\x01\x02\x03\xff\xfe\r\n\r\n", 400},
            {"an empty line first", "\r\n" + get(state()), 400}};
  }

  Requests commands() const {
    Requests requests;
    for (const char* body : {"",
                             "{",
                             "[]",
                             "null",
                             "\"play\"",
                             "{}",
                             R"({"command":1})",
                             R"({"command":"fly"})",
                             R"({"command":"play","and":1})",
                             R"({"command":"speed"})",
                             R"({"command":"speed","speed":"2"})",
                             R"({"command":"speed","speed":0})",
                             R"({"command":"speed","speed":1e9})",
                             R"({"command":"speed","speed":null})",
                             R"({"command":"step","frames":0.5})",
                             R"({"command":"step","frames":1e300})",
                             R"({"command":"seek","exploration":-1,"frame":0})",
                             R"({"command":"seek","exploration":1e9,"frame":0})",
                             R"({"command":"seek","exploration":0,"frame":1e9})",
                             R"({"command":"thing","name":"boule"})",
                             R"({"command":"placement","x":1e6,"y":0,"turn":0})",
                             R"({"command":"explore"})",
                             R"({"command":"system","name":"none"})",
                             R"({"command":"train"})",
                             "{\"command\":\"\xff\xfe\"}",
                             R"({"command":"play"}{"command":"pause"})",
                             R"({"command":"speed","speed":NaN})"}) {
      requests.push_back({fmt::format("command {}", body), command_request(body), 400});
    }
    requests.push_back(
        {"a command that is nested deeply", command_request(std::string(60000, '[')), 400});
    requests.push_back(
        {"a command to another path",
         fmt::format("POST /api/state?token={} HTTP/1.1\r\nHost: {}\r\n{}{}{}\r\n{{}}", token_,
                     host_, own(), json(), length(2)),
         404});
    return requests;
  }

  std::uint16_t port_;
  std::string token_;
  std::string host_;
};

}  // namespace somato::testing
