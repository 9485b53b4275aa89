#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "hardware/topics/topic_body.h"
#include "hardware/topics/topic_client.h"
#include "somato/bodies/explorer.h"

namespace somato::topics {

/// The settings for recording the topics of a robot.
struct TopicExploring {
  std::string address;               ///< Such as "ws://robot:8765".
  std::vector<TopicSensor> sensors;  ///< At least one.
  KeptFrames keep = KeptFrames::kLatest;
  double duration = 5.0;  ///< Seconds of an exploration.
  double patience = 5.0;  ///< Seconds without a message after which the robot is silent.

  /// Has a thing placed before the robot, before it is explored for the given trial; may be empty.
  std::function<Result<void>(const ExploredThing& thing, std::size_t trial)> place;

  /// Receives what happened to the messages of an exploration, and how many the client has dropped
  /// so far; may be empty.
  std::function<void(const TopicTimes& times, std::size_t dropped)> on_end;
};

/// Records what topics report while a robot, which others move, explores a thing; used by one
/// thread. The first exploration opens the connection, and fails (kUnavailable) if that is not
/// possible. The labels of an exploration are `object` and `trial`. After a fault the next
/// exploration connects again; it waits for a robot that was there, as long as its limits permit.
class TopicExplorer : public Explorer {
 public:
  /// Errors (kUsage): no things, no sensors, the address.
  static Result<std::unique_ptr<Explorer>> create(std::vector<ExploredThing> things,
                                                  TopicExploring exploring);

  /// Others move the robot.
  bool moves_real_body() const override { return false; }

 protected:
  Result<Exploration> explore_thing(std::size_t thing, std::size_t trial,
                                    const ExploreOptions& options) override;

 private:
  TopicExplorer(std::vector<ExploredThing> things, TopicExploring exploring);

  Result<void> start();
  Result<void> connect(const ExploreOptions& options);

  TopicExploring exploring_;
  bool was_there_ = false;
  std::unique_ptr<TopicClient> client_;
  std::unique_ptr<TopicBody> body_;  // Ends before its client.
};

}  // namespace somato::topics
