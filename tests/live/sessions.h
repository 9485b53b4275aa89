#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "live/event_hub.h"
#include "live/fake_watched_body.h"
#include "somato/live/view_session.h"

namespace somato::testing {

inline nlohmann::json latest(ViewSession& session, live::EventKind kind) {
  const auto text = session.hub().latest(kind);
  return text ? nlohmann::json::parse(*text) : nlohmann::json();
}
inline nlohmann::json state_of(ViewSession& session) {
  return latest(session, live::EventKind::kState);
}
inline nlohmann::json frame_of(ViewSession& session) {
  return latest(session, live::EventKind::kFrame);
}

// Looks until it holds, for as long as a slow machine may take.
inline bool eventually(const std::function<bool()>& holds) {
  for (int i = 0; i < 6000; ++i) {
    if (holds()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

inline bool command(ViewSession& session, const std::string& text) {
  const auto done = session.command(text);
  EXPECT_TRUE(done) << text << ": " << (done ? "" : done.error().what);
  return done.has_value();
}

inline ViewSource body_source(std::size_t steps = 10) {
  ViewSource source;
  source.name = "fake";
  source.body = std::make_unique<FakeWatchedBody>(steps);
  return source;
}

}  // namespace somato::testing
