#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "views/live/view_session.h"
#include "views/live/view_systems.h"
#include "views/session/system_reading.h"

namespace somato::testing {

inline std::optional<std::size_t> answer_of(const live::Reading& reading) {
  EXPECT_FALSE(reading.candidates.empty());
  return reading.candidates.front().number;
}

struct SaidMoment {
  std::size_t exploration = 0;
  std::size_t moments = 0;
  double time = 0.0;
  std::optional<std::size_t> answer = {};  // none before each channel gave a frame
  std::string object = {};                 // of a whole exploration

  bool operator==(const SaidMoment&) const = default;
};

// Collects what a session says; used by the player's thread until it is done.
class ReadingListener {
 public:
  live::ReadingSink sink() {
    live::ReadingSink sink;
    sink.on_begin = [this](const Exploration& exploration) -> Result<void> {
      channels_ = exploration.channels.size();
      if (refuses_) return fail(ErrorKind::kData, "refused");
      return {};
    };
    sink.on_moment = [this](const live::SaidReading& said) -> Result<void> {
      said_.push_back(entry(said));
      return {};
    };
    sink.on_end = [this](const live::SaidReading& said,
                         const Exploration& exploration) -> Result<void> {
      said_.push_back(entry(said));
      said_.back().object = find_label(exploration, "object").value_or("none");
      return {};
    };
    sink.on_failure = [this](const Error& error) { failures_.push_back(error.what); };
    sink.on_done = [this](const Result<void>& outcome) { done_.set_value(outcome); };
    return sink;
  }

  Result<void> wait() {
    auto done = done_.get_future();
    if (done.wait_for(std::chrono::seconds(60)) == std::future_status::ready) return done.get();
    return fail(ErrorKind::kData, "not done");
  }

  bool refuses_ = false;
  std::size_t channels_ = 0;
  std::vector<SaidMoment> said_;
  std::vector<std::string> failures_;

 private:
  static SaidMoment entry(const live::SaidReading& said) {
    return {said.exploration, said.moments, said.time,
            said.reading != nullptr ? answer_of(*said.reading) : std::nullopt};
  }

  std::promise<Result<void>> done_;
};

inline std::shared_ptr<const SystemModel> crossed_model() {
  return trained_model(crossed_system(), hand_recording(6, 2));
}

inline ViewSource source_with_readings(ViewSource source, ReadingListener& listener) {
  ViewSystem system = view_system(crossed_system(), "crossed");
  system.trained = crossed_model();
  source.systems = {std::move(system)};
  source.system = 0;
  source.readings = listener.sink();
  return source;
}

// Three explorations of a body.
inline ViewSource planned_source(std::unique_ptr<Explorer> explorer) {
  ViewSource source;
  source.name = "fake";
  source.explorer = std::move(explorer);
  source.plan = {{0, 0}, {0, 1}, {1, 0}};
  return source;
}

}  // namespace somato::testing
