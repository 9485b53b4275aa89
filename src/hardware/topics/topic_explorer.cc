#include "hardware/topics/topic_explorer.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>
#include <utility>

#include "somato/bodies/explore_by.h"

namespace somato::topics {
namespace {

constexpr auto kBetweenLooks = std::chrono::milliseconds(50);  // whether it is to stop
constexpr int kLooks = 20;                                     // until it connects again

constexpr double kStep = 0.01;  // s; a step ends with the next message however long that takes

}  // namespace

Result<std::unique_ptr<Explorer>> TopicExplorer::create(std::vector<ExploredThing> things,
                                                        TopicExploring exploring) {
  SOMATO_TRY_VOID(parse_web_socket_address(exploring.address));
  if (things.empty()) {
    return fail(ErrorKind::kUsage, "there is nothing to explore", {}, "name things");
  }
  if (exploring.sensors.empty()) {
    return fail(ErrorKind::kUsage, "there is no channel to record", {}, "name channels");
  }
  return std::unique_ptr<Explorer>(new TopicExplorer(std::move(things), std::move(exploring)));
}

TopicExplorer::TopicExplorer(std::vector<ExploredThing> things, TopicExploring exploring)
    : Explorer(std::move(things), "topics of " + exploring.address),
      exploring_(std::move(exploring)) {}

Result<void> TopicExplorer::start() {
  SOMATO_TRY(client_, TopicClient::start(exploring_.address));
  SOMATO_TRY(body_, TopicBody::start(exploring_.address, *client_, exploring_.sensors,
                                     exploring_.patience, exploring_.keep));
  return {};
}

// A robot that is restarted takes its time.
Result<void> TopicExplorer::connect(const ExploreOptions& options) {
  const auto& should_continue = options.limits.should_continue;
  for (;;) {
    auto started = start();
    if (started) {
      was_there_ = true;
      return {};
    }
    client_.reset();
    const bool is_missing = started.error().kind == ErrorKind::kSystem;
    if (is_missing && !was_there_) started.error().kind = ErrorKind::kUnavailable;
    if (!is_missing || !was_there_) return started;
    for (int look = 0; look < kLooks; ++look) {
      if (should_continue && !should_continue()) {
        return fail(ErrorKind::kInterrupted, "stopped while waiting for the robot");
      }
      std::this_thread::sleep_for(kBetweenLooks);
    }
  }
}

Result<Exploration> TopicExplorer::explore_thing(std::size_t thing, std::size_t trial,
                                                 const ExploreOptions& options) {
  if (!body_) SOMATO_TRY_VOID(connect(options));
  if (exploring_.place) SOMATO_TRY_VOID(exploring_.place(things()[thing], trial));
  body_->begin();
  auto explored =
      prepare_body(
          *body_, options, [] { return Scene{}; }, [] { return std::vector<ScenePose>(); })
          .and_then([&] { return explore_by_holding(*body_, exploring_.duration, kStep); });
  body_->keep_to({});
  body_->observe({});
  if (exploring_.on_end) exploring_.on_end(body_->times(), client_->state().dropped);
  if (explored) {
    explored->labels = labels(thing, trial);
  } else if (explored.error().kind != ErrorKind::kInterrupted) {
    body_.reset();
    client_.reset();
  }
  return explored;
}

}  // namespace somato::topics
