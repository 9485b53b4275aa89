// A session of `somato live` with an emulated device, whose clock the session moves: prints a line
// after every thousand frames, so that scripts/soak.py can measure the process in between.

#include <atomic>
#include <charconv>
#include <condition_variable>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <mutex>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hardware/device_files/device_file.h"
#include "hardware/devices/device_explorer.h"
#include "hardware/emulation/emulated_body.h"
#include "hardware/emulation/emulated_lines.h"
#include "hardware/support/lent_lines.h"
#include "somato/graph/system_model.h"
#include "views/live/view_session.h"

namespace somato {
namespace {

constexpr std::size_t kFramesEach = 500;  // of an exploration
constexpr std::size_t kFramesALine = 1000;

constexpr const char* kDevice = R"(name = "soak"
explore = "holding"
duration = 10
period = 0.02
[servos]
bus = "ssc32"
port = "servo port"
[servo.finger]
channel = 0
zero = 1200
scale = 10
least = 0
most = 60
fastest = 60
[frames]
format = "frames"
port = "sensor port"
elements = 8
rate = 50
[sensor.touch]
unit = "counts"
from = "frames"
elements = ["t1", "t2", "t3", "t4", "t5", "t6", "t7", "t8"]
)";

template <typename T>
T value_of(Result<T> result) {
  if (result) return std::move(*result);
  std::cerr << "soak: " << to_string(result.error()) << "\n";
  std::exit(1);
}

// A finger that does not move, with eight taxels whose readings change.
class Finger : public Body {
 public:
  Finger() {
    description_.name = "soak";
    description_.degrees_of_freedom = {{"finger", "deg", 0.0, 60.0, 600.0}};
    ChannelDescription& touch = description_.sensors.emplace_back();
    touch.name = "touch";
    touch.element_names = {"t1", "t2", "t3", "t4", "t5", "t6", "t7", "t8"};
    state_.positions = {0.0};
    state_.readings = {Matrix<float>(1, 8)};
  }

  const BodyDescription& description() const override { return description_; }
  const BodyState& state() const override { return state_; }

 protected:
  Result<void> drive_to(std::span<const double> targets) override {
    state_.positions.assign(targets.begin(), targets.end());
    return {};
  }

  Result<void> pass(double seconds) override {
    state_.time += seconds;
    ++steps_;
    const auto values = state_.readings[0].values();
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = static_cast<float>((steps_ * (i + 1)) % 100);
    }
    return {};
  }

 private:
  BodyDescription description_;
  BodyState state_;
  std::size_t steps_ = 0;
};

// Counts what a session says, and waits for its end.
class Counter {
 public:
  live::ReadingSink sink() {
    live::ReadingSink sink;
    sink.on_begin = [](const Exploration&) { return Result<void>(); };
    sink.on_moment = [this](const live::SaidReading&) {
      if (++frames_ % kFramesALine == 0) std::cout << frames_ << std::endl;
      return Result<void>();
    };
    sink.on_end = [](const live::SaidReading&, const Exploration&) { return Result<void>(); };
    sink.on_failure = [](const Error& error) { std::cerr << to_string(error) << "\n"; };
    sink.on_done = [this](const Result<void>& outcome) {
      const std::scoped_lock lock(mutex_);
      outcome_ = outcome;
      changed_.notify_all();
    };
    return sink;
  }

  Result<void> wait() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return outcome_.has_value(); });
    return *outcome_;
  }

 private:
  std::size_t frames_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Result<void>> outcome_;
};

void soak(const std::string& model, std::size_t frames) {
  const devices::DeviceFile file = value_of(devices::parse_device_file(kDevice, "soak"));
  emulation::EmulatedBody body(file, std::make_unique<Finger>());
  emulation::EmulatedLines lines(body.wires(), [&](double now) {
    if (!body.advance(now)) std::abort();
  });
  devices::DeviceSurroundings surroundings;
  surroundings.open_lines = [&]() -> Result<std::unique_ptr<wire::Lines>> {
    return std::make_unique<testing::LentLines>(lines);
  };
  Object ball;
  ball.name = "ball";
  Counter counter;
  ViewSource source;
  source.name = "soak";
  source.explorer = value_of(
      devices::DeviceExplorer::create(file, {{ball.name, ball, {}}}, {}, std::move(surroundings)));
  for (std::size_t i = 0; i < frames / kFramesEach; ++i) source.plan.push_back({0, i});
  source.readings = counter.sink();
  source.systems.emplace_back().trained =
      std::make_shared<const SystemModel>(value_of(load_system(model)));
  source.system = 0;
  ViewSession session(std::move(source),
                      {.wait_for_viewer = false, .speed = kFastest, .has_page = false});
  session.start();
  const Result<void> outcome = counter.wait();
  session.stop();
  std::cout << "end" << std::endl;
  std::string line;
  std::getline(std::cin, line);  // The process is measured once more.
  if (!outcome) value_of<int>(fail(outcome.error()));
}

}  // namespace
}  // namespace somato

int main(int count, char** words) {
  std::size_t frames = 0;
  const std::string_view number = count == 3 ? words[2] : "";
  const auto read = std::from_chars(number.data(), number.data() + number.size(), frames);
  if (read.ec != std::errc() || frames == 0) {
    std::cerr << "usage: soak MODEL FRAMES\n";
    return 2;
  }
  somato::soak(words[1], frames);
}
