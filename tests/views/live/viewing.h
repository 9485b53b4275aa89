#pragma once

#include <memory>
#include <string>
#include <utility>

#include "systems/support/systems.h"
#include "views/http/event_hub.h"
#include "views/live/view_server.h"
#include "views/live/view_session.h"
#include "views/support/http_client.h"

namespace somato::testing {

/// Explorations of a hand without physics, each of a different object, to be played fast.
inline ViewSource hand_source(std::size_t explorations = 3) {
  ViewSource source;
  source.name = "hand.mcap";
  source.recording = hand_recording(explorations, 1);
  for (std::size_t i = 0; i < explorations; ++i) {
    source.recording.explorations[i].labels = {{"object", "object " + std::to_string(i % 2)}};
  }
  return source;
}

/// A client that does not wait.
inline ViewSettings at_once() {
  return {false, 100.0, 0.0, 0.0};
}

/// A session and its server, with a page of one line.
class Viewing {
 public:
  explicit Viewing(ViewSource source, const ViewSettings& settings = at_once(),
                   unsigned patience = 1000)
      : session_(std::move(source), settings) {
    session_.start();
    ViewServerSettings server;
    server.patience = patience;
    server_ =
        ViewServer::start(session_, {{"/", "text/html; charset=utf-8", "<p>page</p>"}}, server)
            .value();
  }

  ViewSession& session() { return session_; }
  std::uint16_t port() const { return server_->port(); }
  const std::string& token() const { return server_->token(); }

  std::string with_token(const std::string& path) const {
    return path + (path.find('?') == std::string::npos ? "?" : "&") + "token=" + token();
  }
  std::string get(const std::string& path) const {
    return ask(port(), get_request(port(), with_token(path)));
  }
  std::string command(const std::string& json) const {
    return ask(port(), post_request(port(), with_token("/api/command"), json));
  }

 private:
  ViewSession session_;
  std::unique_ptr<ViewServer> server_;
};

}  // namespace somato::testing
