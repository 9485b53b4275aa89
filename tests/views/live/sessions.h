#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "base/support/eventually.h"
#include "base/support/json_schema.h"
#include "views/http/event_hub.h"
#include "views/live/view_session.h"
#include "views/replay/fake_explorer.h"

namespace somato::testing {

inline std::string name_of(live::EventKind kind) {
  switch (kind) {
    case live::EventKind::kState:
      return "state";
    case live::EventKind::kScene:
      return "scene";
    case live::EventKind::kTraining:
      return "training";
    case live::EventKind::kFrame:
      break;
  }
  return "frame";
}

// The latest event of a kind, checked by its schema; null before the first.
inline nlohmann::json latest(ViewSession& session, live::EventKind kind) {
  const auto text = session.hub().latest(kind);
  if (!text) return {};
  EXPECT_TRUE(text_fits_schema(*text, "view.json#/$defs/Events/properties/" + name_of(kind)));
  return nlohmann::json::parse(*text);
}
inline nlohmann::json state_of(ViewSession& session) {
  return latest(session, live::EventKind::kState);
}
inline nlohmann::json frame_of(ViewSession& session) {
  return latest(session, live::EventKind::kFrame);
}

inline nlohmann::json strips_of(ViewSession& session) {
  const auto strips = session.strips();
  if (!strips) return strips.error().what;
  EXPECT_TRUE(text_fits_schema(*strips, "view.json#/$defs/Answers/properties/strips"));
  return nlohmann::json::parse(*strips);
}

inline bool command(ViewSession& session, const std::string& text) {
  const auto done = session.command(text);
  EXPECT_TRUE(done) << text << ": " << (done ? "" : done.error().what);
  return done.has_value();
}

inline ViewSource body_source(std::size_t steps = 10) {
  ViewSource source;
  source.name = "fake";
  source.explorer = std::make_unique<FakeExplorer>(steps);
  return source;
}

}  // namespace somato::testing
