#include "hardware/devices/device_explorer.h"

#include <fmt/format.h>

#include <utility>

#include "bodies/body/driving.h"
#include "bodies/objects/exploration_source.h"
#include "hardware/devices/device_io.h"
#include "recordings/explorations/growing_channel.h"

namespace somato::devices {
namespace {

// The present readings as an exploration with labels and source of `named`, of one frame.
Exploration as_exploration(const Body& body, const Exploration& named) {
  Exploration present{named.labels, named.source, {}};
  const std::vector<ChannelDescription>& sensors = body.description().sensors;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    Channel channel = detail::empty_channel(sensors[i]);
    channel.frames = Matrix<float>(0, body.state().readings[i].columns());
    append_readings(channel, body.state().readings[i]);
    present.channels.push_back(std::move(channel));
  }
  return present;
}

// An observer may let the body wait, as long as the program runs.
ExploreOptions with_pauses(DeviceBody& body, const ExploreOptions& options,
                           const std::function<std::size_t()>& continued) {
  ExploreOptions waiting = options;
  if (!options.observer.on_step) return waiting;
  waiting.observer.on_step = [&body, &options, &continued](const ExplorationStep& step) {
    const std::size_t before = continued ? continued() : 0;
    auto observed = options.observer.on_step(step);
    if (!continued || continued() == before) body.expect_pause();
    return observed;
  };
  return waiting;
}

}  // namespace

DeviceExplorer::DeviceExplorer(DeviceFile file, std::vector<ExploredThing> things,
                               DeviceExploring exploring, DeviceSurroundings surroundings)
    : Explorer(std::move(things), device_source(file.settings.name)),
      file_(std::move(file)),
      exploring_(std::move(exploring)),
      surroundings_(std::move(surroundings)),
      relax_bytes_(relax_bytes_of(file_)) {}

Result<std::unique_ptr<Explorer>> DeviceExplorer::create(DeviceFile file,
                                                         std::vector<ExploredThing> things,
                                                         DeviceExploring exploring,
                                                         DeviceSurroundings surroundings) {
  if (things.empty()) {
    return fail(ErrorKind::kUsage, "there is nothing to explore", {}, "give a table of objects");
  }
  return std::unique_ptr<Explorer>(new DeviceExplorer(
      std::move(file), std::move(things), std::move(exploring), std::move(surroundings)));
}

Result<Exploration> DeviceExplorer::explore_with(Body& body) const {
  switch (file_.settings.explore) {
    case ExploringMethod::kGrasping:
      return explore_by_grasping(body, exploring_.plan, exploring_.grasp);
    case ExploringMethod::kClosing:
      return explore_by_closing(body, exploring_.closing);
    case ExploringMethod::kStroking:
      return explore_by_stroking(body, exploring_.stroke);
    case ExploringMethod::kPressing:
      return explore_by_pressing(body, exploring_.press);
    case ExploringMethod::kHolding:
      break;
  }
  return explore_by_holding(body, file_.settings.duration, file_.settings.period);
}

// Nothing moves after a fault before a person says so.
Result<void> DeviceExplorer::permit() {
  if (!fault_) return {};
  if (!surroundings_.permit) {
    return fail(ErrorKind::kUnavailable, "a fault has stopped the device", file_.settings.name,
                "remove its cause, and start the device again");
  }
  return surroundings_.permit(*fault_).map([this] { resume(); });
}

Result<void> DeviceExplorer::place(std::size_t thing, std::size_t trial) {
  if (!surroundings_.place) return {};
  auto placed = surroundings_.place(things()[thing], trial);
  if (placed || placed.error().kind != ErrorKind::kSystem) return placed;
  placed.error().kind = ErrorKind::kUnavailable;  // The emulator has ended.
  return placed;
}

// A signal may end the program while the servos are being switched on.
Result<void> DeviceExplorer::start(const ExploreOptions& options) {
  end_body();
  lines_.reset();
  SOMATO_TRY(lines_, surroundings_.open_lines());
  if (surroundings_.on_switch) surroundings_.on_switch(*lines_, relax_bytes_);
  SOMATO_TRY(body_, DeviceBody::start(file_, *lines_, {}, options.limits.should_continue));
  return {};
}

Result<DeviceBody*> DeviceExplorer::body(const ExploreOptions& options) {
  if (body_) return body_.get();
  auto started = start(options);
  if (started) return body_.get();
  end_body();
  if (started.error().kind == ErrorKind::kInterrupted) return fail(std::move(started.error()));
  started.error().kind = ErrorKind::kUnavailable;
  return fail(std::move(started.error()));
}

void DeviceExplorer::end_body() {
  if (body_) body_->relax();
  if (lines_ && surroundings_.on_switch) surroundings_.on_switch(*lines_, {});
  body_.reset();
}

Result<Exploration> DeviceExplorer::explore_on(DeviceBody& body, const Exploration& named,
                                               const ExploreOptions& options) {
  SOMATO_TRY_VOID(body.begin());
  const auto player =
      surroundings_.scenes ? surroundings_.scenes(as_exploration(body, named)) : nullptr;
  const auto scene = [&] { return player ? player->scene() : Scene{}; };
  const auto poses = [&] {
    return player ? player->poses(as_exploration(body, named), 0) : std::vector<ScenePose>();
  };
  const ExploreOptions waiting = with_pauses(body, options, surroundings_.continued);
  auto explored = prepare_body(body, waiting, scene, poses).and_then([&] {
    body.expect_pause();
    return explore_with(body);
  });
  if (explored) {
    if (auto ended = body.end(); !ended) explored = fail(std::move(ended.error()));
  }
  // Only the way back is left, unless the device stopped. It can be interrupted as well, and then
  // the exploration before it counts.
  body.keep_to({.should_continue = options.limits.should_continue});
  body.observe({});
  if (!explored && explored.error().kind == ErrorKind::kInterrupted) body.relax();
  if (!body.is_on()) return explored;
  auto returned = body.go_to_rest();
  if (!returned && returned.error().kind != ErrorKind::kInterrupted) {
    return fail(std::move(returned.error()));
  }
  if (!returned) body.relax();
  return explored;
}

Error DeviceExplorer::stopped(Error error) {
  const bool is_fault = error.kind == ErrorKind::kSystem || error.kind == ErrorKind::kData;
  if (!is_fault) return error;
  fault_ = error;
  if (!surroundings_.keep_log) return error;
  const std::string path = surroundings_.keep_log(body_->history());
  if (path.empty()) return error;
  error.advice += fmt::format("{}the last states and commands are in {}",
                              error.advice.empty() ? "" : "; ", path);
  return error;
}

Result<Exploration> DeviceExplorer::explore_thing(std::size_t thing, std::size_t trial,
                                                  const ExploreOptions& options) {
  SOMATO_TRY_VOID(permit());
  // Servos that start may jump: hands are away then.
  SOMATO_TRY_VOID(place(thing, trial));
  const std::shared_ptr<void> watch = surroundings_.watch ? surroundings_.watch() : nullptr;
  SOMATO_TRY(DeviceBody* const started, body(options));
  const Exploration named{labels(thing, trial), device_source(file_.settings.name), {}};
  auto explored = explore_on(*started, named, options);
  if (explored) {
    explored->labels = named.labels;
    if (!started->is_on()) end_body();
    return explored;
  }
  if (started->is_on()) return explored;  // It has only not found what it was looking for.
  Error error = stopped(std::move(explored.error()));
  end_body();
  return fail(std::move(error));
}

}  // namespace somato::devices
