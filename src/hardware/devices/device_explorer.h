#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hardware/device_files/device_file.h"
#include "hardware/devices/device_body.h"
#include "hardware/devices/state_log.h"
#include "hardware/lines/lines.h"
#include "somato/bodies/explore_by.h"
#include "somato/bodies/explorer.h"

namespace somato::devices {

/// The settings of a device that explores.
struct DeviceExploring {
  ExplorationPlan plan;
  GuardedGrasp grasp;
  Closing closing;
  StrokeParameters stroke;
  PressParameters press;
};

/// The environment that a device requires.
struct DeviceSurroundings {
  /// Opens the lines of the device, before it is started.
  std::function<Result<std::unique_ptr<wire::Lines>>()> open_lines;

  /// Has a thing placed before the body, which waits, before it is explored for the given trial.
  std::function<Result<void>(const ExploredThing& thing, std::size_t trial)> place;

  /// Called before the servos are switched on: the bytes that switch them off, for the first of
  /// lines_of(), so that a signal handler can send them. They are valid until the next call, which
  /// has none, when the servos are off.
  std::function<void(wire::Lines& lines, std::span<const std::uint8_t> relax_bytes)> on_switch;

  /// The number of times that the program was continued after it had been stopped; may be empty.
  std::function<std::size_t()> continued;

  /// Called before each exploration, and before the device is started for it; what it returns is
  /// kept until the exploration ends.
  std::function<std::shared_ptr<void>()> watch;

  /// Called before the device moves again after a fault: a person permits it. An error
  /// (kUnavailable) ends the explorations. Empty: only resume() permits it.
  std::function<Result<void>(const Error& fault)> permit;

  /// Receives the last states of a device that was stopped by an error; returns where they were
  /// saved, for the message.
  std::function<std::string(const StateLog& log)> keep_log;

  /// Finds the scene of the body, with the thing that it explores; by default there is none.
  SceneFinder scenes;
};

/// Explores with a device; used by one thread. Each exploration has its thing placed; the first
/// then starts the device. It explores, and returns to the resting position, where the servos hold
/// until the next one. After a fault the servos are off, and the device is stopped until a person
/// lets it move again; the next exploration then starts it. It fails (kUnavailable) if that is not
/// permitted or not possible, or if nothing can be placed any more.
class DeviceExplorer : public Explorer {
 public:
  /// `source` names the device in recordings. Errors (kUsage): no things.
  static Result<std::unique_ptr<Explorer>> create(DeviceFile file,
                                                  std::vector<ExploredThing> things,
                                                  DeviceExploring exploring,
                                                  DeviceSurroundings surroundings);

  DeviceExplorer(const DeviceExplorer&) = delete;
  DeviceExplorer(DeviceExplorer&&) = delete;
  DeviceExplorer& operator=(const DeviceExplorer&) = delete;
  DeviceExplorer& operator=(DeviceExplorer&&) = delete;
  ~DeviceExplorer() override { end_body(); }

  bool is_stopped() const override { return fault_.has_value(); }
  void resume() override { fault_.reset(); }

 protected:
  Result<Exploration> explore_thing(std::size_t thing, std::size_t trial,
                                    const ExploreOptions& options) override;

 private:
  void end_body();
  DeviceExplorer(DeviceFile file, std::vector<ExploredThing> things, DeviceExploring exploring,
                 DeviceSurroundings surroundings);

  Result<void> permit();
  Result<void> place(std::size_t thing, std::size_t trial);
  Result<void> start(const ExploreOptions& options);
  Result<DeviceBody*> body(const ExploreOptions& options);
  Result<Exploration> explore_with(Body& body) const;
  Result<Exploration> explore_on(DeviceBody& body, const Exploration& named,
                                 const ExploreOptions& options);
  Error stopped(Error error);

  DeviceFile file_;
  DeviceExploring exploring_;
  DeviceSurroundings surroundings_;
  std::vector<std::uint8_t> relax_bytes_;
  std::unique_ptr<wire::Lines> lines_;
  std::optional<Error> fault_;        // That has stopped the device.
  std::unique_ptr<DeviceBody> body_;  // As long as it works; ends before its lines.
};

}  // namespace somato::devices
