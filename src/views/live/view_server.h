#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "views/live/view_session.h"

namespace somato {

/// A file of the page that is served.
struct ViewPage {
  std::string path;  ///< Such as "/" or "/view.js".
  std::string type;  ///< Such as "text/html; charset=utf-8".
  std::string text;
};

struct ViewServerSettings {
  std::string address = "127.0.0.1";  ///< To be reached at, in digits.
  std::uint16_t port = 0;             ///< 0: any that is free.
  std::size_t viewers = 16;           ///< At most.
  std::size_t connections = 64;       ///< At most at a time, those of the viewers among them.
  unsigned patience = 5000;           ///< Milliseconds for a request, or any part of an answer.
};

/// Serves a session to browsers of this machine, as docs/formats/view.md describes. Visitors
/// who have not opened the start address are refused.
class ViewServer {
 public:
  /// Takes a port and begins to serve. The session must outlive the server, and be stopped after
  /// it. Errors: kUsage for an address that is none; kSystem with the system's reason.
  static Result<std::unique_ptr<ViewServer>> start(ViewSession& session,
                                                   std::vector<ViewPage> pages,
                                                   const ViewServerSettings& settings = {});

  ViewServer(const ViewServer&) = delete;
  ViewServer(ViewServer&&) = delete;
  ViewServer& operator=(const ViewServer&) = delete;
  ViewServer& operator=(ViewServer&&) = delete;
  ~ViewServer();

  /// Such as "http://127.0.0.1:40123/?token=...": with it anyone on this machine may come in.
  std::string start_address() const;

  std::uint16_t port() const;
  const std::string& token() const;

 private:
  class Impl;
  explicit ViewServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace somato
